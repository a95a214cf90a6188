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

// Midpoints of 1024 x 512 half vectors, as a check of the rule that refines.
double albedoOnAFineGrid(const BrdfFunction& brdf, double theta_i)
{
    constexpr int kZeniths = 1024, kAzimuths = 512;
    const Vec3d wi = directionFromAngles(theta_i, 0.0);
    double sum = 0.0;
    for (int i = 0; i < kZeniths; ++i) {
        const double u = (i + 0.5) / kZeniths, theta_h = 0.5 * kPi * u * u;
        for (int j = 0; j < kAzimuths; ++j) {
            const Vec3d h = directionFromAngles(theta_h, 2.0 * kPi * (j + 0.5) / kAzimuths);
            const double cosTheta_d = glm::dot(wi, h);
            const Vec3d wo = 2.0 * cosTheta_d * h - wi;
            if (cosTheta_d > 0.0 && wo.z > 0.0)
                sum += brdf(wo, wi).x * 4.0 * cosTheta_d * wo.z * u * std::sin(theta_h);
        }
    }
    return sum * kPi / kZeniths * 2.0 * kPi / kAzimuths;
}

// Tables have such lobes: with kinks along theta_h and theta_d, and narrow along x.
Vec3d kinked(const Vec3d& wo, const Vec3d& wi)
{
    const Vec3d h = glm::normalize(wo + wi);
    const double rough = std::abs(std::fmod(9.0 * std::acos(std::min(1.0, h.z)), 1.0) - 0.5);
    const double along = std::exp(-200.0 * h.x * h.x - 20.0 * h.y * h.y);
    return Vec3d(0.1 + 0.3 * rough + 2.0 * along * std::abs(glm::dot(wi, h) - 0.7));
}

TEST(DirectionalAlbedo, FollowsKinksAndAnisotropy)
{
    constexpr double kStated = 1e-4;
    for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0})
        EXPECT_NEAR(directionalAlbedo(kinked, degrees * kPi / 180.0).x,
                    albedoOnAFineGrid(kinked, degrees * kPi / 180.0), kStated)
            << degrees;
}

TEST(DirectionalAlbedo, EvaluatesFewTimesWhatIsSmooth)
{
    int evaluations = 0;
    const auto counted = [&](const Vec3d&, const Vec3d&) {
        ++evaluations;
        return Vec3d(1.0 / kPi);
    };
    directionalAlbedo(counted, 0.5);
    EXPECT_LT(evaluations, 7000);
}

TEST(DirectionalAlbedo, EvaluatesStepsNotForEver)
{
    int evaluations = 0;
    const auto steps = [&](const Vec3d& wo, const Vec3d&) {
        ++evaluations;
        return Vec3d(std::fmod(1e4 * std::abs(wo.x + wo.y), 1.0) < 0.5 ? 1.0 : 0.0);
    };
    directionalAlbedo(steps, 0.5);
    EXPECT_LE(evaluations, 131072);
}

TEST(ReciprocityError, OfAnEighthOfThePairsIsNear)
{
    const auto wrong = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(1.0 + 0.5 * std::sin(7.0 * wo.x) + 0.1 * wi.y);
    };
    const double whole = medianReciprocityError(wrong, 2);
    EXPECT_GT(whole, 0.1);
    // Twice the standard error that MaterialInfo.cpp states.
    EXPECT_NEAR(medianReciprocityError(wrong, 2, 8192), whole, 0.026 * whole);
}

TEST(MirrorError, IsTheLogarithmBetweenTheTwoSidesOfThePlaneOfIncidence)
{
    const auto oneSided = [](const Vec3d& wo, const Vec3d& wi) {
        const double side = wi.x * wo.y - wi.y * wo.x;
        return Vec3d(std::exp(side > 0.0 ? 0.3 : -0.3));
    };
    EXPECT_NEAR(medianMirrorError(oneSided, 2), 0.6, 1e-6);
    EXPECT_EQ(medianMirrorError(lambertian(0.8), 2), 0.0);
    const auto lobe = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(std::exp(4.0 * glm::dot(wo, wi)) + wo.z);
    };
    EXPECT_NEAR(medianMirrorError(lobe, 2), 0.0, 1e-12) << "not reciprocal, but its mirror image";
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
