// Vertex inputs of an instanced program. Four texels hold an instance: the columns of its model-view matrix without the
// last row; the first column ends with the number of the material.
uniform samplerBuffer fbrdfInstances;
uniform mat4 fbrdfProjection;
FBRDF_ATTRIBUTE vec3 fbrdfVertex;
FBRDF_ATTRIBUTE vec3 fbrdfVertexNormal;
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_ATTRIBUTE vec2 fbrdfVertexTextureCoordinate;
#endif
flat FBRDF_TO_FRAGMENT int fbrdfMaterial;
#define FBRDF_VERTEX vec4(fbrdfVertex, 1.0)
#define FBRDF_CLIP(position)

// This also passes the material on.
mat4 fbrdfModelViewMatrix()
{
    int first = 4 * gl_InstanceID;
    vec4 column = texelFetch(fbrdfInstances, first);
    fbrdfMaterial = int(column.w);
    return mat4(vec4(column.xyz, 0.0), vec4(texelFetch(fbrdfInstances, first + 1).xyz, 0.0),
                vec4(texelFetch(fbrdfInstances, first + 2).xyz, 0.0), vec4(texelFetch(fbrdfInstances, first + 3).xyz, 1.0));
}
