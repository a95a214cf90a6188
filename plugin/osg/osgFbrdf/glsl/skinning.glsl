// The vertex hook that does what osgAnimation::RigTransformHardware needs: bones in twos in each attribute, as (number,
// weight, number, weight), where weights that are not needed are 0. A number is that of a matrix in the palette. OSG's
// uniform nbBonesPerVertex is unsigned, which GLSL 1.20 cannot read.
uniform mat4 matrixPalette[OSG_FBRDF_MATRICES];

vec3 osgFbrdfPosition, osgFbrdfNormal, osgFbrdfTangent;  // of the skinned vertex, so far

void osgFbrdfAddBone(vec2 bone, vec3 position, vec3 normal, vec3 tangent)
{
    mat4 moves = matrixPalette[int(bone.x)];
    mat3 turns = mat3(moves[0].xyz, moves[1].xyz, moves[2].xyz);
    osgFbrdfPosition += bone.y * (moves * vec4(position, 1.0)).xyz;
    osgFbrdfNormal += bone.y * (turns * normal);
    osgFbrdfTangent += bone.y * (turns * tangent);
}

void osgFbrdfAddBones(vec4 bones, vec3 position, vec3 normal, vec3 tangent)
{
    osgFbrdfAddBone(bones.xy, position, normal, tangent);
    osgFbrdfAddBone(bones.zw, position, normal, tangent);
}
