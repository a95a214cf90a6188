// ConserveTest.cpp - no material gives more light than it gets. No GL.
#include <fbrdf/fit/Fit.h>
#include <fbrdf/metrics/Metrics.h>

#include "Known.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

Source lambertian(double albedo)
{
    Source source = test::sourceOf(test::Ggx{0.3, 0.3, 0.0, albedo});
    source.name = "bright";
    source.evaluate = [albedo](const Vec3d&, const Vec3d&) {
        return Vec3d(albedo, 0.5 * albedo, 0.25 * albedo) / kPi;
    };
    return source;
}

FitResult fit(const Source& source, const std::string& form, bool conserve)
{
    FitOptions options;
    options.form = form;
    options.resolution = 16;
    options.heldOut = false;
    options.conserve = conserve;
    return fitMaterial(source, options);
}

double largestAlbedo(const Material& material)
{
    double largest = 0.0;
    for (int degrees = 0; degrees <= 84; degrees += 12)
        for (int turn = 0; turn < 2; ++turn) {
            const Vec3d a = directionalAlbedo(
                [&](const Vec3d& wo, const Vec3d& wi) { return evaluate(material, wo, wi); },
                degrees * kPi / 180.0, turn * kPi / 2.0);
            largest = std::max({largest, a.x, a.y, a.z});
        }
    return largest;
}

// Quadrature of 256 x 128 directions against the 8-bit rounding of the material: 1e-3.
constexpr double kOne = 1.0 + 1e-3;

TEST(Conserve, ScalesWhatIsTooBrightAndKeepsItsHue)
{
    const FitResult bright = fit(lambertian(1.25), "hdio", true);
    EXPECT_NEAR(bright.summary.conserved, 0.8, 2e-3);
    EXPECT_LE(largestAlbedo(bright.material), kOne);
    EXPECT_GE(largestAlbedo(bright.material), 0.99);
    const Vec3d f = evaluate(bright.material, Vec3d(0, 0.6, 0.8), Vec3d(0, 0, 1));
    EXPECT_NEAR(f.x / f.y, 2.0, 0.01);
    EXPECT_NEAR(f.y / f.z, 2.0, 0.01);
}

TEST(Conserve, LeavesWhatIsDarkEnoughAlone)
{
    const FitResult dark = fit(lambertian(0.8), "hdio", true);
    EXPECT_EQ(dark.summary.conserved, 1.0);
    EXPECT_EQ(dark.material.scales, fit(lambertian(0.8), "hdio", false).material.scales);
}

TEST(Conserve, IsAskedForAndNotDoneUnasked)
{
    const FitResult bright = fit(lambertian(1.25), "hdio", false);
    EXPECT_EQ(bright.summary.conserved, 1.0);
    EXPECT_GT(largestAlbedo(bright.material), 1.2);
}

TEST(Conserve, LooksAtAnisotropicFormsFromSeveralSides)
{
    Source source = test::sourceOf(test::Ggx{0.2, 0.6, 1.0, 0.0});
    source.evaluate = [model = test::Ggx{0.2, 0.6, 1.0, 0.0}](const Vec3d& wo, const Vec3d& wi) {
        return 1.4 * model(wo, wi);
    };
    const FitResult result = fit(source, "pqpr", true);
    EXPECT_LT(result.summary.conserved, 1.0);
    EXPECT_LE(largestAlbedo(result.material), kOne);
}

}  // namespace
}  // namespace fbrdf
