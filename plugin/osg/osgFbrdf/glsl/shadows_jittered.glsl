// Soft edges of osgShadow::SoftShadowMap, whose uniforms and texture these are: 32 texels of two offsets each in a unit
// disc, another 32 for each pixel. Uralsky 2005, GPU Gems 2, chapter 17: where the first eight comparisons agree the
// point is in full light or shadow.
#if __VERSION__ >= 130
#define OSGFBRDF_OFFSETS(coordinate) texture(osgShadow_jitterTexture, coordinate)
#else
#define OSGFBRDF_OFFSETS(coordinate) texture3D(osgShadow_jitterTexture, coordinate)
#endif
uniform sampler3D osgShadow_jitterTexture;
uniform float osgShadow_softnessWidth, osgShadow_jitteringScale;

float osgFbrdfJittered(sampler2DShadow map, vec4 coordinate)
{
    float width = osgShadow_softnessWidth * coordinate.q, sum = 0.0;
    for (int i = 0; i < 32; ++i) {
        vec3 place = vec3(gl_FragCoord.xy / osgShadow_jitteringScale, (float(i) + 0.5) / 32.0);
        vec4 offsets = width * (2.0 * OSGFBRDF_OFFSETS(place) - 1.0);
        sum += osgFbrdfPlain(map, coordinate + vec4(offsets.xy, 0.0, 0.0));
        sum += osgFbrdfPlain(map, coordinate + vec4(offsets.zw, 0.0, 0.0));
        if (i == 3 && (sum == 0.0 || sum == 8.0)) return sum / 8.0;
    }
    return sum / 64.0;
}
