// Linear filtering by arithmetic, for textures that do not filter: hardware may know as few as 256
// places between two texels. position is in texels, as in a Table.
vec3 fbrdfFiltered(sampler2D map, vec2 position, vec2 size)
{
    vec2 from = clamp(floor(position), vec2(0.0), size - 1.0);
    vec4 at = (vec4(from, min(from + 1.0, size - 1.0)) + 0.5) / vec4(size, size);
    vec2 weight = clamp(position - from, 0.0, 1.0);
    return mix(mix(FBRDF_TEXTURE2(map, at.xy).rgb, FBRDF_TEXTURE2(map, at.zy).rgb, weight.x),
               mix(FBRDF_TEXTURE2(map, at.xw).rgb, FBRDF_TEXTURE2(map, at.zw).rgb, weight.x),
               weight.y);
}

#ifdef FBRDF_INSTANCED
vec3 fbrdfFiltered(sampler2DArray map, vec3 position, vec2 size)
{
    vec2 from = clamp(floor(position.xy), vec2(0.0), size - 1.0);
    vec4 at = (vec4(from, min(from + 1.0, size - 1.0)) + 0.5) / vec4(size, size);
    vec2 weight = clamp(position.xy - from, 0.0, 1.0);
    float layer = position.z;
    return mix(mix(FBRDF_TEXTURE2(map, vec3(at.xy, layer)).rgb,
                   FBRDF_TEXTURE2(map, vec3(at.zy, layer)).rgb, weight.x),
               mix(FBRDF_TEXTURE2(map, vec3(at.xw, layer)).rgb,
                   FBRDF_TEXTURE2(map, vec3(at.zw, layer)).rgb, weight.x),
               weight.y);
}
#endif

#if !defined(GL_ES) || __VERSION__ >= 300
vec3 fbrdfFiltered(sampler3D map, vec3 position, vec3 size)
{
    vec3 from = clamp(floor(position), vec3(0.0), size - 1.0), to = min(from + 1.0, size - 1.0);
    vec3 weight = clamp(position - from, 0.0, 1.0), low = (from + 0.5) / size,
         high = (to + 0.5) / size;
    vec3 front = mix(
        mix(FBRDF_TEXTURE3(map, low).rgb, FBRDF_TEXTURE3(map, vec3(high.x, low.yz)).rgb, weight.x),
        mix(FBRDF_TEXTURE3(map, vec3(low.x, high.y, low.z)).rgb,
            FBRDF_TEXTURE3(map, vec3(high.xy, low.z)).rgb, weight.x),
        weight.y);
    vec3 back = mix(
        mix(FBRDF_TEXTURE3(map, vec3(low.xy, high.z)).rgb,
            FBRDF_TEXTURE3(map, vec3(high.x, low.y, high.z)).rgb, weight.x),
        mix(FBRDF_TEXTURE3(map, vec3(low.x, high.yz)).rgb, FBRDF_TEXTURE3(map, high).rgb, weight.x),
        weight.y);
    return mix(front, back, weight.z);
}
#endif
