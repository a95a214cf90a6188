// Parts of a model with materials of their own: they look as if each were below an effect of its
// own.
#include "EffectTest.h"
#include "EnvironmentTest.h"
#include "PartNames.h"
#include "PartsTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"

#include <osg/BlendFunc>
#include <osg/Camera>
#include <osg/Fog>
#include <osg/LOD>
#include <osg/Switch>
#include <osgUtil/Optimizer>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::MaterialObject;

// Lights out of reach are left out object by object, so sums are rounded in another order.
constexpr double kSame = 1e-5;

TEST(PartNames, TheFirstNameOfTheInnermostNodeCounts)
{
    const std::vector<osgFbrdf::ModelPart> table{
        {"paint", new FactorizedBrdf}, {"rims", new FactorizedBrdf}, {"glass", new FactorizedBrdf}};
    const osgFbrdf::PartNames names(table);
    const auto node = [](const std::string& name, const std::string& state,
                         const std::string& material) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->setName(name);
        if (!state.empty()) group->getOrCreateStateSet()->setName(state);
        if (!material.empty()) group->getOrCreateStateSet()->setAttribute(osgMaterial(material));
        return group;
    };
    const auto partOf = [&](const osg::Group& inner, const osgFbrdf::PartPlace& above = {}) {
        return names.inside(inner, above).part;
    };
    EXPECT_EQ(partOf(*node("x", "y", "z")), osgFbrdf::kRest);
    EXPECT_EQ(partOf(*node("", "", "")), osgFbrdf::kRest);
    EXPECT_EQ(partOf(*node("glass", "", "")), 2);
    EXPECT_EQ(partOf(*node("glass", "rims", "")), 1);
    EXPECT_EQ(partOf(*node("glass", "rims", "paint")), 0);
    const auto byNode = names.inside(*node("glass", "", ""), {});
    EXPECT_EQ(partOf(*node("rims", "", ""), byNode), 1);
    EXPECT_EQ(partOf(*node("x", "", "rubber"), byNode), 2);
    // An osg::Material replaces that of above, as in OpenGL.
    const auto byMaterial = names.inside(*node("x", "", "paint"), byNode);
    EXPECT_EQ(byMaterial.part, 0);
    EXPECT_EQ(partOf(*node("x", "state", ""), byMaterial), 0);
    EXPECT_EQ(partOf(*node("x", "", "rubber"), byMaterial), 2);
    EXPECT_EQ(partOf(*node("x", "", "rubber"), names.inside(*node("", "", "paint"), {})),
              osgFbrdf::kRest);
}

class Parts : public EffectTest {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        for (const size_t i : {0u, 2u, 4u})
            materials_.emplace_back(
                new MaterialObject(withLobes(testMaterials()[i], testLobes(LobeAxes::tilted, 2))));
        lights_->addChild(osgLights(testLights(9)));
    }

    /// An effect over the model with a material for each of its named parts.
    osg::ref_ptr<FactorizedBrdf> effectOver(osg::Node* model) const
    {
        osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        effect->setFloatTarget(true);
        for (size_t i = 0; i < kPartNames.size(); ++i)
            effect->setPartMaterial(kPartNames[i], materials_[i]);
        effect->addChild(model);
        return effect;
    }

    /// The balls with an effect each, but for the last.
    osg::ref_ptr<osg::Group> apart(const FactorizedBrdf& properties) const
    {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        for (size_t i = 0; i < kBalls; ++i) {
            osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
            effect->setFloatTarget(properties.getFloatTarget());
            effect->setTransfer(properties.getTransfer());
            effect->selectTechnique(properties.getSelectedTechnique());
            if (i >= materials_.size()) {
                group->addChild(ball(i));
                continue;
            }
            effect->setMaterial(materials_[i]);
            effect->addChild(ball(i));
            group->addChild(effect);
        }
        return group;
    }

    std::vector<float> picture(osg::Node* node) { return pictureOf(node, lights_); }

    std::vector<osg::ref_ptr<MaterialObject>> materials_;
    osg::ref_ptr<osg::Group> lights_ = new osg::Group;
};

