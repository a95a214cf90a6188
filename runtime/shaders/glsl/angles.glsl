// Angles of a pair as (cosine, 1 - cosine), both in [0, 1] but for rounding. Twin: PairGeometry, Projection.h.

// 1 - cos = sin^2 / (1 + cos): the sine comes from where nothing cancels. Samplers clamp what rounding leaves beyond 1.
vec2 fbrdfAngleFromCosine(float cosine, float sineSquared)
{
    float c = max(cosine, 0.0);
    return vec2(c, sineSquared / (1.0 + c));
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

// 1 / |both|, where both = wi + wo: with it theta_h and theta_d need no half vector. 1e-30 is above the smallest normal
// float (1.2e-38), so that opposite directions give a finite number.
float fbrdfInverseLength(vec3 both)
{
    return inversesqrt(max(dot(both, both), 1e-30));
}

// h = norm(wi + wo), or the normal where they are opposite.
vec3 fbrdfHalfVector(vec3 wo, vec3 wi)
{
    vec3 both = wi + wo;
    return dot(both, both) > 0.0 ? both * fbrdfInverseLength(both) : vec3(0.0, 0.0, 1.0);
}

// theta_h about a normal in any frame; across = n x (wi + wo).
vec2 fbrdfHalfZenith(float NoV, float NoL, vec3 across, float inverseLength)
{
    return fbrdfAngleFromCosine((NoV + NoL) * inverseLength, dot(across, across) * inverseLength * inverseLength);
}

// theta_d of a pair of unit directions, in any frame.
vec2 fbrdfDifferenceAngle(vec3 wo, vec3 wi)
{
    vec3 both = wi + wo, apart = wi - wo;
    return fbrdfAngleFromCosine(0.5 * dot(both, both) * fbrdfInverseLength(both), 0.25 * dot(apart, apart));
}

// phi_d, folded to [0, pi/2], from the sides of the triangle whose angle it is; n, h and wi in any frame.
vec2 fbrdfDifferenceAzimuth(vec3 n, vec3 h, vec3 wi, float NoV, float NoL)
{
    float along = 0.5 * abs(NoV - NoL), across = abs(dot(n, cross(h, wi)));
    float sines = sqrt(along * along + across * across);
    return sines > 0.0 ? vec2(along / sines, across * across / (sines * (sines + along))) : vec2(0.0, 1.0);
}

// Half of a folded angle, or of pi less it: cos^2 of a half is (1 + cos) / 2, sin^2 is (1 - cos) / 2.
vec2 fbrdfHalfAngle(vec2 folded, bool isNear)
{
    vec2 squares = 0.5 * vec2(1.0 + folded.x, folded.y);
    if (!isNear) squares = squares.yx;
    return fbrdfAngleFromCosine(sqrt(squares.x), squares.y);
}

// phi_d / 2, phi_d in [0, pi] by the mirror symmetry.
vec2 fbrdfHalfDifferenceAzimuth(vec3 n, vec3 h, vec3 wi, float NoV, float NoL)
{
    return fbrdfHalfAngle(fbrdfDifferenceAzimuth(n, h, wi, NoV, NoL), NoV >= NoL);
}

// phi_d / 2, phi_d in [0, pi] by reciprocity.
vec2 fbrdfSideDifferenceAzimuth(vec3 n, vec3 h, vec3 wi, float NoV, float NoL)
{
    bool isNear = (NoV >= NoL) == (dot(n, cross(h, wi)) >= 0.0);
    return fbrdfHalfAngle(fbrdfDifferenceAzimuth(n, h, wi, NoV, NoL), isNear);
}

// d: wi in the frame whose pole is h, in the local frame. Twin: differenceVector, Projection.h.
vec3 fbrdfDifferenceVector(vec3 h, vec3 wi)
{
    float radius = length(h.xy);
    vec2 toH = radius > 0.0 ? h.xy / radius : vec2(1.0, 0.0);
    return vec3(dot(wi, vec3(h.z * toH, -radius)), toH.x * wi.y - toH.y * wi.x, dot(wi, h));
}

// norm(weights.x wo + weights.y wi + weights.z n), in the local frame. Twin: combination, Projection.h.
vec3 fbrdfCombination(vec3 weights, vec3 wo, vec3 wi)
{
    vec3 sum = weights.x * wo + weights.y * wi + vec3(0.0, 0.0, weights.z);
    float size = length(sum);
    return size > 0.0 ? sum / size : vec3(0.0, 0.0, 1.0);
}
