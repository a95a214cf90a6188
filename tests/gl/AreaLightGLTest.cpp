// Pictures under area lights are compared with the same lobes on the CPU, in double.
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentReference.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/GlTest.h"

#include <algorithm>
#include <limits>

namespace fbrdf::test {
namespace {

using Shape = AreaLight::Shape;

constexpr int kSize = 48;
// Relative to the mean of the picture: the emulation is in double.
constexpr double kEmulation = 1e-4;
// The same numbers are added in another order.
constexpr double kOrder = 2e-5;

class AreaLights : public RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        if (!isReady()) return;
        mesh_ = sphereMesh(16);
        gpuMesh_ = renderer_->createMesh(mesh_);
        Offscreen floats = makeOffscreen(kSize);
        geometry_ = geometryBuffer(gl(), floats, mesh_, glm::mat4(1.0f), perspectiveView());
    }
    void TearDown() override
    {
        gpuMesh_.reset();
        RendererTest::TearDown();
    }

    Drawn drawn(const Material& material, const std::vector<Light>& lights,
                const gl::DrawOptions& options)
    {
        const auto gpu = exactMaterial(*renderer_, material);
        return drawItems(*renderer_, kSize, perspectiveView(), {{gpu.get(), gpuMesh_.get()}},
                         lights, options);
    }

    static gl::DrawOptions optionsOf(const std::vector<AreaLight>& lights,
                                     Technique technique = Technique::single)
    {
        gl::DrawOptions options{technique, 4};
        options.areaLights = lights;
        return options;
    }

    std::vector<double> expected(const LobeTable& lobes, const std::vector<AreaLight>& lights) const
    {
        return areaLightImage(lobes, lights, geometry_, perspectiveView());
    }

    static Material tilted(int lobes)
    {
        return withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, lobes));
    }

    gl::MeshData mesh_;
    std::shared_ptr<gl::GpuMesh> gpuMesh_;
    GeometryBuffer geometry_;
};

TEST_P(AreaLights, AreTheSumOfLobesInsideOfThem)
{
    for (const auto& [axes, lobes] : {std::pair{LobeAxes::tilted, 2}, {LobeAxes::bent, 3}})
        for (const Shape shape : kShapes) {
            const LobeTable table = testLobes(axes, lobes);
            const std::vector<AreaLight> lights{areaLightOf(shape)};
            const Drawn picture =
                drawn(withLobes(testMaterials()[0], table), {}, optionsOf(lights));
            EXPECT_EQ(picture.stats.itemsFailed, 0);
            EXPECT_EQ(picture.stats.itemsWithoutEnvironment, 0) << picture.stats.whyNoEnvironment;
            EXPECT_EQ(picture.stats.passes, 1);
            EXPECT_EQ(picture.stats.maxLookups, 0);
            EXPECT_EQ(picture.stats.lightsUsed, 1);
            EXPECT_EQ(picture.stats.environmentError, table.error);
            const auto difference = compareImages(picture.pixels, expected(table, lights), 1.0);
            EXPECT_LT(difference.maxRelative, kEmulation)
                << shapeName(shape) << ": " << describe(difference);
        }
    EXPECT_TRUE(log.empty()) << log[0];
}

// The tester: a light that is a little larger, or of another shape, must not pass.
TEST_P(AreaLights, AreNotThoseOfAnotherSize)
{
    const LobeTable table = testLobes(LobeAxes::tilted, 2);
    for (const Shape shape : {Shape::sphere, Shape::tube, Shape::disc}) {
        AreaLight light = areaLightOf(shape);
        const auto picture = drawn(tilted(2), {}, optionsOf({light})).pixels;
        light.size *= 1.01f;
        EXPECT_GT(compareImages(picture, expected(table, {light}), 1.0).maxRelative,
                  10 * kEmulation);
    }
}

