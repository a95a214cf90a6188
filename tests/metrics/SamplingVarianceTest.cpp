// SamplingVarianceTest.cpp - variances by quadrature against closed forms and against directions
// that are drawn.
#include <fbrdf/brdf/LobeSampling.h>
#include <fbrdf/metrics/SamplingVariance.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fbrdf;

namespace {

// The rings about the mirror direction end at the horizon within a cell: 2e-4 of an integral of
// cosines, whose root is what a deviation of 0 is off by.
constexpr double kRoot = 0.02, kRelative = 2e-3;
// Of 12 x 20,000 directions, whose squares spread more than they themselves do.
constexpr double kDrawn = 0.02;

Vec3d lambert(const Vec3d&, const Vec3d& wi)
{
    return wi.z > 0.0 ? Vec3d(0.3, 0.5, 0.7) / kPi : Vec3d(0.0);
}

double cosine(const Vec3d&, const Vec3d& wi)
{
    return std::max(0.0, wi.z) / kPi;
}

TEST(SamplingVariance, CosineIsPerfectForALambertian)
{
    for (const bool isotropic : {true, false})
        EXPECT_LT(ReflectedLight(lambert, isotropic, 1).deviation(cosine), kRoot);
}

TEST(SamplingVariance, EvenDirectionsOfALambertianHaveAThirdOfItsSquare)
{
    // The integral of (cos / pi)^2 2 pi is 4 / 3.
    const auto even = [](const Vec3d&, const Vec3d&) { return 0.5 / kPi; };
    for (const bool isotropic : {true, false})
        EXPECT_NEAR(ReflectedLight(lambert, isotropic, 1).deviation(even), std::sqrt(1.0 / 3.0),
                    kRelative);
}

TEST(SamplingVariance, IsInfiniteWhereLightIsNeverSampled)
{
    const auto half = [](const Vec3d& wo, const Vec3d& wi) {
        return wi.y > 0.0 ? cosine(wo, wi) : 0.0;
    };
    EXPECT_TRUE(std::isinf(ReflectedLight(lambert, false, 1).deviation(half)));
}

TEST(SamplingVariance, OfBlackIsNothing)
{
    const auto black = [](const Vec3d&, const Vec3d&) { return Vec3d(0.0); };
    EXPECT_EQ(ReflectedLight(black, true, 1).deviation(cosine), 0.0);
}

/// A diffuse part, and a highlight about the mirror direction.
Vec3d glossy(const Vec3d& wo, const Vec3d& wi)
{
    if (!(wi.z > 0.0)) return Vec3d(0.0);
    const double c = glm::dot(wi, Vec3d(-wo.x, -wo.y, wo.z));
    return Vec3d(0.2, 0.1, 0.05) / kPi + Vec3d(0.1 * stretchedCosine(c, 0.2) / std::max(0.2, wi.z));
}

LobeTable glossyLobes(float level)
{
    LobeTable table;
    table.lobes = 1;
    table.thetas = 2;
    table.knots.resize(2);
    for (LobeKnot& knot : table.knots) {
        knot.cosine = {0.2f, 0.1f, 0.05f};
        knot.lobes[0] = {Vec3f(0.15f), level, 0.0f};
    }
    return table;
}

/// The same deviation by drawing.
double drawnDeviation(const ReflectedLight& light, const LobeTable& table)
{
    constexpr int kDraws = 20000;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    double sum = 0.0;
    for (const ReflectedLight::View& view : light.views())
        for (int i = 0; i < kDraws; ++i) {
            const double x = number(random), y = number(random);
            const auto sample = sampleLobes(table, view.wo, Vec2<double>(x, y));
            if (!(sample.wi.z > 0.0)) continue;
            const Vec3d estimate = glossy(view.wo, sample.wi) * (sample.wi.z / sample.pdf);
            sum += view.weight * glm::dot(estimate, estimate) / (3.0 * kDraws);
        }
    return light.deviationOf(sum);
}

TEST(SamplingVariance, IsThatOfDirectionsThatAreDrawn)
{
    const ReflectedLight light(glossy, true, 1);
    const auto deviation = [&light](const LobeTable& table) {
        return light.deviation(
            [&](const Vec3d& wo, const Vec3d& wi) { return lobePdf(table, wo, wi); });
    };
    const LobeTable near = glossyLobes(3.7f), wide = glossyLobes(5.0f);
    EXPECT_NEAR(deviation(near) / drawnDeviation(light, near), 1.0, kDrawn);
    EXPECT_NEAR(deviation(wide) / drawnDeviation(light, wide), 1.0, kDrawn);
    // The tester: other lobes have another deviation.
    EXPECT_GT(deviation(wide) / drawnDeviation(light, near), 1.2);
}

}  // namespace
