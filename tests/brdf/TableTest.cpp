// TableTest.cpp - storages: bounds of their errors, codes and their inverses, filtering.
#include "brdf/Directions.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/brdf/Table.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace fbrdf;

namespace {

constexpr Storage kStorages[] = {Storage::log8, Storage::half, Storage::float32, Storage::linear8};

Table tableOf(int width, int height, int channels, const std::function<float(int, int, int)>& f)
{
    Table table;
    table.domain = GridDomain{{Axis{width, {}}, Axis{height, {}}}};
    table.channels = channels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) table.texels.push_back(f(x, y, c));
    return table;
}

/// Texels without any smoothness: neighbours differ by as much as the range.
Table noise(int channels, float low = -12.0f, float high = 3.0f)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> value(low, high);
    return tableOf(11, 9, channels, [&](int, int, int) { return value(random); });
}

Table smooth()
{
    return tableOf(32, 32, 3, [](int x, int y, int c) {
        const double r = std::hypot(x - 15.5, y - 15.5) / 15.5;
        return static_cast<float>(-10.0 * r * r + c);
    });
}

float largestError(const Table& a, const Table& b)
{
    float most = 0.0f;
    for (size_t i = 0; i < a.texels.size(); ++i)
        most = std::max(most, std::abs(a.texels[i] - b.texels[i]));
    return most;
}

TEST(Storage, NamesAreInverse)
{
    for (const Storage storage : kStorages)
        EXPECT_EQ(storageFromName(storageName(storage)), storage);
    try {
        storageFromName("log16");
        FAIL() << "an unknown storage was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_STREQ(error.what(), "storage: found 'log16', expected log8, half, float or linear8");
    }
}

TEST(Storage, BytesAreTexelsTimesChannelsTimesWidth)
{
    const size_t expected[] = {297, 594, 1188, 297};
    for (size_t k = 0; k < 4; ++k)
        EXPECT_EQ(quantized(noise(3), kStorages[k]).bytes(), expected[k]);
}

TEST(Quantized, FloatChangesNothing)
{
    EXPECT_EQ(quantized(noise(3), Storage::float32).texels, noise(3).texels);
}

TEST(Quantized, HalfRoundsEachTexel)
{
    const Table table = noise(1), half = quantized(table, Storage::half);
    for (size_t i = 0; i < table.texels.size(); ++i)
        EXPECT_EQ(half.texels[i], floatFromHalf(halfFromFloat(table.texels[i])));
}

// A code is the difference to the rounded texel before, in strides of the 16-bit range.
TEST(Quantized, Log8IsOffByHalfAStride)
{
    for (const int channels : {1, 3}) {
        const Table table = noise(channels), log8 = quantized(table, Storage::log8);
        for (int i = 0; i < texelCount(table.domain); ++i)
            for (int c = 0; c < channels; ++c) {
                const float stride = static_cast<float>(log8.log8.stride[static_cast<size_t>(c)]),
                            step = (log8.upper[c] - log8.lower[c]) / 65535.0f;
                const float bound = 0.5f * stride + 1.0f;  // 1: rounding to 16 bits
                ASSERT_LE(std::abs(log8.texel(i, c) - table.texel(i, c)), bound * step);
            }
    }
}

// The reason for coding differences: plain 8 bits over a range of 10 are off by 0.02.
TEST(Quantized, Log8OfASymmetricTableIsSymmetric)
{
    constexpr int kSide = 17;
    Table table = tableOf(kSide, kSide, 3, [](int x, int y, int c) {
        return std::sin(0.37f * float(x * y + c)) * 4.0f + 0.25f * float(x + y);
    });
    std::get<GridDomain>(table.domain).symmetric = true;
    const Table log8 = quantized(table, Storage::log8);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(log8.texel(y * kSide + x, c), log8.texel(x * kSide + y, c));
                const int code = codeOf(log8, y * kSide + x, c);
                ASSERT_TRUE(code >= 0 && code <= 255) << code;
            }
}

TEST(Quantized, Log8OfASmoothMapIsFinerThanPlainCodes)
{
    const Table table = smooth();
    const float range =
        quantized(table, Storage::log8).upper[0] - quantized(table, Storage::log8).lower[0];
    EXPECT_LT(largestError(table, quantized(table, Storage::log8)), 0.25f * 0.5f * range / 255.0f);
}

TEST(Quantized, Linear8IsOffByHalfACode)
{
    const Table table = noise(3, -0.2f, 1.2f);
    Table linear = table;
    linear.storage = Storage::float32;
    for (float& texel : linear.texels) texel = std::log2(std::max(texel, 1e-3f));
    linear = quantized(linear, Storage::linear8);
    for (size_t i = 0; i < table.texels.size(); ++i) {
        const float wanted = std::clamp(table.texels[i], 1e-3f, 1.0f);
        EXPECT_LE(std::abs(linear.texels[i] - wanted), 0.5f / 255.0f + 1e-6f);
    }
}

TEST(Quantized, IsIdempotent)
{
    for (const Storage storage : kStorages) {
        const Table once = quantized(noise(3), storage), twice = quantized(once, storage);
        EXPECT_EQ(once.texels, twice.texels) << storageName(storage);
        EXPECT_EQ(once.lower, twice.lower);
        EXPECT_EQ(once.upper, twice.upper);
        EXPECT_EQ(once.log8.stride, twice.log8.stride);
    }
}

