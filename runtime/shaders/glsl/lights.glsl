// Light sources. A light is three vectors in eye space, see LightVectors.h:
//   position  a point, or for a directional light the unit direction towards it; and 1 / radius^2 (0: unlimited)
//   intensity and 1, or for a directional light 0
//   cone      axis x scale, offset; (0, 0, 0, 1) where there is none
// Directions are unit, so that one expression serves all kinds: branches cost more than the few products.

// Twin: influenceWindow, Light.h. Karis 2013, "Real Shading in Unreal Engine 4", Eq. 9.
float fbrdfInfluenceWindow(float distanceSquared, float inverseRadiusSquared)
{
    float ratio = distanceSquared * inverseRadiusSquared;
    float window = max(1.0 - ratio * ratio, 0.0);
    return window * window;
}

// Twin: falloff, Light.h. As there, 1e-12 keeps a light on the surface finite.
float fbrdfFalloff(float distanceSquared, float inverseRadiusSquared)
{
    float clamped = max(distanceSquared, 1e-12);
    return fbrdfInfluenceWindow(clamped, inverseRadiusSquared) / clamped;
}

// Twin: coneFactor, Light.h. wi: unit, towards the light.
float fbrdfConeFactor(vec4 cone, vec3 wi)
{
    float edge = clamp(cone.w - dot(cone.xyz, wi), 0.0, 1.0);
    return edge * edge;
}

// Irradiance on a surface that faces the light (docs/method.md, Eq. 2), and the unit direction to the light. 1e-30 is
// above the smallest normal float, so that wi is finite at the light itself.
vec3 fbrdfIrradiance(vec4 position, vec4 intensity, vec4 cone, vec3 point, out vec3 wi)
{
    vec3 toLight = position.xyz - intensity.w * point;
    float distanceSquared = dot(toLight, toLight);
    wi = toLight * inversesqrt(max(distanceSquared, 1e-30));
    return intensity.rgb * (fbrdfFalloff(distanceSquared, position.w) * fbrdfConeFactor(cone, wi));
}
