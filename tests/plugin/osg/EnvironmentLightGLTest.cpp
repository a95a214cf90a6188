// Light from everywhere in OpenSceneGraph against the plain runtime under the same panorama.
#include "EffectTest.h"
#include "EnvironmentTest.h"
#include "MaterialStates.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include "EnvironmentCube.h"

#include <osgUtil/Optimizer>

#include <cstdio>

namespace fbrdf::test {
namespace {

using osgFbrdf::EnvironmentLight;
using osgFbrdf::FactorizedBrdf;

// As in EffectGLTest.cpp: the same programs on the same numbers, with matrix products that are
// rounded in another order.
constexpr double kAgainstRuntime = 1e-4;
// Directions of look-ups come of other matrices, and a texel of the lamp is a hundred times as
// bright as its neighbours.
constexpr double kMoved = 1e-3;

const Panorama& panorama()
{
    static const Panorama made = testPanorama(32);
    return made;
}

class EnvironmentLit : public EffectTest {
protected:
    /// The effect under 9 lights and the environment.
    void show(FactorizedBrdf* effect, osg::Node* environment, int lights = 9)
    {
        root_ = scene(effect, osgLights(testLights(lights)));
        root_->addChild(uprightFor(environment));
    }
    std::vector<float> expected(const Material& material, int lights,
                                const RuntimeEnvironment& environment)
    {
        return runtimeImage(material, sphereMesh(24), testLights(lights), {glm::mat4(1.0f)},
                            &environment);
    }
    osg::ref_ptr<osg::Group> root_;
};

TEST_F(EnvironmentLit, EqualsTheRuntimeInEveryTechnique)
{
    const struct {
        size_t material;
        LobeTable lobes;
    } cases[] = {{0, testLobes(LobeAxes::tilted, 1)},
                 {2, testLobes(LobeAxes::tilted, 3)},
                 {0, testLobes(LobeAxes::bent, 3)},
                 {4, testLobes(LobeAxes::bent, 7, true)}};
    const auto environment = osgEnvironment(panorama());
    double worst = 0.0;
    const Notices notices;
    for (const auto& [index, lobes] : cases) {
        const Material material = withLobes(testMaterials()[index], lobes);
        const auto effect = osgEffect(material, sphereMesh(24));
        for (const int lights : {0, 9}) {
            show(effect, environment, lights);
            const auto image = expected(material, lights, {panorama()});
            for (int technique = 0; technique < kTechniqueCount; ++technique) {
                effect->selectTechnique(technique);
                const auto d = compareImages(view_->frame(), image);
                EXPECT_LT(d.maxRelative, kAgainstRuntime)
                    << index << ", " << lobes.lobes << " lobes, " << lights << " lights, technique "
                    << technique << ": " << describe(d);
                const osgFbrdf::DrawReport report = effect->lastReport();
                EXPECT_EQ(report.whyNoEnvironment, "");
                EXPECT_EQ(report.reason, "");
                const int limit = kTechniques[static_cast<size_t>(technique)].maxLookups;
                EXPECT_TRUE(limit == 0 || report.maxLookups <= limit);
                worst = std::max(worst, d.maxRelative);
            }
        }
    }
    std::printf("max relative difference to the runtime %.2e\n", worst);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(notices.text(), "");  // OSG_GL_ERROR_CHECKING writes here
}

// The tester: an environment that is turned, or lobes that differ, must not pass.
TEST_F(EnvironmentLit, IsNotThatOfAnotherRotation)
{
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto environment = osgEnvironment(panorama());
    environment->setRotation(0.05f);
    show(osgEffect(material, sphereMesh(24)), environment);
    EXPECT_GT(compareImages(view_->frame(), expected(material, 9, {panorama()})).maxRelative,
              10.0 * kMoved);
}

GLuint textureOf(const EnvironmentLight& environment, OsgView& view)
{
    const unsigned int id =
        view.viewer().getCamera()->getGraphicsContext()->getState()->getContextID();
    return environment.cube()->getTextureObject(id)->id();
}

TEST_F(EnvironmentLit, TurnsAndDimsWithoutBeingMadeAnew)
{
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto environment = osgEnvironment(panorama());
    const auto effect = osgEffect(material, sphereMesh(24));
    show(effect, environment);
    view_->frame();
    const GLuint texture = textureOf(*environment, *view_);
    for (const float angle : {0.7f, -2.5f}) {
        environment->setRotation(angle);
        environment->setIntensity({0.5f, 1.0f, 2.0f});
        const auto d = compareImages(
            view_->frame(),
            expected(material, 9, {panorama(), kFaceSize, angle, {0.5f, 1.0f, 2.0f}}));
        EXPECT_LT(d.maxRelative, kMoved) << angle << ": " << describe(d);
    }
    environment->setLobes(1);
    const auto d =
        compareImages(view_->frame(),
                      expected(material, 9, {panorama(), kFaceSize, -2.5f, {0.5f, 1.0f, 2.0f}, 1}));
    EXPECT_LT(d.maxRelative, kMoved) << describe(d);
    EXPECT_EQ(effect->lastReport().maxLookups, 1 + 18 + 2)
        << "p(wo), 2 look-ups of each light, the cosine and a lobe";
    EXPECT_EQ(textureOf(*environment, *view_), texture);
}

// Passes that add up off screen, and a curve after their sum, as in a window.
TEST_F(EnvironmentLit, AddsUpInSurfaces)
{
    const Material material = withLobes(testMaterials()[2], testLobes(LobeAxes::tilted, 2));
    const auto effect = osgEffect(material, sphereMesh(24));
    effect->setFloatTarget(false);
    show(effect, osgEnvironment(panorama()));
    const auto image = expected(material, 9, {panorama()});
    for (const Transfer transfer : {Transfer::linear, Transfer::toneMap})
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            effect->setTransfer(transfer);
            effect->selectTechnique(technique);
            auto stored = image;
            for (size_t i = 0; i < stored.size(); ++i)
                if (i % 4 != 3) stored[i] = transferred(transfer, 1.0f, image[i]);
            const auto d = compareImages(view_->frame(), stored);
            EXPECT_LT(d.maxRelative, kAgainstRuntime) << technique << ": " << describe(d);
            EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
            EXPECT_EQ(effect->lastReport().reason, "");
        }
}

TEST_F(EnvironmentLit, IsMultipliedByTheExposure)
{
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(24));
    show(effect, osgEnvironment(panorama()));
    auto expected = view_->frame();
    for (size_t i = 0; i < expected.size(); ++i) expected[i] *= i % 4 == 3 ? 1.0f : 4.0f;
    effect->setExposure(4.0f);
    EXPECT_LT(compareImages(view_->frame(), expected).maxRelative, 1e-6);
}

