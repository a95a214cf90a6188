// The shaded point, in eye space, as surface.vert left it.
FBRDF_FROM_VERTEX vec3 fbrdfPosition;
FBRDF_FROM_VERTEX vec3 fbrdfNormal;
FBRDF_FROM_VERTEX vec3 fbrdfTangent;
FBRDF_COLOUR_OUTPUT

uniform vec4 fbrdfEye;  // homogeneous: a point (w = 1), or the direction to it (w = 0) for a parallel projection

// Unit, from the shaded point to the viewer.
vec3 fbrdfToViewer()
{
    return normalize(fbrdfEye.xyz - fbrdfEye.w * fbrdfPosition);
}
