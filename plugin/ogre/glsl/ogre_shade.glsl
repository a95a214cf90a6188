// Fragment shader: the material under all lights, and what is stored of it.
uniform vec4 fbrdfEye;     // homogeneous, in eye space
uniform vec4 fbrdfEmitted; // emission of the pass; alpha
#ifdef FBRDF_NORMAL_MAP
uniform sampler2D fbrdfNormalMap;  // 2 texel - 1: the normal in the tangent frame
#endif

void fbrdfShade(in vec3 position, in vec3 normal, in vec4 tangent, in float shadow, out vec4 colour)
{
    fbrdfIntegratedShadow = shadow;
    vec3 viewer = normalize(fbrdfEye.xyz - fbrdfEye.w * position);
    colour = vec4(fbrdfEmitted.rgb + fbrdfRadiance(position, normal, tangent, viewer), fbrdfEmitted.a);
}

#ifdef FBRDF_NORMAL_MAP
void fbrdfBump(inout vec3 normal, inout vec4 tangent, in vec2 coordinate)
{
#if __VERSION__ >= 130
    vec3 texel = texture(fbrdfNormalMap, coordinate).xyz;
#else
    vec3 texel = texture2D(fbrdfNormalMap, coordinate).xyz;
#endif
    FbrdfShadingFrame frame = fbrdfPerturbed(fbrdfShadingFrame(normal, tangent), 2.0 * texel - 1.0);
    tangent = vec4(frame.t, dot(cross(frame.n, frame.t), frame.s));
    normal = frame.n;
}
#endif

void fbrdfFinish(inout vec4 colour)
{
#ifdef FBRDF_TONE_MAP
    colour.rgb = fbrdfToneMapped(colour.rgb);
#endif
#ifdef FBRDF_SRGB
    colour.rgb = fbrdfSrgbFromLinear(min(colour.rgb, vec3(1.0)));
#endif
}
