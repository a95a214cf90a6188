// Pictures under an environment are compared with the same lobes on the CPU, over the texels that
// the GPU has.
#include <fbrdf/environment/LobeFit.h>

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include "EnvironmentFixture.h"
#include "support/gl/CompareImages.h"

#include <algorithm>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48, kCube = 32;
// Relative to the mean of the picture: the emulation is in double and filters exactly. A GPU's
// filter knows 256 places between two texels.
constexpr double kEmulation = 1e-4, kEmulationOfGpu = 2e-2;
// The same numbers are added in another order.
constexpr double kOrder = 2e-5;

struct Table {
    std::string name;
    LobeTable lobes;
};

std::vector<Table> tables()
{
    return {{"one", testLobes(LobeAxes::tilted, 1)},
            {"two", testLobes(LobeAxes::tilted, 2)},
            {"three", testLobes(LobeAxes::tilted, 3)},
            {"bent one", testLobes(LobeAxes::bent, 1)},
            {"bent three", testLobes(LobeAxes::bent, 3)},
            {"bent three across", testLobes(LobeAxes::bent, 3, true)},
            {"bent seven", testLobes(LobeAxes::bent, 7)}};
}

class Environment : public EnvironmentFixture {
protected:
    Environment() : EnvironmentFixture(kSize, {kCube, true}) {}
    void SetUp() override
    {
        EnvironmentFixture::SetUp();
        if (isReady()) cube_ = readCube(gl(), *environment_);
    }

    double emulation() const
    {
        return renderer_->capabilities().softwareSampling ? kEmulation : kEmulationOfGpu;
    }

    gl::DrawOptions optionsOf(Technique technique, int maxLookups = 0) const
    {
        gl::DrawOptions options{technique, 4, maxLookups};
        options.environment = light();
        return options;
    }

    std::vector<double> expected(const LobeTable& lobes) const
    {
        return environmentImage(lobes, cube_, geometry_, perspectiveView(), light());
    }

    CubeImage cube_;
};

