// osg::State can replace OpenGL's built-in uniforms and attributes by its own. Then OSG rewrites
// vertex shaders and numbers attributes by itself.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

namespace fbrdf::test {
namespace {

// The same matrices reach the shader in another way.
constexpr double kSame = 1e-5;
// OSG's compact numbering puts the attribute of this unit where tangents are.
constexpr unsigned int kUnitAtTangents = 3;

class BuiltIns : public EffectTest {
protected:
    /// A mesh with tangents that matter, and with texture coordinates for the first `units` units.
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect(unsigned int units)
    {
        const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
        osg::Geometry& sphere = *effect->getChild(0)->asGeometry();
        osg::ref_ptr<osg::Vec2Array> coordinates =
            new osg::Vec2Array(sphere.getVertexArray()->getNumElements());
        for (unsigned int unit = 0; unit < units; ++unit)
            sphere.setTexCoordArray(unit, coordinates, osg::Array::BIND_PER_VERTEX);
        return effect;
    }

    void compare(bool uniforms, bool aliasing, unsigned int units)
    {
        compare(effect(units), runtimeImage(testMaterials()[0], sphereMesh(24), testLights(9)),
                uniforms, aliasing);
    }

    void compare(osgFbrdf::FactorizedBrdf* ball, const std::vector<float>& expected, bool uniforms,
                 bool aliasing)
    {
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(ball);
        root->addChild(osgLights(testLights(9)));
        view_.reset();  // a state of its own: programs are compiled for its settings
        const auto other = newContext();
        OsgView view(other->loader());
        osg::State& state = *view.viewer().getCamera()->getGraphicsContext()->getState();
        state.setUseModelViewAndProjectionUniforms(uniforms);
        state.setUseVertexAttributeAliasing(aliasing);
        view.setView(perspectiveView());
        view.setScene(root);
        const Notices notices;
        for (int technique = 0; technique < osgFbrdf::kDiffuseFallback; ++technique) {
            ball->selectTechnique(technique);
            const auto d = compareImages(view.frame(), expected);
            EXPECT_LT(d.maxRelative, kSame)
                << uniforms << aliasing << ", technique " << technique << ": " << describe(d);
            EXPECT_EQ(ball->lastReport().reason, "");
        }
        EXPECT_EQ(notices.text(), "");
    }
};

// Two look-ups make ten passes that match depth by EQUAL.
TEST_F(BuiltIns, OfOsgsStateGiveTheSamePicture)
{
    compare(true, false, 0);
}

TEST_F(BuiltIns, UnderOtherNumbersGiveTheSamePicture)
{
    compare(false, true, 0);
}

// Texture coordinates, which OSG numbers too, give the tangents here.
TEST_F(BuiltIns, ServeTangentsThatAreDerived)
{
    const auto ball = effect(1);
    auto& coordinates =
        static_cast<osg::Vec2Array&>(*ball->getChild(0)->asGeometry()->getTexCoordArray(0));
    for (unsigned int i = 0; i < coordinates.size(); ++i)
        coordinates[i].set(static_cast<float>(i % 49), static_cast<float>(i / 49));
    ball->setDerivedTangents(true);
    scene(ball, osgLights(testLights(9)));
    const auto expected = view_->frame();
    compare(ball, expected, true, true);
}

TEST_F(BuiltIns, DoNotTakeTheAttributeNumberOfTangents)
{
    static_assert(3 + kUnitAtTangents == osgFbrdf::kTangentAttribute,
                  "after position, normal and colour");
    compare(true, true, kUnitAtTangents + 1);
}

}  // namespace
}  // namespace fbrdf::test
