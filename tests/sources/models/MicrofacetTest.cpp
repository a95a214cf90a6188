// MicrofacetTest.cpp - distributions and masking: the identities that make microfacets conserve.
#include <models/Microfacet.h>

#include "Furnace.h"
#include "Pairs.h"

#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

/// Quadrature of a lobe of roughness 0.02 or more.
constexpr double kQuadrature = 1e-5;
/// The same where max(0, w.h) has a kink inside the domain.
constexpr double kKink = 1e-3;

using Distribution = double (*)(const HalfGeometry&, const Roughness&);
using Lambda = double (*)(const Vec3d&, const Roughness&);

struct Microfacets {
    const char* name;
    Distribution distribution;
    Lambda lambda;
};
constexpr Microfacets kBoth[] = {{"ggx", ggxDistribution, ggxLambda},
                                 {"beckmann", beckmannDistribution, beckmannLambda}};
constexpr Roughness kRoughness[] = {{0.02, 0.02}, {0.1, 0.1}, {0.1, 0.4}, {1.0, 1.0}, {2.0, 0.3}};

/// D of a normal: of the pair that has both directions there.
double at(Distribution distribution, const Vec3d& h, const Roughness& alpha)
{
    return distribution(HalfGeometry(h, h), alpha);
}

TEST(Microfacets, NormalsProjectToTheAreaOfTheSurface)
{
    for (const Microfacets& m : kBoth)
        for (const Roughness& alpha : kRoughness)
            EXPECT_NEAR(integrateHemisphere([&](const Vec3d& h) {
                            return Vec3d(at(m.distribution, h, alpha) * h.z);
                        }).x,
                        1.0, kQuadrature)
                << m.name << " " << alpha.x << " " << alpha.y;
}

TEST(Microfacets, ForgettingTheCosineOfTheNormalIsSeen)
{
    const double sum = integrateHemisphere([&](const Vec3d& h) {
                           return Vec3d(at(ggxDistribution, h, {0.3, 0.3}));
                       }).x;
    EXPECT_GT(std::abs(sum - 1.0), 1000.0 * kQuadrature);
}

TEST(Microfacets, VisibleNormalsProjectToTheVisibleAreaOfTheSurface)
{
    // Heitz 2014, Eq. 14: integral of G1(w) max(0, w.h) D(h) = w.z, which fixes Lambda.
    for (const Microfacets& m : kBoth)
        for (const Roughness& alpha : kRoughness)
            for (const Vec3d& w : {directionDegrees(0.0, 0.0), directionDegrees(30.0, 20.0),
                                   directionDegrees(60.0, 100.0), directionDegrees(85.0, 45.0)}) {
                const double area =
                    integrateHemisphere([&](const Vec3d& h) {
                        return Vec3d(at(m.distribution, h, alpha) * std::max(0.0, glm::dot(w, h)));
                    }).x;
                EXPECT_NEAR(area / (1.0 + m.lambda(w, alpha)), w.z, kKink * w.z)
                    << m.name << " " << alpha.x << " " << alpha.y << " z " << w.z;
            }
}

TEST(Microfacets, LambdaIsZeroAtNormalAndGrowsTowardsGrazing)
{
    for (const Microfacets& m : kBoth) {
        EXPECT_EQ(m.lambda({0.0, 0.0, 1.0}, {0.3, 0.3}), 0.0);
        double previous = 0.0;
        for (double theta = 5.0; theta < 90.0; theta += 5.0) {
            const double lambda = m.lambda(directionDegrees(theta, 30.0), {0.3, 0.3});
            EXPECT_GE(lambda, previous) << m.name << " " << theta;
            previous = lambda;
        }
        EXPECT_GT(previous, 0.5) << m.name;
    }
}

TEST(HalfGeometry, OfGrazingOppositeDirectionsIsTheNormal)
{
    const double z = 1e-12;
    const HalfGeometry half({1.0, 0.0, z}, {-1.0, 0.0, z});
    EXPECT_EQ(half.h, Vec3d(0.0, 0.0, 1.0));
    EXPECT_DOUBLE_EQ(half.cosTheta_d, z);
}

TEST(HalfGeometry, AgreesWithItsDefinition)
{
    for (const auto& pair : spreadPairs(1000)) {
        const HalfGeometry half(pair.wo, pair.wi);
        EXPECT_NEAR(half.cosTheta_d, glm::dot(pair.wi, half.h), 1e-14);
        EXPECT_NEAR(half.complement_h(), 1.0 - half.h.z, 1e-14);
    }
}

TEST(Schlick, GoesFromF0ToOne)
{
    const Vec3d f0(0.04, 0.5, 1.0);
    EXPECT_EQ(schlickFresnel(f0, 1.0), f0);
    EXPECT_EQ(schlickFresnel(f0, 0.0), Vec3d(1.0));
    EXPECT_NEAR(schlickFresnel(f0, 0.5).x, 0.04 + 0.96 / 32.0, 1e-15);
    EXPECT_EQ(schlickWeight(1.0 + 1e-15), 0.0);
}

}  // namespace
}  // namespace fbrdf::test
