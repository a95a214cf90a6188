// The one vertex shader of all passes: later passes test depth for equality, so every pass must compute gl_Position by
// the same expression, and invariantly.
invariant gl_Position;

FBRDF_ATTRIBUTE vec3 fbrdfVertex;
FBRDF_ATTRIBUTE vec3 fbrdfVertexNormal;
FBRDF_ATTRIBUTE vec3 fbrdfVertexTangent;

uniform mat4 fbrdfModelView;
uniform mat4 fbrdfProjection;
uniform mat3 fbrdfNormalMatrix;  // inverse transpose of the model-view matrix

// Eye space: float is finest near the eye, where it matters.
FBRDF_TO_FRAGMENT vec3 fbrdfPosition;
FBRDF_TO_FRAGMENT vec3 fbrdfNormal;
FBRDF_TO_FRAGMENT vec3 fbrdfTangent;

void main()
{
    vec4 position = fbrdfModelView * vec4(fbrdfVertex, 1.0);
    fbrdfPosition = position.xyz;
    fbrdfNormal = fbrdfNormalMatrix * fbrdfVertexNormal;
    fbrdfTangent = mat3(fbrdfModelView[0].xyz, fbrdfModelView[1].xyz, fbrdfModelView[2].xyz) * fbrdfVertexTangent;
    gl_Position = fbrdfProjection * position;
}
