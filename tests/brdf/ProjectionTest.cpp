// ProjectionTest.cpp - from pairs to texels: closed forms, inverses, bounds, float against double.
#include "brdf/Directions.h"

#include <fbrdf/brdf/Projection.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fbrdf;

namespace {

constexpr double kGammas[] = {0.25, 1.0 / 3.0, 0.5, 1.0, 2.0};
// The rounding of a handful of operations in double.
constexpr double kTight = 1e-13;

DiscDomain disc(int size, double gamma)
{
    return DiscDomain::fitting(size, gamma);
}

TEST(Domain, CountsItsTexels)
{
    const Domain map = disc(32, 0.5), line = GridDomain{{Axis{7, {}}}},
                 volume = GridDomain{{Axis{5, {}}, Axis{4, {}}, Axis{3, {}}}};
    EXPECT_EQ(domainSize(map), (std::array<int, 3>{32, 32, 1}));
    EXPECT_EQ(domainSize(line), (std::array<int, 3>{7, 1, 1}));
    EXPECT_EQ(domainSize(volume), (std::array<int, 3>{5, 4, 3}));
    EXPECT_EQ(texelCount(volume), 60);
    EXPECT_EQ(dimensionCount(map), 2);
    EXPECT_EQ(dimensionCount(line), 1);
    EXPECT_EQ(dimensionCount(volume), 3);
    EXPECT_TRUE(isDisc(map));
    EXPECT_FALSE(isDisc(line));
}

TEST(Domain, IsTheSameOnlyWhenEveryFieldIs)
{
    const Domain map = disc(32, 0.5), line = GridDomain{{Axis{7, {}}}};
    const AxisMap cosine{AxisMap::From::cosine, 0.5}, steep{AxisMap::From::oneMinusCosine, 0.25};
    EXPECT_TRUE(sameDomain(map, map));
    EXPECT_TRUE(sameDomain(line, line));
    const Domain others[] = {disc(33, 0.5),
                             disc(32, 0.25),
                             DiscDomain{32, 0.5, 14.0},
                             GridDomain{{Axis{8, {}}}},
                             GridDomain{{Axis{7, cosine}}},
                             GridDomain{{Axis{7, steep}}},
                             GridDomain{{Axis{7, {}}, Axis{7, {}}}},
                             GridDomain{{Axis{7, {}}}, true}};
    for (const Domain& other : others) {
        EXPECT_FALSE(sameDomain(map, other));
        EXPECT_FALSE(sameDomain(line, other));
    }
}

TEST(Domain, ArgumentsFitByKindAndNumber)
{
    const std::vector<Angle> one{Angle::theta_h}, two{Angle::theta_h, Angle::theta_d};
    const Domain map = disc(8, 1.0), line = GridDomain{{Axis{7, {}}}};
    EXPECT_TRUE(argumentFits(map, Direction::h));
    EXPECT_FALSE(argumentFits(map, two));
    EXPECT_TRUE(argumentFits(line, one));
    EXPECT_FALSE(argumentFits(line, two));
    EXPECT_FALSE(argumentFits(line, Direction::wi));
}

TEST(Disc, TheNormalIsTheCentreAndTheHorizonTheRim)
{
    for (const double gamma : kGammas) {
        const DiscDomain domain = disc(32, gamma);
        const auto centre = discPosition(domain, Vec3d(0.0, 0.0, 1.0));
        EXPECT_NEAR(centre.x, 15.5, 1e-6);  // |p|^2 is kept above 1e-30, and its 8th root is 2e-4
        EXPECT_NEAR(centre.y, 15.5, 1e-6);
        const auto rim = discPosition(domain, Vec3d(0.0, -1.0, 0.0));
        EXPECT_NEAR(rim.x, 15.5, kTight);
        EXPECT_NEAR(rim.y, 0.0, kTight);
    }
}

TEST(Disc, RadiusIsAPowerOfTheTangentOfHalfTheAngle)  // |(x, y)| / (1 + z) = tan(theta / 2)
{
    for (const double gamma : kGammas) {
        const DiscDomain domain{32, gamma, 14.0};
        const auto p = discPosition(domain, directionFromAngles(1.0, 0.0));
        EXPECT_NEAR(p.x - 15.5, 14.0 * std::pow(std::tan(0.5), gamma), kTight);
        EXPECT_NEAR(p.y, 15.5, kTight);
    }
}

TEST(Disc, GammaOneIsThePublishedMap)  // u = 1/2 + (7/16) x / (1 + z), texture coordinate
{
    const DiscDomain domain{64, 1.0, 28.0};
    for (int n = 0; n < test::kPoints; ++n) {
        const Vec3d w = test::pair(n).wi;
        const auto p = discPosition(domain, w);
        ASSERT_NEAR((p.x + 0.5) / 64.0, 0.5 + 0.4375 * w.x / (1.0 + w.z), kTight);
        ASSERT_NEAR((p.y + 0.5) / 64.0, 0.5 + 0.4375 * w.y / (1.0 + w.z), kTight);
    }
}

TEST(Disc, DirectionsComeBack)
{
    for (const double gamma : kGammas)
        for (int n = 0; n < test::kPoints; ++n) {
            const DiscDomain domain = disc(17, gamma);
            const Vec3d w = test::pair(n, 0.0).wi;
            const Vec3d back = directionFromDiscPosition(domain, discPosition(domain, w));
            ASSERT_LT(test::distance(back, w), kTight) << gamma << " " << n;
            ASSERT_NEAR(glm::length(back), 1.0, kTight);
        }
}

TEST(Disc, PositionsComeBackAndCornersAreOnTheHorizon)
{
    for (const double gamma : kGammas) {
        const DiscDomain domain{16, gamma, 6.0};
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const Vec3d w = directionFromDiscPosition(domain, {x, y});
                const Vec2<double> offset(x - 7.5, y - 7.5), back = discPosition(domain, w);
                const double radius = glm::length(offset);
                ASSERT_GE(w.z, 0.0);
                if (radius >= 6.0) {
                    ASSERT_NEAR(w.z, 0.0, kTight);
                }
                const Vec2<double> nearest = offset * std::min(1.0, 6.0 / radius) + 7.5;
                ASSERT_LT(glm::length(back - nearest), kTight);
            }
    }
}

