// The effect works with what real scenes have: shadows, fog, levels of detail, several views,
// shared state, and contexts that draw by other techniques.
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>

#include <osg/LightSource>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/PagedLOD>
#include <osg/Switch>
#include <osgDB/WriteFile>
#include <osgFX/Registry>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ShadowMap>
#include <osgViewer/CompositeViewer>

#include <cstdlib>
#include <utility>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

constexpr double kSame = 1e-6;

/// Pixels any of whose numbers are further apart than 0.1 %.
size_t pixelsThatDiffer(const std::vector<float>& a, const std::vector<float>& b)
{
    size_t count = 0;
    for (size_t i = 0; i < a.size(); i += 4) {
        bool differs = false;
        for (size_t c = i; c < i + 4; ++c)
            differs |= std::abs(a[c] - b[c]) > 1e-3f * std::max(std::abs(a[c]), std::abs(b[c]));
        count += differs ? 1 : 0;
    }
    return count;
}

class RealScenes : public EffectTest {
protected:
    osg::ref_ptr<FactorizedBrdf> effect_;
    osg::ref_ptr<osgFbrdf::PointLights> lights_;
    std::vector<float> alone_;

    void SetUp() override
    {
        EffectTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        effect_ = osgEffect(testMaterials()[0], sphereMesh(24));
        lights_ = osgLights(testLights(9));
        scene(effect_, lights_);
        alone_ = view_->frame();
        EXPECT_GT(meanOf(alone_, 3), 0.3);
    }

    /// The image of a scene of `node` and the lights.
    std::vector<float> beside(osg::Node* node) { return pictureOf(node, lights_); }
};

TEST_F(RealScenes, FixedFunctionStateAboveDoesNotReachIt)
{
    osg::ref_ptr<osg::Group> above = new osg::Group;
    above->getOrCreateStateSet()->setMode(GL_BLEND, osg::StateAttribute::ON);
    above->getOrCreateStateSet()->setMode(GL_ALPHA_TEST, osg::StateAttribute::ON);
    above->getOrCreateStateSet()->setMode(GL_TEXTURE_2D, osg::StateAttribute::ON);
    above->addChild(effect_);
    EXPECT_EQ(beside(above), alone_);
}

// Its shadow map is drawn by a camera of its own, without the lights: the effect must be in it, and
// unharmed by the state that the technique puts above.
TEST_F(RealScenes, CastsShadowsInOsgShadow)
{
    osg::ref_ptr<osg::Light> lamp = new osg::Light(0);
    lamp->setPosition({0.0f, 0.0f, 6.0f, 1.0f});
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(lamp);
    osg::ref_ptr<osg::Geometry> floor =
        osg::createTexturedQuadGeometry({-4, -4, -1.5f}, {8, 0, 0}, {0, 8, 0});
    osg::ref_ptr<osg::Group> plain = new osg::Group,
                             shadowed = new osgShadow::ShadowedScene(new osgShadow::ShadowMap);
    for (const auto& group : {plain, shadowed}) {
        group->addChild(source);
        group->addChild(floor);
        group->addChild(effect_);
    }
    const auto without = beside(plain), with = beside(shadowed);
    size_t inShadow = 0, changed = 0;
    for (size_t i = 0; i < with.size(); i += 4) {
        // What the lamp shines on is as bright as before.
        if (alone_[i + 3] > 0.0f)
            changed += std::abs(with[i] - without[i]) > 1e-5f * without[i] ? 1 : 0;
        else
            inShadow += with[i] < 0.9f * without[i] ? 1 : 0;
    }
    EXPECT_GT(inShadow, 50u);
    EXPECT_LT(changed, 120u);
}