TEST_P(Environment, IsTheSumOfLobesOverTheTexelsOfTheCube)
{
    for (const Table& table : tables()) {
        const Drawn picture =
            drawn(withLobes(testMaterials()[0], table.lobes), {}, optionsOf(Technique::single));
        EXPECT_EQ(picture.stats.itemsFailed, 0);
        EXPECT_EQ(picture.stats.itemsWithoutEnvironment, 0) << picture.stats.whyNoEnvironment;
        EXPECT_EQ(picture.stats.passes, 1);
        EXPECT_EQ(picture.stats.maxLookups, table.lobes.lobes + 1);
        EXPECT_EQ(picture.stats.environmentError, table.lobes.error);
        const auto difference = compareImages(picture.pixels, expected(table.lobes), 1.0);
        EXPECT_LT(difference.maxRelative, emulation())
            << table.name << ": " << describe(difference);
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

// The tester: lobes of another table, or an environment that is turned, must not pass.
TEST_P(Environment, IsNotThatOfOtherLobesOrAnotherRotation)
{
    const LobeTable lobes = testLobes(LobeAxes::tilted, 2);
    const Drawn picture =
        drawn(withLobes(testMaterials()[0], lobes), {}, optionsOf(Technique::single));
    LobeTable other = lobes;
    for (LobeKnot& knot : other.knots) knot.lobes[1].tilt += 0.1f;
    EXPECT_GT(compareImages(picture.pixels, expected(other), 1.0).maxRelative, 10 * kEmulation);
    gl::EnvironmentLight turned = light();
    turned.rotation = gl::environmentRotation(0.72f);
    const auto image = environmentImage(lobes, cube_, geometry_, perspectiveView(), turned);
    EXPECT_GT(compareImages(picture.pixels, image, 1.0).maxRelative, 10 * kEmulation);
}

// In an environment of 1 everywhere a picture shows the weights alone: the directional albedo.
TEST_P(Environment, OfOneEverywhereShowsTheAlbedo)
{
    environment_ = made(whitePanorama());
    const CubeImage white{1, {std::vector<Vec3f>(6, Vec3f(1.0f))}};
    for (const Table& table : tables()) {
        const Drawn picture =
            drawn(withLobes(testMaterials()[0], table.lobes), {}, optionsOf(Technique::twoLookup));
        const auto albedo =
            environmentImage(table.lobes, white, geometry_, perspectiveView(), light());
        const auto difference = compareImages(picture.pixels, albedo, 1.0);
        EXPECT_LT(difference.maxRelative, emulation())
            << table.name << ": " << describe(difference);
    }
}

// Levels that are not drawn yet are not looked up: sharp lobes look as in a smaller environment.
TEST_P(Environment, BeforeItIsFinishedIsASmallerOne)
{
    const auto material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    gl::EnvironmentOptions options{2 * kCube, true};
    const auto finished = renderer_->createEnvironment(testPanorama(64), options);
    options.gradual = true;
    const auto begun = renderer_->createEnvironment(testPanorama(64), options);
    CubeImage smaller = readCube(gl(), *finished);
    smaller.size = kCube;
    smaller.levels.erase(smaller.levels.begin());
    const auto small = renderer_->createEnvironment(smaller, {0, true});
    const auto picture = [&](const gl::GpuEnvironment& map) {
        gl::DrawOptions drawing = optionsOf(Technique::single);
        drawing.environment.map = &map;
        return drawn(material, {}, drawing).pixels;
    };
    const auto whole = picture(*finished), first = picture(*begun);
    EXPECT_LT(compareImages(first, picture(*small), 1.0).maxRelative, emulation());
    EXPECT_GT(compareImages(first, whole, 1.0).maxRelative, 10 * emulation());
    EXPECT_TRUE(renderer_->refine(*begun, 6LL * 2 * kCube * 2 * kCube));
    EXPECT_EQ(picture(*begun), whole);
}

TEST_P(Environment, TurnedByAQuarterIsTheTurnedPanorama)
{
    // The cells of a lobe are turned in another way: without a lamp hardly anything depends on
    // that.
    constexpr double kCells = 2e-3;
    const Panorama calm = testPanorama(64, 0.0f);
    const auto straight = made(calm), across = made(turnedPanorama(calm));
    const auto material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    gl::DrawOptions options = optionsOf(Technique::single);
    const auto picture = [&](const gl::GpuEnvironment& map, double angle) {
        options.environment.map = &map;
        options.environment.rotation = gl::environmentRotation(static_cast<float>(angle));
        return drawn(material, {}, options).pixels;
    };
    const auto turned = picture(*straight, 0.5 * kPi);
    const auto difference = compareImages(turned, picture(*across, 0.0), 1.0);
    EXPECT_LT(difference.maxRelative, kCells) << describe(difference);
    for (const double other : {0.0, -0.5 * kPi})
        EXPECT_GT(compareImages(turned, picture(*straight, other), 1.0).maxRelative, 0.1);
}

TEST_P(Environment, AddsUpWithTheLightsInEveryTechnique)
{
    const auto lights = testLights(5);
    for (const size_t form : {size_t{0}, size_t{2}, size_t{6}}) {
        const Material material = withLobes(testMaterials()[form], testLobes(LobeAxes::tilted, 3));
        gl::DrawOptions without = optionsOf(Technique::single);
        without.environment = {};
        auto sum = drawn(material, {}, optionsOf(Technique::single)).pixels;
        const auto lit = drawn(material, lights, without).pixels;
        for (size_t i = 0; i < sum.size(); ++i)
            if (i % 4 != 3) sum[i] += lit[i];
        for (const Technique technique : allTechniques())
            for (const int lookups : {0, 1, 2, 5}) {
                const Drawn both = drawn(material, lights, optionsOf(technique, lookups));
                EXPECT_EQ(both.stats.whyReplaced, "");
                EXPECT_EQ(both.stats.itemsWithoutEnvironment, 0);
                if (lookups > 0) {
                    EXPECT_LE(both.stats.maxLookups, lookups);
                }
                const auto difference = compareImages(both.pixels, sum, 1e-2);
                EXPECT_LT(difference.maxRelative, kOrder)
                    << techniqueName(technique) << " " << lookups << describe(difference);
            }
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(Environment, AddsUpWithListsOfLights)
{
    if (GetParam().legacy) GTEST_SKIP() << "needs OpenGL 3.1";
    const auto lights = testLights(20);
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::bent, 3));
    gl::DrawOptions options = optionsOf(Technique::single);
    const auto expected = drawn(material, lights, options).pixels;
    options.clustered = true;
    const Drawn lists = drawn(material, lights, options);
    EXPECT_EQ(lists.stats.passes, 1);
    EXPECT_EQ(lists.stats.itemsWithoutEnvironment, 0);
    const auto difference = compareImages(lists.pixels, expected, 1e-2);
    EXPECT_LT(difference.maxRelative, kOrder) << describe(difference);
}

TEST_P(Environment, IsStoredInEveryFormatByEveryTechnique)
{
    auto lights = testLights(3);
    for (Light& light : lights) light.intensity *= 0.05f;
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));
    const auto gpu = renderer_->createMaterial(material);
    gl::DrawOptions options = optionsOf(Technique::single);
    options.environment.intensity *= 0.1f;
    const auto exact = drawItems(*renderer_, kSize, perspectiveView(),
                                 {{gpu.get(), gpuMesh_.get()}}, lights, options)
                           .pixels;
    const std::vector<double> radiance(exact.begin(), exact.end());
    for (const OffscreenFormat format :
         {OffscreenFormat::rgba8, OffscreenFormat::rgba16f, OffscreenFormat::rgba32f})
        for (const Transfer transfer :
             {Transfer::linear, Transfer::exposure, Transfer::srgb, Transfer::toneMap})
            for (const Technique technique : allTechniques()) {
                Offscreen offscreen = makeOffscreen(kSize, format);
                options.technique = technique;
                const auto stats = renderer_->draw(
                    {offscreen.framebuffer(), kSize, kSize, transfer}, perspectiveView(),
                    {{gpu.get(), gpuMesh_.get()}}, lights, options);
                EXPECT_EQ(stats.itemsWithoutEnvironment, 0) << stats.whyNoEnvironment;
                const auto stored =
                    truth::storedImage(radiance, transfer, format == OffscreenFormat::rgba8);
                EXPECT_LE(deviationOf(offscreen.readPixels(), stored, stats.error).share, 1.0)
                    << techniqueName(technique) << " " << static_cast<int>(transfer);
            }
}