TEST_P(AreaLights, AddUpWithTheLightsInEveryTechnique)
{
    const auto lights = testLights(5);
    const auto areas = oneOfEach();
    for (const size_t form : {size_t{6}}) {
        const Material material = withLobes(testMaterials()[form], testLobes(LobeAxes::tilted, 3));
        auto sum = drawn(material, {}, optionsOf(areas)).pixels;
        const auto lit = drawn(material, lights, {}).pixels;
        for (size_t i = 0; i < sum.size(); ++i)
            if (i % 4 != 3) sum[i] += lit[i];
        for (const Technique technique : allTechniques()) {
            const Drawn both = drawn(material, lights, optionsOf(areas, technique));
            EXPECT_EQ(both.stats.whyReplaced, "");
            EXPECT_EQ(both.stats.itemsWithoutEnvironment, 0);
            EXPECT_EQ(both.stats.lightsGiven, 10);
            EXPECT_LE(both.stats.maxLookups, technique == Technique::twoLookup ? 2 : 100);
            const auto difference = compareImages(both.pixels, sum, 1e-2);
            EXPECT_LT(difference.maxRelative, kOrder)
                << techniqueName(technique) << describe(difference);
        }
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(AreaLights, AddUpWithAnEnvironment)
{
    const auto environment = renderer_->createEnvironment(testPanorama(64), {32, true});
    const auto areas = oneOfEach();
    for (const int lobes : {2}) {
        gl::DrawOptions none;
        none.environment.map = environment.get();
        auto sum = drawn(tilted(lobes), {}, none).pixels;
        const auto lit = drawn(tilted(lobes), {}, optionsOf(areas)).pixels;
        for (size_t i = 0; i < sum.size(); ++i)
            if (i % 4 != 3) sum[i] += lit[i];
        for (const Technique technique : allTechniques()) {
            gl::DrawOptions options = optionsOf(areas, technique);
            options.environment = none.environment;
            const Drawn both = drawn(tilted(lobes), {}, options);
            EXPECT_EQ(both.stats.whyReplaced, "");
            EXPECT_LE(both.stats.maxLookups, technique == Technique::twoLookup ? 2 : 4);
            const auto difference = compareImages(both.pixels, sum, 1.0);
            EXPECT_LT(difference.maxRelative, kOrder)
                << techniqueName(technique) << describe(difference);
        }
    }
}

// Directions of the environment are drawn in a pass of their own, and area lights stay lobes.
TEST_P(AreaLights, AddUpWithDirectionsOfAnEnvironment)
{
    gl::EnvironmentOptions unfiltered{32, true};
    unfiltered.unfiltered = true;
    const auto environment = renderer_->createEnvironment(testPanorama(64), unfiltered);
    gl::DrawOptions sampled;
    sampled.environment.map = environment.get();
    sampled.environment.samples = 8;
    auto sum = drawn(tilted(2), testLights(2), sampled).pixels;
    const std::vector<AreaLight> areas{areaLightOf(Shape::sphere), areaLightOf(Shape::disc)};
    const auto lit = drawn(tilted(2), {}, optionsOf(areas)).pixels;
    for (size_t i = 0; i < sum.size(); ++i)
        if (i % 4 != 3) sum[i] += lit[i];
    sampled.areaLights = areas;
    const Drawn both = drawn(tilted(2), testLights(2), sampled);
    EXPECT_EQ(both.stats.whyNotSampled, "");
    EXPECT_EQ(both.stats.itemsWithoutEnvironment, 0);
    EXPECT_GT(both.stats.environmentError, 0.0);  // of the area lights' lobes
    const auto difference = compareImages(both.pixels, sum, 1.0);
    EXPECT_LT(difference.maxRelative, kOrder) << describe(difference);
}

TEST_P(AreaLights, OfPackedLibrariesAreThoseOfItems)
{
    const Form form = formPqpr(8, 0.5, 6);
    for (const LobeAxes axes : {LobeAxes::tilted, LobeAxes::bent}) {
        const LobeTable table = testLobes(axes, 3);
        const Material first = withLobes(noiseMaterial(form, Storage::log8), table);
        Material second = withLobes(noiseMaterial(form, Storage::log8, 2), table);
        for (LobeKnot& knot : second.lobes.knots) knot.cosine *= 0.5f;
        const auto library = renderer_->createLibrary({first, second});
        const auto gpuFirst = renderer_->createMaterial(first);
        const auto gpuSecond = renderer_->createMaterial(second);
        const glm::mat4 left = glm::translate(glm::mat4(1.0f), Vec3f(-0.6f, 0.0f, 0.0f)),
                        right = glm::translate(glm::mat4(1.0f), Vec3f(0.6f, 0.0f, 0.0f));
        const auto expectedPicture = drawItems(*renderer_, kSize, perspectiveView(),
                                               {{gpuFirst.get(), gpuMesh_.get(), left},
                                                {gpuSecond.get(), gpuMesh_.get(), right}},
                                               testLights(2), optionsOf(oneOfEach()))
                                         .pixels;
        Offscreen offscreen = makeOffscreen(kSize);
        const auto stats =
            renderer_->drawBatch({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                 {library.get(), gpuMesh_.get(), {{left, 0}, {right, 1}}},
                                 testLights(2), optionsOf(oneOfEach()));
        EXPECT_EQ(stats.itemsWithoutEnvironment, 0) << stats.whyNoEnvironment;
        const auto difference = compareImages(offscreen.readPixels(), expectedPicture, 1e-2);
        EXPECT_LT(difference.maxRelative, 2 * kOrder) << describe(difference);
    }
}

TEST_P(AreaLights, AreMultipliedByTheExposure)
{
    const auto gpu = renderer_->createMaterial(tilted(1));
    std::vector<float> pictures[2];
    for (const bool exposed : {false, true}) {
        Offscreen offscreen = makeOffscreen(kSize);
        gl::DrawOptions options = optionsOf(oneOfEach());
        gl::Target target{offscreen.framebuffer(), kSize, kSize, Transfer::exposure};
        if (exposed) target.exposure = 4.0f;
        if (!exposed)
            for (AreaLight& light : options.areaLights) light.radiance *= 4.0f;
        renderer_->draw(target, perspectiveView(), {{gpu.get(), gpuMesh_.get()}}, {}, options);
        pictures[exposed ? 1 : 0] = offscreen.readPixels();
    }
    EXPECT_LT(compareImages(pictures[1], pictures[0]).maxRelative, kOrder);
}

// Nothing is paid for lights that reach no object: program and picture are those without them.
TEST_P(AreaLights, OutOfReachCostNothing)
{
    AreaLight behind = areaLightOf(Shape::disc), far = areaLightOf(Shape::sphere);
    behind.normal = {1.0f, 0.2f, 1.0f};
    behind.position = {4, 1, 4};
    far.position = {100, 0, 0};
    far.radius = 10.0f;
    const auto lights = testLights(3);
    const Material material = noiseMaterial(formIo(), Storage::half);  // without lobes
    const Drawn picture = drawn(material, lights, optionsOf({behind, far}));
    const Drawn without = drawn(material, lights, {});
    EXPECT_EQ(picture.pixels, without.pixels);
    EXPECT_EQ(picture.stats.lightsCulled, without.stats.lightsCulled + 2);
    EXPECT_EQ(picture.stats.passes, without.stats.passes);
    EXPECT_EQ(picture.stats.itemsWithoutEnvironment, 0);
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(AreaLights, KeepTheStrongestOfTooMany)
{
    std::vector<AreaLight> lights(6, areaLightOf(Shape::sphere));
    for (size_t i = 0; i < 6; ++i) lights[i].radiance = Vec3f(static_cast<float>(i + 1));
    gl::DrawOptions options = optionsOf(lights);
    options.maxLights = 2;
    const Drawn picture = drawn(tilted(2), {}, options);
    EXPECT_EQ(picture.stats.lightsDropped, 4);
    const auto difference = compareImages(
        picture.pixels, expected(testLobes(LobeAxes::tilted, 2), {lights[4], lights[5]}), 1.0);
    EXPECT_LT(difference.maxRelative, kEmulation) << describe(difference);
}

TEST_P(AreaLights, InTheHundredsAreAllDrawn)
{
    std::vector<AreaLight> lights(300, areaLightOf(Shape::sphere));
    for (size_t i = 0; i < lights.size(); ++i) {
        const auto t = static_cast<float>(i);
        lights[i].position = 3.0f * glm::normalize(Vec3f(std::sin(t), std::cos(1.7f * t), 1.0f));
        lights[i].size = 0.1f;
    }
    const Drawn picture = drawn(tilted(1), {}, optionsOf(lights));
    EXPECT_EQ(picture.stats.lightsUsed, 300);
    const auto difference =
        compareImages(picture.pixels, expected(testLobes(LobeAxes::tilted, 1), lights), 1.0);
    EXPECT_LT(difference.maxRelative, kEmulation) << describe(difference);
}

TEST_P(AreaLights, InListsAreTheSame)
{
    std::vector<AreaLight> lights = oneOfEach();
    for (size_t i = 0; i < 60; ++i) {
        const auto t = static_cast<float>(i);
        AreaLight light = areaLightOf(kShapes[i % 4]);
        light.position = 1.6f * glm::normalize(Vec3f(std::sin(t), std::cos(1.7f * t), 1.0f));
        light.end = light.position + Vec3f(0.2f, 0.1f, 0.0f);
        light.size = 0.1f;
        light.axisU *= 0.2f;
        light.axisV *= 0.2f;
        light.radius = 1.0f;
        lights.push_back(light);
    }
    gl::DrawOptions options = optionsOf(lights);
    const auto plain = drawn(tilted(2), testLights(20), options).pixels;
    options.clustered = true;
    const Drawn lists = drawn(tilted(2), testLights(20), options);
    EXPECT_EQ(lists.stats.passes, 1);
    const auto difference = compareImages(lists.pixels, plain, 1e-2);
    EXPECT_LT(difference.maxRelative, 2 * kOrder) << describe(difference);
    EXPECT_EQ(log.empty(), !GetParam().legacy);
    // Shapes that change where the reach stays are drawn as they are.
    for (AreaLight& light : options.areaLights) light.size *= 0.5f;
    const auto smaller = drawn(tilted(2), testLights(20), options).pixels;
    options.clustered = false;
    const auto expectedPicture = drawn(tilted(2), testLights(20), options).pixels;
    EXPECT_LT(compareImages(smaller, expectedPicture, 1e-2).maxRelative, 2 * kOrder);
    EXPECT_GT(compareImages(smaller, plain, 1e-2).maxRelative, 0.1);
}

TEST_P(AreaLights, ThatAreInvalidAreLeftOutAndNamed)
{
    std::vector<AreaLight> lights = oneOfEach();
    for (AreaLight& light : lights) light.radius = 0.0f;
    lights[0].size = 0.0f;
    lights[3].size = -1.0f;
    lights[4].vertices.resize(2);
    lights[2].radiance.y = std::numeric_limits<float>::quiet_NaN();
    const Drawn picture = drawn(tilted(2), {}, optionsOf(lights));
    EXPECT_EQ(picture.stats.lightsGiven, 5);
    EXPECT_EQ(picture.stats.lightsUsed, 1);
    EXPECT_EQ(picture.stats.lightsDropped, 4);
    ASSERT_EQ(log.size(), 4u);
    EXPECT_NE(log[0].find("area light 0 left out: size: found 0, expected"), std::string::npos)
        << log[0];
    const auto difference =
        compareImages(picture.pixels, expected(testLobes(LobeAxes::tilted, 2), {lights[1]}), 1.0);
    EXPECT_LT(difference.maxRelative, kEmulation) << describe(difference);
}

// The eye, or the object, may be inside of a light.
TEST_P(AreaLights, AroundTheObjectAndTheEyeAreFinite)
{
    AreaLight sphere = areaLightOf(Shape::sphere), tube = areaLightOf(Shape::tube);
    sphere.position = {0, 0, 3};
    sphere.size = 2.5f;
    tube.position = {-5, 0, 0};
    tube.end = {5, 0, 0};
    tube.size = 0.9f;
    for (const AreaLight& light : {sphere, tube}) {
        const Drawn picture = drawn(tilted(2), {}, optionsOf({light}));
        const auto difference =
            compareImages(picture.pixels, expected(testLobes(LobeAxes::tilted, 2), {light}), 1.0);
        EXPECT_LT(difference.maxRelative, 10 * kEmulation) << describe(difference);
        for (const float value : picture.pixels) ASSERT_TRUE(std::isfinite(value));
    }
}

// Numbers of area lights follow those of the lights.
TEST_P(AreaLights, AreDimmedByTheShadowHook)
{
    gl::Hooks hooks;
    hooks.shadow =
        "float fbrdfShadow(int light, vec3 position, vec3 toLight)\n{\n"
        "    return light == 3 ? 0.0 : light == 4 ? 0.5 : 1.0;\n}\n";
    const auto gpuHooks = renderer_->createHooks(hooks);
    const auto gpu = renderer_->createMaterial(tilted(2));
    const auto lights = testLights(2);
    std::vector<AreaLight> areas = oneOfEach();
    const auto dimmed = drawItems(*renderer_, kSize, perspectiveView(),
                                  {{gpu.get(), gpuMesh_.get(), glm::mat4(1.0f), gpuHooks.get()}},
                                  lights, optionsOf(areas))
                            .pixels;
    areas[1].radiance *= 0.0f;
    areas[2].radiance *= 0.5f;
    const auto expectedPicture = drawItems(*renderer_, kSize, perspectiveView(),
                                           {{gpu.get(), gpuMesh_.get()}}, lights, optionsOf(areas))
                                     .pixels;
    EXPECT_LT(compareImages(dimmed, expectedPicture, 1e-2).maxRelative, kOrder);
}

INSTANTIATE_TEST_SUITE_P(Variants, AreaLights, testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
