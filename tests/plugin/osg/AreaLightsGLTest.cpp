// Area lights in OpenSceneGraph against the plain runtime under the same lights.
#include "AreaLightsTest.h"
#include "EffectTest.h"
#include "EnvironmentTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <osg/LightSource>
#include <osgUtil/Optimizer>

#include <cstdio>
#include <limits>

namespace fbrdf::test {
namespace {

using osgFbrdf::AreaLights;
using osgFbrdf::FactorizedBrdf;
using Shape = AreaLight::Shape;

// As in EffectGLTest.cpp: the same programs on the same numbers, with matrix products that are
// rounded in another order.
constexpr double kAgainstRuntime = 1e-4;
// Shapes that were moved are rounded once more.
constexpr double kMoved = 1e-4;

/// Relative to the mean of the picture: a share is a sum of edges, most of which cancels.
ImageDifference difference(const std::vector<float>& found, const std::vector<float>& expected)
{
    return compareImages(found, expected, 1.0);
}

class AreaLit : public EffectTest {
protected:
    void show(FactorizedBrdf* effect, osg::Node* areaLights, int lights = 0)
    {
        root_ = scene(effect, osgLights(testLights(lights)));
        root_->addChild(areaLights);
    }
    static Material material(int lobes = 2)
    {
        return withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, lobes));
    }
    std::vector<float> expected(const std::vector<AreaLight>& areaLights, int lights = 0)
    {
        return runtimeImage(material(), sphereMesh(24), testLights(lights), {glm::mat4(1.0f)},
                            nullptr, areaLights);
    }
    osg::ref_ptr<osg::Group> root_;
};

TEST_F(AreaLit, EqualsTheRuntimeForEveryShape)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    const Notices notices;
    double worst = 0.0;
    for (const Shape shape : kShapes) {
        const std::vector<AreaLight> lights{areaLightOf(shape)};
        show(effect, osgAreaLights(lights));
        const auto d = difference(view_->frame(), expected(lights));
        EXPECT_LT(d.maxRelative, kAgainstRuntime) << shapeName(shape) << ": " << describe(d);
        worst = std::max(worst, d.maxRelative);
        EXPECT_GT(meanOf(view_->frame(), 0), 1e-3) << shapeName(shape);
        const osgFbrdf::DrawReport report = effect->lastReport();
        EXPECT_EQ(report.maxLookups, 0) << "area lights look nothing up";
        EXPECT_EQ(report.lightsUsed, 1);
        EXPECT_EQ(report.whyNoEnvironment, "");
    }
    std::printf("max relative difference to the runtime %.2e\n", worst);
    EXPECT_EQ(notices.text(), "");  // OSG_GL_ERROR_CHECKING writes here
}

// The tester: a light that is a little larger must not pass.
TEST_F(AreaLit, IsNotThatOfAnotherSize)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    std::vector<AreaLight> lights{areaLightOf(Shape::sphere)};
    show(effect, osgAreaLights(lights));
    lights[0].size *= 1.01f;
    EXPECT_GT(difference(view_->frame(), expected(lights)).maxRelative, 10 * kAgainstRuntime);
}

