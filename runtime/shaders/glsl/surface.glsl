// The shaded point, in eye space, as surface.vert left it.
FBRDF_FROM_VERTEX vec3 fbrdfPosition;
FBRDF_FROM_VERTEX vec3 fbrdfNormal;
#ifdef FBRDF_INSTANCED
flat FBRDF_FROM_VERTEX int fbrdfMaterial;
#endif
#ifndef FBRDF_DERIVED_TANGENT
FBRDF_FROM_VERTEX vec3 fbrdfTangent;
#endif
FBRDF_COLOUR_OUTPUT

uniform vec4 fbrdfEye;  // homogeneous: a point (w = 1), or the direction to it (w = 0) for a parallel projection

// Unit, from the shaded point to the viewer.
vec3 fbrdfToViewer()
{
    return normalize(fbrdfEye.xyz - fbrdfEye.w * fbrdfPosition);
}

#ifdef FBRDF_DERIVED_TANGENT
FBRDF_FROM_VERTEX vec2 fbrdfTextureCoordinate;

// Towards increasing s, by Cramer's rule from the differences to the neighbouring pixels; 0 where (s, t) is constant.
vec3 fbrdfDerivedTangent()
{
    vec2 dx = dFdx(fbrdfTextureCoordinate), dy = dFdy(fbrdfTextureCoordinate);
    return sign(dx.s * dy.t - dx.t * dy.s) * (dFdx(fbrdfPosition) * dy.t - dFdy(fbrdfPosition) * dx.t);
}
#define fbrdfTangent fbrdfDerivedTangent()
#endif
