// HalfDifferenceTest.cpp - Rusinkiewicz' angles: closed forms, inverses, symmetries, poles.
#include "brdf/Directions.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fbrdf;

namespace {

// A few rotations in double cause some tens of roundings of 1e-16.
constexpr double kTight = 1e-14;
// Azimuths lose digits as 1 / sin(theta); the points keep 0.01 away from the poles.
constexpr double kAzimuth = 1e-12;

double angleBetween(double a, double b)
{
    return std::abs(std::remainder(a - b, 2.0 * kPi));
}

TEST(HalfDifference, MirrorPairHasItsHalfVectorOnTheNormal)
{
    const double theta = 0.7;
    const auto a = halfDifferenceFromPair(
        {directionFromAngles(theta, kPi + 0.3), directionFromAngles(theta, 0.3)});
    EXPECT_NEAR(a.theta_h, 0.0, kTight);
    EXPECT_NEAR(a.theta_d, theta, kTight);
}

TEST(HalfDifference, RetroPairHasNoDifference)
{
    const Vec3d w = directionFromAngles(0.9, -2.0);
    const auto a = halfDifferenceFromPair({w, w});
    EXPECT_NEAR(a.theta_h, 0.9, kTight);
    EXPECT_NEAR(a.phi_h, -2.0, kTight);
    EXPECT_NEAR(a.theta_d, 0.0, kTight);
}

TEST(HalfDifference, KnownPair)  // wi 30 degrees towards x and wo 90 degrees away: h at 30 degrees
{
    const auto a = halfDifferenceFromPair(
        {directionFromAngles(kPi / 2.0, 0.0), directionFromAngles(kPi / 6.0, kPi)});
    EXPECT_NEAR(a.theta_h, kPi / 6.0, kTight);
    EXPECT_NEAR(a.phi_h, 0.0, kTight);
    EXPECT_NEAR(a.theta_d, kPi / 3.0, kTight);
    EXPECT_NEAR(angleBetween(a.phi_d, kPi), 0.0, kTight);  // wi lies back towards the normal
}

TEST(HalfDifference, PairsComeBack)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const auto back = pairFromHalfDifference(halfDifferenceFromPair(pair));
        ASSERT_LT(test::distance(back.wi, pair.wi), kTight) << n;
        ASSERT_LT(test::distance(back.wo, pair.wo), kTight) << n;
    }
}

TEST(HalfDifference, AnglesComeBack)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto p = test::point(n);
        const double limit = 0.5 * kPi - 0.01;
        const HalfDifference a{0.01 + (limit - 0.01) * p[0], kPi * (2.0 * p[1] - 1.0),
                               0.01 + (limit - 0.01) * p[2], kPi * (2.0 * p[3] - 1.0)};
        const HalfDifference b = halfDifferenceFromPair(pairFromHalfDifference(a));
        ASSERT_NEAR(a.theta_h, b.theta_h, kTight) << n;
        ASSERT_NEAR(a.theta_d, b.theta_d, kTight) << n;
        ASSERT_LT(angleBetween(a.phi_h, b.phi_h), kAzimuth) << n;
        ASSERT_LT(angleBetween(a.phi_d, b.phi_d), kAzimuth) << n;
    }
}

TEST(HalfDifference, SwappingLightAndViewTurnsPhiDByPi)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const auto a = halfDifferenceFromPair(pair), b = halfDifferenceFromPair({pair.wi, pair.wo});
        ASSERT_EQ(a.theta_h, b.theta_h);
        ASSERT_EQ(a.phi_h, b.phi_h);
        ASSERT_NEAR(a.theta_d, b.theta_d, kTight);
        if (a.theta_d < 0.01) continue;
        ASSERT_LT(angleBetween(a.phi_d, b.phi_d + kPi), kAzimuth) << n;
    }
}

TEST(HalfDifference, RotationAboutTheNormalChangesPhiHOnly)
{
    const double turn = 1.234, c = std::cos(turn), s = std::sin(turn);
    const auto turned = [&](const Vec3d& v) {
        return Vec3d(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
    };
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const auto a = halfDifferenceFromPair(pair),
                   b = halfDifferenceFromPair({turned(pair.wo), turned(pair.wi)});
        if (a.theta_h < 0.01 || a.theta_d < 0.01) continue;
        ASSERT_NEAR(a.theta_h, b.theta_h, kTight);
        ASSERT_NEAR(a.theta_d, b.theta_d, kTight);
        ASSERT_LT(angleBetween(a.phi_h + turn, b.phi_h), kAzimuth);
        ASSERT_LT(angleBetween(a.phi_d, b.phi_d), kAzimuth);
    }
}

TEST(HalfDifference, VectorsAreThoseOfTheAngles)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n, 0.0);
        const auto a = halfDifferenceFromPair(pair);
        const auto [half, difference] = halfDifferenceVectors(pair);
        ASSERT_LT(test::distance(half, directionFromAngles(a.theta_h, 0.0)), kTight) << n;
        ASSERT_LT(test::distance(difference, directionFromAngles(a.theta_d, a.phi_d)), kTight) << n;
    }
}

TEST(HalfDifference, StaysWithinItsRanges)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto a = halfDifferenceFromPair(test::pair(n, 0.0));
        ASSERT_GE(a.theta_h, 0.0);
        ASSERT_LE(a.theta_h, 0.5 * kPi);
        ASSERT_GE(a.theta_d, 0.0);
        ASSERT_LE(a.theta_d, 0.5 * kPi);
        ASSERT_LE(std::max(std::abs(a.phi_h), std::abs(a.phi_d)), kPi);
    }
}

// acos(z) would give 0 for every angle below 1e-8.
TEST(HalfDifference, TinyAnglesKeepTheirDigits)
{
    const double tiny = 1e-12;
    const Vec3d normal(0.0, 0.0, 1.0);
    const auto a = halfDifferenceFromPair({normal, directionFromAngles(tiny, 0.5)});
    EXPECT_NEAR(a.theta_h / tiny, 0.5, 1e-6);
    EXPECT_NEAR(a.theta_d / tiny, 0.5, 1e-3);  // a difference of rotated numbers near 1e-16
}

TEST(HalfDifference, DegeneratePairsAreFinite)
{
    const Vec3d normal(0.0, 0.0, 1.0), x(1.0, 0.0, 0.0);
    for (const auto& pair : {DirectionPair<double>{normal, normal}, {x, -x}, {normal, -normal}}) {
        const auto a = halfDifferenceFromPair(pair);
        for (const double angle : {a.theta_h, a.phi_h, a.theta_d, a.phi_d})
            EXPECT_TRUE(std::isfinite(angle));
    }
    const auto same = halfDifferenceFromPair({normal, normal});
    EXPECT_EQ(same.phi_h, 0.0);
    EXPECT_EQ(same.phi_d, 0.0);
}

}  // namespace
