// Vertex shader: the surface in eye space. Other states (skinning, instancing) have moved vertex, normal and tangent
// before, in object space.

// A normal under the inverse transpose of m, by its cofactors, as the runtime does it (surface.vert).
vec3 fbrdfMovedNormal(mat3 m, vec3 n)
{
    vec3 yz = cross(m[1], m[2]), zx = cross(m[2], m[0]), xy = cross(m[0], m[1]);
    return (yz * n.x + zx * n.y + xy * n.z) / dot(m[0], yz);
}

void fbrdfSurface(in mat4 worldView, in vec4 vertex, in vec3 normal, out vec3 eyePosition, out vec3 eyeNormal)
{
    eyePosition = (worldView * vertex).xyz;
    eyeNormal = fbrdfMovedNormal(mat3(worldView[0].xyz, worldView[1].xyz, worldView[2].xyz), normal);
}

// tangent.w: handedness, which GL sets to 1 where the array has three components. A matrix that mirrors changes it.
void fbrdfTangentFrame(in mat4 worldView, in vec4 tangent, out vec4 eyeTangent)
{
    mat3 turn = mat3(worldView[0].xyz, worldView[1].xyz, worldView[2].xyz);
    eyeTangent = vec4(turn * tangent.xyz, tangent.w * sign(dot(turn[0], cross(turn[1], turn[2]))));
}