TEST_F(AreaLit, AddsUpWithLightsAndTheEnvironmentInEveryTechnique)
{
    const auto areas = oneOfEach();
    const auto effect = osgEffect(material(), sphereMesh(24));
    const RuntimeEnvironment runtimeEnvironment{testPanorama(32)};
    for (const bool withEnvironment : {false, true}) {
        show(effect, osgAreaLights(areas), 9);
        if (withEnvironment)
            root_->addChild(uprightFor(osgEnvironment(runtimeEnvironment.panorama)));
        const auto image =
            runtimeImage(material(), sphereMesh(24), testLights(9), {glm::mat4(1.0f)},
                         withEnvironment ? &runtimeEnvironment : nullptr, areas);
        for (const bool floatTarget : {true, false})
            for (int technique = 0; technique < kTechniqueCount; ++technique) {
                effect->setFloatTarget(floatTarget);
                effect->selectTechnique(technique);
                const auto d = difference(view_->frame(), image);
                EXPECT_LT(d.maxRelative, kAgainstRuntime)
                    << "technique " << technique << (withEnvironment ? ", environment" : "")
                    << (floatTarget ? "" : ", surfaces") << ": " << describe(d);
                const osgFbrdf::DrawReport report = effect->lastReport();
                EXPECT_EQ(report.reason, "");
                EXPECT_EQ(report.whyNoEnvironment, "");
                EXPECT_EQ(report.lightsUsed, 9 + 5);
                const int limit = kTechniques[static_cast<size_t>(technique)].maxLookups;
                EXPECT_TRUE(limit == 0 || report.maxLookups <= limit);
            }
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// More than one program has room for, and polygons that are many vectors each.
TEST_F(AreaLit, ManyAreSpreadOverPasses)
{
    std::vector<AreaLight> areas;
    for (int i = 0; i < 90; ++i)
        for (const Shape shape : {Shape::rectangle, Shape::polygon}) {
            AreaLight& light = areas.emplace_back(areaLightOf(shape));
            light.radiance *= 0.01f * static_cast<float>(1 + i % 7);
        }
    const auto effect = osgEffect(material(), sphereMesh(8));
    show(effect, osgAreaLights(areas));
    const auto image =
        runtimeImage(material(), sphereMesh(8), {}, {glm::mat4(1.0f)}, nullptr, areas);
    const auto d = difference(view_->frame(), image);
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
    EXPECT_GT(effect->lastReport().passes, 1);
    EXPECT_EQ(effect->lastReport().lightsUsed, 180);
}

// osg::LightSources have attenuations, which are applied by the shadow hook; area lights are not
// attenuated by any of them.
TEST_F(AreaLit, StandsBesideAttenuatedLights)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    const osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->getLight()->setPosition({1.0f, 2.0f, 2.0f, 1.0f});
    source->getLight()->setLinearAttenuation(0.5f);
    const auto areas = osgAreaLights(oneOfEach());
    root_ = scene(effect, source);
    auto sum = view_->frame();
    show(effect, areas);
    const auto lit = view_->frame();
    for (size_t i = 0; i < sum.size(); ++i)
        if (i % 4 != 3) sum[i] += lit[i];
    root_ = scene(effect, source);
    root_->addChild(areas);
    const auto d = difference(view_->frame(), sum);
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
    EXPECT_EQ(effect->lastReport().lightsUsed, 6);
}

TEST_F(AreaLit, IsMultipliedByTheExposure)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    show(effect, osgAreaLights(oneOfEach()));
    auto expected = view_->frame();
    for (size_t i = 0; i < expected.size(); ++i) expected[i] *= i % 4 == 3 ? 1.0f : 4.0f;
    effect->setExposure(4.0f);
    EXPECT_LT(difference(view_->frame(), expected).maxRelative, 1e-6);
}

/// What the transform makes of each shape, done by hand.
std::vector<AreaLight> scaledBy(std::vector<AreaLight> lights, float s)
{
    for (AreaLight& light : lights) {
        light.position *= s;
        light.end *= s;
        light.axisU *= s;
        light.axisV *= s;
        light.size *= s;
        for (Vec3f& vertex : light.vertices) vertex *= s;
    }
    return lights;
}

