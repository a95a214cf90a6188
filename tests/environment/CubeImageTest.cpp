#include <fbrdf/brdf/CubeFaces.h>
#include <fbrdf/environment/CubeImage.h>

#include <gtest/gtest.h>

#include "environment/Panoramas.h"

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

/// Sums of floats of at most 1.
constexpr double kRounding = 1e-6;

/// Solid angle of the part of a face from its centre to (s, t), for the corner of a texel.
double cornerSolidAngle(double s, double t)
{
    return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0));
}

double cubeTexelSolidAngle(int x, int y, int size)
{
    const auto edge = [size](int i) { return 2.0 * i / size - 1.0; };
    return cornerSolidAngle(edge(x + 1), edge(y + 1)) - cornerSolidAngle(edge(x), edge(y + 1)) -
           cornerSolidAngle(edge(x + 1), edge(y)) + cornerSolidAngle(edge(x), edge(y));
}

/// Integral over the sphere of a level.
Vec3d fluxOf(const CubeImage& cube, size_t level)
{
    const int size = cube.sizeOf(level);
    Vec3d sum(0.0);
    for (int face = 0; face < kFaces; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                sum += cubeTexelSolidAngle(x, y, size) *
                       Vec3d(cube.levels[level][static_cast<size_t>((face * size + y) * size + x)]);
    return sum;
}

TEST(CubeImage, SolidAnglesOfTheTesterAddUp)
{
    const CubeImage ones{8, {std::vector<Vec3f>(6 * 64, Vec3f(1.0f))}};
    EXPECT_NEAR(fluxOf(ones, 0).x, 4.0 * kPi, 1e-12);
}

TEST(CubeImage, OfAConstantIsThatConstantInAllLevels)
{
    for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {7, 3}, {64, 32}, {300, 20}})
        for (const int size : {1, 2, 8, 32}) {
            const CubeImage cube =
                cubeOfPanorama(constantPanorama(width, height, Vec3f(1.0f)), size);
            ASSERT_EQ(cube.size, size);
            ASSERT_EQ(cube.levels.size(), static_cast<size_t>(std::log2(size)) + 1);
            for (size_t level = 0; level < cube.levels.size(); ++level) {
                ASSERT_EQ(cube.levels[level].size(),
                          static_cast<size_t>(6 * cube.sizeOf(level) * cube.sizeOf(level)));
                for (const Vec3f& texel : cube.levels[level]) ASSERT_EQ(texel, Vec3f(1.0f));
            }
        }
}

TEST(CubeImage, LosesNoLightOfALampOfOneTexel)
{
    // The solid angle of a texel is summed over meridians, the light of a lamp is exact.
    constexpr double kFlux = 0.002;
    std::mt19937 random(2);
    const int width = 256, height = 128;
    for (int i = 0; i < 24; ++i) {
        // Rows beside the poles, beside the edges of the two faces, and any others.
        const int rows[] = {0,  1,  height - 1, height - 2,
                            31, 32, 20,         static_cast<int>(random() % height)};
        const int y = rows[i % 8], x = i < 16 ? (i / 8) * 64 : static_cast<int>(random() % width);
        const Panorama lamp = oneTexelPanorama(width, height, x, y);
        const double exact = texelSolidAngle(lamp, y);
        for (const int size : {8, 32}) {
            const double flux = fluxOf(cubeOfPanorama(lamp, size), 0).x;
            EXPECT_NEAR(flux / exact, 1.0, kFlux) << x << " " << y << " on " << size;
        }
    }
}

TEST(CubeImage, PutsLightWhereThePanoramaHasIt)
{
    // A lamp at the centre of a texel of the cube, and much smaller, lights that texel alone.
    constexpr int kSize = 8;
    for (int texel = 0; texel < kFaces * kSize * kSize; texel += 5) {
        const int face = texel / (kSize * kSize), y = texel / kSize % kSize, x = texel % kSize;
        const auto place = panoramaPlace(cubeTexelDirection(face, x, y, kSize));
        const Panorama lamp = oneTexelPanorama(256, 128, static_cast<int>(256 * place.x),
                                               static_cast<int>(128 * place.y));
        const CubeImage cube = cubeOfPanorama(lamp, kSize);
        for (int i = 0; i < kFaces * kSize * kSize; ++i)
            ASSERT_EQ(cube.levels[0][static_cast<size_t>(i)].x > 0.0f, i == texel)
                << i << " " << texel;
    }
}

TEST(CubeImage, OfAGradientIsThatGradient)
{
    // Linear in the direction: means over texels differ from the centre by some h^2 / 24, and the
    // panorama is constant over texels of pi / 512.
    constexpr double kStep = 0.004;
    const auto radiance = [](const Vec3d& w) { return 1.0 + 0.5 * w; };
    const CubeImage cube = cubeOfPanorama(panoramaOf(1024, 512, radiance), 32);
    for (int face = 0; face < kFaces; ++face)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const Vec3d expected = radiance(cubeTexelDirection(face, x, y, 32));
                const Vec3d found(cube.levels[0][static_cast<size_t>((face * 32 + y) * 32 + x)]);
                ASSERT_NEAR(glm::distance(found, expected), 0.0, kStep) << face << x << " " << y;
            }
}

