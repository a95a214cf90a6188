// Positions in tables. Twins: axisCoordinate and discPosition, Projection.h. Exponents are constants where these are
// called, so a compiler keeps one branch.

// u in [0, 1] of an angle given as cosine and 1 - cosine.
float fbrdfAxisCoordinate(bool fromCosine, float exponent, float cosine, float complement)
{
    float base = fromCosine ? cosine : complement;
    if (exponent == 1.0) return base;
    if (exponent == 0.5) return sqrt(base);
    if (exponent == 0.25) return sqrt(sqrt(base));
    return pow(base, exponent);
}

// Texel position of a direction of the upper hemisphere. With p = direction.xy / (1 + z) it is at p |p|^(gamma - 1). 1e-30
// is above the smallest normal float, so that the centre of the map is finite.
vec2 fbrdfDiscPosition(float size, float gamma, float radius, vec3 direction)
{
    float height = 1.0 + max(direction.z, 0.0), square = max(dot(direction.xy, direction.xy), 1e-30), scale;
    if (gamma == 0.5) scale = inversesqrt(height * sqrt(square));
    else if (gamma == 1.0) scale = 1.0 / height;
    else scale = pow(square, 0.5 * (gamma - 1.0)) * pow(height, -gamma);
    return vec2(0.5 * (size - 1.0)) + radius * scale * direction.xy;
}