TEST_F(Parts, LookAsUnderEffectsOfTheirOwn)
{
    if (filtersCoarsely()) GTEST_SKIP() << "look-ups are too coarse to compare";
    lights_->addChild(uprightFor(osgEnvironment(testPanorama(16))));
    const auto effect = effectOver(fourBalls());
    const Notices notices;
    for (const bool isFloat : {true, false})
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            effect->setFloatTarget(isFloat);
            effect->selectTechnique(technique);
            const auto expected = picture(apart(*effect)), found = picture(effect);
            const auto d = compareImages(found, expected);
            EXPECT_LT(d.maxRelative, kSame)
                << "technique " << technique << ", float target " << isFloat << ": " << describe(d);
            EXPECT_GT(meanOf(found, 3), 0.3);
            for (const FactorizedBrdf* part : effect->effectsOfParts()) {
                EXPECT_EQ(part->lastReport().technique,
                          kTechniques[static_cast<size_t>(technique)].title);
                EXPECT_EQ(part->lastReport().reason, "");
                EXPECT_EQ(part->lastReport().whyNoEnvironment, "");
            }
        }
    EXPECT_EQ(notices.text(), "");
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// The tester: one material for another must not pass.
TEST_F(Parts, AreNotAlike)
{
    const auto effect = effectOver(fourBalls());
    const auto expected = picture(effect);
    effect->setPartMaterial("rims", materials_[0]);
    EXPECT_GT(compareImages(picture(effect), expected).maxRelative, 0.1);
}

TEST_F(Parts, FollowTheTransferAndFogOfAll)
{
    const auto effect = effectOver(fourBalls());
    effect->setTransfer(Transfer::toneMap);
    effect->setFloatTarget(false);
    for (const auto& part : effect->getParts()) {
        EXPECT_EQ(part.effect->getTransfer(), Transfer::toneMap);
        EXPECT_FALSE(part.effect->getFloatTarget());
    }
    const osg::ref_ptr<osg::StateSet> foggy = new osg::StateSet;
    const osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setDensity(0.1f);
    foggy->setAttributeAndModes(fog);
    effect->setStateSet(foggy);
    for (const int technique : {0, 2}) {
        effect->selectTechnique(technique);
        const auto expected = apart(*effect);
        expected->setStateSet(foggy);
        const auto d = compareImages(picture(effect), picture(expected));
        EXPECT_LT(d.maxRelative, kSame) << describe(d);
    }
}

TEST_F(Parts, OfOneMaterialShareAnEffect)
{
    const auto effect = effectOver(fourBalls());
    EXPECT_EQ(effect->effectsOfParts().size(), 3u);
    effect->setPartMaterial("rims", materials_[0]);
    EXPECT_EQ(effect->getParts().size(), 3u);
    EXPECT_EQ(effect->effectsOfParts().size(), 2u);
    effect->setPart("paint", nullptr);
    ASSERT_EQ(effect->getParts().size(), 2u);
    EXPECT_EQ(effect->getParts()[0].name, "glass");
}

// The one that has no name of the table has the material of the effect where there is one.
TEST_F(Parts, LeaveTheRestToTheEffectAbove)
{
    if (filtersCoarsely()) GTEST_SKIP() << "look-ups are too coarse to compare";
    const auto effect = effectOver(fourBalls());
    effect->setMaterial(materials_[0]);
    for (int technique = 0; technique < kTechniqueCount; ++technique) {
        effect->selectTechnique(technique);
        const auto expected = apart(*effect);
        osg::ref_ptr<FactorizedBrdf> last = new FactorizedBrdf;
        last->setFloatTarget(true);
        last->selectTechnique(technique);
        last->setMaterial(materials_[0]);
        last->addChild(ball(3));
        expected->setChild(3, last);
        const auto d = compareImages(picture(effect), picture(expected));
        EXPECT_LT(d.maxRelative, kSame) << "technique " << technique << ": " << describe(d);
    }
}

/// Counts how often a node is culled.
struct CullCounter : public osg::NodeCallback {
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        ++count;
        traverse(node, visitor);
    }
    int count = 0;
};

