// The vertex hook that does what osgAnimation::RigTransformHardware needs: bones in twos in each attribute, as (number,
// weight, number, weight). A number is that of a matrix in the palette.
uniform mat4 matrixPalette[OSG_FBRDF_MATRICES];
uniform int nbBonesPerVertex;

vec3 osgFbrdfPosition, osgFbrdfNormal, osgFbrdfTangent;  // of the skinned vertex, so far

void osgFbrdfAddBone(vec2 bone, vec3 position, vec3 normal, vec3 tangent)
{
    mat4 moves = matrixPalette[int(bone.x)];
    mat3 turns = mat3(moves[0].xyz, moves[1].xyz, moves[2].xyz);
    osgFbrdfPosition += bone.y * (moves * vec4(position, 1.0)).xyz;
    osgFbrdfNormal += bone.y * (turns * normal);
    osgFbrdfTangent += bone.y * (turns * tangent);
}

void osgFbrdfAddBones(vec4 bones, int first, vec3 position, vec3 normal, vec3 tangent)
{
    if (first < nbBonesPerVertex) osgFbrdfAddBone(bones.xy, position, normal, tangent);
    if (first + 1 < nbBonesPerVertex) osgFbrdfAddBone(bones.zw, position, normal, tangent);
}
