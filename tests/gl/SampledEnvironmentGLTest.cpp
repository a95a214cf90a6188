// Pictures under an environment by directions that are drawn, against the same directions on the
// CPU, over the texels that the GPU has.
#include <fbrdf/base/Error.h>
#include <fbrdf/environment/SampledLight.h>

#include <gtest/gtest.h>

#include "EnvironmentFixture.h"
#include "support/gl/CompareImages.h"

namespace fbrdf::test {
namespace {

constexpr int kSize = 32, kCube = 32;
// Relative to the mean of the picture, as in EnvironmentGLTest.cpp. A direction at the rim of a
// lobe is known less exactly than others (SamplingGLTest.cpp): the largest error is that of a pixel
// that has one.
constexpr double kMean = 1e-4, kLargest = 1e-2, kOfGpu = 2e-2;
// The same numbers are added in another order.
constexpr double kOrder = 2e-5;

class SampledEnvironment : public EnvironmentFixture {
protected:
    SampledEnvironment() : EnvironmentFixture(kSize, {kCube, true, true}) {}

    gl::DrawOptions optionsOf(int samples, Technique technique = Technique::single) const
    {
        gl::DrawOptions options{technique, 4, 0};
        options.environment = light();
        options.environment.samples = samples;
        return options;
    }
};

Material sampledMaterial(size_t form, LobeAxes axes, int lobes)
{
    return withLobes(testMaterials()[form], testLobes(axes, lobes));
}

TEST_P(SampledEnvironment, IsTheMeanOverDirectionsOfTheCpu)
{
    const CubeImage cube = readUnfilteredCube(gl(), *environment_);
    const bool exact = renderer_->capabilities().softwareSampling;
    for (const Material& material :
         {sampledMaterial(0, LobeAxes::tilted, 2), sampledMaterial(2, LobeAxes::tilted, 1),
          sampledMaterial(6, LobeAxes::bent, 3)})
        for (const int samples : {1, 24}) {
            const gl::DrawOptions options = optionsOf(samples);
            const Drawn picture = drawn(material, {}, options);
            EXPECT_EQ(picture.stats.itemsFailed, 0);
            EXPECT_EQ(picture.stats.whyNotSampled, "");
            EXPECT_EQ(picture.stats.passes, 1);
            EXPECT_EQ(picture.stats.environmentError, 0.0);
            const auto difference = compareImages(
                picture.pixels,
                sampledImage(material, cube, geometry_, perspectiveView(), options.environment),
                1.0);
            EXPECT_LT(difference.meanRelative, exact ? kMean : kOfGpu)
                << material.name << " " << samples << ": " << describe(difference);
            EXPECT_LT(difference.maxRelative, exact ? kLargest : 10 * kOfGpu)
                << material.name << " " << samples << ": " << describe(difference);
        }
    EXPECT_TRUE(log.empty()) << log[0];
}

// The tester: other lobes draw other directions, and another material reflects something else.
TEST_P(SampledEnvironment, IsNotThatOfOtherLobesOrAnotherMaterial)
{
    const CubeImage cube = readUnfilteredCube(gl(), *environment_);
    const Material material = sampledMaterial(0, LobeAxes::tilted, 2);
    const gl::DrawOptions options = optionsOf(8);
    const auto pixels = drawn(material, {}, options).pixels;
    Material other = material;
    for (LobeKnot& knot : other.lobes.knots) knot.lobes[0].level += 0.2f;
    Material brighter = material;
    brighter.scales[0] *= 1.01f;
    for (const Material& wrong : {other, brighter})
        EXPECT_GT(
            compareImages(
                pixels,
                sampledImage(wrong, cube, geometry_, perspectiveView(), options.environment), 1.0)
                .meanRelative,
            10 * kMean);
}

TEST_P(SampledEnvironment, CostsTheLookUpsOfTheMaterialForEachDirection)
{
    // p(wo) q(h) p(wi), and the environment.
    const Drawn picture = drawn(sampledMaterial(0, LobeAxes::tilted, 2), {}, optionsOf(12));
    EXPECT_EQ(picture.stats.maxLookups, 12 * (1 + 3));
}

TEST_P(SampledEnvironment, AddsUpWithTheLights)
{
    const Material material = sampledMaterial(0, LobeAxes::tilted, 2);
    const auto lights = testLights(5);
    auto sum = drawn(material, {}, optionsOf(8)).pixels;
    gl::DrawOptions without;
    const auto lit = drawn(material, lights, without).pixels;
    for (size_t i = 0; i < sum.size(); ++i)
        if (i % 4 != 3) sum[i] += lit[i];
    const Drawn both = drawn(material, lights, optionsOf(8));
    EXPECT_EQ(both.stats.passes, 2);
    const auto difference = compareImages(both.pixels, sum, 1e-2);
    EXPECT_LT(difference.maxRelative, kOrder) << describe(difference);
}

TEST_P(SampledEnvironment, IsStoredInEveryFormat)
{
    auto lights = testLights(3);
    for (Light& light : lights) light.intensity *= 0.05f;
    const Material material = sampledMaterial(0, LobeAxes::tilted, 2);
    const auto gpu = renderer_->createMaterial(material);
    gl::DrawOptions options = optionsOf(4);
    options.environment.intensity *= 0.1f;
    const auto exact = drawItems(*renderer_, kSize, perspectiveView(),
                                 {{gpu.get(), gpuMesh_.get()}}, lights, options)
                           .pixels;
    const std::vector<double> radiance(exact.begin(), exact.end());
    for (const OffscreenFormat format : {OffscreenFormat::rgba8, OffscreenFormat::rgba16f})
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb, Transfer::toneMap}) {
            Offscreen offscreen = makeOffscreen(kSize, format);
            const auto stats =
                renderer_->draw({offscreen.framebuffer(), kSize, kSize, transfer},
                                perspectiveView(), {{gpu.get(), gpuMesh_.get()}}, lights, options);
            EXPECT_EQ(stats.whyNotSampled, "");
            const auto stored =
                truth::storedImage(radiance, transfer, format == OffscreenFormat::rgba8);
            EXPECT_LE(deviationOf(offscreen.readPixels(), stored, stats.error).share, 1.0)
                << static_cast<int>(transfer);
        }
}

