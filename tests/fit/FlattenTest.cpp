// FlattenTest.cpp - beyond the samples a material gives back no more light than it gets. No GL.
#include "Conserve.h"
#include "Known.h"

#include <fbrdf/fit/Fit.h>
#include <fbrdf/metrics/Metrics.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kHighest = 55.0 * kPi / 180.0;  // of measured light and views

// Grows towards grazing angles by exp(steepness (theta_i + theta_o)); its largest albedo at
// kHighest is 0.7 for a steepness of 0.8.
BrdfFunction growing(double steepness)
{
    return [steepness](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(0.0135, 0.027, 0.054) * std::exp(steepness * (std::acos(std::min(wo.z, 1.0)) +
                                                                   std::acos(std::min(wi.z, 1.0))));
    };
}

Source measured(const BrdfFunction& brdf)
{
    Source function;
    function.name = "growing";
    function.isotropic = true;
    function.evaluate = brdf;
    Source source = test::scattered(function, 20000, 2);
    const auto isOutside = [](const Sample& s) {
        return static_cast<double>(std::min(s.wi.z, s.wo.z)) < std::cos(kHighest);
    };
    source.samples.erase(std::remove_if(source.samples.begin(), source.samples.end(), isOutside),
                         source.samples.end());
    return source;
}

FitResult fitTo(const Source& source, const std::string& form)
{
    FitOptions options;
    options.form = form;
    options.heldOut = false;
    options.straightens = false;
    return fitMaterial(source, options);
}

class Flatten : public testing::TestWithParam<std::string> {};

TEST_P(Flatten, KeepsTheAlbedoBelowOneAndWhatWasMeasured)
{
    const BrdfFunction brdf = growing(0.8);
    ASSERT_LT(directionalAlbedo(brdf, kHighest).z, 1.0);
    ASSERT_GT(directionalAlbedo(brdf, 85.0 * kPi / 180.0).z, 1.0);
    const FitResult fit = fitTo(measured(brdf), GetParam());
    EXPECT_LE(largestAlbedo(fit.material, 1), 1.0);
    EXPECT_LT(fit.summary.all.logMedian, 0.01);
    const Vec3d low(std::sin(1.4), 0.0, std::cos(1.4)), other(-low.x, 0.0, low.z);
    const Vec3d f = evaluate(fit.material, low, other);
    EXPECT_NEAR(f.z / f.x, 4.0, 0.1);
    EXPECT_GT(f.z, brdf(Vec3d(std::sin(kHighest), 0.0, std::cos(kHighest)), Vec3d(0.0, 0.0, 1.0))
                       .z);  // less steep is not dark
}

TEST_P(Flatten, LeavesSlopesThatKeepTheAlbedoBelowOne)
{
    const BrdfFunction brdf = growing(0.4);
    const FitResult fit = fitTo(measured(brdf), GetParam());
    const Vec3d low(std::sin(1.3), 0.0, std::cos(1.3)), other(-low.x, 0.0, low.z);
    EXPECT_NEAR(evaluate(fit.material, low, other).z / brdf(low, other).z, 1.0, 0.15);
}

// Two tables, a table and a curve, a volume and a table, a sum.
INSTANTIATE_TEST_SUITE_P(Forms, Flatten, testing::Values("hdio", "hdg", "hdpu", "io+hdio"),
                         [](const auto& form) {
                             std::string name = form.param;
                             std::replace(name.begin(), name.end(), '+', '_');
                             return name;
                         });

// What the samples themselves demand is not taken from them.
TEST(FlattenMeasured, AlbedosAboveOneStay)
{
    const BrdfFunction brdf = [](const Vec3d&, const Vec3d&) { return Vec3d(0.5); };
    const FitResult fit = fitTo(measured(brdf), "hdio");
    EXPECT_LT(fit.summary.all.logRms, 0.01);
    EXPECT_NEAR(largestAlbedo(fit.material, 1), 0.5 * kPi, 0.05);
}

}  // namespace
}  // namespace fbrdf
