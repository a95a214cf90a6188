// Scenes with more lights than uniforms hold are drawn by lists, in one pass, and as the plain
// runtime draws them.
#include "EffectTest.h"
#include "EnvironmentTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <osg/LightSource>
#include <osg/MatrixTransform>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

// Lists and passes add the lights up in other orders.
constexpr double kSame = 1e-4;
constexpr int kMany = 4096;

/// Lights around the unit sphere, each of which reaches a part of it.
std::vector<Light> manyLights(int count)
{
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        Light light;
        const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z),
                     phi = i * kPi * (3.0 - std::sqrt(5.0)), away = 1.1 + 0.1 * (i % 4);
        light.position = Vec3f(Vec3d(r * std::cos(phi), r * std::sin(phi), z) * away);
        light.intensity = Vec3f(0.02f + 0.01f * static_cast<float>(i % 3), 0.03f, 0.02f);
        light.radius = i % 512 == 0 ? 0.0f : 0.5f;
        lights.push_back(light);
    }
    return lights;
}

class LightListsOf : public EffectTest {
protected:
    osg::ref_ptr<FactorizedBrdf> effect_;
    osg::ref_ptr<osgFbrdf::PointLights> points_;
    osg::ref_ptr<osg::Group> root_;

    void show(size_t material, const std::vector<Light>& lights)
    {
        effect_ = osgEffect(testMaterials()[material], sphereMesh(24));
        points_ = osgLights(lights);
        root_ = scene(effect_, points_);
        view_->frame();  // the context is asked what it can draw
    }

    void expectListed(bool listed, int lights)
    {
        const osgFbrdf::DrawReport report = effect_->lastReport();
        EXPECT_EQ(report.longestLightList > 0, listed);
        EXPECT_EQ(report.lightsDropped, 0);
        EXPECT_EQ(report.lightsUsed + report.lightsCulled, lights);
        EXPECT_EQ(report.technique, "single pass");
    }

    bool hasLists() const
    {
        GLint texels = 0;
        if (view_->viewer()
                .getCamera()
                ->getGraphicsContext()
                ->getState()
                ->get<osg::GLExtensions>()
                ->glVersion >= 3.1f)
            glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
        return texels > 0;
    }
};

TEST_F(LightListsOf, FourThousandLightsEqualTheRuntime)
{
    const auto lights = manyLights(kMany);
    for (const size_t material : {size_t(0), size_t(4)}) {
        const Notices notices;
        show(material, lights);
        const auto found = view_->frame();
        const auto d =
            compareImages(found, runtimeImage(testMaterials()[material], sphereMesh(24), lights));
        EXPECT_LT(d.maxRelative, kSame) << material << ": " << describe(d);
        EXPECT_GT(meanOf(found, 0), 0.01);
        expectListed(hasLists(), kMany);
        EXPECT_LT(effect_->lastReport().longestLightList, kMany / 2);
        EXPECT_EQ(notices.text(), "");
    }
}

TEST_F(LightListsOf, FewLightsAreNotMade)
{
    const auto lights = manyLights(256);
    show(0, lights);
    view_->frame();
    expectListed(false, 256);
}

// Lights of OpenSceneGraph, their attenuation and a curve are with the lists.
TEST_F(LightListsOf, HaveAttenuatedLightsAndACurve)
{
    const auto lights = manyLights(600);
    const auto osgLight = [](float x) {
        osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
        osg::Light& light = *source->getLight();
        light.setLightNum(x > 0.0f ? 0 : 1);
        light.setPosition({x, 1.0f, 3.0f, 1.0f});
        light.setDiffuse({2.0f, 1.0f, 0.5f, 1.0f});
        light.setLinearAttenuation(0.3f);
        return source;
    };
    show(0, lights);
    effect_->setTransfer(Transfer::srgb);
    effect_->setExposure(0.2f);
    for (const float x : {2.0f, -2.0f}) root_->addChild(osgLight(x));
    view_->frame();  // a changed effect asks the context again
    const auto listed = view_->frame();
    expectListed(hasLists(), 602);
    effect_->selectTechnique(osgFbrdf::kBatched);
    effect_->setLightsPerPass(200);
    const auto d = compareImages(listed, view_->frame());
    EXPECT_LT(d.maxRelative, kSame) << describe(d);
    EXPECT_EQ(effect_->lastReport().longestLightList, 0);
    // Where one of them is off the others are still right.
    effect_->getOrCreateStateSet()->setMode(GL_LIGHT1, osg::StateAttribute::OFF);
    const auto off = view_->frame();
    effect_->selectTechnique(osgFbrdf::kSinglePass);
    const auto e = compareImages(view_->frame(), off);
    EXPECT_LT(e.maxRelative, kSame) << describe(e);
    expectListed(false, 601);
    EXPECT_GT(compareImages(off, listed).maxRelative, 10.0 * kSame);
}

TEST_F(LightListsOf, FollowLightsTransformsAndTheEye)
{
    auto lights = manyLights(600);
    show(0, lights);
    const auto before = view_->frame();
    const auto expectRuntime = [&](const char* what) {
        const auto found = view_->frame();
        const auto d =
            compareImages(found, runtimeImage(testMaterials()[0], sphereMesh(24), lights));
        EXPECT_LT(d.maxRelative, kSame) << what << ": " << describe(d);
        EXPECT_GT(compareImages(found, before).maxRelative, 10.0 * kSame) << what;
        expectListed(hasLists(), 600);
    };
    lights[7].intensity *= 50.0f;
    points_->setLights(lights);
    expectRuntime("a light");
    const osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrixd::rotate(0.7, 0.0, 0.0, 1.0));
    root_->replaceChild(points_, moved);
    moved->addChild(points_);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.0, 0.0, 1.0));
    for (Light& light : lights)
        light.position = Vec3f(turn * glm::dvec4(glm::dvec3(light.position), 1.0));
    expectRuntime("a transform");
    view_->setView(orthographicView());
    view_->frame();
    EXPECT_EQ(effect_->lastReport().lightsDropped, 0);
    view_->setView(perspectiveView());
    expectRuntime("the eye");
}

// A fragment counts its pixels from the corner of the window.
TEST_F(LightListsOf, AreRightInAViewportThatBeginsElsewhere)
{
    show(0, manyLights(kMany));
    view_->viewer().getCamera()->setViewport(kSize / 4, kSize / 8, kSize / 2, kSize / 2);
    const auto listed = view_->frame();
    expectListed(hasLists(), kMany);
    effect_->selectTechnique(osgFbrdf::kBatched);
    effect_->setLightsPerPass(256);
    const auto d = compareImages(listed, view_->frame());
    EXPECT_LT(d.maxRelative, kSame) << describe(d);
    EXPECT_GT(meanOf(listed, 3), 0.05);
}

TEST_F(LightListsOf, StandBesideAnEnvironment)
{
    const auto lights = manyLights(600);
    effect_ =
        osgEffect(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)), sphereMesh(24));
    root_ = scene(effect_, osgLights(lights));
    root_->addChild(uprightFor(osgEnvironment(testPanorama(16))));
    view_->frame();
    const auto listed = view_->frame();
    EXPECT_EQ(effect_->lastReport().whyNoEnvironment, "");
    expectListed(hasLists(), 600);
    effect_->selectTechnique(osgFbrdf::kBatched);
    effect_->setLightsPerPass(200);
    const auto d = compareImages(listed, view_->frame());
    EXPECT_LT(d.maxRelative, kSame) << describe(d);
}

}  // namespace
}  // namespace fbrdf::test