// OpenGL has one set of lights for all objects: the light of the view stays as it is.
TEST_F(RealScenes, TheFallbackLeavesOthersTheirHeadlight)
{
    view_->viewer().setLightingMode(osg::View::HEADLIGHT);
    osg::ref_ptr<osg::Geometry> wall =
        osg::createTexturedQuadGeometry({-4, -4, -1.5f}, {8, 0, 0}, {0, 8, 0});
    const auto expected = beside(wall);
    effect_->selectTechnique(osgFbrdf::kDiffuseFallback);
    osg::ref_ptr<osg::Group> both = new osg::Group;
    both->addChild(effect_);
    both->addChild(wall);
    const auto found = beside(both);
    size_t compared = 0;
    for (size_t i = 0; i < found.size(); i += 4)
        if (alone_[i + 3] == 0.0f) {
            EXPECT_EQ(found[i + 1], expected[i + 1]) << i;
            ++compared;
        }
    EXPECT_GT(compared, 100u);
    EXPECT_GT(meanOf(expected, 1), 0.1);
    EXPECT_EQ(effect_->lastReport().lightsUsed, 7);
}

TEST_F(RealScenes, StandsBelowLevelsOfDetailAndSwitches)
{
    osg::ref_ptr<osg::LOD> levels = new osg::LOD;
    levels->addChild(effect_, 0.0f, 100.0f);
    levels->addChild(new osg::Group, 100.0f, 1000.0f);
    EXPECT_EQ(beside(levels), alone_);
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(effect_, true);
    EXPECT_EQ(beside(choice), alone_);
    choice->setAllChildrenOff();
    EXPECT_EQ(meanOf(beside(choice), 3), 0.0);
    choice->setAllChildrenOn();
    EXPECT_EQ(beside(choice), alone_);
    // Lights that are switched off light nothing.
    osg::ref_ptr<osg::Switch> lamps = new osg::Switch;
    lamps->addChild(osgLights(testLights(2)), false);
    lamps->addChild(effect_);
    EXPECT_EQ(beside(lamps), alone_);
}

TEST_F(RealScenes, IsPagedInWithTheMaterialBesideIt)
{
    const TemporaryDir folder;
    ASSERT_TRUE(osgDB::writeNodeFile(*osgMesh(sphereMesh(24)), folder.file("ball.osgb")));
    writeMaterial(testMaterials()[0], folder.file("noise.fbrdf"));
    osg::ref_ptr<osg::PagedLOD> paged = new osg::PagedLOD;
    paged->setDatabasePath(folder.file(""));
    paged->setFileName(0, "ball.osgb.[noise.fbrdf].fbrdf");
    paged->setRange(0, 0.0f, 1000.0f);
    paged->setCenter({0.0f, 0.0f, 0.0f});
    paged->setRadius(1.0f);
    const Notices notices;
    std::vector<float> image = beside(paged);
    for (int i = 0; i < 500 && meanOf(image, 3) == 0.0; ++i) {
        OpenThreads::Thread::microSleep(10000);
        image = view_->frame();
    }
    ASSERT_EQ(paged->getNumChildren(), 1u);
    auto* effect = dynamic_cast<FactorizedBrdf*>(paged->getChild(0));
    ASSERT_TRUE(effect);
    effect->setFloatTarget(true);
    view_->frame();
    // Text files have few digits of positions and normals.
    EXPECT_LT(compareImages(view_->frame(), alone_).meanRelative, 0.01);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
    EXPECT_EQ(notices.text(), "");
}

