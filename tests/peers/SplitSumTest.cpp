// SplitSumTest.cpp - the split sum where it is exact, and where it cannot be.
#include <fbrdf/peers/SplitSum.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

Panorama sky()
{
    Panorama panorama{32, 16, {}};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const Vec3d w = panoramaDirection((x + 0.5) / 32, (y + 0.5) / 16);
            // Lamps all over, so that the width of a lobe shows.
            const double lamp = x % 8 == 4 && y % 4 == 2 ? 10.0 : 0.0;
            panorama.texels.emplace_back(1.0 + w.y + lamp, 1.0 + 0.5 * w.x + lamp, 0.5 + lamp);
        }
    return panorama;
}

TEST(SplitSum, IsExactForALambertian)
{
    const EnvironmentSphere sphere({sky()}, 24, 8, 1);
    const auto truth = sphere.truth([](const Vec3d&, const Vec3d& wi) {
        return wi.z > 0.0 ? Vec3d(0.5, 0.3, 0.2) / kPi : Vec3d(0.0);
    });
    const std::vector<Vec3d> albedo(sphere.pixels().size(), Vec3d(0.5, 0.3, 0.2));
    const SplitSum::Fit fit = SplitSum(sphere, 1).best(truth, albedo);
    EXPECT_GT(fit.psnr[0], 45.0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.diffuse[c] / albedo[0][c], 1.0, 0.03) << c;
}

TEST(SplitSum, FindsTheWidthOfItsOwnLobe)
{
    const EnvironmentSphere sphere({sky()}, 24, 8, 1);
    // Normal incidence of its lobe at every view: the mirror direction bent by the same rule.
    const double alpha = std::exp2(-7.0 + 0.25 * 20);
    const auto f = [alpha](const Vec3d& wo, const Vec3d& wi) {
        if (!(wi.z > 0.0)) return Vec3d(0.0);
        const Vec3d mirror(-wo.x, -wo.y, wo.z);
        const Vec3d axis = glm::normalize(glm::mix(mirror, Vec3d(0, 0, 1), alpha * alpha));
        const double c = glm::dot(axis, wi), h2 = 0.5 * (1.0 + c);
        const double d = h2 * (alpha * alpha - 1.0) + 1.0;
        return Vec3d(c > 0.0 ? 0.01 * c / (d * d) / std::max(wi.z, 1e-3) : 0.0);
    };
    const EnvironmentSphere white({Panorama{8, 4, std::vector<Vec3f>(32, Vec3f(1.0f))}}, 24, 8, 1);
    const std::vector<Vec3d> albedo = white.truth(f)[0];
    const SplitSum::Fit fit = SplitSum(sphere, 1).best(sphere.truth(f), albedo);
    EXPECT_NEAR(std::log2(fit.alpha / alpha), 0.0, 0.3);
}

}  // namespace
