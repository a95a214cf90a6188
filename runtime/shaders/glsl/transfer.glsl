// Turns exposed radiance into the value that is stored. Twins: Transfer.h.

// IEC 61966-2-1:1999; x in [0, 1].
vec3 fbrdfSrgbFromLinear(vec3 x)
{
    vec3 curve = 1.055 * pow(max(x, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}

// Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", Eq. 4, white at 4.
vec3 fbrdfToneMapped(vec3 radiance)
{
    vec3 x = clamp(radiance, 0.0, 4.0);  // white, also where a sum is infinite
    return min(vec3(1.0), x * (1.0 + x / 16.0) / (1.0 + x));
}