// The directions of a shader are unit only to 1e-7 and may dip below the horizon.
template <class T>
void expectInside(const DiscDomain& domain, const Vec3<T>& w)
{
    const Vec2<T> p = discPosition(domain, w);
    const T last = static_cast<T>(domain.size - 1), slack = last * static_cast<T>(1e-6);
    ASSERT_GE(p.x, -slack);
    ASSERT_GE(p.y, -slack);
    ASSERT_LE(p.x, last + slack);
    ASSERT_LE(p.y, last + slack);
}

TEST(Disc, NeverLeavesTheMap)
{
    for (const double gamma : kGammas)
        for (int n = 0; n < test::kPoints; ++n) {
            const Vec3d w = test::pair(n, 0.0).wi;
            const double phi = 2.0 * kPi * n / test::kPoints;
            const Vec3d rim(std::cos(phi), std::sin(phi), n % 2 ? 0.0 : -1e-7);
            for (const Vec3d& v : {w, rim}) {
                expectInside<double>(disc(32, gamma), v);
                expectInside<float>(disc(32, gamma), Vec3f(v));
            }
        }
}

// Directions have an error of 6e-8, which the warp r^gamma amplifies by r^(gamma - 1) towards the
// centre; a distance of 0.05 from the normal keeps that below 20 for gamma = 1/4 over 16 texels.
TEST(Disc, FloatAgreesWithDouble)
{
    constexpr double kFloat = 20.0 * 16.0 * 2e-7;
    for (const double gamma : kGammas)
        for (int n = 0; n < test::kPoints; ++n) {
            const Vec3d w = test::pair(n).wi;
            if (std::hypot(w.x, w.y) < 0.05) continue;
            const auto p = discPosition(disc(32, gamma), w);
            const auto q = discPosition(disc(32, gamma), Vec3f(w));
            ASSERT_NEAR(p.x, double(q.x), kFloat);
            ASSERT_NEAR(p.y, double(q.y), kFloat);
        }
}

constexpr double kExponents[] = {0.25, 0.3, 0.5, 1.0, 2.0};
constexpr AxisMap::From kFrom[] = {AxisMap::From::oneMinusCosine, AxisMap::From::cosine};

TEST(AxisMap, EndsAreZeroAndOne)
{
    for (const double exponent : kExponents) {
        const AxisMap complement{AxisMap::From::oneMinusCosine, exponent},
            cosine{AxisMap::From::cosine, exponent};
        EXPECT_EQ(axisCoordinate(complement, 1.0, 0.0), 0.0);
        EXPECT_EQ(axisCoordinate(complement, 0.0, 1.0), 1.0);
        EXPECT_EQ(axisCoordinate(cosine, 1.0, 0.0), 1.0);
        EXPECT_EQ(axisCoordinate(cosine, 0.0, 1.0), 0.0);
    }
    const AxisMap sine{AxisMap::From::oneMinusCosine, 0.5};  // sqrt(1 - cos) = sqrt(2) sin(theta/2)
    EXPECT_NEAR(axisCoordinate(sine, std::cos(0.8), 1.0 - std::cos(0.8)),
                std::sqrt(2.0) * std::sin(0.4), kTight);
}