TEST(Quantized, ConvertsBetweenLogAndLinear)
{
    const Table log = noise(3, -7.0f, 0.0f), linear = quantized(log, Storage::linear8),
                back = quantized(linear, Storage::float32);
    for (size_t i = 0; i < log.texels.size(); ++i) {
        EXPECT_NEAR(linear.texels[i], std::exp2(log.texels[i]), 0.5f / 255.0f + 1e-6f);
        if (linear.texels[i] > 0.0f)
            EXPECT_NEAR(std::exp2(back.texels[i]), linear.texels[i], 1e-6f);
        else
            EXPECT_TRUE(std::isfinite(back.texels[i])) << "log2 of 0 must stay a number";
    }
}

TEST(Codes, AreBytesAndComeBack)
{
    for (const Storage storage : {Storage::log8, Storage::linear8})
        for (const int channels : {1, 3}) {
            const Table table = quantized(noise(channels, -9.0f, 0.0f), storage);
            for (int i = 0; i < texelCount(table.domain); ++i)
                for (int c = 0; c < channels; ++c) {
                    const int code = codeOf(table, i, c);
                    ASSERT_GE(code, 0);
                    ASSERT_LE(code, 255);
                    ASSERT_EQ(texelFromCode(table, i, c, code), table.texel(i, c));
                    ASSERT_NE(texelFromCode(table, i, c, code + 1), table.texel(i, c));
                }
        }
}

TEST(Codes, Unorm16HoldsTheEightBitStoragesExactly)
{
    const Table log8 = quantized(noise(3), Storage::log8),
                linear8 = quantized(noise(3, -9.0f, 0.0f), Storage::linear8);
    for (const Table* table : {&log8, &linear8})
        for (int i = 0; i < texelCount(table->domain); ++i)
            for (int c = 0; c < 3; ++c) {
                const int value = unorm16Of(*table, i, c);
                ASSERT_EQ(texelFromUnorm16(*table, c, value), table->texel(i, c));
            }
    for (int i = 0; i < texelCount(linear8.domain); ++i)
        ASSERT_EQ(unorm16Of(linear8, i, 0), 257 * codeOf(linear8, i, 0));
}

// Steps finer than floats would give several codes one value, and codes would be ambiguous.
TEST(Codes, ComeBackFromNearlyConstantTables)
{
    for (const float level : {0.0f, -2.65f, 100.0f})
        for (const float spread : {0.0f, 1e-7f, 1e-5f, 1e-3f}) {
            const Table table = tableOf(16, 16, 1, [&](int x, int y, int) {
                return level + spread * std::sin(0.3f * static_cast<float>(x + 16 * y));
            });
            const Table log8 = quantized(table, Storage::log8);
            ASSERT_GT(log8.upper[0], log8.lower[0]);
            for (int i = 0; i < 256; ++i)
                ASSERT_EQ(texelFromCode(log8, i, 0, codeOf(log8, i, 0)), log8.texel(i, 0))
                    << level << " " << spread;
            EXPECT_LE(largestError(table, log8), 0.02f * spread + 1e-6f * std::abs(level));
        }
}

TEST(Sample, IsTheTexelAtItsCentreAndLinearBetween)
{
    const Table table = tableOf(
        5, 4, 3, [](int x, int y, int c) { return static_cast<float>((c + 1) * x - 2 * y + c); });
    for (int n = 0; n < 200; ++n) {
        const auto p = test::point(n);
        const Vec3d at(4.0 * p[0], 3.0 * p[1], 0.0);
        const Vec3d value = sample(table, at);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(value[c], (c + 1) * at.x - 2.0 * at.y + c, 1e-13);
    }
    EXPECT_EQ(sample(table, Vec3f(2.0f, 3.0f, 0.0f)).y, table.texel(2 + 5 * 3, 1));
}

TEST(Sample, OneChannelIsSharedByAllColours)
{
    const Vec3d value = sample(noise(1), Vec3d(2.3, 4.5, 0.0));
    EXPECT_EQ(value.x, value.y);
    EXPECT_EQ(value.x, value.z);
}

TEST(Contrast, IsTheSumOverAxesOfTheLargestDifferences)
{
    Table table;
    table.domain = GridDomain{{Axis{3, {}}, Axis{2, {}}, Axis{2, {}}}};
    table.channels = 1;
    //             x: 0 to 1 to 5        y: +10        z: +100
    table.texels = {0, 1, 5, 10, 11, 15, 100, 101, 105, 110, 111, 115};
    EXPECT_EQ(contrast(table), 4.0 + 10.0 + 100.0);
    table.texels = std::vector<float>(12, 3.0f);
    EXPECT_EQ(contrast(table), 0.0);
}

TEST(Contrast, IsThatOfTheWorstChannel)
{
    Table table;
    table.domain = GridDomain{{Axis{2, {}}, Axis{1, {}}}};
    table.texels = {0, 0, 0, 1, -7, 2};
    EXPECT_EQ(contrast(table), 7.0);
}

}  // namespace
