#include <fbrdf/brdf/CubeFaces.h>
#include <fbrdf/brdf/DirectionMap.h>

#include <gtest/gtest.h>

#include "support/ExpectError.h"

#include <cmath>
#include <limits>
#include <random>

namespace fbrdf {
namespace {

// The rounding of floats of magnitude 8 or less.
constexpr double kFloat = 1e-6;

/// log2 F of a direction, one number for each channel.
using Logs = Vec3d (*)(const Vec3d&);

Vec3d smooth(const Vec3d& d)
{
    return {-4.0 * (1.0 - d.z), 0.8 * d.x + 0.5 * d.x * d.y, std::sin(2.0 * d.y) - d.z};
}

Vec3d constant(const Vec3d&)
{
    return {1.5, -2.0, 0.25};
}

/// A highlight of six octaves, steepest at the pole of a warped map.
Vec3d peak(const Vec3d& d)
{
    return Vec3d(6.0 * std::exp(-40.0 * (1.0 - d.z)));
}

Table tableOf(Logs logs, int size, double gamma)
{
    Table table;
    table.name = "p";
    const DiscDomain disc = DiscDomain::fitting(size, gamma);
    table.domain = disc;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3d value = logs(directionFromDiscPosition(disc, {x, y}));
            for (int c = 0; c < 3; ++c) table.texels.push_back(static_cast<float>(value[c]));
        }
    return table;
}

Vec3d valueAt(const Table& table, const Vec3d& direction)
{
    return sample(table, Vec3d(discPosition(std::get<DiscDomain>(table.domain), direction), 0.0));
}

DirectionMapRequest requestOf(LookUp lookUp, int size, bool seamless)
{
    DirectionMapRequest request;
    request.lookUp = lookUp;
    request.size = size;
    request.seamless = seamless;
    return request;
}

/// A direction of the hemisphere, uniformly distributed.
Vec3d randomDirection(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double z = unit(random), phi = 2.0 * kPi * unit(random), radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

/// The value of a map; a corner of the cube takes the mean of the texels that exist.
Vec3d mapAt(const DirectionMap& map, const Vec3d& direction, bool seamless)
{
    if (map.lookUp == LookUp::parabolic) return valueAt(map.table, direction);
    const CubeStencil stencil = cubeStencil(direction, map.size(), seamless);
    Vec3d sum(0.0), mean(0.0);
    for (size_t k = 0; k < 4; ++k) {
        if (stencil.texel[k] < 0) continue;
        for (int c = 0; c < 3; ++c) {
            const double texel = static_cast<double>(map.table.texel(stencil.texel[k], c));
            sum[c] += stencil.weight[k] * texel;
            mean[c] += texel / 3.0;
        }
    }
    for (size_t k = 0; k < 4; ++k)
        if (stencil.texel[k] < 0) sum += stencil.weight[k] * mean;
    return sum;
}

double largest(const Vec3d& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

TEST(CubeFaces, PutTheAxesWhereOpenGlDoes)
{
    // The centre of each face, and the texel left of it in the top row (table 8.19: s and t).
    const Vec3d axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Vec3d corners[] = {{1, 1, 1},   {-1, 1, -1}, {-1, 1, -1},
                             {-1, -1, 1}, {-1, 1, 1},  {1, 1, -1}};
    for (int face = 0; face < kFaces; ++face) {
        EXPECT_EQ(cubePoint(face, 0.5, 0.5, 2), axes[face]);
        EXPECT_EQ(cubePoint(face, -0.5, -0.5, 2), corners[face]);
    }
}

TEST(CubeFaces, StencilsOfTexelCentresAreThoseTexels)
{
    for (const bool seamless : {false, true})
        for (int texel = 0; texel < kFaces * 16; ++texel) {
            const CubeStencil s =
                cubeStencil(cubePoint(texel / 16, texel % 4, texel / 4 % 4, 4), 4, seamless);
            double weight = 0.0;
            for (size_t k = 0; k < 4; ++k) weight += s.texel[k] == texel ? s.weight[k] : 0.0;
            EXPECT_NEAR(weight, 1.0, 1e-12) << texel;
        }
}

TEST(CubeFaces, EdgesAreReadFromBothSidesAlike)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> along(-0.8, 0.8);
    const Table table = tableOf(smooth, 16, 1.0);
    const DirectionMap map = recombined(table, requestOf(LookUp::cube, 8, true));
    double clamped = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double t = along(random);
        const Vec3d one(1.0, t, 1.0 + 1e-9), other(1.0 + 1e-9, t, 1.0);
        EXPECT_LT(largest(mapAt(map, one, true) - mapAt(map, other, true)), 1e-6);
        clamped = std::max(clamped, largest(mapAt(map, one, false) - mapAt(map, other, false)));
    }
    EXPECT_GT(clamped, 0.01) << "seams must show where they are";
}

TEST(CubeFaces, CornersLackOneTexel)
{
    EXPECT_FALSE(cubeStencil({1.0, 1.0, 1.0}, 8, true).isWhole);
    EXPECT_TRUE(cubeStencil({1.0, 1.0, 1.0}, 8, false).isWhole);
    EXPECT_TRUE(cubeStencil({1.0, 0.2, 1.0}, 8, true).isWhole);
}

TEST(DirectionMap, OfAConstantIsExact)
{
    for (const LookUp lookUp : {LookUp::parabolic, LookUp::cube})
        for (const bool seamless : {false, true}) {
            const auto map = recombined(tableOf(constant, 8, 0.5), requestOf(lookUp, 0, seamless));
            EXPECT_LT(map.error, kFloat);
            EXPECT_EQ(map.size(), 16) << "no texel more than it needs";
        }
}

TEST(DirectionMap, IsWithinItsErrorEverywhere)
{
    std::mt19937 random(7);
    for (const Logs logs : {smooth, peak})
        for (const double gamma : {0.5, 1.0})
            for (const LookUp lookUp : {LookUp::parabolic, LookUp::cube})
                for (const bool seamless : {false, true}) {
                    const Table table = tableOf(logs, 16, gamma);
                    const DirectionMap map = recombined(table, requestOf(lookUp, 64, seamless));
                    double worst = 0.0;
                    for (int i = 0; i < 20000; ++i) {
                        const Vec3d d = randomDirection(random);
                        worst =
                            std::max(worst, largest(mapAt(map, d, seamless) - valueAt(table, d)));
                    }
                    EXPECT_LE(worst, map.error + kFloat) << gamma << lookUpName(lookUp);
                    EXPECT_GE(worst, 0.3 * map.error) << gamma << lookUpName(lookUp);
                }
}

TEST(DirectionMap, TakesTheSizeThatItNeeds)
{
    const Table table = tableOf(smooth, 16, 1.0);
    double last = std::numeric_limits<double>::infinity();
    for (const int size : {16, 32, 64, 128}) {
        const double error = recombined(table, requestOf(LookUp::cube, size, true)).error;
        EXPECT_LT(error, 0.75 * last) << size;
        last = error;
    }
    const DirectionMap chosen = recombined(table, requestOf(LookUp::cube, 0, true));
    EXPECT_LE(chosen.error, 1.0 / 64.0);
    EXPECT_GT(recombined(table, requestOf(LookUp::cube, chosen.size() / 2, true)).error,
              1.0 / 64.0);
    DirectionMapRequest request = requestOf(LookUp::cube, 0, true);
    EXPECT_EQ(recombined(tableOf(peak, 16, 0.5), request).size(), 256);
    request.largest = 64;
    EXPECT_EQ(recombined(tableOf(peak, 16, 0.5), request).size(), 64);
}

TEST(DirectionMap, SaysWhatItCannotHold)
{
    const Form pqpr = formPqpr(8, 0.5, 16), hdio = formHdio({8, 4, 4});
    EXPECT_EQ(whyNotRecombined(pqpr, 0, Storage::log8), "");
    EXPECT_NE(whyNotRecombined(pqpr, 0, Storage::linear8).find("logs"), std::string::npos);
    EXPECT_NE(whyNotRecombined(pqpr, 2, Storage::half).find("angles"), std::string::npos);
    EXPECT_NE(whyNotRecombined(hdio, 1, Storage::half).find("'T2'"), std::string::npos);
    Form below = pqpr;
    below.terms[0].factors[1].argument = Direction::combination(-1.0, 1.0, 0.5);
    EXPECT_NE(whyNotRecombined(below, 1, Storage::half).find("below"), std::string::npos);
    for (const Direction& direction : {Direction::mirror, Direction::d}) {
        below.terms[0].factors[1].argument = direction;
        EXPECT_EQ(whyNotRecombined(below, 1, Storage::half), "");
    }
}

TEST(DirectionMap, RefusesSizesThatAreNone)
{
    for (const int size : {-2, 1, 33, 4096})
        test::expectError(ErrorKind::usage, "even number", [&] {
            recombined(tableOf(constant, 8, 0.5), requestOf(LookUp::cube, size, true));
        });
}

TEST(LookUp, HasNames)
{
    for (const LookUp l : {LookUp::native, LookUp::parabolic, LookUp::cube})
        EXPECT_EQ(lookUpFromName(lookUpName(l)), l);
    test::expectError(ErrorKind::usage, "expected native", [] { lookUpFromName("dual"); });
}

TEST(DirectionMapContrast, OfACubeSeesBothSidesOfAnEdge)
{
    DirectionMap map = recombined(tableOf(constant, 16, 1.0), {LookUp::cube, 8});
    EXPECT_EQ(contrast(map), 0.0);
    // One face higher than the others: within the faces nothing differs.
    const size_t face = 3 * 8 * 8;
    for (size_t i = 0; i < face; ++i) map.table.texels[4 * face + i] += 2.0f;
    EXPECT_EQ(contrast(map), 4.0);
    // What lies deep below the horizon is never read.
    map = recombined(tableOf(constant, 16, 1.0), {LookUp::cube, 8});
    map.table.texels[5 * face + face / 2] += 2.0f;
    EXPECT_EQ(contrast(map), 0.0);
    const DirectionMap smoothMap = recombined(tableOf(smooth, 16, 1.0), {LookUp::cube, 32});
    const DirectionMap finer = recombined(tableOf(smooth, 16, 1.0), {LookUp::cube, 64});
    EXPECT_LT(contrast(finer), 0.7 * contrast(smoothMap));
}

TEST(DirectionMapContrast, OfAParabolicMapIsThatOfItsTable)
{
    const DirectionMap map = recombined(tableOf(peak, 16, 0.5), {LookUp::parabolic, 32});
    EXPECT_EQ(contrast(map), contrast(map.table));
    EXPECT_GT(contrast(map), 0.0);
}

}  // namespace
}  // namespace fbrdf
