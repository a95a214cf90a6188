// Vertex code of the host in all passes: instances, and the skinning of osgAnimation.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/Fog>
#include <osg/MatrixTransform>
#include <osgAnimation/RigGeometry>
#include <osgAnimation/RigTransformHardware>
#include <osgAnimation/RigTransformSoftware>
#include <osgAnimation/Skeleton>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// Vertices are moved before and not by the model-view matrix, which rounds differently.
constexpr float kMoved = 2e-3f;

class Hooked : public EffectTest {
protected:
    std::vector<float> picture(FactorizedBrdf* effect, int technique)
    {
        effect->selectTechnique(technique);
        return pictureOf(effect, lights_);
    }

    /// Pixels that differ by more than rounding are few: those at edges.
    static void expectAlike(const std::vector<float>& found, const std::vector<float>& expected,
                            const std::string& where)
    {
        ASSERT_EQ(found.size(), expected.size());
        size_t differ = 0, drawn = 0;
        for (size_t i = 0; i < found.size(); i += 4) {
            const float d = std::abs(found[i] - expected[i]);
            differ += d > kMoved * (1.0f + expected[i]) ? 1 : 0;
            drawn += expected[i + 3] > 0.0f ? 1 : 0;
        }
        EXPECT_GT(drawn, 300u) << where;
        EXPECT_LT(differ, drawn / 50) << where;
    }

    osg::ref_ptr<osgFbrdf::PointLights> lights_ = osgLights(testLights(9));
};

// A thousand instances are one draw; here there are four.
TEST_F(Hooked, InstancesLookAsUnderTransforms)
{
    const std::vector<osg::Vec3f> places{
        {-0.6f, -0.6f, 0}, {0.6f, -0.6f, 0}, {-0.6f, 0.6f, 0.3f}, {0.6f, 0.6f, -0.3f}};
    const auto cubes = osgMesh(sphereMesh(6));
    cubes->setUseDisplayList(false);
    cubes->getPrimitiveSet(0)->setNumInstances(static_cast<int>(places.size()));
    cubes->setInitialBound(osg::BoundingBox(-2, -2, -2, 2, 2, 2));
    const osg::ref_ptr<osg::Uniform> uniform =
        new osg::Uniform(osg::Uniform::FLOAT_VEC3, "places", static_cast<int>(places.size()));
    osg::ref_ptr<osg::Group> apart = new osg::Group;
    for (unsigned int i = 0; i < places.size(); ++i) {
        uniform->setElement(i, places[i]);
        const osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(places[i]));
        const auto mesh = osgMesh(sphereMesh(6));
        mesh->setInitialBound(osg::BoundingBox(-2, -2, -2, 2, 2, 2));
        place->addChild(mesh);
        apart->addChild(place);
    }
    cubes->getOrCreateStateSet()->addUniform(uniform);
    const auto instanced = effectOver(cubes, testMaterials()[0]),
               separate = effectOver(apart, testMaterials()[0]);
    instanced->setVertexHook(
        {"#if __VERSION__ < 140\n"
         "#extension GL_ARB_draw_instanced : require\n"
         "#define INSTANCE gl_InstanceIDARB\n"
         "#else\n"
         "#define INSTANCE gl_InstanceID\n"
         "#endif\n"
         "uniform vec3 places[4];\n"
         "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
         "{ position += places[INSTANCE]; }\n"});
    for (const bool isFoggy : {false, true}) {
        for (const auto& effect : {instanced, separate}) {
            const osg::ref_ptr<osg::Fog> fog = new osg::Fog;
            fog->setDensity(0.1f);
            if (isFoggy) effect->getOrCreateStateSet()->setAttributeAndModes(fog);
        }
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            const auto found = picture(instanced, technique);
            if (instanced->lastReport().technique == "diffuse fallback") GTEST_SKIP();
            expectAlike(found, picture(separate, technique),
                        std::to_string(technique) + (isFoggy ? " in fog" : ""));
        }
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

