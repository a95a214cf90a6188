// The tint hook of the runtime: textures of the model, where the effect names their units.
#ifdef OSG_FBRDF_TINT
uniform sampler2D osgFbrdfTint;  // codes of sRGB
#endif
#ifdef OSG_FBRDF_ALPHA
uniform sampler2D osgFbrdfAlpha;
#endif

// IEC 61966-2-1:1999. Twin: linearFromSrgb in Srgb.h.
vec3 osgFbrdfLinearFromSrgb(vec3 codes)
{
    vec3 curve = pow((codes + 0.055) / 1.055, vec3(2.4));
    return mix(curve, codes / 12.92, vec3(lessThanEqual(codes, vec3(0.04045))));
}

vec4 fbrdfTint()
{
    vec4 tint = vec4(1.0);
#ifdef OSG_FBRDF_TINT
    tint = FBRDF_TEXTURE_MIPMAPPED(osgFbrdfTint, fbrdfTextureCoordinate);
    tint.rgb = osgFbrdfLinearFromSrgb(tint.rgb);
#endif
#ifdef OSG_FBRDF_ALPHA
    tint.a = FBRDF_TEXTURE_MIPMAPPED(osgFbrdfAlpha, fbrdfTextureCoordinate).r;
#endif
#if __VERSION__ == 120 || defined(GL_ARB_compatibility)
    tint.a *= gl_FrontMaterial.diffuse.a;
#endif
    return tint;
}
