// GgxSamplingTest.cpp - the best diffuse + GGX for a material that is one, and for others.
#include <fbrdf/peers/GgxSampling.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

Vec3d direction(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// The integral of a density over the upper half or, for GGX alone, over all directions whose half
/// vector is above the horizon.
double integral(const GgxSampling& sampling, const Vec3d& wo, bool upperHalf)
{
    constexpr int kThetas = 400, kPhis = 400;
    double sum = 0.0;
    for (int i = 0; i < kThetas; ++i)
        for (int j = 0; j < kPhis; ++j) {
            const double theta = kPi * (i + 0.5) / kThetas;
            const Vec3d wi = direction(theta, 2.0 * kPi * (j + 0.5) / kPhis);
            if (wi.z > (upperHalf ? 0.0 : -wo.z))
                sum += sampling.density(wo, wi) * std::sin(theta) * 2.0 * kPi * kPi /
                       (kThetas * kPhis);
        }
    return sum;
}

TEST(GgxSampling, DensityIntegratesToOne)
{
    for (const double theta : {0.1, 0.7, 1.4}) {
        EXPECT_NEAR(integral({0.2, 0.2, 1.0}, direction(theta, 1.0), false), 1.0, 3e-3) << theta;
        EXPECT_NEAR(integral({0.2, 0.6, 1.0}, direction(theta, 2.0), false), 1.0, 3e-3) << theta;
    }
    EXPECT_NEAR(integral({0.5, 0.5, 0.0}, direction(1.2, 0.0), true), 1.0, 1e-3);
}

/// f cos theta_i is the density of a mixture.
Reflectance reflectanceOf(const GgxSampling& sampling)
{
    return [sampling](const Vec3d& wo, const Vec3d& wi) {
        return wi.z > 0.0 ? Vec3d(sampling.density(wo, wi) / wi.z) : Vec3d(0.0);
    };
}

TEST(GgxSampling, FindsTheMixtureThatAMaterialIs)
{
    const GgxSampling truth{0.17, 0.17, 0.35};
    const GgxSamplingFit fit = bestGgxSampling(ReflectedLight(reflectanceOf(truth), true, 0));
    // What falls below the horizon at grazing angles is lost, so the best is not quite the same.
    EXPECT_NEAR(fit.sampling.alphaX / 0.17, 1.0, 0.1);
    EXPECT_EQ(fit.sampling.alphaX, fit.sampling.alphaY);
    EXPECT_NEAR(fit.sampling.highlight, 0.35, 0.05);
    EXPECT_LT(fit.deviation, 0.15);
    EXPECT_LE(fit.deviationOfFreeShares, fit.deviation);
}

TEST(GgxSampling, IsNotPerfectForADiffuseMaterialThatDarkens)
{
    const auto dark = [](const Vec3d& wo, const Vec3d& wi) {
        return wi.z > 0.0 ? Vec3d(0.5 * wo.z * wi.z) : Vec3d(0.0);
    };
    const ReflectedLight light(dark, true, 0);
    const GgxSamplingFit fit = bestGgxSampling(light);
    // cos^2 by the cosine: the mean of its square over its squared mean is 9 / 8.
    EXPECT_LE(fit.deviation, std::sqrt(1.0 / 8.0) + 0.01);
    EXPECT_GT(fit.deviation, 0.05);
    EXPECT_NEAR(fit.deviation, light.deviation([&](const Vec3d& wo, const Vec3d& wi) {
        return fit.sampling.density(wo, wi);
    }),
                1e-6);
}

}  // namespace