// Two cameras of one viewer see one scene, and each sees it lit as if it were alone.
TEST_F(RealScenes, TwoViewsInOneViewerEachSeeTheirLights)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect_);
    root->addChild(lights_);
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window =
        new osgViewer::GraphicsWindowEmbedded(0, 0, 2 * kSize, kSize);
    Offscreen target(context().loader(), {2 * kSize, kSize, OffscreenFormat::rgba32f, true});
    window->setDefaultFboId(target.framebuffer());
    for (int i = 0; i < 2; ++i) {
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        setUpView(*view);
        osg::Camera* camera = view->getCamera();
        camera->setGraphicsContext(window);
        camera->setViewport(i * kSize, 0, kSize, kSize);
        camera->setProjectionMatrix(osgMatrix(perspectiveView().projection));
        camera->setViewMatrix(osgMatrix(perspectiveView().view) *
                              osg::Matrixd::rotate(osg::PI * i, 0.0, 0.0, 1.0));
        view->setSceneData(root);
        viewer.addView(view);
    }
    viewer.realize();
    for (int frame = 0; frame < 2; ++frame) {
        osg::GLExtensions::Get(window->getState()->getContextID(), true)
            ->glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        viewer.frame();
    }
    const auto both = target.readPixels();
    std::vector<float> left, right;
    for (int y = 0; y < kSize; ++y) {
        const auto row = both.begin() + y * 2 * kSize * 4;
        left.insert(left.end(), row, row + kSize * 4);
        right.insert(right.begin(), row + kSize * 4, row + 2 * kSize * 4);
    }
    EXPECT_LT(compareImages(left, alone_).maxRelative, kSame);
    // The view is turned half around its axis: rows are reversed above, columns here.
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize / 2; ++x)
            for (int c = 0; c < 4; ++c)
                std::swap(right[static_cast<size_t>((y * kSize + x) * 4 + c)],
                          right[static_cast<size_t>((y * kSize + kSize - 1 - x) * 4 + c)]);
    EXPECT_LT(pixelsThatDiffer(right, alone_), kSize * kSize / 50);  // edges fall either way
}

TEST_F(RealScenes, StateSetsAreSharedByEffectsOfOneMaterial)
{
    osg::ref_ptr<FactorizedBrdf> twin = new FactorizedBrdf;
    twin->setMaterial(effect_->getMaterial());
    twin->setFloatTarget(true);
    osg::ref_ptr<osg::MatrixTransform> aside =
        new osg::MatrixTransform(osg::Matrixd::translate(0.0, 0.0, -50.0));
    aside->addChild(twin);
    twin->addChild(osgMesh(sphereMesh(8)));
    osg::ref_ptr<osg::Group> both = new osg::Group;
    // The host has one state set on two nodes.
    osg::ref_ptr<osg::StateSet> shared = new osg::StateSet;
    shared->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
    effect_->setStateSet(shared);
    aside->setStateSet(shared);
    both->addChild(effect_);
    both->addChild(aside);
    EXPECT_EQ(beside(both), alone_);
    EXPECT_EQ(effect_->getMaterial(), twin->getMaterial());
    EXPECT_EQ(shared->getAttributeList().size(), 0u);  // nothing of ours went into it
}

// osgFX takes the largest index over all contexts: whatever one context refuses, a lesser one
// must serve all.
TEST_F(RealScenes, TheChoiceIsMonotonicOverContexts)
{
    for (int technique = 0; technique < effect_->getNumTechniques(); ++technique) {
        effect_->selectTechnique(technique);
        view_->frame();
        EXPECT_EQ(effect_->lastReport().technique,
                  effect_->getTechnique(technique)->techniqueName());
    }
    effect_->selectTechnique(osgFX::Effect::AUTO_DETECT);
    view_->frame();
    const auto state = view_->viewer().getCamera()->getGraphicsContext()->getState();
    bool before = false;
    for (int technique = 0; technique < effect_->getNumTechniques(); ++technique) {
        const bool valid = effect_->getTechnique(technique)->validate(*state);
        EXPECT_TRUE(valid || !before) << "technique " << technique;
        before = valid;
    }
    EXPECT_TRUE(before);
}

TEST_F(RealScenes, AContextWithoutShadersMakesAllDrawTheFallback)
{
    const auto root = view_->viewer().getSceneData();
    view_->frame();
    EXPECT_EQ(effect_->lastReport().technique, "single pass");
    {
        const auto other = newContext();
        OsgView second(other->loader());
        second.setView(perspectiveView());
        second.setScene(root);
        second.frame();
        const auto* state = second.viewer().getCamera()->getGraphicsContext()->getState();
        osg::GLExtensions::Get(state->getContextID(), true)->isGlslSupported = false;
        effect_->setLightsPerPass(5);  // asks the contexts anew
        for (int i = 0; i < 2; ++i) EXPECT_GT(meanOf(second.frame(), 3), 0.3);
        EXPECT_EQ(effect_->lastReport().technique, "diffuse fallback");
        context().makeCurrent();
        for (int i = 0; i < 2; ++i) EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
        EXPECT_EQ(effect_->lastReport().technique, "diffuse fallback");
        other->makeCurrent();
        root->releaseGLObjects(second.viewer().getCamera()->getGraphicsContext()->getState());
    }
    context().makeCurrent();
    view_->frame();  // a context that released its objects no longer counts
    EXPECT_EQ(effect_->lastReport().technique, "single pass");
}

