#version 120
// The one vertex shader of all passes in OpenSceneGraph, which hands matrices and arrays over in gl_*. Its outputs are
// those of the runtime's surface.vert. Later passes test depth for equality: one expression for gl_Position.
invariant gl_Position;

attribute vec3 fbrdfVertexTangent;

varying vec3 fbrdfPosition;
varying vec3 fbrdfNormal;
varying vec3 fbrdfTangent;

void main()
{
    vec4 position = gl_ModelViewMatrix * gl_Vertex;
    fbrdfPosition = position.xyz;
    fbrdfNormal = gl_NormalMatrix * gl_Normal;
    fbrdfTangent =
        mat3(gl_ModelViewMatrix[0].xyz, gl_ModelViewMatrix[1].xyz, gl_ModelViewMatrix[2].xyz) * fbrdfVertexTangent;
    gl_ClipVertex = position;
    gl_Position = gl_ProjectionMatrix * position;
}
