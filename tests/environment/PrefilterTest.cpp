#include <fbrdf/environment/Prefilter.h>

#include <gtest/gtest.h>

#include "environment/Panoramas.h"

#include <cmath>

namespace fbrdf {
namespace {

TEST(Prefilter, HasTheLevelsOfTheLobes)
{
    EXPECT_EQ(prefilteredLevels(8), 1);
    EXPECT_EQ(prefilteredLevels(16), 2);
    EXPECT_EQ(prefilteredLevels(128), 5);
    EXPECT_EQ(prefilteredLevels(512), 7);
    EXPECT_EQ(prefilteredLevels(1024), 7);
    EXPECT_EQ(cubeLevelOf(6.0, 512), 6.0);
    EXPECT_EQ(cubeLevelOf(6.0, 128), 4.0);
    EXPECT_EQ(cubeLevelOf(2.0, 128), 0.0);
    EXPECT_EQ(cubeLevelOf(6.0, 1024), 6.0);
}

TEST(Prefilter, OfAConstantIsThatConstant)
{
    constexpr double kRounding = 2e-6;  // weights are floats
    const CubeImage source = cubeOfPanorama(constantPanorama(16, 8, Vec3f(1.0f, 2.0f, 0.5f)), 16);
    const CubeImage cube = prefiltered(source, 16);
    ASSERT_EQ(cube.levels.size(), size_t(2));
    for (size_t level = 0; level < 2; ++level) {
        ASSERT_EQ(cube.levels[level].size(), 6 * size_t(16 >> level) * size_t(16 >> level));
        for (const Vec3f& texel : cube.levels[level])
            ASSERT_NEAR(glm::distance(texel, Vec3f(1.0f, 2.0f, 0.5f)), 0.0f, kRounding);
    }
}

TEST(Prefilter, OfOneHalfOfTheSphereIsTheClosedForm)
{
    // Of the half sphere about +y the lobes about +y see all, those about -y nothing, and those of
    // the horizon one half.
    constexpr double kLeak = 0.02;  // the widest cells look across the horizon
    const auto upper = [](const Vec3d& w) { return Vec3d(w.y > 0.0 ? 1.0 : 0.0); };
    const CubeImage cube = prefiltered(cubeOfPanorama(panoramaOf(64, 32, upper), 32), 32);
    for (int level = 4; level <= kCosineLevel; ++level) {
        EXPECT_NEAR(samplePrefiltered(cube, {0, 1, 0}, level).x, 1.0, kLeak) << level;
        EXPECT_NEAR(samplePrefiltered(cube, {0, -1, 0}, level).x, 0.0, kLeak) << level;
        EXPECT_NEAR(samplePrefiltered(cube, {1, 0, 0}, level).x, 0.5, kLeak) << level;
    }
    // A cosine at angle b from +y sees (1 + cos b) / 2 of it (its two halves are ellipses).
    for (const double b : {0.4, 0.8, 1.2, 2.0})
        EXPECT_NEAR(samplePrefiltered(cube, {std::sin(b), std::cos(b), 0.0}, kCosineLevel).x,
                    0.5 * (1.0 + std::cos(b)), kLeak)
            << b;
}

/// A lobe summed over the texels of a panorama, each by 4 x 4 samples.
Vec3d summed(const Panorama& panorama, const Vec3d& axis, int level)
{
    constexpr int kSamples = 4;
    const int width = kSamples * panorama.width, height = kSamples * panorama.height;
    Vec3d sum(0.0);
    double energy = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3d w = panoramaDirection((x + 0.5) / width, (y + 0.5) / height);
            const double weight =
                lobeValue(glm::dot(w, axis), level) * std::sin(kPi * (y + 0.5) / height);
            sum += weight * Vec3d(panorama.texel(x / kSamples, y / kSamples));
            energy += weight;
        }
    return sum / energy;
}

TEST(Prefilter, IsTheSumOverThePanorama)
{
    constexpr double kRms = 0.01;  // of the mean radiance
    // Some lamps a hundred times as bright as the rest.
    Panorama panorama = randomPanorama(64, 32, 1);
    for (int i = 0; i < 6; ++i)
        panorama.texels[static_cast<size_t>(301 * (i + 1))] = Vec3f(100.0f, 50.0f, 20.0f);
    Vec3d mean(0.0);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            mean += texelSolidAngle(panorama, y) / (4.0 * kPi) * Vec3d(panorama.texel(x, y));
    const CubeImage cube = prefiltered(cubeOfPanorama(panorama, 64), 32);
    for (int level = 4; level <= kCosineLevel; ++level) {
        const int size = 32 >> (level - 4);
        double squares = 0.0;
        for (int i = 0; i < 48; ++i) {
            const int face = i % 6, x = (7 * i) % size, y = (5 * i + i / 8) % size;
            const Vec3d axis = cubeTexelDirection(face, x, y, size);
            const Vec3d error =
                (samplePrefiltered(cube, axis, level) - summed(panorama, axis, level)) / mean;
            squares += glm::dot(error, error) / 3.0;
        }
        EXPECT_LT(std::sqrt(squares / 48), kRms) << level;
    }
}

TEST(Prefilter, DoesNotDependOnThreads)
{
    const CubeImage source = cubeOfPanorama(randomPanorama(32, 16, 2), 16);
    EXPECT_EQ(prefiltered(source, 16, 1).levels, prefiltered(source, 16, 3).levels);
}

}  // namespace
}  // namespace fbrdf
