// ReachTest.cpp - the figures that the README states, on real measurements and on models. No GL.
#include <fbrdf/fit/Fit.h>
#include <fbrdf/metrics/StandardSphere.h>
#include <fbrdf/sources/OpenSource.h>

#include "Known.h"
#include "support/DataDir.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

FitResult fit(const Source& source, const std::string& form, Storage storage)
{
    FitOptions options;
    options.form = form;
    options.storage = storage;
    return fitMaterial(source, options);
}

double spherePsnr(const Source& source, const Material& material)
{
    constexpr int kSize = 128;  // a quarter of the standard pixels, to be quick
    const auto picture = renderStandardSphere(
        [&](const Vec3d& wo, const Vec3d& wi) {
            return Vec3d(evaluate(material, Vec3f(wo), Vec3f(wi)));
        },
        kSize);
    return imageErrors(picture, renderStandardSphere(source.evaluate, kSize)).psnrLinear;
}

TEST(Reach, GarnetRedIsFarBelowTheMapsOf2001)
{
    FBRDF_NEEDS_DATA("cornell_pbrt2/garnet_red.brdf");
    const Source source = openSource(test::dataPath("cornell_pbrt2/garnet_red.brdf"));
    const FitResult result = fit(source, "hdio", Storage::log8);
    EXPECT_EQ(result.summary.folds, 5);
    EXPECT_LE(result.summary.heldOut.logMedianChannel.x, 0.02);
    EXPECT_LE(result.summary.heldOut.logMedianChannel.y, 0.06);
    EXPECT_LE(result.summary.heldOut.logMedianChannel.z, 0.15);
}

TEST(Reach, PqprRepresentsAnisotropicMetal)
{
    const Source source = test::sourceOf(test::Ggx{0.1, 0.4, 0.9, 0.0});
    const FitResult result = fit(source, "pqpr", Storage::log8);
    EXPECT_LE(result.summary.heldOut.cosRms, 0.08);
    EXPECT_GE(spherePsnr(source, result.material),
              spherePsnr(source, fit(source, "pqpr", Storage::float32).material) - 1.0);
}

// Highlights of measured materials depend on phi_d, which hdio sees at grazing directions alone.
TEST(Reach, HdpioSeesWhatHdioDoesNotInTheSameBytes)
{
    FBRDF_NEEDS_DATA("nbrdf/nbrdf_weights.f32");
    const Source nickel = openSource(test::dataPath("nbrdf/nbrdf_weights.f32") + "#nickel");
    const Material stored = fit(nickel, "hdpio", Storage::log8).material;
    EXPECT_LE(materialBytes(stored), 3900u);
    EXPECT_EQ(lookupsPerPass(stored.form), 2);
    const double psnr = spherePsnr(nickel, stored);
    EXPECT_GE(psnr, 50.5);
    EXPECT_GE(psnr, spherePsnr(nickel, fit(nickel, "hdio", Storage::log8).material) + 2.0);
}

struct Gloss {
    test::Ggx ggx;
    double decibels;
};

class GlossReach : public testing::TestWithParam<Gloss> {};

TEST_P(GlossReach, HdioInFourKilobytes)
{
    const Source source = test::sourceOf(GetParam().ggx);
    const Material stored = fit(source, "hdio", Storage::log8).material;
    EXPECT_LE(materialBytes(stored), 4096u);
    const double psnr = spherePsnr(source, stored);
    EXPECT_GE(psnr, GetParam().decibels);
    EXPECT_GE(psnr, spherePsnr(source, fit(source, "hdio", Storage::float32).material) - 1.0);
}

INSTANTIATE_TEST_SUITE_P(Models, GlossReach,
                         testing::Values(Gloss{{0.1, 0.1, 0.04, 0.3}, 57.0},
                                         Gloss{{0.02, 0.02, 0.9, 0.0}, 58.0}));

}  // namespace
}  // namespace fbrdf
