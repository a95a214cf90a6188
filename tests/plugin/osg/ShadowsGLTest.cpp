// The effect under every technique of osgShadow. They cull the scene several times in a frame, by
// cameras of their own, and put programs and textures above it. The effect loses nothing but the
// light of the lamp where it turns away from it, and the floor gets the shadow that an ordinary
// sphere would cast. Shadows that fall on an effect: ShadowsReceivedGLTest.cpp.
#include "EffectTest.h"
#include "Pictures.h"
#include "ShadowTechniques.h"

#include "support/gl/Scenes.h"

#include <osg/LightSource>

namespace fbrdf::test {
namespace {

using Picture = std::vector<float>;

class Shadows : public EffectTest, public ::testing::WithParamInterface<ShadowKind> {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        lamp_->setPosition({0.8f, 0.5f, 1.2f, 0.0f});
        lamp_->setDiffuse({1.0f, 1.0f, 1.0f, 1.0f});
        lamp_->setAmbient({0.2f, 0.2f, 0.2f, 1.0f});
    }

    // osg::Identifier deadlocks where a cull visitor is deleted after the technique that knew it.
    void TearDown() override
    {
        EffectTest::TearDown();
        techniques_.clear();
    }

    /// The caster over the floor, with a shadow of the technique or without.
    Picture picture(osg::Node* caster, bool shadowed)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        if (shadowed) root = shadowedScene(GetParam(), techniques_);
        root->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
        root->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::ON);
        const osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
        source->setLight(lamp_);
        root->addChild(source);
        const osg::ref_ptr<osg::Node> floor =
            osg::createTexturedQuadGeometry({-4, -4, -1.5f}, {8, 0, 0}, {0, 8, 0});
        if (GetParam().dividesScene) {
            floor->setNodeMask(kReceives);
            caster->setNodeMask(kCasts);
        }
        root->addChild(floor);
        root->addChild(caster);
        view_->setScene(root);
        for (int frame = 0; frame < 2; ++frame) view_->frame();
        const Picture image = view_->frame();
        view_->setScene(nullptr);
        return image;
    }

    std::vector<osg::ref_ptr<osgShadow::ShadowTechnique>> techniques_;
    osg::ref_ptr<osg::Light> lamp_ = new osg::Light(0);
};

/// Pixels beside the object that a technique made darker.
double inShadow(const Picture& with, const Picture& without, const Picture& object, float shade)
{
    size_t count = 0;
    for (size_t i = 0; i < with.size(); i += 4)
        count += object[i + 3] == 0.0f && with[i] < shade * without[i] ? 1 : 0;
    return static_cast<double>(count);
}

struct Change {
    size_t darker = 0;  ///< by as much as the light of the lamp at most
    size_t other = 0;
};
/// Numbers of the object that a technique changed. unlit: the object without the lamp.
Change changeOf(const Picture& with, const Picture& without, const Picture& unlit,
                const Picture& object)
{
    Change change;
    for (size_t i = 0; i < with.size(); ++i) {
        const float slack = 1e-5f * std::abs(without[i]);
        if (object[i - i % 4 + 3] == 0.0f || std::abs(with[i] - without[i]) <= slack) continue;
        ++(with[i] < without[i] && with[i] > unlit[i] - slack ? change.darker : change.other);
    }
    return change;
}

struct Way {
    std::string name;
    int technique;
    bool surfaces;
    Picture without = {}, unlit = {};
};

TEST_P(Shadows, LeaveTheEffectWhatTheLampShinesOnAndDarkenTheFloor)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    // Most techniques draw back faces into their maps, of models that have these culled.
    effect->getChild(0)->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
    effect->addChild(osgLights(testLights(3)));
    scene(effect, nullptr);
    const Picture alone = view_->frame();
    std::vector<Way> ways{{"single", osgFbrdf::kSinglePass, false},
                          {"two", osgFbrdf::kTwoLookups, false},
                          {"surfaces", osgFbrdf::kTwoLookups, true}};
    const auto choose = [&](const Way& way) {
        effect->setFloatTarget(!way.surfaces);
        effect->selectTechnique(way.technique);
    };
    // This comes first, as some techniques leave lights behind in the context.
    for (Way& way : ways) {
        choose(way);
        way.without = picture(effect, false);
        lamp_->setDiffuse({0.0f, 0.0f, 0.0f, 1.0f});
        way.unlit = picture(effect, false);
        lamp_->setDiffuse({1.0f, 1.0f, 1.0f, 1.0f});
    }
    const auto onObject = static_cast<double>(
        std::count_if(alone.begin(), alone.end(), [](float v) { return v > 0.0f; }));
    const osg::ref_ptr<osg::Node> sphere = osgMesh(sphereMesh(24));
    const Picture sphereWithout = picture(sphere, false), sphereWith = picture(sphere, true);
    const double expected = inShadow(sphereWith, sphereWithout, alone, GetParam().shade);
    EXPECT_GT(expected, 50.0);
    const std::string name = std::string("shadow-") + GetParam().name + "-";
    keepPicture(sphereWith, kSize, name + "ordinary");
    for (const Way& way : ways) {
        choose(way);
        const Picture with = picture(effect, true);
        keepPicture(with, kSize, name + way.name);
        const Change change = changeOf(with, way.without, way.unlit, alone);
        EXPECT_EQ(change.other, 0u) << way.name;
        EXPECT_LT(static_cast<double>(change.darker), 0.12 * onObject) << way.name;
        EXPECT_NEAR(inShadow(with, way.without, alone, GetParam().shade), expected, 0.05 * expected)
            << way.name;
        EXPECT_EQ(effect->lastReport().reason, "");
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, Shadows, ::testing::ValuesIn(shadowKinds()),
                         [](const ::testing::TestParamInfo<ShadowKind>& kind) {
                             return std::string(kind.param.name);
                         });

}  // namespace
}  // namespace fbrdf::test