TEST_F(Parts, AreTraversedOnceForEachPass)
{
    const auto model = fourBalls();
    const osg::ref_ptr<CullCounter> counter = new CullCounter;
    model->setCullCallback(counter);
    const auto effect = effectOver(model);
    for (const int technique : {0, 2}) {
        effect->selectTechnique(technique);
        picture(effect);
        int most = 0;
        for (const auto* part : effect->effectsOfParts())
            most = std::max(most, part->lastReport().passes);
        counter->count = 0;
        view_->frame();
        EXPECT_EQ(counter->count, most) << technique;
    }
}

// What is transparent in the model comes after all parts, and is sorted with the scene.
TEST_F(Parts, LeaveWhatIsTransparentInItsBin)
{
    const auto model = fourBalls();
    osg::ref_ptr<osg::Geometry> pane =
        osg::createTexturedQuadGeometry({-2, -2, 1.5f}, {4, 0, 0}, {0, 4, 0});
    const osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
    (*colour)[0] = {0.0f, 0.0f, 0.0f, 0.75f};
    pane->setColorArray(colour);
    auto* state = pane->getOrCreateStateSet();
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    const auto effect = effectOver(model);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    const auto without = picture(effect);
    model->insertChild(0, pane);
    const auto behind = picture(effect);
    for (size_t i = 0; i < behind.size(); i += 4)
        ASSERT_NEAR(behind[i], 0.25f * without[i], 1e-4f * (1.0f + without[i])) << i;
}

TEST_F(Parts, StandBelowSwitchesLevelsOfDetailAndInside)
{
    const auto effect = effectOver(fourBalls());
    const auto expected = picture(effect);
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(fourBalls(), true);
    choice->addChild(ball(0), false);
    osg::ref_ptr<osg::LOD> levels = new osg::LOD;
    levels->addChild(choice, 0.0f, 100.0f);
    levels->addChild(ball(1), 100.0f, 1000.0f);
    EXPECT_EQ(picture(effectOver(levels)), expected);
    // Within another part, which ends there.
    osg::ref_ptr<osg::Group> named = new osg::Group;
    named->setName("rims");
    named->addChild(ball(0));
    named->addChild(ball(1));
    named->addChild(ball(2));
    osg::ref_ptr<osg::Group> both = new osg::Group;
    both->addChild(named);
    both->addChild(ball(3));
    EXPECT_EQ(picture(effectOver(both)), expected);
}

TEST_F(Parts, WorkWithComputedNearAndFar)
{
    view_->viewer().getCamera()->setComputeNearFarMode(
        osg::CullSettings::COMPUTE_NEAR_FAR_USING_PRIMITIVES);
    const auto effect = effectOver(fourBalls());
    const auto found = picture(effect);
    const auto d = compareImages(found, picture(apart(*effect)));
    EXPECT_LT(d.maxRelative, kSame) << describe(d);
    EXPECT_GT(meanOf(found, 3), 0.3);
}