TEST_F(AreaLit, GoesWithTheTransformsAbove)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    const auto areas = oneOfEach();
    show(effect, osgAreaLights(scaledBy(areas, 1.3f)));
    const auto image = view_->frame();
    const osg::Matrixd turn = osg::Matrixd::rotate(0.7, osg::Vec3d(0.3, 1.0, 0.2)) *
                              osg::Matrixd::translate(0.5, -3.0, 0.25);
    const osg::ref_ptr<osg::MatrixTransform> above =
        new osg::MatrixTransform(osg::Matrixd::scale(1.3, 1.3, 1.3) * turn);
    const osg::ref_ptr<osg::MatrixTransform> back =
        new osg::MatrixTransform(osg::Matrixd::inverse(turn));
    above->addChild(osgAreaLights(areas));
    back->addChild(above);
    show(effect, back);
    const auto d = difference(view_->frame(), image);
    EXPECT_LT(d.maxRelative, kMoved) << describe(d);
    for (osg::MatrixTransform* node : {above.get(), back.get()})
        node->setDataVariance(osg::Object::STATIC);
    osgUtil::Optimizer().optimize(root_, osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS);
    EXPECT_LT(difference(view_->frame(), image).maxRelative, kMoved);
}

// A mirrored light shines from the mirrored side.
TEST_F(AreaLit, ShinesFromTheSameSideOfAMirroredShape)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    const auto areas = oneOfEach();
    show(effect, osgAreaLights(areas));
    const auto image = view_->frame();
    std::vector<AreaLight> mirrored = areas;
    const auto flip = [](Vec3f& v) { v.x = -v.x; };
    for (AreaLight& light : mirrored) {
        for (Vec3f* v : {&light.position, &light.end, &light.normal, &light.axisU, &light.axisV})
            flip(*v);
        for (Vec3f& vertex : light.vertices) flip(vertex);
        light.axisU = -light.axisU;
        std::reverse(light.vertices.begin(), light.vertices.end());
    }
    const osg::ref_ptr<osg::MatrixTransform> mirror =
        new osg::MatrixTransform(osg::Matrixd::scale(-1.0, 1.0, 1.0));
    mirror->addChild(osgAreaLights(mirrored));
    show(effect, mirror);
    const auto d = difference(view_->frame(), image);
    EXPECT_LT(d.maxRelative, kMoved) << describe(d);
}

TEST_F(AreaLit, OutOfReachCostsNothing)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    const auto root = scene(effect, osgLights(testLights(3)));
    const auto without = view_->frame();
    AreaLight far = areaLightOf(Shape::sphere);
    far.position = {100.0f, 0.0f, 0.0f};
    far.radius = 10.0f;
    AreaLight behind = areaLightOf(Shape::rectangle);
    behind.axisU = -behind.axisU;
    root->addChild(osgAreaLights({far, behind}));
    EXPECT_EQ(view_->frame(), without);
    const osgFbrdf::DrawReport report = effect->lastReport();
    EXPECT_EQ(report.passes, 1);
    EXPECT_EQ(report.lightsUsed, 3);
    EXPECT_EQ(report.lightsCulled, 2);
    EXPECT_EQ(report.lightsDropped, 0);
}

TEST_F(AreaLit, BadOnesAreLeftOutWithOneLine)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    const std::vector<AreaLight> good{areaLightOf(Shape::tube)};
    std::vector<AreaLight> lights = good;
    for (const float size : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        lights.push_back(areaLightOf(Shape::sphere));
        lights.back().size = size;
    }
    lights.push_back(areaLightOf(Shape::polygon));
    lights.back().vertices.resize(2);
    const auto node = osgAreaLights(lights);
    show(effect, node);
    const Notices notices;
    view_->frame();
    const auto d = difference(view_->frame(), expected(good));
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
    EXPECT_EQ(effect->lastReport().lightsUsed, 1);
    EXPECT_EQ(effect->lastReport().lightsDropped, 4);
    EXPECT_EQ(notices.text(),
              "osgFbrdf: an effect without a name: lights are left out: found 5, 1 of which are "
              "valid and within what the technique can draw; an area light: vertices: found 2, "
              "expected 3 to 256\n");
    // A transform that flattens a sphere leaves nothing of it.
    const osg::ref_ptr<osg::MatrixTransform> flat =
        new osg::MatrixTransform(osg::Matrixd::scale(1.0, 1.0, 0.0));
    flat->addChild(osgAreaLights({areaLightOf(Shape::sphere), areaLightOf(Shape::disc)}));
    show(effect, flat);
    view_->frame();
    EXPECT_EQ(effect->lastReport().lightsUsed, 0);
    EXPECT_EQ(effect->lastReport().lightsDropped, 2);
}

