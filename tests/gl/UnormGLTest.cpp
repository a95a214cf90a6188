// Where no float can be drawn to, lights add up in RGBA8, scaled; the sum agrees with the reference
// in double within the plan's bound.
#include <gtest/gtest.h>

#include "support/gl/CoarseStore.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Reference.h"

#include <algorithm>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

/// Lights around the sphere, at about one distance, the first above the viewer.
std::vector<Light> ring(int count, float brightest)
{
    std::vector<Light> lights;
    for (int i = 0; i < count; ++i) {
        Light light;
        const float turn =
            2.0f * static_cast<float>(kPi) * static_cast<float>(i) / static_cast<float>(count);
        light.position = Vec3f(4.0f * std::cos(turn), 4.0f * std::sin(turn), 8.0f);
        light.intensity = Vec3f(1.0f, 0.9f, 0.8f) * (brightest * 60.0f / static_cast<float>(count));
        lights.push_back(light);
    }
    return lights;
}

class Unorm : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        Offscreen floats = makeOffscreen(kSize);
        geometry_ = geometryBuffer(gl(), floats, mesh_, glm::mat4(1.0f), perspectiveView());
    }

    gl::RendererOptions withoutFloatTargets()
    {
        gl::RendererOptions options = rendererOptions();
        options.capabilities = makeRenderer().capabilities();
        options.capabilities->floatTargets = options.capabilities->halfTargets = false;
        return options;
    }

    struct Result {
        gl::DrawStats stats;
        double share = 0.0;
    };
    Result draw(gl::Renderer& renderer, const Material& material, const std::vector<Light>& lights,
                const gl::DrawOptions& options, Transfer transfer = Transfer::linear)
    {
        const auto gpu = renderer.createMaterial(material);
        const auto mesh = renderer.createMesh(mesh_);
        Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
        offscreen.clear();
        Result result;
        result.stats = renderer.draw({offscreen.framebuffer(), kSize, kSize, transfer},
                                     perspectiveView(), {{gpu.get(), mesh.get()}}, lights, options);
        const auto exact = storedImage(
            referenceImage(material, geometry_, lights, perspectiveView()), transfer, true);
        result.share = deviationOf(offscreen.readPixels(), exact, result.stats.error).share;
        return result;
    }

    const gl::MeshData mesh_ = sphereMesh(16);
    GeometryBuffer geometry_;
};

TEST_P(Unorm, SumsAreWithinWhatThePlanStates)
{
    gl::Renderer renderer(withoutFloatTargets());
    double worst = 0.0;
    for (const Form& form :
         {formPqp(8, 0.5), formPqpr(8, 0.5, 6), sumOf(formPqp(8, 0.5), formIo())})
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb, Transfer::toneMap})
            for (const Technique technique : {Technique::batched, Technique::twoLookup}) {
                // A curve is steepest at black, where four lights lose too much.
                const int lights = isCurved(transfer) ? 2 : 4;
                const gl::DrawOptions options{technique, lights / 2};
                const Result drawn =
                    draw(renderer, calmMaterial(form),
                         ring(lights, isCurved(transfer) ? 0.08f : 0.15f), options, transfer);
                EXPECT_EQ(drawn.stats.itemsFailed, 0);
                EXPECT_EQ(drawn.stats.technique, technique) << drawn.stats.whyReplaced;
                EXPECT_EQ(drawn.stats.accumulation, "RGBA8");
                if (technique == Technique::twoLookup) {
                    EXPECT_LE(drawn.stats.maxLookups, 2);
                }
                EXPECT_LE(drawn.share, 1.0)
                    << form.name << " " << techniqueName(technique) << " transfer "
                    << static_cast<int>(transfer) << " bound " << drawn.stats.error.absolute;
                worst = std::max(worst, drawn.share);
            }
    EXPECT_GT(worst, 0.25) << "a bound that nothing comes near says nothing";
}

TEST_P(Unorm, MoreLightsLoseMoreAndTheBoundRises)
{
    gl::Renderer renderer(withoutFloatTargets());
    const gl::DrawOptions options{Technique::twoLookup};
    double last = 0.0;
    for (const int lights : {2, 4, 8}) {
        const Result drawn =
            draw(renderer, calmMaterial(formPqp(8, 0.5)), ring(lights, 0.25f), options);
        EXPECT_LE(drawn.share, 1.0) << lights;
        EXPECT_EQ(drawn.stats.passes, lights + 1);
        EXPECT_GT(drawn.stats.error.absolute, 1.3 * last);
        last = drawn.stats.error.absolute;
    }
}

TEST_P(Unorm, SumsThatWouldBeNoPictureAreReplacedWithTheReason)
{
    gl::Renderer renderer(withoutFloatTargets());
    // In steep tables the sum that is possible is far above the one that occurs.
    const Result drawn = draw(renderer, noiseMaterial(formPqp(8, 0.5), Storage::half),
                              ring(12, 0.25f), {Technique::twoLookup});
    EXPECT_EQ(drawn.stats.technique, Technique::single);
    EXPECT_NE(drawn.stats.whyReplaced.find("12 lights in RGBA8 surfaces"), std::string::npos)
        << drawn.stats.whyReplaced;
    EXPECT_EQ(drawn.stats.passes, 1);
    EXPECT_LE(drawn.share, 1.0);
}

