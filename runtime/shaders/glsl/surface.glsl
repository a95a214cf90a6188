// The shaded point, in eye space, interpolated from what surface.vert wrote.
FBRDF_FROM_VERTEX vec3 fbrdfPosition;
FBRDF_FROM_VERTEX vec3 fbrdfNormal;
#ifdef FBRDF_INSTANCED
flat FBRDF_FROM_VERTEX int fbrdfMaterial;
#endif
#ifndef FBRDF_DERIVED_TANGENT
FBRDF_FROM_VERTEX vec4 fbrdfTangent;
#endif
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_FROM_VERTEX vec2 fbrdfTextureCoordinate;
#endif
#ifdef FBRDF_NORMAL_MAP
uniform sampler2D fbrdfNormalMap;  // 2 texel - 1: the normal in the tangent frame
#endif
FBRDF_COLOUR_OUTPUT

uniform vec4 fbrdfEye;  // homogeneous: a point (w = 1), or the direction to it (w = 0) for a parallel projection

// Unit, from the shaded point to the viewer.
vec3 fbrdfToViewer()
{
    return normalize(fbrdfEye.xyz - fbrdfEye.w * fbrdfPosition);
}

#ifdef FBRDF_DERIVED_TANGENT
// The tangent towards increasing s, by Cramer's rule from the differences to the neighbouring pixels, with the
// handedness of (s, t); 0 where (s, t) is constant.
vec4 fbrdfDerivedTangent()
{
    vec2 dx = dFdx(fbrdfTextureCoordinate), dy = dFdy(fbrdfTextureCoordinate);
    vec3 px = dFdx(fbrdfPosition), py = dFdy(fbrdfPosition);
    float facing = sign(dx.s * dy.t - dx.t * dy.s);
    vec3 alongS = facing * (px * dy.t - py * dx.t), alongT = facing * (py * dx.s - px * dy.s);
    return vec4(alongS, dot(cross(fbrdfNormal, alongS), alongT));
}
#define fbrdfTangent fbrdfDerivedTangent()
#endif
