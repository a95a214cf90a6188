// The one vertex shader of all passes: later passes test depth for equality, so every pass must compute gl_Position by
// the same expression, and invariantly. One of the files inputs_*.glsl comes before it.
invariant gl_Position;

FBRDF_ATTRIBUTE vec4 fbrdfVertexTangent;  // w: handedness, which GL sets to 1 where the array has three components
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_TO_FRAGMENT vec2 fbrdfTextureCoordinate;
#endif

// Eye space: float is finest near the eye, where it matters.
FBRDF_TO_FRAGMENT vec3 fbrdfPosition;
FBRDF_TO_FRAGMENT vec3 fbrdfNormal;
FBRDF_TO_FRAGMENT vec4 fbrdfTangent;

// A normal under the inverse transpose of m, by its cofactors. The host's own normal matrix is not used: engines round
// theirs in different ways, and near the terminator an ulp of a normal is visible.
vec3 fbrdfMovedNormal(mat3 m, vec3 n)
{
    vec3 yz = cross(m[1], m[2]), zx = cross(m[2], m[0]), xy = cross(m[0], m[1]);
    return (yz * n.x + zx * n.y + xy * n.z) / dot(m[0], yz);
}

void main()
{
    mat4 modelView = fbrdfModelViewMatrix();
    vec4 vertex = FBRDF_VERTEX, tangent = fbrdfVertexTangent;
    vec3 normal = fbrdfVertexNormal;
#ifdef FBRDF_VERTEX_HOOK
    fbrdfVertexHook(vertex.xyz, normal, tangent);
#endif
    vec4 position = modelView * vertex;
    mat3 turn = mat3(modelView[0].xyz, modelView[1].xyz, modelView[2].xyz);
    fbrdfPosition = position.xyz;
    fbrdfNormal = fbrdfMovedNormal(turn, normal);
    // A matrix that mirrors changes the frame's handedness.
    fbrdfTangent = vec4(turn * tangent.xyz, tangent.w * sign(dot(turn[0], cross(turn[1], turn[2]))));
#ifdef FBRDF_TEXTURE_COORDINATE
    fbrdfTextureCoordinate = fbrdfVertexTextureCoordinate;
#endif
    FBRDF_CLIP(position)
    gl_Position = fbrdfProjection * position;
}
