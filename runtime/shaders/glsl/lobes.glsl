// Lobes that stand for a material under an environment. Twin: lobesAt, LobeTable.cpp, step by step.

// Position of theta_o among the knots 0 to `last`; 89 degrees are the last knot.
float fbrdfThetaPosition(float sine, float cosine, float last)
{
    float left = max(0.0, 1.0 - atan(sine, cosine) / 1.55334303);
    return (1.0 - pow(left, 2.0 / 3.0)) * last;
}

// Position of phi_o, folded to [0, pi / 2]. 1e-30: GLSL leaves atan(0, 0) open, which normal incidence would ask for.
float fbrdfAzimuthPosition(vec2 w, float last)
{
    return atan(abs(w.y), max(abs(w.x), 1e-30)) / 1.57079633 * last;
}

// The knot before a position, and the share of the one after it.
vec2 fbrdfLobeKnot(float position, float last)
{
    float clamped = clamp(position, 0.0, last);
    float knot = min(floor(clamped), last - 1.0);
    return vec2(knot, clamped - knot);
}

// The mirror direction of wo, turned towards n by an angle; in any frame. 1e-30 is above the smallest normal float, so
// that the axis is n at normal incidence.
vec3 fbrdfTiltedAxis(vec3 n, vec3 wo, float NoV, float angle)
{
    vec3 along = wo - n * NoV;
    float across = length(along);
    along /= max(across, 1e-30);
    vec3 mirror = n * NoV - along * across, inwards = n * across + along * NoV;
    return mirror * cos(angle) + inwards * sin(angle);
}

// The mirror direction of wo about the normal that is bent along the tangent or across it, in the local frame. Normals
// of the quadrant x, y >= 0 are mirrored as wo is.
vec3 fbrdfBentAxis(vec3 wo, vec2 offset)
{
    float side = (offset.x != 0.0 ? wo.x : wo.y) < 0.0 ? -1.0 : 1.0;
    vec3 normal = normalize(vec3(side * offset, 1.0));
    return 2.0 * dot(wo, normal) * normal - wo;
}
