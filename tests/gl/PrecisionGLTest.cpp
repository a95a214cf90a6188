// The plan's promise of precision is checked for each technique, form, target and transfer, against
// the CPU reference in double.
#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

class Precision : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        Offscreen floats = makeOffscreen(kSize);
        geometry_ = geometryBuffer(gl(), floats, sphere_, glm::mat4(1.0f), view_);
    }

    const gl::MeshData sphere_ = sphereMesh(16);
    const gl::View view_ = perspectiveView();
    GeometryBuffer geometry_;
};

TEST_P(Precision, IsWithinBoundsInEveryFormTechniqueTargetAndTransfer)
{
    gl::Renderer renderer = makeRenderer();
    const auto mesh = renderer.createMesh(sphere_);
    double worst = 0.0;
    for (const Material& material : testMaterials())
        for (const int count : {1, 12}) {
            if (hasSigns(material)) continue;  // the bound is relative to magnitudes that cancel
            const auto gpu = renderer.createMaterial(material);
            auto lights = testLights(count);
            for (Light& light : lights) light.intensity /= static_cast<float>(2 * count);
            const auto radiance = referenceImage(material, geometry_, lights, view_);
            for (const auto format :
                 {OffscreenFormat::rgba32f, OffscreenFormat::rgba16f, OffscreenFormat::rgba8})
                for (const Transfer transfer :
                     {Transfer::linear, Transfer::srgb, Transfer::toneMap})
                    for (const Technique technique : allTechniques()) {
                        Offscreen offscreen = makeOffscreen(kSize, format);
                        const auto stats =
                            renderer.draw({offscreen.framebuffer(), kSize, kSize, transfer}, view_,
                                          {{gpu.get(), mesh.get()}}, lights, {technique, 8, 0});
                        EXPECT_EQ(stats.technique, technique);
                        EXPECT_EQ(stats.whyReplaced, "");
                        const auto exact =
                            storedImage(radiance, transfer, format == OffscreenFormat::rgba8);
                        const double part =
                            deviationOf(offscreen.readPixels(), exact, stats.error).share;
                        EXPECT_LE(part, 1.0)
                            << material.name << " " << techniqueName(technique) << " format "
                            << static_cast<int>(format) << " transfer "
                            << static_cast<int>(transfer) << " lights " << count << " bound "
                            << stats.error.relative << " + " << stats.error.absolute;
                        worst = std::max(worst, part);
                    }
        }
    EXPECT_GT(worst, 0.3) << "a bound that nothing comes near says nothing";
}

// OpenGL ES often cannot blend in RGBA32F.
TEST_P(Precision, IsWithinBoundsWhereSumsAreHalves)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->floatTargets = false;
    gl::Renderer renderer(options);
    const auto mesh = renderer.createMesh(sphere_);
    auto lights = testLights(5);
    for (Light& light : lights) light.intensity /= 10.0f;
    double worst = 0.0;
    for (const Material& material : testMaterials()) {
        if (hasSigns(material)) continue;
        const auto gpu = renderer.createMaterial(material);
        const auto radiance = referenceImage(material, geometry_, lights, view_);
        for (const auto format : {OffscreenFormat::rgba16f, OffscreenFormat::rgba8})
            for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
                Offscreen offscreen = makeOffscreen(kSize, format);
                const auto stats =
                    renderer.draw({offscreen.framebuffer(), kSize, kSize, transfer}, view_,
                                  {{gpu.get(), mesh.get()}}, lights, {Technique::twoLookup, 8, 0});
                EXPECT_EQ(stats.technique, Technique::twoLookup) << stats.whyReplaced;
                EXPECT_LE(stats.maxLookups, 2);
                if (isCurved(transfer)) {
                    EXPECT_EQ(stats.accumulation, "RGBA16F");
                }
                const auto exact =
                    storedImage(radiance, transfer, format == OffscreenFormat::rgba8);
                const double part = deviationOf(offscreen.readPixels(), exact, stats.error).share;
                EXPECT_LE(part, 1.0)
                    << material.name << " format " << static_cast<int>(format) << " bound "
                    << stats.error.relative << " + " << stats.error.absolute;
                worst = std::max(worst, part);
            }
    }
    EXPECT_GT(worst, 0.2) << "a bound that nothing comes near says nothing";
}

