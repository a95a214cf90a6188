// FurnaceTest.cpp - the integrator of the energy tests, on known answers and on wrong ones.
#include "Furnace.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::test {
namespace {

BrdfFunction lambertian(double albedo)
{
    return [albedo](const Vec3d&, const Vec3d&) { return Vec3d(albedo / kPi); };
}

TEST(Furnace, HemisphereHasItsSolidAngleAndProjectedArea)
{
    EXPECT_NEAR(integrateHemisphere([](const Vec3d&) { return Vec3d(1.0); }).x, 2.0 * kPi, 1e-12);
    EXPECT_NEAR(integrateHemisphere([](const Vec3d& w) { return Vec3d(w.z); }).x, kPi, 1e-12);
}

TEST(Furnace, LambertianHasItsAlbedoFromEveryDirection)
{
    for (const double degrees : {0.0, 25.0, 60.0, 85.0, 89.0})
        for (const double albedo : {0.0, 0.2, 1.0})
            EXPECT_NEAR(directionalAlbedo(lambertian(albedo),
                                          directionFromAngles(degrees * kPi / 180.0, 0.3))
                            .y,
                        albedo, 0.1 * kFurnace)
                << degrees;
}

TEST(Furnace, NarrowLobeOfKnownAlbedoIsResolved)
{
    // The normalised lobe of Phong at normal incidence, a highlight of roughness 0.01.
    const double n = 20000.0;
    const BrdfFunction lobe = [n](const Vec3d& wo, const Vec3d& wi) {
        const double cosine = glm::dot(Vec3d(-wi.x, -wi.y, wi.z), wo);
        return Vec3d(cosine > 0.0 ? (n + 2.0) / (2.0 * kPi) * std::pow(cosine, n) : 0.0);
    };
    EXPECT_NEAR(directionalAlbedo(lobe, {0.0, 0.0, 1.0}).x, 1.0, 1e-6);
}

TEST(Furnace, WhiteLambertianConserves)
{
    EXPECT_TRUE(conserves(lambertian(1.0)));
}

TEST(Furnace, RejectsOneLambertianOfOnePerCentTooMuchAndOneScaledByTwo)
{
    EXPECT_FALSE(conserves(lambertian(1.01)));
    EXPECT_FALSE(conserves(lambertian(2.0)));
}

TEST(Furnace, RejectsGainThatIsSeenOnlyTowardsGrazing)
{
    EXPECT_FALSE(conserves(
        [](const Vec3d& wo, const Vec3d&) { return Vec3d((wo.z < 0.1 ? 1.1 : 0.5) / kPi); }));
}

TEST(Furnace, ForgottenCosineIsSeen)
{
    const auto divided = [](const Vec3d&, const Vec3d& wi) { return Vec3d(1.0 / (kPi * wi.z)); };
    // 2, but for the cells that the horizon cuts, where f cos does not vanish.
    EXPECT_NEAR(directionalAlbedo(divided, {0.0, 0.0, 1.0}).x, 2.0, 0.1);
}

}  // namespace
}  // namespace fbrdf::test