TEST_P(Environment, IsMultipliedByTheExposure)
{
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 1));
    const auto gpu = renderer_->createMaterial(material);
    std::vector<float> pictures[2];
    for (const bool exposed : {false, true}) {
        Offscreen offscreen = makeOffscreen(kSize);
        gl::DrawOptions options = optionsOf(Technique::single);
        gl::Target target{offscreen.framebuffer(), kSize, kSize, Transfer::exposure};
        if (exposed)
            target.exposure = 4.0f;
        else
            options.environment.intensity *= 4.0f;
        renderer_->draw(target, perspectiveView(), {{gpu.get(), gpuMesh_.get()}}, {}, options);
        pictures[exposed ? 1 : 0] = offscreen.readPixels();
    }
    EXPECT_LT(compareImages(pictures[1], pictures[0]).maxRelative, kOrder);
}

TEST_P(Environment, WithFewerLobesHasTheirEnergy)
{
    environment_ = made(whitePanorama());
    const Material material = withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 3));
    gl::DrawOptions options = optionsOf(Technique::single);
    const auto all = drawn(material, {}, options).pixels;
    for (const int lobes : {1, 2, 3, 9}) {
        options.environment.lobes = lobes;
        const Drawn fewer = drawn(material, {}, options);
        EXPECT_EQ(fewer.stats.maxLookups, 1 + std::min(3, lobes));
        EXPECT_LT(compareImages(fewer.pixels, all).maxRelative, kEmulation);
    }
}