TEST(AxisMap, AnglesComeBackAndGrow)
{
    for (const auto from : kFrom)
        for (const double exponent : kExponents) {
            const AxisMap map{from, exponent};
            double before = from == AxisMap::From::cosine ? 1.0 : 0.0;
            for (int i = 1; i < 1000; ++i) {
                const double theta = 0.5 * kPi * i / 1000.0, s = std::sin(0.5 * theta);
                const double u = axisCoordinate(map, std::cos(theta), 2.0 * s * s);
                ASSERT_TRUE(from == AxisMap::From::cosine ? u < before : u > before) << theta;
                // acos(cos^...) near the normal: 1e-16 of cosine is 1e-16 / sin(theta) of angle.
                ASSERT_NEAR(angleFromAxisCoordinate(map, u), theta, 1e-12) << exponent;
                before = u;
            }
        }
}

TEST(PairGeometry, CosinesAreThoseOfTheAngles)
{
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const PairGeometry<double> g(pair);
        const HalfDifference a = halfDifferenceFromPair(pair);
        const double angles[kAngleCount] = {a.theta_h, a.theta_d, std::acos(pair.wi.z),
                                            std::acos(pair.wo.z), 0.0};
        for (size_t k = 0; k < static_cast<size_t>(Angle::phi_d); ++k) {
            ASSERT_NEAR(g.cosine[k], std::cos(angles[k]), 1e-14);
            ASSERT_NEAR(g.complement[k], 1.0 - std::cos(angles[k]), 1e-14);
        }
    }
}

// 1 - cos of a float cosine has no digit left below theta = 3e-4; the complement keeps all digits.
TEST(PairGeometry, ComplementsOfSmallAnglesKeepTheirDigits)
{
    for (const double theta : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        const Vec3d wi = directionFromAngles(theta, 0.3), wo(0.0, 0.0, 1.0);
        const PairGeometry<float> g(DirectionPair<float>{Vec3f(wo), Vec3f(wi)});
        const double s = std::sin(0.5 * theta), quarter = std::sin(0.25 * theta);
        const auto complement = [&](Angle a) {
            return double(g.complement[static_cast<size_t>(a)]);
        };
        EXPECT_NEAR(complement(Angle::theta_i) / (2.0 * s * s), 1.0, 1e-6) << theta;
        EXPECT_NEAR(complement(Angle::theta_h) / (2.0 * quarter * quarter), 1.0, 1e-6) << theta;
        EXPECT_NEAR(complement(Angle::theta_d) / (2.0 * quarter * quarter), 1.0, 1e-6) << theta;
    }
}

