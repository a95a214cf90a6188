// The lists of a fragment: of lights, or of area lights. Twin: LightClusters.h, which describes how the view is cut.

// First index and number. lists: those of each cluster; grid: columns, rows, slices; scale: columns and rows per pixel,
// scale and bias of the slice. 1e-6 is kNearest, LightReach.h: the log of smaller distances is not needed.
ivec2 fbrdfLightList(isamplerBuffer lists, ivec3 grid, vec4 scale, vec2 pixel, float distance)
{
    float slice = log2(max(distance, 1e-6)) * scale.z + scale.w;
    ivec3 at = ivec3(clamp(floor(vec3(pixel * scale.xy, slice)), vec3(0.0), vec3(grid - 1)));
    return texelFetch(lists, (at.z * grid.y + at.y) * grid.x + at.x).rg;
}

// Light `i` of a list; the `everywhere` lights that reach everywhere come before it.
int fbrdfListed(isamplerBuffer indices, ivec2 list, int everywhere, int i)
{
    return i < everywhere ? i : texelFetch(indices, list.x + i - everywhere).r;
}

// True where the point is inside of the radius of a light, given by its first vector.
bool fbrdfReaches(vec4 position, vec3 point)
{
    vec3 toLight = position.xyz - point;
    return dot(toLight, toLight) * position.w < 1.0;
}