// As on a GPU, to which small surfaces cost less; a CPU takes RGBA32F.
TEST_P(Precision, IsWithinBoundsInWhateverFormatLightsAddUp)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->softwareSampling = false;
    gl::Renderer renderer(options);
    const auto mesh = renderer.createMesh(sphere_);
    std::map<std::string, int> taken;
    double worst = 0.0;
    const auto drawn = [&](const Material& material, const gl::DrawOptions& drawOptions, int count,
                           float dim, Transfer transfer) {
        const auto gpu = renderer.createMaterial(material);
        auto lights = testLights(count);
        for (Light& light : lights) light.intensity *= dim / static_cast<float>(count);
        Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
        const auto stats = renderer.draw({offscreen.framebuffer(), kSize, kSize, transfer}, view_,
                                         {{gpu.get(), mesh.get()}}, lights, drawOptions);
        const auto exact =
            storedImage(referenceImage(material, geometry_, lights, view_), transfer, true);
        const double part = deviationOf(offscreen.readPixels(), exact, stats.error).share;
        EXPECT_LE(part, 1.0) << material.name << " in " << stats.accumulation << " bound "
                             << stats.error.relative << " + " << stats.error.absolute;
        worst = std::max(worst, part);
        return stats;
    };
    for (const Form& form : {formPqp(8, 0.5), formPqpr(8, 0.5, 6)})
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb, Transfer::toneMap})
            for (const int count : {2, 3, 40})
                for (const float dim : {0.002f, 0.5f, 20.0f}) {
                    const auto stats =
                        drawn(calmMaterial(form), {Technique::twoLookup}, count, dim, transfer);
                    ++taken[stats.accumulation];
                    EXPECT_NE(stats.whyAccumulation.find("allowed"), std::string::npos);
                }
    // Halves that are cut off, as on llvmpipe, are within the tolerance of no sum.
    for (const char* format : {"RGBA8", "RGBA32F"}) EXPECT_GT(taken[format], 0) << format;
    EXPECT_EQ(taken["RGBA16"] > 0, renderer.capabilities().unorm16Targets);
    for (const auto asked : {ColourFormat::rgba8, ColourFormat::rgba16f, ColourFormat::rgba16,
                             ColourFormat::rgba32f}) {
        if (asked == ColourFormat::rgba16 && !renderer.capabilities().unorm16Targets) continue;
        gl::DrawOptions wanted{Technique::twoLookup};
        wanted.accumulation = asked;
        const auto stats = drawn(calmMaterial(formPqp(8, 0.5)), wanted, 4, 0.15f, Transfer::linear);
        EXPECT_EQ(stats.accumulation, colourFormatName(asked)) << stats.whyAccumulation;
    }
    EXPECT_GT(worst, 0.3) << "a bound that nothing comes near says nothing";
}

// A driver may refuse at any size what it promised.
TEST_P(Precision, IsThatOfFloatsWhereSmallSurfacesAreRefused)
{
    Hooks hooks(context().loader());
    gl::RendererOptions options = rendererOptions();
    options.load = Hooks::load;
    options.loadUser = &hooks;
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->softwareSampling = false;
    if (!options.capabilities->unorm16Targets) GTEST_SKIP() << "there is no format to refuse";
    gl::Renderer renderer(options);
    const auto gpu = renderer.createMaterial(calmMaterial(formPqp(8, 0.5)));
    const auto mesh = renderer.createMesh(sphereMesh(16));
    Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
    const auto accumulation = [&] {
        return renderer
            .draw({offscreen.framebuffer(), offscreen.width(), offscreen.width()},
                  perspectiveView(), {{gpu.get(), mesh.get()}}, testLights(3),
                  {Technique::twoLookup})
            .accumulation;
    };
    EXPECT_EQ(accumulation(), "RGBA16");
    hooks.refusedFormat = GL_RGBA16;
    offscreen = makeOffscreen(kSize + 1, OffscreenFormat::rgba8);  // for which there are none yet
    EXPECT_EQ(accumulation(), "RGBA32F");
}

TEST_P(Precision, OfReplacedTechniquesIsThatOfWhatIsDrawn)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->floatTargets = options.capabilities->halfTargets = false;
    gl::Renderer renderer(options);
    const auto gpu = renderer.createMaterial(testMaterials()[2]);
    const auto mesh = renderer.createMesh(sphereMesh(16));
    Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
    const auto stats =
        renderer.draw({offscreen.framebuffer(), kSize, kSize, Transfer::srgb}, perspectiveView(),
                      {{gpu.get(), mesh.get()}}, testLights(5), {Technique::twoLookup, 8, 0});
    EXPECT_EQ(stats.technique, Technique::single);
    EXPECT_NE(stats.whyReplaced.find("offscreen"), std::string::npos) << stats.whyReplaced;
    EXPECT_EQ(stats.passes, 1);
}

INSTANTIATE_TEST_SUITE_P(Backends, Precision,
                         ::testing::Values(GlVariant{Backend::egl, false},
                                           GlVariant{Backend::egl, true}),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
