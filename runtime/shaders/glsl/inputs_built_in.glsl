// Vertex inputs of an engine that hands matrices and arrays over in the gl_* of GLSL 1.20, and clips in eye space.
#define fbrdfProjection gl_ProjectionMatrix
#define fbrdfVertexNormal gl_Normal
#define fbrdfVertexTextureCoordinate gl_MultiTexCoord0.st
#define FBRDF_VERTEX gl_Vertex
#define FBRDF_CLIP(position) gl_ClipVertex = position;

mat4 fbrdfModelViewMatrix()
{
    return gl_ModelViewMatrix;
}
