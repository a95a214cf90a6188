// The shadow hook of the runtime (fbrdf/gl/Hooks.h): depth maps of up to 4 lights (ShadowMaps.h), compared
// with and filtered between four texels.
uniform sampler2DArrayShadow shadowMaps;
uniform mat4 shadowFromEye[4];  // to the depth map's coordinates, in [0, 1] after the division
uniform vec4 shadowLights;      // the light of each map; -1: none

float seenOf(int map, vec3 position)
{
    vec4 clip = shadowFromEye[map] * vec4(position, 1.0);
    vec3 place = clip.xyz / clip.w;
    // Outside of the map there are no objects, nor in front of it; behind it there may be a ground.
    if (clip.w <= 0.0 || place.xy != clamp(place.xy, 0.0, 1.0) || place.z < 0.0) return 1.0;
    return textureGrad(shadowMaps, vec4(place.xy, float(map), min(place.z, 1.0)), vec2(0.0), vec2(0.0));
}

float fbrdfShadow(int light, vec3 position, vec3 toLight)
{
    int found = -1;
    for (int map = 0; map < 4; ++map)
        if (int(shadowLights[map]) == light) found = map;
    return found < 0 ? 1.0 : seenOf(found, position);  // one look-up: a driver may not jump over others
}
