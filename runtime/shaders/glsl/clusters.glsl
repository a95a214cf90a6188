// The list of lights of a fragment. Twin: LightClusters.h, which says how the view is cut.
uniform samplerBuffer fbrdfLightBuffer;     // three vec4 a light
uniform isamplerBuffer fbrdfLightIndices;   // lights of all lists
uniform isamplerBuffer fbrdfLightLists;     // first index and number of each cluster
uniform ivec3 fbrdfClusterGrid;             // columns, rows, slices
uniform vec4 fbrdfClusterScale;             // columns and rows a pixel, scale and bias of the slice

// First index and number.
ivec2 fbrdfLightList(vec2 pixel, float distance)
{
    float slice = log2(max(distance, 1e-6)) * fbrdfClusterScale.z + fbrdfClusterScale.w;
    ivec3 at = ivec3(clamp(floor(vec3(pixel * fbrdfClusterScale.xy, slice)), vec3(0.0), vec3(fbrdfClusterGrid - 1)));
    return texelFetch(fbrdfLightLists, (at.z * fbrdfClusterGrid.y + at.y) * fbrdfClusterGrid.x + at.x).rg;
}