// The transform above the environment and the rotation of the node are the same turn, whatever the
// scale and place of the transform.
TEST_F(EnvironmentLit, TurnsWithTheTransformsAbove)
{
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(24));
    const auto environment = osgEnvironment(panorama());
    environment->setRotation(0.7f);
    show(effect, environment);
    const auto expected = view_->frame();
    environment->setRotation(0.0f);
    const osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(
        osg::Matrixd::rotate(0.7, 0.0, 0.0, 1.0) * osg::Matrixd::scale(3.0, 2.0, 0.5) *
        osg::Matrixd::translate(100.0, 0.0, 0.0));
    above->addChild(environment);
    show(effect, above);
    EXPECT_GT(compareImages(view_->frame(), expected).maxRelative, 10.0 * kMoved);
    above->setMatrix(osg::Matrixd::rotate(0.7, 0.0, 0.0, 1.0) * osg::Matrixd::scale(3.0, 3.0, 3.0) *
                     osg::Matrixd::translate(100.0, 0.0, 0.0));
    const auto d = compareImages(view_->frame(), expected);
    EXPECT_LT(d.maxRelative, kMoved) << describe(d);
    root_->setDataVariance(osg::Object::STATIC);
    above->setDataVariance(osg::Object::STATIC);
    osgUtil::Optimizer().optimize(root_, osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS);
    EXPECT_LT(compareImages(view_->frame(), expected).maxRelative, kMoved);
}

TEST_F(EnvironmentLit, IsDrawnInTwoContextsAndAfterARelease)
{
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::bent, 3)), sphereMesh(24));
    show(effect, osgEnvironment(panorama()));
    const auto first = view_->frame();
    {
        const auto other = newContext();
        OsgView second(other->loader());
        second.setView(perspectiveView());
        second.setScene(root_);
        EXPECT_EQ(second.frame(), first);
        root_->releaseGLObjects(second.viewer().getCamera()->getGraphicsContext()->getState());
    }
    context().makeCurrent();
    EXPECT_EQ(view_->frame(), first);
    root_->releaseGLObjects();
    root_->resizeGLObjectBuffers(4);
    EXPECT_EQ(view_->frame(), first);
}

// The last frame may still refer to it, and the next one must not.
TEST_F(EnvironmentLit, IsGoneInTheFrameAfterItIsTakenAway)
{
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(9)));
    const auto without = view_->frame();
    const int lookups = effect->lastReport().maxLookups;
    root->addChild(uprightFor(osgEnvironment(panorama())));
    EXPECT_GT(compareImages(view_->frame(), without).maxRelative, 0.1);
    EXPECT_GT(effect->lastReport().maxLookups, lookups);
    root->removeChild(2, 1);
    EXPECT_EQ(view_->frame(), without);
    EXPECT_EQ(effect->lastReport().maxLookups, lookups);
}