TEST_P(SampledEnvironment, IsThatOfLobesWithAReasonInOtherTechniques)
{
    const Material material = sampledMaterial(0, LobeAxes::tilted, 2);
    const auto lights = testLights(2);
    for (const Technique technique : {Technique::batched, Technique::twoLookup}) {
        const Drawn asked = drawn(material, lights, optionsOf(8, technique)),
                    lobes = drawn(material, lights, optionsOf(0, technique));
        EXPECT_NE(asked.stats.whyNotSampled.find(techniqueName(technique)), std::string::npos)
            << asked.stats.whyNotSampled;
        EXPECT_EQ(asked.stats.technique, technique);
        EXPECT_EQ(asked.stats.whyReplaced, "");
        EXPECT_EQ(asked.pixels, lobes.pixels);
        EXPECT_LE(asked.stats.maxLookups, lobes.stats.maxLookups);
    }
    gl::DrawOptions limited = optionsOf(8);
    limited.maxLookups = 3;
    EXPECT_NE(drawn(material, {}, limited).stats.whyNotSampled.find("limit of look-ups"),
              std::string::npos);
}

TEST_P(SampledEnvironment, IsThatOfLobesWithAReasonForPackedMaterials)
{
    const Material material = withLobes(noiseMaterial(formPqpr(8, 0.5, 6), Storage::log8),
                                        testLobes(LobeAxes::tilted, 2));
    const auto library = renderer_->createLibrary({material, material});
    Offscreen offscreen = makeOffscreen(kSize);
    const auto stats = renderer_->drawBatch(
        {offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
        {library.get(), gpuMesh_.get(), {{glm::mat4(1.0f), 1}}}, {}, optionsOf(8));
    EXPECT_EQ(stats.itemsFailed, 0);
    // Where the context cannot pack, materials are items and directions are drawn.
    EXPECT_EQ(stats.whyNotSampled.empty(), !library->whyNotPacked().empty());
}

TEST_P(SampledEnvironment, IsThatOfLobesWithAReasonWhereUniformsDoNotSuffice)
{
    auto options = rendererOptions();
    options.capabilities = renderer_->capabilities();
    options.capabilities->maxUniformVectors = 140;
    gl::Renderer renderer(options);
    const auto gpu = renderer.createMaterial(sampledMaterial(0, LobeAxes::bent, 7));
    const auto environment = renderer.createEnvironment(testPanorama(64), {kCube, false, true});
    const auto mesh = renderer.createMesh(mesh_);
    gl::DrawOptions draw = optionsOf(8);
    draw.environment.map = environment.get();
    const Drawn picture =
        drawItems(renderer, kSize, perspectiveView(), {{gpu.get(), mesh.get()}}, {}, draw);
    EXPECT_NE(picture.stats.whyNotSampled.find("room"), std::string::npos)
        << picture.stats.whyNotSampled;
}

TEST_P(SampledEnvironment, NeedsTheUnfilteredCubeAndANumberInRange)
{
    const Material material = sampledMaterial(0, LobeAxes::tilted, 2);
    EXPECT_THROW(drawn(material, {}, optionsOf(-1)), Error);
    EXPECT_THROW(drawn(material, {}, optionsOf(kMostSamples + 1)), Error);
    environment_ = renderer_->createEnvironment(testPanorama(64), {kCube, true});
    EXPECT_EQ(environment_->unfilteredTexture(), 0u);
    try {
        drawn(material, {}, optionsOf(8));
        ADD_FAILURE() << "drawn";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("EnvironmentOptions::unfiltered"),
                  std::string::npos);
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, SampledEnvironment, ::testing::ValuesIn(allVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
