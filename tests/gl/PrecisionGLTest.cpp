// What the plan promises of precision: each technique, form, target and transfer against the CPU
// reference in double.
#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"

#include <algorithm>
#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr int kLights = 12;

bool isSigned(const Material& material)
{
    const auto holdsSigns = [](const Table& t) { return t.storage == Storage::signedHalf; };
    return std::any_of(material.tables.begin(), material.tables.end(), holdsSigns);
}

/// RGB of a reference as a target stores it; alpha left.
std::vector<double> stored(std::vector<double> image, Transfer transfer, bool unorm)
{
    for (size_t i = 0; i < image.size(); ++i) {
        if (i % 4 == 3) continue;
        image[i] = transferred(transfer, 1.0, image[i]);
        if (unorm) image[i] = std::min(image[i], 1.0);
    }
    return image;
}

/// The largest error as a multiple of what the bound allows.
double share(const std::vector<float>& found, const std::vector<double>& exact,
             const ErrorBound& bound)
{
    double total = 0.0, worst = 0.0;
    size_t lit = 0;
    for (const double value : exact) {
        total += value;
        lit += value != 0.0 ? 1 : 0;
    }
    const double floor = 1e-3 * total / static_cast<double>(std::max<size_t>(lit, 1));
    for (size_t i = 0; i < exact.size(); ++i) {
        const double allowed = bound.relative * std::max(exact[i], floor) + bound.absolute;
        worst = std::max(worst, std::abs(static_cast<double>(found[i]) - exact[i]) / allowed);
    }
    return worst;
}

class Precision : public GlTest {};

TEST_P(Precision, HoldsInEveryFormTechniqueTargetAndTransfer)
{
    gl::Renderer renderer = makeRenderer();
    const gl::MeshData sphere = sphereMesh(16);
    const auto mesh = renderer.createMesh(sphere);
    const gl::View view = perspectiveView();
    Offscreen floats = makeOffscreen(kSize);
    const auto geometry = geometryBuffer(gl(), floats, sphere, glm::mat4(1.0f), view);
    double worst = 0.0;
    for (const Material& material : testMaterials()) {
        if (isSigned(material)) continue;  // the bound is relative to magnitudes that cancel
        const auto gpu = renderer.createMaterial(material);
        auto lights = testLights(kLights);
        for (Light& light : lights) light.intensity /= static_cast<float>(2 * kLights);
        const auto radiance = referenceImage(material, geometry, lights, view);
        for (const auto format :
             {OffscreenFormat::rgba32f, OffscreenFormat::rgba16f, OffscreenFormat::rgba8})
            for (const Transfer transfer : {Transfer::linear, Transfer::srgb, Transfer::toneMap})
                for (const Technique technique :
                     {Technique::single, Technique::batched, Technique::twoLookup}) {
                    Offscreen offscreen = makeOffscreen(kSize, format);
                    const auto stats =
                        renderer.draw({offscreen.framebuffer(), kSize, kSize, transfer}, view,
                                      {{gpu.get(), mesh.get()}}, lights, {technique, 8, 0});
                    EXPECT_EQ(stats.technique, technique);
                    EXPECT_EQ(stats.whyReplaced, "");
                    const auto exact = stored(radiance, transfer, format == OffscreenFormat::rgba8);
                    const double part = share(offscreen.readPixels(), exact, stats.error);
                    EXPECT_LE(part, 1.0)
                        << material.name << " " << techniqueName(technique) << " format "
                        << static_cast<int>(format) << " transfer " << static_cast<int>(transfer)
                        << " lights " << kLights << " bound " << stats.error.relative << " + "
                        << stats.error.absolute;
                    worst = std::max(worst, part);
                }
    }
    EXPECT_GT(worst, 0.3) << "a bound that nothing comes near says nothing";
}

TEST_P(Precision, OfReplacedTechniquesIsThatOfWhatIsDrawn)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->floatTargets = false;
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