TEST_F(EnvironmentLit, IsSeenThroughTheMaskOfTheView)
{
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(24));
    const auto environment = osgEnvironment(panorama()), other = osgEnvironment(whitePanorama());
    show(effect, environment);
    root_->addChild(uprightFor(other));
    const Notices notices;
    const auto first = view_->frame();
    EXPECT_EQ(effect->lastReport().environmentsLeftOut, 1);
    EXPECT_NE(notices.text().find("2 environments"), std::string::npos) << notices.text();
    environment->setNodeMask(0);
    EXPECT_GT(compareImages(view_->frame(), first).maxRelative, 0.1);
    EXPECT_EQ(effect->lastReport().environmentsLeftOut, 0);
}

// The headlight is for scenes that nothing else lights.
TEST_F(EnvironmentLit, TurnsTheHeadlightOff)
{
    const auto effect =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(24));
    const auto environment = osgEnvironment(panorama());
    view_->viewer().setLightingMode(osg::View::HEADLIGHT);
    show(effect, environment, 0);
    view_->frame();
    EXPECT_EQ(effect->lastReport().lightsUsed, 0);
    environment->setIntensity({0.0f, 0.0f, 0.0f});
    EXPECT_GT(meanOf(view_->frame(), 0), 0.0);
    EXPECT_EQ(effect->lastReport().lightsUsed, 1);
}

// A file from before there were lobes: the effect is drawn without until a thread has fitted them.
TEST_F(EnvironmentLit, IsLeftOutUntilLobesAreFitted)
{
    const Material material = noiseMaterial(formIo(), Storage::half);
    const auto effect = osgEffect(material, sphereMesh(24));
    view_->viewer().setLightingMode(osg::View::HEADLIGHT);
    show(effect, osgEnvironment(panorama()), 0);
    const Notices notices;
    view_->frame();
    if (!effect->lastReport().whyNoEnvironment.empty()) {
        EXPECT_EQ(effect->lastReport().lightsUsed, 1) << "the headlight";
        view_->frame();
        const std::string& text = notices.text();
        const size_t at =
            text.find("drawn without the environment or area lights: found lobes that a thread");
        ASSERT_NE(at, std::string::npos) << text;
        EXPECT_EQ(text.find("drawn without", at + 1), std::string::npos) << text;
    }
    for (int i = 0; i < 3000 && !effect->lastReport().whyNoEnvironment.empty(); ++i) {
        OpenThreads::Thread::microSleep(10000);
        view_->draw();
    }
    EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
    EXPECT_EQ(effect->lastReport().lightsUsed, 0);
    std::string whyNot;
    const auto fitted = effect->getMaterial()->states()->lobes(0, whyNot);
    ASSERT_TRUE(fitted) << whyNot;
    const auto d =
        compareImages(view_->frame(), expected(withLobes(material, *fitted), 0, {panorama()}));
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
}

// The fallback has the mean radiance as ambient light.
TEST_F(EnvironmentLit, IsTheSameFromAllSidesInTheFallback)
{
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    effect->selectTechnique(osgFbrdf::kDiffuseFallback);
    const auto environment = osgEnvironment(whitePanorama());
    environment->setIntensity({0.5f, 1.0f, 0.25f});
    show(effect, environment, 0);
    const auto image = view_->frame();
    const osg::Vec3f& albedo = effect->getMaterial()->albedo();
    int covered = 0;
    for (size_t i = 0; i < image.size(); i += 4) {
        if (image[i + 3] < 1.0f) continue;
        ++covered;
        EXPECT_NEAR(double(image[i]), 0.5 * double(albedo.x()), 1e-3);
        EXPECT_NEAR(double(image[i + 1]), double(albedo.y()), 1e-3);
    }
    EXPECT_GT(covered, 100);
    EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
}

TEST_F(EnvironmentLit, AMissingPictureIsOneLineAndLightsNothing)
{
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto effect = osgEffect(material, sphereMesh(24));
    const auto without = runtimeImage(material, sphereMesh(24), testLights(9));
    const osg::ref_ptr<EnvironmentLight> environment = new EnvironmentLight;
    const Notices notices;
    EXPECT_FALSE(environment->setPictureFile("no-such-picture.hdr"));
    EXPECT_EQ(environment->getPictureFile(), "no-such-picture.hdr");
    show(effect, environment);
    for (int frame = 0; frame < 2; ++frame)
        EXPECT_LT(compareImages(view_->frame(), without).maxRelative, kAgainstRuntime);
    EXPECT_EQ(notices.text(),
              "osgFbrdf: no-such-picture.hdr: found no such file, expected a picture, studio, "
              "overcast, clear\n");
}

}  // namespace
}  // namespace fbrdf::test