TEST_P(Unorm, ALightInsideTheObjectsBoundsHasNoPeak)
{
    gl::Renderer renderer(withoutFloatTargets());
    auto lights = ring(3, 0.1f);
    lights[1].position = Vec3f(0.0f, 0.0f, 0.9f);
    const Result drawn =
        draw(renderer, calmMaterial(formPqp(8, 0.5)), lights, {Technique::twoLookup});
    EXPECT_EQ(drawn.stats.technique, Technique::single);
    EXPECT_NE(drawn.stats.whyReplaced, "");
}

TEST_P(Unorm, WithoutSurfacesThereIsTheOnePass)
{
    Hooks hooks(context().loader());
    gl::RendererOptions options = withoutFloatTargets();
    options.load = Hooks::load;
    options.loadUser = &hooks;
    gl::Renderer renderer(options);
    hooks.refuseFramebuffers = true;
    const Material material = calmMaterial(formPqp(8, 0.5));
    const Result drawn = draw(renderer, material, ring(3, 0.25f), {Technique::twoLookup});
    EXPECT_EQ(drawn.stats.technique, Technique::single);
    EXPECT_NE(drawn.stats.whyReplaced, "");
    EXPECT_LE(drawn.share, 1.0);
    EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const std::string& line) {
        return line.find("no RGBA8 surface") != std::string::npos;
    }));
}

class ByteStores : public Unorm {
protected:
    gl::RendererOptions storing(ByteStore store)
    {
        gl::RendererOptions options = withoutFloatTargets();
        options.load = coarselyStoring(context().options().backend, store);
        return options;
    }
    /// Steps that the plan of one pass says a byte may be off; a shader filters, and nothing else
    /// adds to them.
    double stepsOf(const gl::RendererOptions& options)
    {
        gl::Renderer renderer(options);
        const Result drawn =
            draw(renderer, calmMaterial(formPqp(8, 0.5)), ring(1, 0.2f), {}, Transfer::linear);
        EXPECT_LE(drawn.share, 1.0);
        return 255.0 * (drawn.stats.error.absolute - drawn.stats.error.maps.absolute);
    }
};

TEST_P(ByteStores, AreMeasured)
{
    EXPECT_NEAR(stepsOf(storing(ByteStore::truncated)), 1.0, 0.01);
    EXPECT_NEAR(stepsOf(storing(ByteStore::wrong)), 1.06, 0.01);
    // Between a half and one, halves are 2^-11 apart, and no code lies in the middle of two.
    const double viaHalves = stepsOf(storing(ByteStore::viaHalves));
    EXPECT_GT(viaHalves, 0.52);
    EXPECT_LT(viaHalves, 0.5 + 255.0 * 0x1p-12);
    const std::string name = reinterpret_cast<const char*>(gl().GetString(GL_RENDERER));
    if (name.find("llvmpipe") != std::string::npos) {
        EXPECT_NEAR(stepsOf(withoutFloatTargets()), 0.5, 0.01);
    }
}

TEST_P(ByteStores, ThatAHostKnowsAreNotMeasured)
{
    gl::RendererOptions options = storing(ByteStore::truncated);
    options.capabilities->rounding = StoreRounding{3.0, 4.0};
    EXPECT_NEAR(stepsOf(options), 3.0, 1e-9);
}

// The sums are within what is stated where bytes are stored coarsely; and what is true of llvmpipe
// is not true there.
TEST_P(ByteStores, AreWithinTheBoundOfSums)
{
    for (const ByteStore store : {ByteStore::truncated, ByteStore::viaHalves, ByteStore::wrong}) {
        gl::RendererOptions believing = storing(store);
        believing.capabilities->rounding = StoreRounding{0.5, 0.5};
        gl::Renderer renderer(storing(store)), wrong(believing);
        double used = 0.0, untrue = 0.0;
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb})
            for (const Technique technique : {Technique::single, Technique::twoLookup}) {
                const Material material = calmMaterial(formPqp(8, 0.5));
                const auto lights = ring(2, isCurved(transfer) ? 0.08f : 0.15f);
                const Result drawn = draw(renderer, material, lights, {technique}, transfer);
                EXPECT_EQ(drawn.stats.technique, technique) << drawn.stats.whyReplaced;
                EXPECT_LE(drawn.share, 1.0) << static_cast<int>(store);
                used = std::max(used, drawn.share);
                untrue =
                    std::max(untrue, draw(wrong, material, lights, {technique}, transfer).share);
            }
        EXPECT_GT(used, 0.4) << "a bound that nothing comes near says nothing";
        EXPECT_GT(untrue, 1.0) << static_cast<int>(store);
    }
}

TEST_P(ByteStores, AreWhatOpenGlGrantsWhereTheyCannotBeMeasured)
{
    Hooks hooks(context().loader());
    gl::RendererOptions options = withoutFloatTargets();
    options.load = Hooks::load;
    options.loadUser = &hooks;
    hooks.refuseFramebuffers = true;
    EXPECT_NEAR(stepsOf(options), 1.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Backends, ByteStores, ::testing::ValuesIn(allVariants()), variantName);
INSTANTIATE_TEST_SUITE_P(Backends, Unorm, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
