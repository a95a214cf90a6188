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

// Twin: falloff, Light.h. squares: squared distance and its inverse. As there, 1e12 keeps a light on the surface finite.
float fbrdfFalloff(vec2 squares, float inverseRadiusSquared)
{
    return fbrdfInfluenceWindow(squares.x, inverseRadiusSquared) * min(squares.y, 1e12);
}

// Twin: coneFactor, Light.h. wi: unit, towards the light.
float fbrdfConeFactor(vec4 cone, vec3 wi)
{
    float edge = clamp(cone.w - dot(cone.xyz, wi), 0.0, 1.0);
    return edge * edge;
}

// The unit direction to a light, given by its first vector and the last number of the second, and what fbrdfFalloff
// needs. 1e-30 is above the smallest normal float, so that the direction is finite at the light itself.
vec3 fbrdfToLight(vec4 position, float isLocated, vec3 point, out vec2 squares)
{
    vec3 toLight = position.xyz - isLocated * point;
    float square = dot(toLight, toLight), inverse = inversesqrt(max(square, 1e-30));
    squares = vec2(square, inverse * inverse);
    return toLight * inverse;
}

// Irradiance on a surface that faces the light (docs/method.md, Eq. 2), and the unit direction to the light.
vec3 fbrdfIrradiance(vec4 position, vec4 intensity, vec4 cone, vec3 point, out vec3 wi)
{
    vec2 squares;
    wi = fbrdfToLight(position, intensity.w, point, squares);
    return intensity.rgb * (fbrdfFalloff(squares, position.w) * fbrdfConeFactor(cone, wi));
}
