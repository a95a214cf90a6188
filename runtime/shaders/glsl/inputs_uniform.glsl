// Vertex inputs of a program that draws one object: attributes, and matrices in uniforms.
uniform mat4 fbrdfModelView;
uniform mat4 fbrdfProjection;
FBRDF_ATTRIBUTE vec3 fbrdfVertex;
FBRDF_ATTRIBUTE vec3 fbrdfVertexNormal;
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_ATTRIBUTE vec2 fbrdfVertexTextureCoordinate;
#endif
#define FBRDF_VERTEX vec4(fbrdfVertex, 1.0)
#define FBRDF_CLIP(position)

mat4 fbrdfModelViewMatrix()
{
    return fbrdfModelView;
}
