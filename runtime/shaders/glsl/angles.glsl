// Angles of a pair as (cosine, 1 - cosine), both in [0, 1] but for rounding. Twin: PairGeometry, Projection.h.

// 1 - cos = (sin^2 + (1 - cos)^2) / 2: the sine comes from where nothing cancels, and the rounding of 1 - cos counts times
// 1 - cos itself. It needs no division, of which a GPU does few. Samplers clamp what rounding leaves beyond 1.
vec2 fbrdfAngleFromCosine(float cosine, float sineSquared)
{
    float c = max(cosine, 0.0), complement = 1.0 - c;
    return vec2(c, 0.5 * (sineSquared + complement * complement));
}

// Zenith angle of a unit direction in the local frame: theta_i, theta_o, theta_h.
vec2 fbrdfZenith(vec3 w)
{
    return fbrdfAngleFromCosine(w.z, dot(w.xy, w.xy));
}

// The same about a unit normal in any frame: isotropic forms need no tangent.
vec2 fbrdfZenithAbout(vec3 n, vec3 w)
{
    vec3 sine = cross(n, w);
    return fbrdfAngleFromCosine(dot(n, w), dot(sine, sine));
}

// |both| and 1 / |both|, where both = wi + wo: with them theta_h, theta_d and phi_d need no half vector. 1e-30 is above
// the smallest normal float (1.2e-38), so that opposite directions give finite numbers.
vec2 fbrdfSizeOf(vec3 both)
{
    float square = dot(both, both), inverse = inversesqrt(max(square, 1e-30));
    return vec2(square * inverse, inverse);
}

// h = norm(wi + wo), or the normal where they are opposite.
vec3 fbrdfHalfVector(vec3 wo, vec3 wi)
{
    vec3 both = wi + wo;
    vec2 size = fbrdfSizeOf(both);
    return size.x > 0.0 ? both * size.y : vec3(0.0, 0.0, 1.0);
}

// theta_h about a normal n in any frame; across = n x both, height = n both; fbrdfAngleFromCosine, multiplied out.
vec2 fbrdfHalfZenith(float height, vec3 across, vec2 size)
{
    float above = max(height, 0.0), lacks = size.x - above;
    return vec2(above * size.y, 0.5 * size.y * size.y * (dot(across, across) + lacks * lacks));
}

// theta_d of a pair of unit directions, in any frame, from fbrdfSizeOf(wi + wo).x; fbrdfAngleFromCosine, multiplied out.
vec2 fbrdfDifferenceAngle(vec3 wo, vec3 wi, float size)
{
    vec3 apart = wi - wo;
    float lacks = 2.0 - size;
    return vec2(0.5 * size, 0.125 * (dot(apart, apart) + lacks * lacks));
}

// phi_d, folded to [0, pi/2], from the sides of the triangle whose angle it is, times |wi + wo|:
//     side = n (wo x wi),   lean = |wi + wo| (NoV - NoL) / 2.
vec2 fbrdfDifferenceAzimuth(float side, float lean)
{
    float square = side * side + lean * lean, inverse = inversesqrt(max(square, 1e-30));
    float across = side * inverse;
    return square > 0.0 ? fbrdfAngleFromCosine(abs(lean) * inverse, across * across) : vec2(0.0, 1.0);
}

// Half of a folded angle, or of pi less it: cos^2 of a half is (1 + cos) / 2, sin^2 is (1 - cos) / 2.
vec2 fbrdfHalfAngle(vec2 folded, bool isNear)
{
    vec2 squares = 0.5 * vec2(1.0 + folded.x, folded.y);
    if (!isNear) squares = squares.yx;
    return fbrdfAngleFromCosine(sqrt(squares.x), squares.y);
}

// phi_d / 2, phi_d in [0, pi] by the mirror symmetry.
vec2 fbrdfHalfDifferenceAzimuth(float side, float lean)
{
    return fbrdfHalfAngle(fbrdfDifferenceAzimuth(side, lean), lean >= 0.0);
}

// phi_d / 2, phi_d in [0, pi] by reciprocity.
vec2 fbrdfSideDifferenceAzimuth(float side, float lean)
{
    return fbrdfHalfAngle(fbrdfDifferenceAzimuth(side, lean), (lean >= 0.0) == (side >= 0.0));
}

// d: wi in the frame whose pole is h, in the local frame. Twin: differenceVector, Projection.h.
vec3 fbrdfDifferenceVector(vec3 h, vec3 wi)
{
    float square = dot(h.xy, h.xy), inverse = inversesqrt(max(square, 1e-30));
    vec2 toH = square > 0.0 ? h.xy * inverse : vec2(1.0, 0.0);
    return vec3(dot(wi, vec3(h.z * toH, -square * inverse)), toH.x * wi.y - toH.y * wi.x, dot(wi, h));
}

// norm(weights.x wo + weights.y wi + weights.z n), in the local frame. Twin: combination, Projection.h.
vec3 fbrdfCombination(vec3 weights, vec3 wo, vec3 wi)
{
    vec3 sum = weights.x * wo + weights.y * wi + vec3(0.0, 0.0, weights.z);
    float square = dot(sum, sum);
    return square > 0.0 ? sum * inversesqrt(max(square, 1e-30)) : vec3(0.0, 0.0, 1.0);
}
