#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/Metrics.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// Midpoint rule on 256 x 128 half vectors: what the furnace test below reaches on a lobe of 0.02.
constexpr double kQuadrature = 2e-3;

BrdfFunction lambertian(double albedo)
{
    return [albedo](const Vec3d&, const Vec3d&) { return Vec3d(albedo / kPi); };
}

// Walter et al. 2007, Eq. 33: the GGX distribution of normals, of which integral D cos theta_h dw_h
// = 1.
double ggx(double cosTheta_h, double alpha)
{
    const double c2 = cosTheta_h * cosTheta_h, a2 = alpha * alpha;
    return a2 / (kPi * std::pow(c2 * (a2 - 1.0) + 1.0, 2.0));
}

// D(h) (n.h) / (4 (wi.h) (n.wo)): its albedo is the share of the normals whose mirror image stays
// above the horizon.
BrdfFunction mirrorFacets(double alpha)
{
    return [alpha](const Vec3d& wo, const Vec3d& wi) {
        const Vec3d h = glm::normalize(wo + wi);
        return Vec3d(ggx(h.z, alpha) * h.z / (4.0 * glm::dot(wi, h) * wo.z));
    };
}

TEST(DirectionalAlbedo, OfALambertianIsItsAlbedo)
{
    for (const double degrees : {0.0, 30.0, 60.0, 85.0})
        EXPECT_NEAR(directionalAlbedo(lambertian(0.7), degrees * kPi / 180.0).x, 0.7, kQuadrature)
            << degrees;
}

TEST(DirectionalAlbedo, OfMirrorFacetsAtNormalIncidenceIsClosed)
{
    // Facets up to 45 degrees reflect upwards; of GGX normals tan^2 / (alpha^2 + tan^2) lie below
    // an angle.
    for (const double alpha : {0.02, 0.1, 0.3, 0.8})
        EXPECT_NEAR(directionalAlbedo(mirrorFacets(alpha), 0.0).y, 1.0 / (1.0 + alpha * alpha),
                    kQuadrature)
            << alpha;
}

TEST(DirectionalAlbedo, OfNarrowMirrorFacetsStaysNearOneAtAnyIncidence)
{
    // At 60 degrees facets tilted by more than 15 degrees may reflect down: at most this share of
    // them.
    const double alpha = 0.02, tangent = std::tan(15.0 * kPi / 180.0);
    const double lost = alpha * alpha / (alpha * alpha + tangent * tangent);
    const double albedo = directionalAlbedo(mirrorFacets(alpha), kPi / 3.0).x;
    EXPECT_LE(albedo, 1.0 + kQuadrature);
    EXPECT_GE(albedo, 1.0 - lost - kQuadrature);
}

TEST(DirectionalAlbedo, SeparatesChannels)
{
    const Vec3d albedo = directionalAlbedo(
        [](const Vec3d&, const Vec3d&) { return Vec3d(0.9, 0.5, 0.0) / kPi; }, 0.5);
    EXPECT_NEAR(albedo.x, 0.9, kQuadrature);
    EXPECT_NEAR(albedo.y, 0.5, kQuadrature);
    EXPECT_EQ(albedo.z, 0.0);
}

TEST(PhysicsErrors, OfALambertian)
{
    const PhysicsErrors errors = physicsErrors(lambertian(0.8), 2);
    EXPECT_EQ(errors.reciprocity, 0.0);
    EXPECT_NEAR(errors.albedoMax, 0.8, kQuadrature);
}

TEST(PhysicsErrors, SeeALambertianScaledByTwo)
{
    EXPECT_NEAR(physicsErrors(lambertian(2.0), 2).albedoMax, 2.0, 2.0 * kQuadrature);
}

TEST(PhysicsErrors, SeeAForgottenCosine)
{
    // f / cos theta_o is not reciprocal, by |ln cos theta_i / cos theta_o|.
    const auto wrong = [](const Vec3d& wo, const Vec3d&) { return Vec3d(0.1 / wo.z); };
    EXPECT_GT(physicsErrors(wrong, 2).reciprocity, 0.2);
}

TEST(PhysicsErrors, OneSidedBlackIsInfinitelyUnreciprocal)
{
    const auto wrong = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(wo.x > wi.x ? 1.0 : 0.0);
    };
    EXPECT_TRUE(std::isinf(physicsErrors(wrong, 2).reciprocity));
}

}  // namespace
}  // namespace fbrdf