TEST(CubeImage, DoesNotDependOnThreads)
{
    const Panorama panorama = randomPanorama(30, 17, 3);
    const CubeImage one = cubeOfPanorama(panorama, 16, 1), four = cubeOfPanorama(panorama, 16, 4);
    EXPECT_EQ(one.levels, four.levels);
}

TEST(CubeImage, LevelsAreMeansOfFour)
{
    const CubeImage cube = cubeOfPanorama(randomPanorama(64, 32, 4), 8);
    for (int face = 0; face < kFaces; ++face)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const auto at = [&](int i, int j) {
                    return Vec3d(cube.levels[0][static_cast<size_t>((face * 8 + 2 * y + j) * 8 +
                                                                    2 * x + i)]);
                };
                const Vec3d mean = 0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1));
                const Vec3d found(cube.levels[1][static_cast<size_t>((face * 4 + y) * 4 + x)]);
                EXPECT_NEAR(glm::distance(found, mean), 0.0, kRounding);
            }
}

TEST(CubeImage, SamplesTexelsAtTheirCentres)
{
    const CubeImage cube = cubeOfPanorama(randomPanorama(64, 32, 5), 8);
    for (size_t level = 0; level < cube.levels.size(); ++level) {
        const int size = cube.sizeOf(level);
        for (int face = 0; face < kFaces; ++face)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const Vec3d found =
                        sampleCube(cube, 3.0 * cubeTexelDirection(face, x, y, size), double(level));
                    const Vec3d texel(
                        cube.levels[level][static_cast<size_t>((face * size + y) * size + x)]);
                    EXPECT_NEAR(glm::distance(found, texel), 0.0, kRounding);
                }
    }
}

TEST(CubeImage, IsFilteredAsStencilsSay)
{
    const CubeImage cube = cubeOfPanorama(randomPanorama(64, 32, 6), 4);
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        const Vec3d direction = randomDirection(random);
        const CubeStencil stencil = cubeStencil(direction, 4, true);
        Vec3d sum(0.0);
        double weight = 0.0;
        for (size_t k = 0; k < 4; ++k)
            if (stencil.texel[k] >= 0) {
                sum += stencil.weight[k] *
                       Vec3d(cube.levels[0][static_cast<size_t>(stencil.texel[k])]);
                weight += stencil.weight[k];
            }
        if (stencil.isWhole)
            EXPECT_NEAR(glm::distance(sampleCube(cube, direction, 0.0), sum), 0.0, kRounding);
        else
            EXPECT_LT(weight, 1.0);
    }
}

TEST(CubeImage, AtACornerIsTheMeanOfThreeTexels)
{
    CubeImage cube{2, {std::vector<Vec3f>(24, Vec3f(0.0f))}};
    // The texels beside the corner (1, 1, 1), on +x, +y and +z.
    const CubePlace places[] = {cubePlace({1.0, 0.5, 0.5}), cubePlace({0.5, 1.0, 0.5}),
                                cubePlace({0.5, 0.5, 1.0})};
    float value = 1.0f;
    for (const CubePlace& place : places) {
        cube.levels[0][static_cast<size_t>((place.face * 2 + (place.t > 0.0)) * 2 +
                                           (place.s > 0.0))] = Vec3f(value);
        value *= 2.0f;
    }
    EXPECT_NEAR(sampleCube(cube, {1.0, 1.0, 1.0}, 0.0).x, 7.0 / 3.0, kRounding);
}

TEST(CubeImage, IsContinuousOverEdges)
{
    const CubeImage cube = cubeOfPanorama(randomPanorama(64, 32, 8), 8);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> along(-1.0, 1.0);
    for (int i = 0; i < 500; ++i) {
        Vec3d edge(1.0, 1.0, along(random));
        for (int turn = i % 3; turn > 0; --turn) edge = {edge.z, edge.x, edge.y};
        const Vec3d step = 1e-9 * randomDirection(random);
        const double level = 0.5 * (i % 7);
        EXPECT_NEAR(glm::distance(sampleCube(cube, edge + step, level),
                                  sampleCube(cube, edge - step, level)),
                    0.0, kRounding);
    }
}

TEST(CubeImage, MixesAndClampsLevels)
{
    const CubeImage cube = cubeOfPanorama(randomPanorama(64, 32, 10), 8);
    const Vec3d direction(0.3, -0.8, 0.2);
    const auto at = [&](double level) { return sampleCube(cube, direction, level); };
    EXPECT_NEAR(glm::distance(at(1.25), 0.75 * at(1.0) + 0.25 * at(2.0)), 0.0, kRounding);
    EXPECT_EQ(at(-2.0), at(0.0));
    EXPECT_EQ(at(9.0), at(3.0));
    EXPECT_EQ(at(std::nan("")), at(0.0));
}

TEST(CubeImage, ReadsSomeTexelInDirectionsThatAreNone)
{
    const CubeImage cube = cubeOfPanorama(constantPanorama(4, 2, Vec3f(1.0f)), 8);
    const double bad[] = {std::nan(""), std::numeric_limits<double>::infinity(), 0.0};
    for (const double x : bad)
        for (const double y : bad)
            for (const double z : bad) EXPECT_EQ(sampleCube(cube, {x, y, z}, 0.5), Vec3d(1.0));
}

}  // namespace
}  // namespace fbrdf