// Cameras below are drawn once, as they say.
TEST_F(Parts, LeaveCamerasBelowToThemselves)
{
    osg::ref_ptr<osg::Camera> inset = new osg::Camera;
    inset->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    inset->setRenderOrder(osg::Camera::POST_RENDER);
    inset->setClearMask(GL_DEPTH_BUFFER_BIT);
    inset->setViewport(0, 0, 16, 16);
    osg::ref_ptr<osg::Group> named = new osg::Group;
    named->setName("glass");
    named->addChild(osg::createTexturedQuadGeometry({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    inset->addChild(named);
    inset->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    const auto effect = effectOver(fourBalls());
    for (const int technique : {0, 2}) {
        effect->selectTechnique(technique);
        effect->removeChild(inset);
        const auto without = picture(effect);
        effect->addChild(inset);
        const auto with = picture(effect);
        for (size_t i = 0; i < with.size(); i += 4)
            if (i / 4 % kSize < 16 && i / 4 / kSize < 16)
                ASSERT_EQ(with[i], 1.0f) << i;
            else
                ASSERT_EQ(with[i], without[i]) << i;
    }
}

TEST_F(Parts, SurviveTheOptimizer)
{
    // State sets that differ in their names alone would become one.
    osg::ref_ptr<osg::Group> model = new osg::Group;
    for (size_t i = 0; i < kPartNames.size(); ++i) {
        const auto single = ball(i);
        single->setStateSet(nullptr);
        single->setName("");
        single->getChild(0)->getOrCreateStateSet()->setAttribute(osgMaterial(kPartNames[i]));
        model->addChild(single);
    }
    const auto effect = effectOver(model);
    osg::ref_ptr<osg::MatrixTransform> above =
        new osg::MatrixTransform(osg::Matrixd::rotate(0.3, 0.0, 1.0, 0.0));
    above->addChild(effect);
    const auto expected = picture(above);
    osgUtil::Optimizer().optimize(above, osgUtil::Optimizer::ALL_OPTIMIZATIONS);
    EXPECT_EQ(picture(above), expected);
}

TEST_F(Parts, AreCopiedWithTheEffect)
{
    const auto effect = effectOver(fourBalls());
    const auto expected = picture(effect);
    const osg::ref_ptr<FactorizedBrdf> shallow = osg::clone(effect.get());
    EXPECT_EQ(shallow->getParts()[1].effect, effect->getParts()[1].effect);
    EXPECT_EQ(picture(shallow), expected);
    const osg::ref_ptr<FactorizedBrdf> deep =
        osg::clone(effect.get(), osg::CopyOp::DEEP_COPY_NODES);
    EXPECT_NE(deep->getParts()[1].effect, effect->getParts()[1].effect);
    EXPECT_EQ(picture(deep), expected);
}

size_t linesIn(const std::string& text)
{
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(Parts, WithoutTheirMaterialHaveTheFallbackAndOneLine)
{
    lights_->setChild(0, osgLights(testLights(8)));  // as many as the fallback has
    const auto effect = effectOver(fourBalls());
    const auto before = picture(effect);
    const Notices notices;
    EXPECT_FALSE(effect->setPartMaterialFile("rims", "gone.fbrdf"));
    const auto after = picture(effect);
    EXPECT_EQ(linesIn(notices.text()), 1u) << notices.text();
    EXPECT_NE(notices.text().find("'rims', gone.fbrdf: "), std::string::npos) << notices.text();
    ASSERT_EQ(effect->getParts().back().name, "rims");
    EXPECT_EQ(effect->getParts().back().effect->lastReport().technique, "diffuse fallback");
    EXPECT_EQ(effect->lastReport().technique, "the model's own state");
    size_t changed = 0;
    for (size_t i = 0; i < before.size(); i += 4) {
        const size_t x = i / 4 % kSize, y = i / 4 / kSize;
        if (x >= kSize / 2 && y < kSize / 2)
            changed += before[i] != after[i] ? 1 : 0;  // the ball of the rims
        else
            ASSERT_EQ(before[i], after[i]) << x << ", " << y;
        ASSERT_EQ(before[i + 3] > 0.0f, after[i + 3] > 0.0f) << x << ", " << y;
    }
    EXPECT_GT(changed, 100u);
}

TEST_F(Parts, ThatTheModelHasNotGiveOneLineEach)
{
    const auto effect = effectOver(fourBalls());
    const auto expected = picture(effect);
    const Notices notices;
    effect->setPartMaterial("seats", materials_[1]);
    effect->setPartMaterial("rubber", materials_[1]);
    effect->setPart("rubber", nullptr);
    EXPECT_EQ(picture(effect), expected);
    picture(effect);
    EXPECT_EQ(linesIn(notices.text()), 1u) << notices.text();
    EXPECT_NE(notices.text().find("'seats': found no part of that name"), std::string::npos)
        << notices.text();
}

TEST_F(Parts, ComeBackAfterTheirGlObjectsAreReleased)
{
    const auto effect = effectOver(fourBalls());
    const auto expected = picture(effect);
    effect->releaseGLObjects(view_->viewer().getCamera()->getGraphicsContext()->getState());
    EXPECT_EQ(view_->frame(), expected);
}

}  // namespace
}  // namespace fbrdf::test
