// LobeFitTest.cpp - lobes of reflectances whose lobes are known, energy, and what no lobe can be.
#include "support/ExpectError.h"

#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/plan/Lobes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace fbrdf;
using fbrdf::test::expectError;

namespace {

Vec3d direction(double theta, double phi = 0.0)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A BRDF that is a Lambertian and one lobe about the mirror direction, cut off at the horizon.
Vec3d lobeBrdf(const Vec3d& wo, const Vec3d& wi, double level, const Vec3d& weight)
{
    if (!(wi.z > 0.0) || !(wo.z > 0.0)) return Vec3d(0.0);
    const double lobe = lobeValue(glm::dot(wi, Vec3d(-wo.x, -wo.y, wo.z)), level);
    return Vec3d(0.2, 0.3, 0.4) / kPi + weight * lobe / wi.z;
}

/// An anisotropic highlight that is much longer across the tangent than along it.
Vec3d longBrdf(const Vec3d& wo, const Vec3d& wi)
{
    if (!(wi.z > 0.0) || !(wo.z > 0.0)) return Vec3d(0.0);
    const Vec3d h = glm::normalize(wo + wi);
    const double x = h.x / (0.05 * h.z), y = h.y / (0.3 * h.z);
    return Vec3d(0.3, 0.2, 0.1) * std::exp(-x * x - y * y) / std::sqrt(wi.z * wo.z + 1e-3) / 0.15;
}

double albedoOf(const Reflectance& f, const Vec3d& wo, int channel)
{
    constexpr int kThetas = 400, kPhis = 400;
    double sum = 0.0;
    for (int i = 0; i < kThetas; ++i)
        for (int j = 0; j < kPhis; ++j) {
            const double theta = (i + 0.5) / kThetas * 0.5 * kPi;
            const Vec3d wi = direction(theta, (j + 0.5) / kPhis * 2.0 * kPi);
            sum += f(wo, wi)[channel] * std::cos(theta) * std::sin(theta);
        }
    return sum * 0.5 * kPi / kThetas * 2.0 * kPi / kPhis;
}

Vec3f sumOfWeights(const LobeTable& table, const LobeKnot& knot)
{
    Vec3f sum = knot.cosine;
    for (size_t k = 0; k < static_cast<size_t>(table.lobes); ++k) sum += knot.lobes[k].weight;
    return sum;
}

TEST(LobeFit, ALambertianIsACosine)
{
    const auto f = [](const Vec3d&, const Vec3d& wi) {
        return wi.z > 0.0 ? Vec3d(0.5, 0.25, 0.75) / kPi : Vec3d(0.0);
    };
    const LobeTable table = fitLobes(f, true);
    validate(table, "test");
    EXPECT_EQ(table.lobes, 1);  // more would bring nothing
    EXPECT_LT(table.error, 1e-3);
    for (const LobeKnot& knot : table.knots)
        EXPECT_LT(glm::length(sumOfWeights(table, knot) - Vec3f(0.5f, 0.25f, 0.75f)), 1e-3f);
}

TEST(LobeFit, FindsTheLobeThatAReflectanceHas)
{
    const Vec3d weight(0.3, 0.2, 0.1);
    for (const double level : {2.0, 3.0}) {
        LobeFitOptions options;
        options.lobes = 1;
        const LobeTable table = fitLobes(
            [&](const Vec3d& wo, const Vec3d& wi) { return lobeBrdf(wo, wi, level, weight); }, true,
            options);
        EXPECT_LT(table.error, 0.02) << level;
        // Knots up to 60 degrees, where the horizon cuts nothing off.
        for (size_t i = 0; i < 13; ++i) {
            const Lobe& lobe = table.knots[i].lobes[0];
            EXPECT_NEAR(double(lobe.level), level, 0.26) << i;
            EXPECT_LT(std::abs(lobe.tilt), 0.2f) << i;
            EXPECT_LT(glm::length(Vec3d(lobe.weight) - weight), 0.02) << i;
            EXPECT_LT(glm::length(table.knots[i].cosine - Vec3f(0.2f, 0.3f, 0.4f)), 0.02f) << i;
        }
    }
}

TEST(LobeFit, WeightsAddUpToTheAlbedo)
{
    const Vec3d weight(0.3, 0.2, 0.1);
    const Reflectance rough = [&](const Vec3d& wo, const Vec3d& wi) {
        return lobeBrdf(wo, wi, 4.0, weight);
    };
    for (const bool isotropic : {true, false}) {
        const Reflectance f = isotropic ? rough : Reflectance(longBrdf);
        const LobeTable table = fitLobes(f, isotropic);
        const int count = table.thetas;
        for (const int i : {0, count / 3, 2 * count / 3}) {
            const LobeKnot& knot = table.knots[static_cast<size_t>(i)];
            for (int c = 0; c < 3; ++c) {
                const double albedo = albedoOf(f, direction(lobeKnotAngle(i, count)), c);
                // White furnace: a twohundredth.
                EXPECT_NEAR(double(sumOfWeights(table, knot)[c]), albedo, 0.005 * albedo) << i;
            }
        }
    }
}

TEST(LobeFit, MoreLobesAreNotWorse)
{
    // A wide and a narrow highlight, as of a coat over a rough base.
    const auto f = [](const Vec3d& wo, const Vec3d& wi) {
        return lobeBrdf(wo, wi, 1.0, Vec3d(0.1)) + lobeBrdf(wo, wi, 4.5, Vec3d(0.2, 0.3, 0.1));
    };
    double before = std::numeric_limits<double>::infinity();
    for (int lobes = 1; lobes <= 3; ++lobes) {
        LobeFitOptions options;
        options.lobes = lobes;
        const LobeTable table = fitLobes(f, true, options);
        validate(table, "test");
        EXPECT_LE(table.error, before) << lobes;
        before = table.error;
        // With lobes left out it is worse, and no better than a table that was fitted so.
        ASSERT_EQ(table.fewerErrors.size(), static_cast<size_t>(table.lobes) - 1);
        for (size_t i = 0; i < table.fewerErrors.size(); ++i) {
            EXPECT_GT(table.fewerErrors[i], table.error);
            EXPECT_EQ(withFewerLobes(table, static_cast<int>(i) + 1).error, table.fewerErrors[i]);
        }
        if (lobes == 2) {
            EXPECT_EQ(table.lobes, 2);
            EXPECT_LT(table.error, 0.02);
        }
    }
}

TEST(LobeFit, BentNormalsFollowALongHighlight)
{
    const LobeTable table = fitLobes(longBrdf, false);
    validate(table, "test");
    EXPECT_EQ(table.axes, LobeAxes::bent);
    EXPECT_EQ(table.lobes, 3);
    EXPECT_TRUE(table.acrossTangent);  // the side along which the highlight is long
    LobeFitOptions one;
    one.normals = 1;
    const LobeTable single = fitLobes(longBrdf, false, one);
    EXPECT_LT(table.error, 0.7 * single.error);
    EXPECT_TRUE(single.fewerErrors.empty());
    ASSERT_EQ(table.fewerErrors.size(), 1u);
    // All the light in the middle one is worse than the best single lobe, but not absurd.
    EXPECT_GE(table.fewerErrors[0], 0.99 * single.error);
    EXPECT_LT(table.fewerErrors[0], 3.0 * single.error);
    // The same highlight turned by a quarter.
    const auto turned = [](const Vec3d& wo, const Vec3d& wi) {
        return longBrdf(Vec3d(wo.y, -wo.x, wo.z), Vec3d(wi.y, -wi.x, wi.z));
    };
    const LobeTable other = fitLobes(turned, false);
    EXPECT_FALSE(other.acrossTangent);
    EXPECT_NEAR(other.error, table.error, 0.02 * table.error);
    EXPECT_EQ(other.spread, table.spread);
}

TEST(LobeFit, KIsSoManyTiltedLobesOrOneThreeOrSevenBentNormals)
{
    const std::pair<int, int> expected[] = {{1, 1}, {2, 3}, {3, 7}};
    for (const auto& [lobes, normals] : expected) {
        const LobeFitOptions options = lobeOptions(lobes);
        EXPECT_EQ(options.lobes, lobes);
        EXPECT_EQ(options.normals, normals);
    }
    EXPECT_EQ(LobeFitOptions().normals, lobeOptions(LobeFitOptions().lobes).normals);
}

TEST(LobeFit, BothSidesOfThePlaneOfIncidenceCount)
{
    const auto f = [](const Vec3d& wo, const Vec3d& wi) {
        return lobeBrdf(wo, wi, 4.0, Vec3d(0.3, 0.2, 0.1));
    };
    // Twice as much on one side, nothing on the other.
    const auto oneSided = [&](const Vec3d& wo, const Vec3d& wi) {
        const double side = wo.x * wi.y - wo.y * wi.x;
        return f(wo, wi) * (side > 0.0 ? 2.0 : side < 0.0 ? 0.0 : 1.0);
    };
    const LobeTable even = fitLobes(f, true), odd = fitLobes(oneSided, true);
    for (size_t i = 0; i < even.knots.size(); ++i)
        EXPECT_LT(glm::length(sumOfWeights(even, even.knots[i]) - sumOfWeights(odd, odd.knots[i])),
                  1e-5f);
}

TEST(LobeFit, DoesNotDependOnThreads)
{
    const auto f = [](const Vec3d& wo, const Vec3d& wi) {
        return lobeBrdf(wo, wi, 3.3, Vec3d(0.3, 0.2, 0.1));
    };
    LobeFitOptions one, four;
    one.threads = 1;
    four.threads = 4;
    const LobeTable a = fitLobes(f, true, one), b = fitLobes(f, true, four);
    ASSERT_EQ(a.knots.size(), b.knots.size());
    for (size_t i = 0; i < a.knots.size(); ++i) {
        EXPECT_EQ(a.knots[i].cosine, b.knots[i].cosine);
        EXPECT_EQ(a.knots[i].lobes[0].weight, b.knots[i].lobes[0].weight);
    }
    EXPECT_EQ(a.error, b.error);
}

TEST(LobeFit, BlackHasNoWeights)
{
    for (const bool isotropic : {true, false}) {
        const LobeTable table =
            fitLobes([](const Vec3d&, const Vec3d&) { return Vec3d(0.0); }, isotropic);
        validate(table, "test");
        EXPECT_EQ(table.error, 0.0);
        for (const LobeKnot& knot : table.knots) EXPECT_EQ(sumOfWeights(table, knot), Vec3f(0.0f));
    }
}

TEST(LobeFit, RefusesWhatIsNoNumber)
{
    for (const bool isotropic : {true, false})
        expectError(ErrorKind::fit, "a reflectance that is no number at theta_o", [&] {
            fitLobes([](const Vec3d&,
                        const Vec3d& wi) { return Vec3d(wi.z > 0.5 ? std::nan("") : 0.1); },
                     isotropic);
        });
}

TEST(LobeFit, RefusesOptionsOutOfRange)
{
    const auto f = [](const Vec3d&, const Vec3d&) { return Vec3d(0.1); };
    const auto refuses = [&](const LobeFitOptions& options, const char* words) {
        expectError(ErrorKind::usage, words, [&] { fitLobes(f, true, options); });
    };
    LobeFitOptions options;
    options.lobes = 4;
    refuses(options, "4 lobes");
    options = {};
    options.normals = 2;
    refuses(options, "2 bent normals");
    options = {};
    options.thetas = 1;
    refuses(options, "1 knots");
}

}  // namespace
