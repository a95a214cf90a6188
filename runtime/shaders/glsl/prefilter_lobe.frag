// A texel of a level: the sum over the cells of a lobe, each looked up where texels are as large. Twin: prefiltered,
// Prefilter.h.
uniform samplerCube fbrdfRadiance;
uniform sampler2D fbrdfCells;     // one row: x, y and weight of a cell, its level at the centre of a face
uniform int fbrdfCellCount;
uniform float fbrdfCellRoom;      // texels of the row

void main()
{
    vec3 axis = normalize(fbrdfFacePoint(gl_FragCoord.xy));
    mat3 frame = fbrdfLobeFrame(axis);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < fbrdfCellCount; ++i) {
        vec4 cell = FBRDF_TEXTURE2(fbrdfCells, vec2((float(i) + 0.5) / fbrdfCellRoom, 0.5));
        vec3 direction = frame * vec3(cell.xy, sqrt(max(0.0, 1.0 - dot(cell.xy, cell.xy))));
        vec3 size = abs(direction);
        // A texel is smaller towards the edges of a face: levelOfCell, Prefilter.h.
        float level = cell.w - 1.5 * log2(max(size.x, max(size.y, size.z)));
        sum += cell.z * FBRDF_TEXTURE_CUBE_LEVEL(fbrdfRadiance, direction, level).rgb;
    }
    fbrdfColour = vec4(min(sum, vec3(fbrdfLargest)), 1.0);
}
