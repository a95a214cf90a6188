// The list of lights of a fragment. Twin: LightClusters.h, which describes how the view is cut.
uniform samplerBuffer fbrdfLightBuffer;     // three vec4 for each light
uniform isamplerBuffer fbrdfLightIndices;   // lights of all lists
uniform isamplerBuffer fbrdfLightLists;     // first index and number of each cluster
uniform ivec3 fbrdfClusterGrid;             // columns, rows, slices
uniform int fbrdfLightCount;                // lights that reach everywhere: the first of the buffer
uniform vec4 fbrdfClusterScale;             // columns and rows per pixel, scale and bias of the slice

// First index and number. 1e-6 is kNearest, LightReach.h: the log of smaller distances is not needed.
ivec2 fbrdfLightList(vec2 pixel, float distance)
{
    float slice = log2(max(distance, 1e-6)) * fbrdfClusterScale.z + fbrdfClusterScale.w;
    ivec3 at = ivec3(clamp(floor(vec3(pixel * fbrdfClusterScale.xy, slice)), vec3(0.0), vec3(fbrdfClusterGrid - 1)));
    return texelFetch(fbrdfLightLists, (at.z * fbrdfClusterGrid.y + at.y) * fbrdfClusterGrid.x + at.x).rg;
}

// Light `i` of a list; the lights that reach everywhere come before it.
int fbrdfListed(ivec2 list, int i)
{
    return i < fbrdfLightCount ? i : texelFetch(fbrdfLightIndices, list.x + i - fbrdfLightCount).r;
}

// True where the point is inside of the light's radius.
bool fbrdfReaches(int light, vec3 point)
{
    vec4 position = texelFetch(fbrdfLightBuffer, 3 * light);
    vec3 toLight = position.xyz - point;
    return dot(toLight, toLight) * position.w < 1.0;
}
