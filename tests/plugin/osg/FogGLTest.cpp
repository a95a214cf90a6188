// Fog over the effect equals OpenGL's fog over an ordinary object beside it.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/Fog>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// OpenGL's own fog interpolates the distance, ours the position.
constexpr double kAgainstOpenGl = 1e-4;
const osg::Vec4f kColour{0.5f, 0.25f, 1.0f, 1.0f};

class Fog : public EffectTest {
protected:
    osg::ref_ptr<osg::Fog> fog_ = new osg::Fog;

    void SetUp() override
    {
        EffectTest::SetUp();
        fog_->setStart(2.0f);
        fog_->setEnd(5.0f);
        fog_->setDensity(0.2f);
        fog_->setColor(kColour);
    }

    std::vector<float> inFog(osg::Node* node, bool isOn = true)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->getOrCreateStateSet()->setAttributeAndModes(fog_, isOn);
        root->addChild(node);
        root->addChild(osgLights(testLights(9)));
        view_->setScene(root);
        view_->frame();
        return view_->frame();
    }

    /// The share of the object that comes through the fog, as OpenGL itself computes it: of a white
    /// sphere without light in black fog.
    std::vector<float> through()
    {
        osg::ref_ptr<osg::Geometry> white = osgMesh(sphereMesh(24));
        osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array;
        colour->push_back({1.0f, 1.0f, 1.0f, 1.0f});
        white->setColorArray(colour, osg::Array::BIND_OVERALL);
        white->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        fog_->setColor({0.0f, 0.0f, 0.0f, 1.0f});
        const auto image = inFog(white);
        fog_->setColor(kColour);
        return image;
    }

    static std::vector<float> blended(std::vector<float> image, const std::vector<float>& through)
    {
        for (size_t i = 0; i < image.size(); ++i)
            if (i % 4 != 3 && image[i - i % 4 + 3] > 0.0f)
                image[i] = image[i] * through[i] +
                           kColour[static_cast<unsigned int>(i % 4)] * (1.0f - through[i]);
        return image;
    }
};

TEST_F(Fog, IsThatOfOpenGlInEveryModeAndTechnique)
{
    for (const auto mode : {osg::Fog::LINEAR, osg::Fog::EXP, osg::Fog::EXP2}) {
        fog_->setMode(mode);
        const auto through = this->through();
        EXPECT_GT(meanOf(through, 0), 0.05);
        for (const size_t material : {size_t(0), size_t(2), size_t(4)})
            for (const int technique : {osgFbrdf::kSinglePass, osgFbrdf::kTwoLookups})
                for (const bool floatTarget : {true, false}) {
                    const auto effect = osgEffect(testMaterials()[material], sphereMesh(24));
                    effect->selectTechnique(technique);
                    effect->setFloatTarget(floatTarget);
                    effect->setTransfer(floatTarget ? Transfer::linear : Transfer::toneMap);
                    const auto clear = inFog(effect, false);
                    const int passes = effect->lastReport().passes;
                    const auto d = compareImages(inFog(effect), blended(clear, through));
                    EXPECT_LT(d.maxRelative, kAgainstOpenGl)
                        << "mode " << mode << ", material " << material << ", technique "
                        << technique << ": " << describe(d);
                    EXPECT_EQ(effect->lastReport().passes, passes + 1);
                    EXPECT_EQ(effect->lastReport().reason, "");
                }
    }
}

TEST_F(Fog, OfAnotherDensityIsNoticed)
{
    fog_->setMode(osg::Fog::EXP);
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    const auto clear = inFog(effect, false);
    const auto through = this->through();
    fog_->setDensity(0.21f);
    EXPECT_GT(compareImages(inFog(effect), blended(clear, through)).maxRelative,
              10.0 * kAgainstOpenGl);
}

TEST_F(Fog, FollowsOverridesAsOpenSceneGraphHasThem)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    const auto clear = inFog(effect, false), foggy = inFog(effect);
    EXPECT_NE(clear, foggy);
    // The effect turns fog off, unless a state above overrides it.
    effect->getOrCreateStateSet()->setMode(GL_FOG, osg::StateAttribute::OFF);
    EXPECT_EQ(inFog(effect), clear);
    EXPECT_EQ(inFog(effect, true), clear);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->getOrCreateStateSet()->setAttributeAndModes(
        fog_, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    root->addChild(effect);
    root->addChild(osgLights(testLights(9)));
    view_->setScene(root);
    EXPECT_EQ(view_->frame(), foggy);
    effect->getOrCreateStateSet()->setMode(
        GL_FOG, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    EXPECT_EQ(view_->frame(), clear);
}

// Off the axis the eye is further than the plane through it.
TEST_F(Fog, RadialFogIsThickerOffTheAxis)
{
    fog_->setMode(osg::Fog::LINEAR);
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->setExposure(0.0f);
    const auto planar = inFog(effect);
    fog_->setUseRadialFog(true);
    const auto radial = inFog(effect);
    EXPECT_GT(meanOf(radial, 2), 1.001 * meanOf(planar, 2));
    const size_t centre = 4 * (kSize / 2 * kSize + kSize / 2);
    EXPECT_NEAR(radial[centre + 2], planar[centre + 2], 0.05f * planar[centre + 2]);
}

}  // namespace
}  // namespace fbrdf::test