TEST_F(RealScenes, ATechniqueThatThereIsNotDrawsTheFallback)
{
    effect_->selectTechnique(17);
    EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
    EXPECT_EQ(effect_->lastReport().technique, "diffuse fallback");
}

TEST_F(RealScenes, TooFewTextureUnitsAreRefusedWithTheFallback)
{
    const Notices notices;
    // The first is known before anything is drawn, the second only by asking OpenGL.
    for (const int unit : {100000, 31}) {
        effect_->setFirstTextureUnit(unit);
        for (int frame = 0; frame < 2; ++frame) {
            EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
            if (unit == 31 && frame == 0) continue;
            EXPECT_EQ(effect_->lastReport().technique, "diffuse fallback");
        }
        EXPECT_NE(notices.text().find("texture units"), std::string::npos) << notices.text();
    }
    EXPECT_EQ(notices.text().find("GL error"), std::string::npos) << notices.text();
    effect_->setFirstTextureUnit(3);
    view_->frame();
    EXPECT_EQ(view_->frame(), alone_);
}

/// Counts the draws during which units 0 and 2 have the textures of the host.
class HostsTextures : public osg::Drawable::DrawCallback {
public:
    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override
    {
        const auto kept = [&](unsigned int unit) {
            return info.getState()->getLastAppliedTextureAttribute(
                       unit, osg::StateAttribute::TEXTURE) == texture;
        };
        ++(kept(0) && kept(2) ? keptInDraws : lostInDraws);
        drawable->drawImplementation(info);
    }
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    mutable int keptInDraws = 0, lostInDraws = 0;
};

// SimGear keeps the lists of its lights in units 11 to 14.
TEST_F(RealScenes, UnitsThatOthersKeepAreLeftToThem)
{
    const osg::ref_ptr<HostsTextures> host = new HostsTextures;
    osg::ref_ptr<osg::Group> above = new osg::Group;
    for (const unsigned int unit : {0u, 2u})
        above->getOrCreateStateSet()->setTextureAttribute(unit, host->texture);
    above->addChild(effect_);
    beside(above);
    effect_->getChild(0)->asDrawable()->setDrawCallback(host);
    view_->frame();
    EXPECT_EQ(std::exchange(host->lostInDraws, 0), 1);
    effect_->setFreeTextureUnits({0, 2});
    for (const int technique : {osgFbrdf::kSinglePass, osgFbrdf::kTwoLookups})
        for (const bool surfaces : {false, true}) {
            effect_->selectTechnique(technique);
            effect_->setFloatTarget(!surfaces);
            EXPECT_LT(compareImages(view_->frame(), alone_).maxRelative, 1e-4);
            EXPECT_EQ(effect_->lastReport().reason, "");
        }
    EXPECT_EQ(host->lostInDraws, 0);
    EXPECT_GT(host->keptInDraws, 20);
    std::set<int> all;
    for (int unit = 0; unit < 500; ++unit) all.insert(unit);
    effect_->setFreeTextureUnits(all);
    const Notices notices;
    for (int frame = 0; frame < 2; ++frame) EXPECT_GT(meanOf(view_->frame(), 3), 0.3);
    EXPECT_EQ(effect_->lastReport().technique, "diffuse fallback");
    EXPECT_NE(notices.text().find("others keep 500"), std::string::npos) << notices.text();
}

