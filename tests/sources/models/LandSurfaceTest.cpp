// LandSurfaceTest.cpp - Rahman-Pinty-Verstraete and Ross-Li against limits, and against the
// published formulas written a second time, in Python, in angles as the papers have them.
#include "ExpectedValues.h"
#include "Pairs.h"

#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

constexpr double kTight = 1e-12;  // a handful of roundings

double red(const std::string& spec, const Vec3d& wo, const Vec3d& wi)
{
    return makeModelSource(spec).evaluate(wo, wi).x;
}

TEST(Rpv, AgreesWithAnotherImplementation)
{
    expectValues("rpv:rho_0=0.1/0.25/0.5,k=0.7,theta=-0.1",
                 {{0.0463188118667, 0.110551402048, 0.203617378698},
                  {0.0574155226918, 0.140349419889, 0.27006755031},
                  {0.0637669417776, 0.156184925168, 0.301595086084}});
    expectValues("rpv:rho_0=0.1/0.25/0.5,k=1.3,theta=0.4",
                 {{0.0218179807211, 0.0520740550406, 0.095911787541},
                  {0.0328336677548, 0.0802602851315, 0.154440956078},
                  {0.0109353452567, 0.0267840362577, 0.051720316235}});
    expectValues("rpv:rho_0=0.1/0.2/0.3,k=0.8,theta=-0.2,rho_c=1/0.5/0",
                 {{0.0351525491795, 0.0848836914396, 0.14919342678},
                  {0.0316161769263, 0.0686361161153, 0.111059817567},
                  {0.0491271896164, 0.105815061731, 0.170063616345}});
}

TEST(Rpv, IsLambertianWithoutBowlAsymmetryAndHotSpot)
{
    for (const auto& pair : spreadPairs(20))
        EXPECT_NEAR(red("rpv:rho_0=0.3,k=1,theta=0,rho_c=1", pair.wo, pair.wi), 0.3 / kPi, kTight);
}

TEST(Rpv, TheHotSpotIsTwoLessItsParameter)
{
    const Vec3d w = directionDegrees(40.0, 30.0);
    EXPECT_NEAR(red("rpv:rho_0=0.3,k=1,theta=0,rho_c=0.4", w, w), 0.3 * 1.6 / kPi, kTight);
    EXPECT_NEAR(red("rpv:rho_0=0.3,k=1,theta=0", w, w), 0.3 * 1.7 / kPi, kTight);
}

TEST(RossLi, AgreesWithAnotherImplementation)
{
    expectValues("ross-li:f_iso=0.2/0.4/0.5,f_vol=0.1/0.3/0,f_geo=0.03/0.01/0.05",
                 {{0.0455526591173, 0.109792057674, 0.136157407118},
                  {0.0504103955266, 0.193921905306, 0.0926845081148},
                  {0.0404458073083, 0.130453532327, 0.113668638318}});
}

TEST(RossLi, KernelsVanishAtTheNormalAndHaveTheirHotSpots)
{
    const Vec3d normal(0.0, 0.0, 1.0), w = directionDegrees(45.0, 200.0);
    EXPECT_NEAR(red("ross-li:f_iso=0.2,f_vol=1,f_geo=1", normal, normal), 0.2 / kPi, kTight);
    // Along one direction the phase angle and the overlap's distance are 0, so that t is pi / 2.
    const double ross = 0.25 * kPi * (std::sqrt(2.0) - 1.0), li = 2.0 - std::sqrt(2.0);
    EXPECT_NEAR(red("ross-li:f_iso=0,f_vol=1,f_geo=0", w, w), ross / kPi, kTight);
    EXPECT_NEAR(red("ross-li:f_iso=0,f_vol=0,f_geo=1", w, w), li / kPi, kTight);
}

TEST(RossLi, IsDarkWhereTheKernelsFallBelowZero)
{
    EXPECT_EQ(red("ross-li:f_iso=0.1,f_vol=0,f_geo=1", directionDegrees(60.0, 0.0),
                  directionDegrees(60.0, 180.0)),
              0.0);
}

}  // namespace
}  // namespace fbrdf::test