TEST(PairGeometry, OppositeDirectionsHaveAHalfVector)
{
    const PairGeometry<float> g(DirectionPair<float>{{1.0f, 0.0f, 0.0f}, {-1.0f, 0.0f, 0.0f}});
    EXPECT_EQ(g.h, Vec3f(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(g.cosine[static_cast<size_t>(Angle::theta_d)], 0.0f);
    EXPECT_EQ(g.complement[static_cast<size_t>(Angle::theta_d)], 1.0f);
}

TEST(DirectionVector, DifferenceHasTheAnglesOfTheFrameAboutH)  // Rusinkiewicz 1998
{
    for (int i = 0; i < 1000; ++i) {
        const auto pair = test::pair(i);
        const HalfDifference angles = halfDifferenceFromPair(pair);
        const Vec3d d = directionVector(Direction::d, PairGeometry<double>(pair));
        EXPECT_LT(glm::length(d - directionFromAngles(angles.theta_d, angles.phi_d)), 1e-9)
            << "pair " << i;
        // Swapping light and viewer turns d by half a turn.
        const Vec3d swapped =
            directionVector(Direction::d, PairGeometry<double>({pair.wi, pair.wo}));
        EXPECT_LT(glm::length(swapped - Vec3d(-d.x, -d.y, d.z)), 1e-9) << "pair " << i;
    }
}

TEST(DirectionVector, MirrorAndCombinationsMatchTheirDefinitions)
{
    const auto pair = test::pair(3);
    const PairGeometry<double> g(pair);
    const Vec3d n(0.0, 0.0, 1.0);
    const auto near = [](const Vec3d& a, const Vec3d& b) {
        EXPECT_LT(glm::length(a - b), kTight) << a.x << " " << a.y << " " << a.z;
    };
    near(directionVector(Direction::mirror, g), 2.0 * pair.wo.z * n - pair.wo);
    near(directionVector(Direction::combination(2.0, 2.0, 0.0), g), g.h);
    near(directionVector(Direction::combination(-1.0, 0.5, 3.0), g),
         glm::normalize(0.5 * pair.wi - pair.wo + 3.0 * n));
    near(directionVector(Direction::combination(0.0, 0.0, 0.0), g), n);
}

TEST(PairGeometry, FoldedDifferenceAzimuthIsThatOfTheAngles)
{
    for (int i = 0; i < 1000; ++i) {
        const auto pair = test::pair(i);
        const PairGeometry<double> g(pair);
        const HalfDifference angles = halfDifferenceFromPair(pair);
        const auto phi_d = static_cast<size_t>(Angle::phi_d);
        EXPECT_NEAR(g.cosine[phi_d], std::abs(std::cos(angles.phi_d)), 1e-9) << "pair " << i;
        EXPECT_NEAR(g.complement[phi_d], 1.0 - g.cosine[phi_d], kTight);
    }
    const PairGeometry<double> mirrored(DirectionPair<double>{{0.6, 0.0, 0.8}, {-0.6, 0.0, 0.8}});
    EXPECT_EQ(mirrored.cosine[static_cast<size_t>(Angle::phi_d)], 0.0);
    EXPECT_EQ(mirrored.complement[static_cast<size_t>(Angle::phi_d)], 1.0);
}

TEST(PairGeometry, HalfDifferenceAzimuthTellsLightFromView)
{
    const auto half = static_cast<size_t>(Angle::half_phi_d);
    for (int i = 0; i < 1000; ++i) {
        const auto pair = test::pair(i);
        const PairGeometry<double> g(pair), swapped({pair.wi, pair.wo});
        const double angle = 0.5 * std::abs(halfDifferenceFromPair(pair).phi_d);
        EXPECT_NEAR(g.cosine[half], std::cos(angle), 1e-9) << "pair " << i;
        EXPECT_NEAR(g.complement[half], 1.0 - g.cosine[half], kTight);
        EXPECT_NEAR(std::acos(g.cosine[half]) + std::acos(swapped.cosine[half]), kPi / 2.0, 1e-7);
    }
    // Where phi_d means nothing, and in the plane of incidence: the view above the light, below it.
    const PairGeometry<double> mirrored(DirectionPair<double>{{0.6, 0.0, 0.8}, {-0.6, 0.0, 0.8}});
    EXPECT_NEAR(mirrored.cosine[half], std::sqrt(0.5), kTight);
    const Vec3d up(0.0, 0.0, 1.0), low(0.6, 0.0, 0.8);
    EXPECT_NEAR(PairGeometry<double>({up, low}).complement[half], 0.0, kTight);
    EXPECT_NEAR(PairGeometry<double>({low, up}).cosine[half], 0.0, kTight);
}

TEST(PairGeometry, SideDifferenceAzimuthTellsTheSidesOfThePlaneOfIncidenceApart)
{
    const auto side = static_cast<size_t>(Angle::side_phi_d);
    for (int i = 0; i < 1000; ++i) {
        const auto pair = test::pair(i);
        const Vec3d flip(1.0, -1.0, 1.0);
        const PairGeometry<double> g(pair), swapped({pair.wi, pair.wo}),
            mirrored({flip * pair.wo, flip * pair.wi});
        const double phi = halfDifferenceFromPair(pair).phi_d;
        const double angle = 0.5 * (phi < 0.0 ? phi + kPi : phi);
        EXPECT_NEAR(g.cosine[side], std::cos(angle), 1e-9) << "pair " << i;
        EXPECT_NEAR(g.complement[side], 1.0 - g.cosine[side], kTight);
        EXPECT_NEAR(swapped.cosine[side], g.cosine[side], 1e-9) << "reciprocal";
        EXPECT_NEAR(std::acos(g.cosine[side]) + std::acos(mirrored.cosine[side]), kPi / 2.0, 1e-7);
    }
}

TEST(TexelPosition, TakesTheDirectionOrTheAnglesAskedFor)
{
    const auto pair = test::pair(7);
    const PairGeometry<double> g(pair);
    const DiscDomain map = disc(16, 0.5);
    const Vec3d directions[] = {pair.wi, pair.wo, glm::normalize(pair.wi + pair.wo)};
    const Direction names[] = {Direction::wi, Direction::wo, Direction::h};
    for (size_t k = 0; k < 3; ++k) {
        const Vec3d position = texelPosition(Domain(map), Argument(names[k]), g);
        EXPECT_EQ(Vec2<double>(position), discPosition(map, directions[k]));
        EXPECT_EQ(position.z, 0.0);
    }
    const Axis h{9, {AxisMap::From::oneMinusCosine, 0.25}}, o{5, {AxisMap::From::cosine, 1.0}};
    const Vec3d position =
        texelPosition(Domain(GridDomain{{h, o}}),
                      Argument(std::vector<Angle>{Angle::theta_h, Angle::theta_o}), g);
    const double theta_h = halfDifferenceFromPair(pair).theta_h;
    EXPECT_NEAR(position.x, 8.0 * std::pow(1.0 - std::cos(theta_h), 0.25), kTight);
    EXPECT_NEAR(position.y, 4.0 * pair.wo.z, kTight);
    EXPECT_EQ(position.z, 0.0);
}

}  // namespace