TEST_F(RealScenes, WithoutShadersTheFallbackIsDrawn)
{
    auto* extensions = osg::GLExtensions::Get(
        view_->viewer().getCamera()->getGraphicsContext()->getState()->getContextID(), true);
    const bool before = extensions->isGlslSupported;
    extensions->isGlslSupported = false;
    effect_->setLightsPerPass(5);  // asks the context anew
    const Notices notices;
    view_->frame();
    const auto image = view_->frame();
    extensions->isGlslSupported = before;
    EXPECT_GT(meanOf(image, 3), 0.3);
    EXPECT_EQ(effect_->lastReport().technique, "diffuse fallback");
    EXPECT_NE(effect_->lastReport().reason, "");
    EXPECT_NE(notices.text().find("GLSL"), std::string::npos) << notices.text();
}

TEST_F(RealScenes, IsListedForOsgfxbrowser)
{
    const auto& effects = osgFX::Registry::instance()->getEffectMap();
    const auto found = effects.find("Factorized BRDF");
    ASSERT_NE(found, effects.end());
    const osg::ref_ptr<osg::Object> made = found->second->cloneType();
    auto* demo = dynamic_cast<FactorizedBrdf*>(made.get());
    ASSERT_TRUE(demo);
    demo->setUpDemo();
    demo->setFloatTarget(true);
    demo->addChild(osgMesh(sphereMesh(24)));
    EXPECT_GT(meanOf(beside(demo), 0), 0.01);
    EXPECT_EQ(demo->lastReport().technique, "single pass");
}

TEST_F(RealScenes, EightLightSourcesWithConesAreTaken)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect_);
    std::vector<Light> expected;
    for (unsigned int number = 0; number < 8; ++number) {
        osg::ref_ptr<osg::Light> plain = new osg::Light(number);
        const float x = 0.5f * static_cast<float>(number) - 2.0f;
        plain->setPosition({x, 1.0f, 4.0f, 1.0f});
        plain->setDiffuse({1.0f, 0.5f, 0.25f, 1.0f});
        plain->setConstantAttenuation(0.0f);
        plain->setQuadraticAttenuation(1.0f);
        Light light;
        light.position = {x, 1.0f, 4.0f};
        light.intensity = Vec3f(1.0f, 0.5f, 0.25f) * static_cast<float>(kPi);
        if (number % 2 == 1) {
            plain->setDirection({-x, -1.0f, -4.0f});
            plain->setSpotCutoff(10.0f);
            light.type = Light::Type::spot;
            light.axis = glm::normalize(Vec3f(-x, -1.0f, -4.0f));
            light.innerAngle = light.outerAngle = osg::DegreesToRadians(10.0f);
        }
        expected.push_back(light);
        osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
        source->setLight(plain);
        root->addChild(source);
    }
    view_->setScene(root);
    const auto d =
        compareImages(view_->frame(), runtimeImage(testMaterials()[0], sphereMesh(24), expected));
    EXPECT_LT(d.meanRelative, 1e-4) << describe(d);  // a sharp cone's edge may fall either way
    EXPECT_EQ(effect_->lastReport().lightsUsed, 8);
}

TEST_F(RealScenes, ACurveComesAfterTheSumOverAllPasses)
{
    for (const Transfer transfer : {Transfer::srgb, Transfer::toneMap})
        for (const int technique : {osgFbrdf::kSinglePass, osgFbrdf::kTwoLookups}) {
            effect_->setExposure(0.1f);
            effect_->setTransfer(transfer);
            effect_->selectTechnique(technique);
            view_->frame();
            const auto image = view_->frame();
            ASSERT_EQ(effect_->lastReport().reason, "");
            double worst = 0.0;
            for (size_t i = 0; i < image.size(); ++i)
                if (i % 4 != 3 && alone_[i - i % 4 + 3] > 0.0f)
                    worst = std::max(
                        worst,
                        std::abs(static_cast<double>(image[i]) -
                                 static_cast<double>(transferred(transfer, 0.1f, alone_[i]))));
            EXPECT_LT(worst, 1e-5) << "technique " << technique;
        }
}

}  // namespace
}  // namespace fbrdf::test
