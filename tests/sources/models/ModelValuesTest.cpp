// ModelValuesTest.cpp - values of the analytic models that can be written down.
#include "Furnace.h"
#include "Pairs.h"

#include <fbrdf/base/Number.h>
#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

/// A handful of roundings.
constexpr double kTight = 1e-12;

const Vec3d kNormal(0.0, 0.0, 1.0);

Vec3d evaluate(const std::string& spec, const Vec3d& wo, const Vec3d& wi)
{
    return makeModelSource(spec).evaluate(wo, wi);
}

/// Expects value to be expected, relative to its size.
void expectValue(double value, double expected, double relative = kTight)
{
    EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(Lambert, IsAlbedoOverPi)
{
    for (const auto& pair : spreadPairs(20))
        EXPECT_EQ(evaluate("lambert:albedo=0.1/0.5/1", pair.wo, pair.wi),
                  Vec3d(0.1, 0.5, 1.0) / kPi);
}

TEST(Phong, PeaksInTheMirrorDirectionAndFallsWithThePowerOfTheCosine)
{
    const Vec3d wo = directionDegrees(20.0, 0.0);
    const double peak = 0.5 * 12.0 / (2.0 * kPi);
    expectValue(evaluate("phong:kd=0.2,ks=0.5,n=10", wo, directionDegrees(20.0, 180.0)).x,
                0.2 / kPi + peak);
    expectValue(evaluate("phong:kd=0.2,ks=0.5,n=10", wo, directionDegrees(40.0, 0.0)).x,
                0.2 / kPi + peak * std::pow(0.5, 10.0));
    expectValue(evaluate("phong:kd=0.2,ks=0.5,n=10", wo, directionDegrees(80.0, 0.0)).x, 0.2 / kPi);
}

TEST(Phong, AlbedoAtNormalIncidenceIsKdPlusKs)
{
    for (const char* n : {"0", "1", "7.5", "1000"}) {
        const Source source = makeModelSource(std::string("phong:kd=0.2,ks=0.5,n=") + n);
        EXPECT_NEAR(directionalAlbedo(source.evaluate, kNormal).x, 0.7, kFurnace) << n;
    }
}

TEST(BlinnPhong, PeakHasTheClosedFormNormalisation)
{
    const double norm = 12.0 * 14.0 / (8.0 * kPi * (10.0 + std::pow(2.0, -5.0)));
    expectValue(evaluate("blinn-phong:kd=0,ks=1,n=10", kNormal, kNormal).x, norm);
    expectValue(evaluate("blinn-phong:kd=0.2,ks=0.5,n=10", directionDegrees(50.0, 0.0),
                         directionDegrees(10.0, 180.0))
                    .x,
                0.2 / kPi + 0.5 * norm * std::pow(std::cos(20.0 * kPi / 180.0), 10.0));
}

TEST(BlinnPhong, AlbedoAtNormalIncidenceIsKdPlusKs)
{
    for (const char* n : {"0", "1", "7.5", "1000"}) {
        const Source source = makeModelSource(std::string("blinn-phong:kd=0.2,ks=0.5,n=") + n);
        EXPECT_NEAR(directionalAlbedo(source.evaluate, kNormal).x, 0.7, kFurnace) << n;
    }
}

TEST(Lafortune, OfTheMirrorMatrixIsPhong)
{
    // C = (-1, -1, 1) s with s^n = ks (n + 2) / (2 pi).
    const double scale = std::pow(0.5 * 12.0 / (2.0 * kPi), 0.1);
    const std::string across = numberText(-scale, 17),
                      spec = "lafortune:kd=0.2,cx=" + across + ",cy=" + across +
                             ",cz=" + numberText(scale, 17) + ",n=10";
    const Source lafortune = makeModelSource(spec);
    const Source phong = makeModelSource("phong:kd=0.2,ks=0.5,n=10");
    for (const auto& pair : spreadPairs(300))
        expectValue(lafortune.evaluate(pair.wo, pair.wi).x, phong.evaluate(pair.wo, pair.wi).x);
}

TEST(Lafortune, HasItsParametersPerChannel)
{
    const Vec3d f = evaluate("lafortune:kd=0,cx=-1,cy=-1,cz=0.5/0.8/1,n=2/3/4", kNormal, kNormal);
    EXPECT_NEAR(f.x, 0.25, kTight);
    EXPECT_NEAR(f.y, 0.512, kTight);
    EXPECT_NEAR(f.z, 1.0, kTight);
}

TEST(Ward, HasItsPeakAndItsGaussianInTheTangentOfTheHalfAngle)
{
    const char* spec = "ward:rho_d=0.1,rho_s=0.33,alpha_x=0.05,alpha_y=0.16";
    const double peak = 0.33 / (4.0 * kPi * 0.05 * 0.16);
    expectValue(evaluate(spec, kNormal, kNormal).x, 0.1 / kPi + peak);
    for (const double degrees : {2.0, 5.0, 20.0}) {
        const double angle = degrees * kPi / 180.0, tangent = std::tan(angle);
        const auto expected = [&](double alpha) {
            return 0.1 / kPi + peak * std::exp(-std::pow(tangent / alpha, 2.0)) / std::cos(angle);
        };
        const Vec3d x = directionDegrees(degrees, 0.0), y = directionDegrees(degrees, 90.0);
        expectValue(evaluate(spec, x, x).x, expected(0.05));
        expectValue(evaluate(spec, y, y).x, expected(0.16));
    }
    // In the mirror direction only the cosines remain.
    expectValue(evaluate(spec, directionDegrees(60.0, 30.0), directionDegrees(60.0, 210.0)).x,
                0.1 / kPi + 2.0 * peak);
}

TEST(Ggx, HasItsClosedFormAtNormalIncidence)
{
    const Vec3d f =
        evaluate("ggx:alpha_x=0.1,alpha_y=0.4,f0=0.9/0.5/0.04,kd=0.2", kNormal, kNormal);
    for (int c = 0; c < 3; ++c)
        expectValue(f[c], 0.2 / kPi + Vec3d(0.9, 0.5, 0.04)[c] / (4.0 * kPi * 0.1 * 0.4));
}

TEST(Ggx, HasItsClosedFormInTheMirrorDirection)
{
    // theta = 60 degrees: tan^2 = 3, Lambda = (sqrt(1 + 3 alpha^2) - 1) / 2 on both sides.
    const double d = 1.0 / (kPi * 0.25 * 0.25), fresnel = 0.04 + 0.96 / 32.0;
    const double masking = 1.0 / std::sqrt(1.0 + 3.0 * 0.25 * 0.25);
    expectValue(
        evaluate("ggx:alpha=0.25", directionDegrees(60.0, 15.0), directionDegrees(60.0, 195.0)).x,
        d * fresnel * masking);
}

TEST(Ggx, RetroReflectionHasTheTailOfTheDistribution)
{
    // wo = wi at 45 degrees along x: h = w, D = 1 / (pi ax ay (1 / (2 ax^2) + 1/2)^2).
    const double ax = 0.2, ay = 0.5, tail = 0.5 / (ax * ax) + 0.5;
    const double lambda = 0.5 * (std::sqrt(1.0 + ax * ax) - 1.0);
    const Vec3d w = directionDegrees(45.0, 0.0);
    expectValue(evaluate("ggx:alpha_x=0.2,alpha_y=0.5,f0=0.3", w, w).x,
                0.3 / (kPi * ax * ay * tail * tail * 4.0 * 0.5 * (1.0 + 2.0 * lambda)));
}

TEST(Beckmann, HasItsClosedFormsAtNormalIncidenceAndInTheMirrorDirection)
{
    const double d = 1.0 / (kPi * 0.25 * 0.25);
    expectValue(evaluate("beckmann:alpha=0.25,f0=0.9,kd=0.2", kNormal, kNormal).x,
                0.2 / kPi + 0.9 * d / 4.0);
    const double a = 1.0 / (0.25 * std::sqrt(3.0));
    const double lambda = 0.5 * (std::erf(a) - 1.0) + std::exp(-a * a) / (2.0 * a * std::sqrt(kPi));
    expectValue(
        evaluate("beckmann:alpha=0.25", directionDegrees(60.0, 15.0), directionDegrees(60.0, 195.0))
            .x,
        d * (0.04 + 0.96 / 32.0) / (1.0 + 2.0 * lambda));
}

TEST(AshikhminShirley, HasItsClosedFormAtNormalIncidence)
{
    const double coupled = 28.0 / (23.0 * kPi) * 0.3 * 0.9 * std::pow(1.0 - 1.0 / 32.0, 2.0);
    expectValue(evaluate("ashikhmin-shirley:kd=0.3,ks=0.1,nu=8,nv=24", kNormal, kNormal).x,
                coupled + 0.1 * std::sqrt(9.0 * 25.0) / (8.0 * kPi));
}

TEST(AshikhminShirley, ExponentGoesFromNuToNvWithTheAzimuthOfTheHalfVector)
{
    const double c = std::cos(0.4), sc = 0.1 * 15.0 / (8.0 * kPi * c);
    for (const auto& [phi, n] : {std::pair{0.0, 8.0}, {90.0, 24.0}, {45.0, 16.0}}) {
        const Vec3d w = directionFromAngles(0.4, phi * kPi / 180.0);
        expectValue(evaluate("ashikhmin-shirley:kd=0,ks=0.1,nu=8,nv=24", w, w).x,
                    sc * std::pow(c, n));
    }
}

TEST(AshikhminShirley, ExponentIsContinuousThroughThePole)
{
    const Source source = makeModelSource("ashikhmin-shirley:kd=0,ks=0.1,nu=8,nv=1e6");
    const double pole = source.evaluate(kNormal, kNormal).x;
    for (const double tilt : {1e-7, 1e-9, 1e-12, 1e-16}) {
        const Vec3d w(0.0, tilt, 1.0);
        EXPECT_NEAR(source.evaluate(w, w).x, pole, 1e-6 * pole) << tilt;
    }
}

TEST(OrenNayar, OfNoRoughnessIsLambertian)
{
    for (const auto& pair : spreadPairs(50))
        expectValue(evaluate("oren-nayar:albedo=0.6,sigma=0", pair.wo, pair.wi).x, 0.6 / kPi);
}

TEST(OrenNayar, HasItsClosedFormAtNormalIncidence)
{
    const double s = 0.25, c1 = 1.0 - 0.5 * s / (s + 0.33), second = 0.17 * s / (s + 0.13);
    expectValue(
        evaluate("oren-nayar:albedo=0.8,sigma=0.5", kNormal, directionDegrees(70.0, 12.0)).x,
        (0.8 * c1 + 0.64 * second) / kPi);
}

// The published formulas, evaluated in Python with angles from acos and atan2.
TEST(OrenNayar, AgreesWithAnotherImplementation)
{
    const char* spec = "oren-nayar:albedo=0.8,sigma=0.5";
    const auto f = [&](const Vec3d& wi, const Vec3d& wo) { return evaluate(spec, wo, wi).x; };
    expectValue(f(directionDegrees(30.0, 0.0), directionDegrees(40.0, 170.0)), 0.196029706845,
                1e-11);
    expectValue(f(directionDegrees(65.0, 20.0), directionDegrees(70.0, 215.0)), 0.136378249531,
                1e-11);
    expectValue(f(directionDegrees(10.0, 90.0), directionDegrees(80.0, 80.0)), 0.23668668709,
                1e-11);
}

TEST(OrenNayar, ScattersBackMoreThanForth)
{
    const Source source = makeModelSource("oren-nayar:sigma=0.5");
    const Vec3d wo = directionDegrees(60.0, 0.0);
    EXPECT_GT(source.evaluate(wo, wo).x,
              1.5 * source.evaluate(wo, directionDegrees(60.0, 180.0)).x);
}

TEST(OrenNayar, ConservesUpToTheAlbedoItPromises)
{
    for (const char* sigma : {"0.1", "0.2", "0.3", "0.4", "0.6", "1", "1.5"}) {
        const std::string spec = std::string("oren-nayar:sigma=") + sigma + ",albedo=";
        EXPECT_TRUE(conserves(makeModelSource(spec + "0.95").evaluate)) << spec;
    }
    EXPECT_FALSE(conserves(makeModelSource("oren-nayar:albedo=1,sigma=0.3").evaluate))
        << "the promise could be wider";
}

TEST(Plastic, IsTheWeightedSumOfItsParts)
{
    const Vec3d wo = directionDegrees(60.0, 0.0), wi = directionDegrees(0.0, 0.0);
    const double entering = 1.0 - 0.04, leaving = 1.0 - (0.04 + 0.96 / 32.0);
    const double interface = evaluate("ggx:alpha=0.1,f0=0.04,kd=0", wo, wi).x;
    expectValue(evaluate("plastic:albedo=0.5,sigma=0,alpha=0.1,f0=0.04", wo, wi).x,
                0.5 / kPi * entering * leaving + interface);
    const double base = evaluate("oren-nayar:albedo=0.5,sigma=0.4", wo, wi).x;
    expectValue(evaluate("plastic:albedo=0.5,sigma=0.4,alpha=0.1,f0=0.04", wo, wi).x,
                base * entering * leaving + interface);
}

}  // namespace
}  // namespace fbrdf::test
