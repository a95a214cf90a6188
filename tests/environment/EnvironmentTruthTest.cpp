// EnvironmentTruthTest.cpp - the sum over texels against closed forms.
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/environment/EnvironmentTruth.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

Panorama constant(int width, int height, const Vec3f& radiance)
{
    return {width, height,
            std::vector<Vec3f>(static_cast<size_t>(width) * static_cast<size_t>(height), radiance)};
}

Vec3d lambert(const Vec3d&, const Vec3d& wi)
{
    return wi.z > 0.0 ? Vec3d(0.5, 0.25, 0.75) / kPi : Vec3d(0.0);
}

/// Frames that face in several directions.
std::vector<ShadingFrame<double>> frames()
{
    std::vector<ShadingFrame<double>> result;
    for (const Vec3d& normal :
         {Vec3d(0, 0, 1), Vec3d(0, 1, 0), Vec3d(-0.3, -0.8, 0.2), Vec3d(1, 0, 0)})
        result.push_back(shadingFrame<double>(normal, Vec3d(0.2, 0.5, -0.9)));
    return result;
}

Vec3d viewerOf(const ShadingFrame<double>& frame)
{
    return glm::normalize(frame.n + 0.7 * frame.t - 0.2 * frame.s);
}

TEST(EnvironmentTruth, OfAConstantIsTheAlbedo)
{
    const Vec3f radiance(2.0f, 1.0f, 0.5f);
    const EnvironmentTruth truth({constant(64, 32, radiance)});
    for (const auto& frame : frames()) {
        const Vec3d found = truth.reflected(lambert, frame, viewerOf(frame)).front();
        const Vec3d expected = Vec3d(0.5, 0.25, 0.75) * Vec3d(radiance);
        // What the horizon cuts off of texels of 5 degrees.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 0.005 * expected[c]);
    }
}

TEST(EnvironmentTruth, OfOneTexelIsALight)
{
    Panorama panorama = constant(128, 64, Vec3f(0.0f));
    const int x = 40, y = 20;
    panorama.texels[static_cast<size_t>(y * 128 + x)] = Vec3f(10.0f, 20.0f, 30.0f);
    const Vec3d light = panoramaDirection((x + 0.5) / 128, (y + 0.5) / 64);
    const EnvironmentTruth truth({panorama});
    for (const auto& frame : frames()) {
        const double cosine = glm::dot(frame.n, light);
        const Vec3d found = truth.reflected(lambert, frame, viewerOf(frame)).front();
        const Vec3d expected = Vec3d(0.5, 0.25, 0.75) / kPi * std::max(0.0, cosine) *
                               Vec3d(10.0, 20.0, 30.0) * texelSolidAngle(panorama, y);
        if (std::abs(cosine) > 0.1) {
            EXPECT_LT(glm::length(found - expected), 2e-3 * glm::length(expected) + 1e-12);
        }
    }
}

TEST(EnvironmentTruth, ResolvesAHighlightWithinATexel)
{
    // A lobe of a degree in a texel of 3 degrees: its integral is 1 wherever the mirror direction
    // is.
    const auto f = [](const Vec3d& wo, const Vec3d& wi) {
        return wi.z > 0.0 ? Vec3d(lobeValue(glm::dot(wi, Vec3d(-wo.x, -wo.y, wo.z)), 0.0) / wi.z)
                          : Vec3d(0.0);
    };
    const EnvironmentTruth truth({constant(128, 64, Vec3f(1.0f))});
    TexelSplits coarse;
    coarse.near = coarse.nearest = 1;
    const EnvironmentTruth rough({constant(128, 64, Vec3f(1.0f))}, coarse);
    double worst = 0.0;
    for (const auto& frame : frames()) {
        EXPECT_NEAR(truth.reflected(f, frame, viewerOf(frame)).front().x, 1.0, 0.01);
        worst =
            std::max(worst, std::abs(rough.reflected(f, frame, viewerOf(frame)).front().x - 1.0));
    }
    EXPECT_GT(worst, 0.05);  // the tester: without splitting the texels it is not resolved
}

TEST(EnvironmentTruth, IntegratesSeveralAtOnce)
{
    const Panorama a = constant(16, 8, Vec3f(1.0f)), b = constant(16, 8, Vec3f(0.5f, 2.0f, 0.0f));
    const auto frame = frames()[2];
    const auto both = EnvironmentTruth({a, b}).reflected(lambert, frame, viewerOf(frame));
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0], EnvironmentTruth({a}).reflected(lambert, frame, viewerOf(frame))[0]);
    EXPECT_EQ(both[1], EnvironmentTruth({b}).reflected(lambert, frame, viewerOf(frame))[0]);
}

}  // namespace
