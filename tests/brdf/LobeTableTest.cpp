// LobeTableTest.cpp - lobes against their integrals and closed forms, tables against their knots.
#include "support/ExpectError.h"

#include <fbrdf/brdf/LobeTable.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace fbrdf;
using fbrdf::test::expectError;

namespace {

/// A table whose numbers all differ.
LobeTable testTable(LobeAxes axes, int lobes, int thetas = 24, int azimuths = 1)
{
    LobeTable table;
    table.axes = axes;
    table.lobes = lobes;
    table.thetas = thetas;
    table.azimuths = azimuths;
    table.spread = axes == LobeAxes::bent ? 0.2f : 0.0f;
    for (int i = 0; i < thetas * azimuths; ++i) {
        LobeKnot knot;
        const auto x = static_cast<float>(i);
        knot.cosine = Vec3f(0.1f, 0.2f, 0.3f) + 0.01f * x;
        for (size_t k = 0; k < static_cast<size_t>(lobes); ++k) {
            const auto y = static_cast<float>(k);
            knot.lobes[k].weight = Vec3f(0.3f, 0.2f, 0.1f) + 0.01f * x + 0.1f * y;
            knot.lobes[k].level = 1.0f + 0.5f * y + 0.02f * std::fmod(x, 24.0f);
            if (axes == LobeAxes::tilted) knot.lobes[k].tilt = i == 0 ? 0.0f : 0.3f * y + 0.01f * x;
        }
        table.knots.push_back(knot);
    }
    return table;
}

Vec3d direction(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double integralOf(double level)
{
    // The substitution g = u^3 pi / 2 resolves the narrowest lobe.
    constexpr int kSteps = 20000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps, g = 0.5 * kPi * u * u * u;
        sum += 2.0 * kPi * lobeValue(std::cos(g), level) * std::sin(g) * 1.5 * kPi * u * u / kSteps;
    }
    return sum;
}

TEST(Lobes, IntegrateToOneAtEveryLevel)
{
    for (double level = 0.0; level <= kCosineLevel; level += 0.25)
        EXPECT_NEAR(integralOf(level), 1.0, 1e-5) << level;
}

TEST(Lobes, LastLevelIsTheCosine)
{
    for (const double cosine : {1.0, 0.7, 0.1}) {
        EXPECT_NEAR(lobeValue(cosine, kCosineLevel), cosine / kPi, 1e-15);
        EXPECT_NEAR(lobeValue(cosine, 9.0), cosine / kPi, 1e-15);
    }
    EXPECT_EQ(lobeValue(-0.1, kCosineLevel), 0.0);
    EXPECT_EQ(lobeValue(0.0, 2.0), 0.0);
}

TEST(Lobes, BetweenLevelsAreMixtures)
{
    const double a = stretchedCosine(0.99, lobeWidth(2.0)),
                 b = stretchedCosine(0.99, lobeWidth(3.0));
    EXPECT_NEAR(lobeValue(0.99, 2.25), 0.75 * a + 0.25 * b, 1e-12 * a);
    EXPECT_GT(std::abs(a - b), 1.0);  // the tester: the two differ
}

TEST(LobeTable, KnotsAreDenseAtGrazing)
{
    EXPECT_EQ(lobeKnotAngle(0, 24), 0.0);
    EXPECT_NEAR(lobeKnotAngle(23, 24), 89.0 * kDegree, 1e-12);
    for (int i = 2; i < 24; ++i)
        EXPECT_LT(lobeKnotAngle(i, 24) - lobeKnotAngle(i - 1, 24),
                  lobeKnotAngle(i - 1, 24) - lobeKnotAngle(i - 2, 24));
}

TEST(LobeTable, ReadsItsKnotsAndMixesNeighbours)
{
    const LobeTable table = testTable(LobeAxes::tilted, 2);
    for (int i = 0; i + 1 < table.thetas; ++i) {
        const auto at = static_cast<size_t>(i);
        const double here = lobeKnotAngle(i, 24);
        const LobeSum<double> sum = lobesAt(table, direction(here, 1.0));
        EXPECT_NEAR(sum.cosine.x, double(table.knots[at].cosine.x), 1e-6) << i;
        EXPECT_NEAR(sum.level[1], double(table.knots[at].lobes[1].level), 1e-6) << i;
        EXPECT_NEAR(sum.weight[1].z, double(table.knots[at].lobes[1].weight.z), 1e-6) << i;
        // Half a knot farther along the axis of knots, not of angles.
        const double u = (i + 0.5) / 23.0, middle = 89.0 * kDegree * (1.0 - std::pow(1.0 - u, 1.5));
        EXPECT_NEAR(lobesAt(table, direction(middle, 1.0)).cosine.y,
                    0.5 * double(table.knots[at].cosine.y + table.knots[at + 1].cosine.y), 1e-6)
            << i;
    }
}

TEST(LobeTable, BeyondTheLastKnotStaysThere)
{
    const LobeTable table = testTable(LobeAxes::tilted, 1);
    EXPECT_EQ(lobesAt(table, direction(89.5 * kDegree, 0.0)).cosine.x,
              double(table.knots.back().cosine.x));
}

TEST(LobeTable, TiltTurnsTheMirrorDirectionTowardsTheNormal)
{
    LobeTable table = testTable(LobeAxes::tilted, 1);
    for (LobeKnot& knot : table.knots) knot.lobes[0].level = 4.0f;
    for (const float tilt : {0.0f, 0.5f, -0.5f}) {
        for (LobeKnot& knot : table.knots) knot.lobes[0].tilt = tilt;
        const double theta = 0.8, phi = 2.0;
        const LobeSum<double> sum = lobesAt(table, direction(theta, phi));
        // In the plane of incidence, on the other side of the normal.
        const Vec3d expected = direction(theta - double(tilt) * 0.25, phi + kPi);
        EXPECT_LT(glm::length(sum.axis[0] - expected), 1e-6) << double(tilt);
    }
}

TEST(LobeTable, BentAxesMirrorAboutBentNormals)
{
    LobeTable table = testTable(LobeAxes::bent, 3, 12, 7);
    const Vec3d wo = direction(0.7, 0.4);
    for (const bool across : {false, true}) {
        table.acrossTangent = across;
        const LobeSum<double> sum = lobesAt(table, wo);
        EXPECT_LT(glm::length(sum.axis[1] - Vec3d(-wo.x, -wo.y, wo.z)), 1e-12);
        for (const int k : {0, 2}) {
            // Both make equal angles with the normal, in one plane with it.
            const double offset = 0.2 * (k - 1);
            const Vec3d normal = glm::normalize(across ? Vec3d(0, offset, 1) : Vec3d(offset, 0, 1));
            const Vec3d axis = sum.axis[static_cast<size_t>(k)];
            EXPECT_NEAR(glm::length(axis), 1.0, 1e-6);
            EXPECT_LT(glm::length(glm::normalize(axis + wo) - normal), 1e-6);
        }
    }
}

TEST(LobeTable, BentTablesAreTheSameInAllQuadrants)
{
    const LobeTable table = testTable(LobeAxes::bent, 3, 12, 7);
    const Vec3d wo = direction(0.7, 0.4);
    const double expected = lobesAt(table, wo).cosine.x;
    for (const Vec3d& other :
         {Vec3d(-wo.x, wo.y, wo.z), Vec3d(wo.x, -wo.y, wo.z), Vec3d(-wo.x, -wo.y, wo.z)})
        EXPECT_EQ(lobesAt(table, other).cosine.x, expected);
    EXPECT_NE(lobesAt(table, direction(0.7, 1.0)).cosine.x, expected);
}

TEST(LobeTable, BentAxesAreMirroredAsTheViewIs)
{
    LobeTable table = testTable(LobeAxes::bent, 3, 12, 7);
    const Vec3d wo = direction(0.7, 0.4);
    for (const bool across : {false, true}) {
        table.acrossTangent = across;
        const LobeSum<double> here = lobesAt(table, wo);
        for (const Vec3d& sides : {Vec3d(-1, 1, 1), Vec3d(1, -1, 1), Vec3d(-1, -1, 1)}) {
            const LobeSum<double> there = lobesAt(table, wo * sides);
            for (size_t k = 0; k < 3; ++k)
                EXPECT_LT(glm::length(there.axis[k] - here.axis[k] * sides), 1e-12) << k;
        }
    }
}

TEST(LobeTable, FloatsFollowDoubles)
{
    // acos near 1 is good to sqrt(2 eps); levels change by 0.02 a knot.
    constexpr double kClose = 1e-5;
    for (const LobeTable& table :
         {testTable(LobeAxes::tilted, 3), testTable(LobeAxes::bent, 5, 12, 7)})
        for (double theta = 0.001; theta < 1.57; theta += 0.013) {
            const Vec3d wo = direction(theta, 5.0 * theta);
            const LobeSum<double> exact = lobesAt(table, wo);
            const LobeSum<float> rough = lobesAt(table, Vec3f(wo));
            for (size_t k = 0; k < static_cast<size_t>(table.lobes); ++k) {
                EXPECT_LT(glm::length(Vec3d(rough.axis[k]) - exact.axis[k]), kClose) << theta;
                EXPECT_NEAR(double(rough.level[k]), exact.level[k], kClose) << theta;
                EXPECT_LT(glm::length(Vec3d(rough.weight[k]) - exact.weight[k]), kClose) << theta;
            }
        }
}

TEST(LobeTable, NormalIncidenceHasAnAxis)
{
    const LobeTable table = testTable(LobeAxes::tilted, 2);
    EXPECT_EQ(lobesAt(table, Vec3f(0, 0, 1)).axis[1], Vec3f(0, 0, 1));
    EXPECT_EQ(lobesAt(table, Vec3d(0, 0, 1)).axis[0], Vec3d(0, 0, 1));
}

TEST(LobeTable, RefusesWhatIsOutOfRange)
{
    const LobeTable good = testTable(LobeAxes::tilted, 2);
    validate(good, "x");
    validate(LobeTable{}, "x");
    const auto refuses = [&](const char* words, const auto& change) {
        LobeTable table = good;
        change(table);
        expectError(ErrorKind::input, words, [&] { validate(table, "x"); });
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refuses("4 lobes", [](LobeTable& t) { t.lobes = 4; });
    refuses("2 lobes", [](LobeTable& t) { t.axes = LobeAxes::bent; });
    refuses("24 knots", [](LobeTable& t) { t.thetas = 25; });
    refuses("24 knots", [](LobeTable& t) { t.azimuths = 0; });
    refuses("no number", [&](LobeTable& t) { t.spread = nan; });
    refuses("no number", [](LobeTable& t) { t.error = -1.0; });
    refuses("no number", [](LobeTable& t) { t.fewerErrors = {-1.0}; });
    refuses("2 errors of fewer lobes", [](LobeTable& t) { t.fewerErrors = {0.5, 0.25}; });
    refuses("knot 3", [&](LobeTable& t) { t.knots[3].cosine.y = nan; });
    refuses("knot 4", [](LobeTable& t) { t.knots[4].lobes[1].weight.x = -1e-3f; });
    refuses("knot 5", [](LobeTable& t) { t.knots[5].lobes[0].level = 6.1f; });
    refuses("knot 6", [](LobeTable& t) { t.knots[6].lobes[0].tilt = INFINITY; });
}

}  // namespace
