#include <fbrdf/brdf/Half.h>
#include <fbrdf/shaders/TextureImage.h>

#include <gtest/gtest.h>

#include "support/gl/Scenes.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr float kUlps = 2e-6f;      // lower + extent x word in float, at magnitudes of 1.5
constexpr float kWordStep = 2e-4f;  // 3 / 65535 / 2, and the slack of rounding

Capabilities capabilities(bool floatTextures)
{
    Capabilities c;
    c.floatTextures = floatTextures;
    return c;
}

Table tableOf(Storage storage)
{
    return test::noiseMaterial(formHdio({8, 4, 4}), storage).tables[0];
}

float decoded(const TextureImage& image, size_t index)
{
    const int c = static_cast<int>(index % 3);
    return image.lower[c] + image.extent[c] * (static_cast<float>(image.words[index]) / 65535.0f);
}

TEST(TextureImage, KeepsEightBitTablesExactly)
{
    for (const Storage storage : {Storage::log8, Storage::linear8}) {
        const Table table = tableOf(storage);
        const TextureImage image = textureImage(table, capabilities(true));
        ASSERT_EQ(image.type, TexelType::unorm16);
        ASSERT_EQ(image.words.size(), table.texels.size());
        for (size_t i = 0; i < image.words.size(); ++i) {
            const int word = unorm16Of(table, static_cast<int>(i / 3), static_cast<int>(i % 3));
            ASSERT_EQ(image.words[i], word);
            ASSERT_NEAR(decoded(image, i), table.texels[i], kUlps);
        }
        EXPECT_EQ(image.encoding.logarithmic, storage == Storage::log8);
        EXPECT_EQ(image.encoding.ranged, storage == Storage::log8);
    }
}

TEST(TextureImage, KeepsHalvesAndFloatsExactly)
{
    const Table half = tableOf(Storage::half), full = tableOf(Storage::float32);
    const TextureImage a = textureImage(half, capabilities(true)),
                       b = textureImage(full, capabilities(true));
    ASSERT_EQ(a.type, TexelType::half);
    for (size_t i = 0; i < half.texels.size(); ++i)
        ASSERT_EQ(floatFromHalf(a.words[i]), half.texels[i]);
    ASSERT_EQ(b.type, TexelType::float32);
    EXPECT_EQ(b.floats, full.texels);
    EXPECT_FALSE(a.encoding.ranged || b.encoding.ranged);
}

TEST(TextureImage, IsDecodedWhereACpuSamples)
{
    Capabilities software = capabilities(true);
    software.softwareSampling = true;
    for (const Storage storage : {Storage::log8, Storage::linear8, Storage::half}) {
        const Table table = tableOf(storage);
        const TextureImage image = textureImage(table, software);
        ASSERT_EQ(image.type, TexelType::float32);
        EXPECT_EQ(image.floats, table.texels);
        EXPECT_FALSE(image.encoding.ranged);
        EXPECT_EQ(image.encoding.logarithmic, isLog(storage));
    }
    software.floatTextures = false;
    EXPECT_EQ(textureImage(tableOf(Storage::log8), software).type, TexelType::unorm16);
}

TEST(TextureImage, FallsBackToWordsWithoutFloatTextures)
{
    const Table table = tableOf(Storage::float32);
    const TextureImage image = textureImage(table, capabilities(false));
    ASSERT_EQ(image.type, TexelType::unorm16);
    EXPECT_TRUE(image.encoding.ranged);
    for (size_t i = 0; i < table.texels.size(); ++i)
        ASSERT_NEAR(decoded(image, i), table.texels[i], kWordStep);
}

// A constant is the lower end of its range, at word 0, so its only error is the rounding of that
// end: a few ulps (FLOAT_EQ allows four) and far less than a word of a wider range.
TEST(TextureImage, HoldsAConstantTable)
{
    Table table = tableOf(Storage::float32);
    std::fill(table.texels.begin(), table.texels.end(), 0.7f);
    const TextureImage image = textureImage(table, capabilities(false));
    for (size_t i = 0; i < table.texels.size(); ++i) ASSERT_FLOAT_EQ(decoded(image, i), 0.7f);
    const Table coded = quantized(table, Storage::log8);
    const TextureImage codes = textureImage(coded, capabilities(true));
    for (size_t i = 0; i < table.texels.size(); ++i) ASSERT_FLOAT_EQ(decoded(codes, i), 0.7f);
}

TEST(TextureImage, RepeatsOneChannelThreeTimes)
{
    Table table = tableOf(Storage::float32);
    table.channels = 1;
    table.texels.resize(table.texels.size() / 3);
    const TextureImage image = textureImage(table, capabilities(true));
    ASSERT_EQ(image.floats.size(), 3 * table.texels.size());
    for (size_t i = 0; i < image.floats.size(); ++i)
        ASSERT_EQ(image.floats[i], table.texels[i / 3]);
    const TextureImage codes = textureImage(quantized(table, Storage::log8), capabilities(true));
    for (size_t i = 0; i < codes.words.size(); i += 3) {
        ASSERT_EQ(codes.words[i], codes.words[i + 2]);
        ASSERT_NEAR(decoded(codes, i + 1), decoded(codes, i), kUlps);
    }
}

TEST(TextureImage, DecodesUniformKnots)
{
    const Table table = test::noiseMaterial(formPqpr(4, 1.0, 12), Storage::log8).tables[2];
    const auto knots = uniformKnots(table);
    ASSERT_EQ(knots.size(), 12u);
    for (size_t i = 0; i < knots.size(); ++i)
        for (int c = 0; c < 3; ++c) EXPECT_EQ(knots[i][c], table.texel(static_cast<int>(i), c));
}

TEST(TextureImage, FilterErrorIsThatOfTheSteepestTexelsAndOfRounding)
{
    const Table table = tableOf(Storage::half);
    const TextureImage halves = textureImage(table, capabilities(true)),
                       words = textureImage(tableOf(Storage::log8), capabilities(true));
    EXPECT_EQ(halves.contrast, contrast(table));
    EXPECT_DOUBLE_EQ(filterError(halves, {0.25, 0.0}), 0.25 * contrast(table));
    double largest = 0.0;
    for (const float texel : table.texels)
        largest = std::max(largest, static_cast<double>(std::abs(texel)));
    EXPECT_DOUBLE_EQ(filterError(halves, {0.0, 0.5}), 0.5 * largest);
    // UNORM texels are rounded as parts of their range.
    EXPECT_DOUBLE_EQ(
        filterError(words, {0.0, 0.5}),
        0.5 * static_cast<double>(std::max({words.extent.x, words.extent.y, words.extent.z})));
}

}  // namespace
}  // namespace fbrdf
