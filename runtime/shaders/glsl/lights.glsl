// Light sources. A light is two vectors: (position, 1) of a point light or (unit direction towards it, 0) of a
// directional one, in eye space; and (intensity, radius of influence or 0).

// Twin: falloff, Light.h. Karis 2013, "Real Shading in Unreal Engine 4", Eq. 9.
float fbrdfFalloff(float distanceSquared, float radius)
{
    float factor = 1.0 / max(distanceSquared, 1e-12);
    if (radius > 0.0) {
        float ratio = distanceSquared / (radius * radius);
        float window = ratio < 1.0 ? 1.0 - ratio * ratio : 0.0;
        factor *= window * window;
    }
    return factor;
}

// Irradiance on a surface that faces the light (seed Eq. 2), and the unit direction to the light.
vec3 fbrdfIrradiance(vec4 position, vec4 intensity, vec3 point, out vec3 wi)
{
    vec3 toLight = position.xyz - position.w * point;
    float distanceSquared = dot(toLight, toLight);
    wi = toLight * inversesqrt(max(distanceSquared, 1e-30));
    return position.w > 0.0 ? intensity.rgb * fbrdfFalloff(distanceSquared, intensity.w) : intensity.rgb;
}
