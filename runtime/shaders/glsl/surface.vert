// The one vertex shader of all passes: later passes test depth for equality, so every pass must compute gl_Position by
// the same expression, and invariantly. FBRDF_BUILT_INS: an engine hands matrices and arrays over in gl_*.
invariant gl_Position;

#ifdef FBRDF_BUILT_INS
#define fbrdfModelView gl_ModelViewMatrix
#define fbrdfProjection gl_ProjectionMatrix
#define fbrdfVertexNormal gl_Normal
#define FBRDF_VERTEX gl_Vertex
#else
#ifdef FBRDF_INSTANCED
// Four texels an instance: columns of its model-view matrix without the last row; the first ends with its material.
uniform samplerBuffer fbrdfInstances;
#else
uniform mat4 fbrdfModelView;
#endif
uniform mat4 fbrdfProjection;
FBRDF_ATTRIBUTE vec3 fbrdfVertex;
FBRDF_ATTRIBUTE vec3 fbrdfVertexNormal;
#define FBRDF_VERTEX vec4(fbrdfVertex, 1.0)
#endif
FBRDF_ATTRIBUTE vec4 fbrdfVertexTangent;  // and handedness; 1 where the array has three components
#if defined(FBRDF_DERIVED_TANGENT) || defined(FBRDF_NORMAL_MAP)
#ifdef FBRDF_BUILT_INS
#define fbrdfVertexTextureCoordinate gl_MultiTexCoord0.st
#else
FBRDF_ATTRIBUTE vec2 fbrdfVertexTextureCoordinate;
#endif
FBRDF_TO_FRAGMENT vec2 fbrdfTextureCoordinate;
#endif

// Eye space: float is finest near the eye, where it matters.
FBRDF_TO_FRAGMENT vec3 fbrdfPosition;
FBRDF_TO_FRAGMENT vec3 fbrdfNormal;
FBRDF_TO_FRAGMENT vec4 fbrdfTangent;
#ifdef FBRDF_INSTANCED
flat FBRDF_TO_FRAGMENT int fbrdfMaterial;
#endif

// A normal under the inverse transpose of m, by its cofactors. Not a matrix from the host: engines round theirs each in
// a way of its own, and near the terminator an ulp of a normal is seen.
vec3 fbrdfMovedNormal(mat3 m, vec3 n)
{
    vec3 yz = cross(m[1], m[2]), zx = cross(m[2], m[0]), xy = cross(m[0], m[1]);
    return (yz * n.x + zx * n.y + xy * n.z) / dot(m[0], yz);
}

void main()
{
#ifdef FBRDF_INSTANCED
    int first = 4 * gl_InstanceID;
    vec4 column = texelFetch(fbrdfInstances, first);
    fbrdfMaterial = int(column.w);
    mat4 fbrdfModelView =
        mat4(vec4(column.xyz, 0.0), vec4(texelFetch(fbrdfInstances, first + 1).xyz, 0.0),
             vec4(texelFetch(fbrdfInstances, first + 2).xyz, 0.0), vec4(texelFetch(fbrdfInstances, first + 3).xyz, 1.0));
#endif
    vec4 vertex = FBRDF_VERTEX, tangent = fbrdfVertexTangent;
    vec3 normal = fbrdfVertexNormal;
#ifdef FBRDF_VERTEX_HOOK
    fbrdfVertexHook(vertex.xyz, normal, tangent);
#endif
    vec4 position = fbrdfModelView * vertex;
    mat3 turn = mat3(fbrdfModelView[0].xyz, fbrdfModelView[1].xyz, fbrdfModelView[2].xyz);
    fbrdfPosition = position.xyz;
    fbrdfNormal = fbrdfMovedNormal(turn, normal);
    // A mirror turns the frame's hand.
    fbrdfTangent = vec4(turn * tangent.xyz, tangent.w * sign(dot(turn[0], cross(turn[1], turn[2]))));
#if defined(FBRDF_DERIVED_TANGENT) || defined(FBRDF_NORMAL_MAP)
    fbrdfTextureCoordinate = fbrdfVertexTextureCoordinate;
#endif
#ifdef FBRDF_BUILT_INS
    gl_ClipVertex = position;
#endif
    gl_Position = fbrdfProjection * position;
}
