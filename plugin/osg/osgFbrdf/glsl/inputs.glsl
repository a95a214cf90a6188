// Vertex inputs where osg::State hands matrices and arrays over by uniforms and attributes of its own. Compatibility
// profiles still clip in eye space.
uniform mat4 osg_ModelViewMatrix;
uniform mat4 osg_ProjectionMatrix;
FBRDF_ATTRIBUTE vec4 osg_Vertex;
FBRDF_ATTRIBUTE vec3 osg_Normal;
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_ATTRIBUTE vec4 osg_MultiTexCoord0;
#define fbrdfVertexTextureCoordinate osg_MultiTexCoord0.st
#endif
#define fbrdfProjection osg_ProjectionMatrix
#define fbrdfVertexNormal osg_Normal
#define FBRDF_VERTEX osg_Vertex
#ifdef GL_ARB_compatibility
#define FBRDF_CLIP(position) gl_ClipVertex = position;
#else
#define FBRDF_CLIP(position)
#endif

mat4 fbrdfModelViewMatrix()
{
    return osg_ModelViewMatrix;
}