osg::ref_ptr<osgAnimation::Bone> bone(const std::string& name, float y, double angle)
{
    const osg::ref_ptr<osgAnimation::Bone> bone = new osgAnimation::Bone(name);
    bone->setDataVariance(osg::Object::DYNAMIC);
    bone->setInvBindMatrixInSkeletonSpace(
        osg::Matrix::translate(0.0, -static_cast<double>(y), 0.0));
    const osg::Matrix local = osg::Matrix::rotate(angle, 0.0, 0.0, 1.0) *
                              osg::Matrix::translate(0.0, static_cast<double>(y), 0.0);
    bone->setMatrix(local);
    bone->setMatrixInSkeletonSpace(local);
    return bone;
}

/// A bar along y, the upper half of which bends by 40 degrees about a bone in its middle.
osg::ref_ptr<osgAnimation::Skeleton> bentBar(osgAnimation::RigTransform* transform)
{
    gl::MeshData mesh = sphereMesh(12);
    for (Vec3f& p : mesh.positions) p = {0.35f * p.x, 1.1f * p.y, 0.35f * p.z};
    const osg::ref_ptr<osgAnimation::RigGeometry> rig = new osgAnimation::RigGeometry;
    rig->setSourceGeometry(osgMesh(mesh));
    rig->copyFrom(*rig->getSourceGeometry());
    rig->setDataVariance(osg::Object::DYNAMIC);
    rig->setUseDisplayList(false);
    const osg::ref_ptr<osgAnimation::VertexInfluenceMap> influences =
        new osgAnimation::VertexInfluenceMap;
    for (const char* name : {"root", "upper"}) (*influences)[name].setName(name);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const float upper = std::clamp(2.0f * mesh.positions[i].y + 0.5f, 0.0f, 1.0f);
        const auto index = static_cast<unsigned int>(i);
        if (upper < 1.0f) (*influences)["root"].emplace_back(index, 1.0f - upper);
        if (upper > 0.0f) (*influences)["upper"].emplace_back(index, upper);
    }
    rig->setInfluenceMap(influences);
    rig->setRigTransformImplementation(transform);
    const osg::ref_ptr<osgAnimation::Skeleton> skeleton = new osgAnimation::Skeleton;
    skeleton->setDefaultUpdateCallback();
    const auto root = bone("root", 0.0f, 0.0), upper = bone("upper", 0.0f, 0.7);
    root->addChild(upper);
    skeleton->addChild(root);
    skeleton->addChild(rig);
    return skeleton;
}

TEST_F(Hooked, SkinningInHardwareLooksAsInSoftware)
{
    const osg::ref_ptr<osgAnimation::RigTransformHardware> hardware =
        new osgAnimation::RigTransformHardware;
    // It wants a shader of its own, which the effect's programs replace.
    hardware->setShader(new osg::Shader(
        osg::Shader::VERTEX, "void main() { gl_Position = vec4(float(MAX_MATRIX)); }\n"));
    // Isotropic, as software skinning leaves tangents where they were.
    const Material material = calmMaterial(sumOf(formIo(), formIo()));
    const auto skinned = effectOver(bentBar(hardware), material),
               software = effectOver(bentBar(new osgAnimation::RigTransformSoftware), material);
    picture(skinned, 0);  // makes palette and attributes
    ASSERT_GT(hardware->getNumVertexAttrib(), 0u);
    skinned->setVertexHook(osgFbrdf::skinningHook(
        hardware->getMatrixPaletteUniform()->getNumElements(), hardware->getNumVertexAttrib()));
    for (int technique = 0; technique < kTechniqueCount; ++technique) {
        const auto expected = picture(software, technique);
        const auto found = picture(skinned, technique);
        if (skinned->lastReport().technique == "diffuse fallback") GTEST_SKIP();
        expectAlike(found, expected, std::to_string(technique));
    }
    skinned->setVertexHook({});
    EXPECT_GT(compareImages(picture(skinned, 0), picture(software, 0)).meanRelative, 0.05);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace fbrdf::test
