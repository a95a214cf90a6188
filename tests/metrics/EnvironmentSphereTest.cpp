// EnvironmentSphereTest.cpp - the scene of environments: exposure, white furnace, lobes against the
// sum over texels, and that a difference is seen.
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/metrics/EnvironmentSphere.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

constexpr int kSize = 12, kCube = 8;

Panorama sky(int width, int height)
{
    Panorama panorama{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3d w = panoramaDirection((x + 0.5) / width, (y + 0.5) / height);
            panorama.texels.emplace_back(1.0 + w.y, 1.0 + 0.5 * w.x, 1.2 - 0.3 * w.z);
        }
    return panorama;
}

Vec3d lambert(const Vec3d&, const Vec3d& wi)
{
    return wi.z > 0.0 ? Vec3d(0.5 / kPi) : Vec3d(0.0);
}

/// A cosine of albedo 1/2 alone.
LobeTable cosineTable()
{
    LobeTable table;
    table.lobes = 1;
    table.thetas = 2;
    table.knots.resize(2);
    for (LobeKnot& knot : table.knots) knot.cosine = Vec3f(0.5f);
    return table;
}

TEST(EnvironmentSphere, ShowsAGreyLambertianAtFourTenths)
{
    const EnvironmentSphere sphere({sky(64, 32)}, kSize, kCube, 1);
    const auto grey = sphere.truth(lambert);
    // By how much black differs from it says how bright it is.
    const EnvironmentSphere::Image black(grey[0].size(), Vec3d(0.0));
    const double rms = std::pow(10.0, -sphere.psnr(grey[0], black, 0) / 20.0);
    EXPECT_NEAR(rms, 0.4, 0.1);  // the mean of squares of a sphere that is lit from above
}

TEST(EnvironmentSphere, LobesOfALambertianAreItsTruth)
{
    const EnvironmentSphere sphere({sky(64, 32)}, kSize, kCube, 1);
    const auto truth = sphere.truth(lambert), lit = sphere.lit(cosineTable());
    EXPECT_GT(sphere.psnr(lit[0], truth[0], 0), 40.0);
    for (size_t i = 0; i < truth[0].size(); ++i)
        if (sphere.pixels()[i].isSeen()) {
            EXPECT_LT(glm::length(lit[0][i] - truth[0][i]), 0.02 * glm::length(truth[0][i])) << i;
        }
}

TEST(EnvironmentSphere, FollowsAHighlight)
{
    const auto f = [](const Vec3d& wo, const Vec3d& wi) {
        return wi.z > 0.0 ? Vec3d(0.4 * lobeValue(glm::dot(wi, Vec3d(-wo.x, -wo.y, wo.z)), 4.0) /
                                  std::max(wi.z, 1e-2))
                          : Vec3d(0.0);
    };
    const EnvironmentSphere sphere({sky(64, 32)}, kSize, 4 * kCube, 1);  // lobe levels from 4 on
    const auto truth = sphere.truth(f);
    EXPECT_GT(sphere.psnr(sphere.lit(fitLobes(f, true))[0], truth[0], 0), 40.0);
    EXPECT_LT(sphere.psnr(sphere.lit(cosineTable())[0], truth[0], 0), 35.0);
}

TEST(EnvironmentSphere, PicturesThatAreEqualDifferByNothing)
{
    const EnvironmentSphere sphere({sky(16, 8)}, kSize, kCube, 1);
    const auto image = sphere.lit(cosineTable());
    EXPECT_TRUE(std::isinf(sphere.psnr(image[0], image[0], 0)));
}

TEST(EnvironmentSphere, ReductionKeepsTheMean)
{
    const auto meanOf = [](const Panorama& panorama) {
        Vec3d sum(0.0);
        for (int y = 0; y < panorama.height; ++y)
            for (int x = 0; x < panorama.width; ++x)
                sum += texelSolidAngle(panorama, y) * Vec3d(panorama.texel(x, y));
        return sum / (4.0 * kPi);
    };
    const Panorama large = sky(96, 48);
    for (const auto& [width, height] : {std::pair(32, 16), std::pair(40, 20), std::pair(96, 48)}) {
        const Panorama small = reduced(large, width, height);
        EXPECT_EQ(small.width, width);
        EXPECT_EQ(small.height, height);
        EXPECT_LT(glm::length(meanOf(small) - meanOf(large)), 1e-6);  // rounding of floats
    }
}

}  // namespace