// Objects of a library are drawn in one call a pass, each with lobes of its own.
TEST_P(Environment, OfPackedLibrariesIsThatOfItems)
{
    for (const Table& table : tables()) {
        const Form form = formPqpr(8, 0.5, 6);
        const Material first = withLobes(noiseMaterial(form, Storage::log8), table.lobes);
        Material second = withLobes(noiseMaterial(form, Storage::log8, 2), table.lobes);
        second.lobes.spread *= 0.5f;
        for (LobeKnot& knot : second.lobes.knots) {
            knot.cosine *= 0.5f;
            for (Lobe& lobe : knot.lobes) lobe.level *= 0.9f;
        }
        const auto library = renderer_->createLibrary({first, second});
        const auto gpuFirst = renderer_->createMaterial(first);
        const auto gpuSecond = renderer_->createMaterial(second);
        const glm::mat4 left = glm::translate(glm::mat4(0.5f), Vec3f(-1.0f, 0.0f, 0.0f)),
                        right = glm::translate(glm::mat4(0.5f), Vec3f(1.0f, 0.0f, 0.0f));
        glm::mat4 models[] = {left, right};
        for (glm::mat4& model : models) model[3][3] = 1.0f;
        for (const Technique technique : {Technique::single, Technique::twoLookup}) {
            const auto expected = drawItems(*renderer_, kSize, perspectiveView(),
                                            {{gpuFirst.get(), gpuMesh_.get(), models[0]},
                                             {gpuSecond.get(), gpuMesh_.get(), models[1]}},
                                            testLights(2), optionsOf(technique))
                                      .pixels;
            Offscreen offscreen = makeOffscreen(kSize);
            const auto stats = renderer_->drawBatch(
                {offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                {library.get(), gpuMesh_.get(), {{models[0], 0}, {models[1], 1}}}, testLights(2),
                optionsOf(technique));
            EXPECT_EQ(stats.itemsWithoutEnvironment, 0) << stats.whyNoEnvironment;
            EXPECT_EQ(stats.environmentError, table.lobes.error);
            if (library->whyNotPacked().empty()) {
                EXPECT_EQ(stats.drawCalls, stats.passes);
            }
            const auto difference = compareImages(offscreen.readPixels(), expected, 1e-2);
            EXPECT_LT(difference.maxRelative, 2 * kOrder) << table.name << describe(difference);
        }
    }
}

// A file from before there were lobes: prepare waits for the fit, a draw does not.
TEST_P(Environment, FitsLobesThatAMaterialLacks)
{
    const Material material = noiseMaterial(formIo(), Storage::half);
    const LobeTable fitted = fitLobes(material);
    const auto gpu = renderer_->createMaterial(material);
    renderer_->prepare(*gpu, optionsOf(Technique::single), 0);
    const Drawn picture =
        drawItems(*renderer_, kSize, perspectiveView(), {{gpu.get(), gpuMesh_.get()}}, {},
                  optionsOf(Technique::single));
    EXPECT_EQ(picture.stats.itemsWithoutEnvironment, 0) << picture.stats.whyNoEnvironment;
    EXPECT_EQ(picture.stats.environmentError, fitted.error);
    auto fewer = optionsOf(Technique::single);
    fewer.environment.lobes = 1;
    EXPECT_EQ(
        drawItems(*renderer_, kSize, perspectiveView(), {{gpu.get(), gpuMesh_.get()}}, {}, fewer)
            .stats.environmentError,
        withFewerLobes(fitted, 1).error);
    const auto difference = compareImages(picture.pixels, expected(fitted), 1.0);
    EXPECT_LT(difference.maxRelative, emulation()) << describe(difference);
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(Environment, IsLeftOutUntilTheLobesAreFitted)
{
    const auto gpu = renderer_->createMaterial(noiseMaterial(formIo(), Storage::half));
    const auto draw = [&] {
        return drawItems(*renderer_, kSize, perspectiveView(), {{gpu.get(), gpuMesh_.get()}}, {},
                         optionsOf(Technique::single));
    };
    const Drawn first = draw();
    EXPECT_EQ(first.stats.itemsFailed, 0);
    if (first.stats.itemsWithoutEnvironment > 0) {
        EXPECT_NE(first.stats.whyNoEnvironment.find("being fitted"), std::string::npos);
        draw();
        EXPECT_EQ(log.size(), 1u);
    }
    renderer_->prepare(*gpu, optionsOf(Technique::single), 0);
    EXPECT_EQ(draw().stats.itemsWithoutEnvironment, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, Environment, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