TEST_F(AreaLit, TheObjectAndTheEyeMayBeInsideOfOne)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    AreaLight around = areaLightOf(Shape::sphere);
    around.position = {0.0f, 0.0f, 0.0f};
    around.size = 50.0f;
    show(effect, osgAreaLights({around}));
    const auto d = difference(view_->frame(), expected({around}));
    EXPECT_LT(d.maxRelative, kAgainstRuntime) << describe(d);
}

// The headlight is for scenes that nothing else lights.
TEST_F(AreaLit, TurnsTheHeadlightOff)
{
    const auto effect = osgEffect(material(), sphereMesh(24));
    view_->viewer().setLightingMode(osg::View::HEADLIGHT);
    const auto node = osgAreaLights({areaLightOf(Shape::sphere)});
    show(effect, node);
    const auto image = view_->frame();
    EXPECT_EQ(effect->lastReport().lightsUsed, 1);
    EXPECT_LT(difference(image, expected({areaLightOf(Shape::sphere)})).maxRelative,
              kAgainstRuntime);
    node->setNodeMask(0);
    EXPECT_GT(meanOf(view_->frame(), 0), 0.0);
    EXPECT_EQ(effect->lastReport().lightsUsed, 1) << "the headlight";
}

// The environment and area lights of a file without lobes wait for a thread that fits them.
TEST_F(AreaLit, IsLeftOutUntilLobesAreFitted)
{
    const auto effect = osgEffect(noiseMaterial(formIo(), Storage::half), sphereMesh(24));
    view_->viewer().setLightingMode(osg::View::HEADLIGHT);
    show(effect, osgAreaLights({areaLightOf(Shape::sphere)}));
    view_->frame();
    if (!effect->lastReport().whyNoEnvironment.empty()) {
        EXPECT_EQ(effect->lastReport().lightsUsed, 1) << "the headlight";
    }
    for (int i = 0; i < 3000 && !effect->lastReport().whyNoEnvironment.empty(); ++i) {
        OpenThreads::Thread::microSleep(10000);
        view_->draw();
    }
    EXPECT_EQ(effect->lastReport().whyNoEnvironment, "");
    EXPECT_EQ(effect->lastReport().lightsUsed, 1);
    EXPECT_EQ(effect->lastReport().maxLookups, 0);
}

// Far from a small light, the fallback's light is as bright as the area light on a diffuse surface.
TEST_F(AreaLit, IsALightOfOpenGLInTheFallback)
{
    for (const Shape shape : {Shape::sphere, Shape::disc, Shape::rectangle}) {
        AreaLight light = areaLightOf(shape);
        light.position = {0.0f, 0.0f, 10.0f};
        light.size = 0.1f;
        light.normal = {0.0f, 0.0f, -1.0f};
        light.axisU = {0.0f, 0.1f, 0.0f};
        light.axisV = {0.1f, 0.0f, 0.0f};
        light.radiance = Vec3f(3000.0f);
        const auto effect = osgEffect(material(), sphereMesh(24));
        effect->selectTechnique(osgFbrdf::kDiffuseFallback);
        show(effect, osgAreaLights({light}));
        const auto image = view_->frame();
        float brightest = 0.0f;
        for (size_t i = 0; i < image.size(); i += 4) brightest = std::max(brightest, image[i]);
        const double area = shape == Shape::rectangle ? 0.04 : kPi * 0.01;
        // The sphere comes within 9 of the light.
        const double expected =
            3000.0 * area / 81.0 / kPi * double(effect->getMaterial()->albedo().x());
        EXPECT_NEAR(double(brightest), expected, 0.03 * expected) << shapeName(shape);
        EXPECT_EQ(effect->lastReport().lightsUsed, 1);
    }
}

}  // namespace
}  // namespace fbrdf::test
