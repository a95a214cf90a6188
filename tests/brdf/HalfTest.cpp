// HalfTest.cpp - binary16 against its definition: all 65536 numbers, and rounding by arithmetic in
// double, which shares no code with the bit operations of the library.
#include <fbrdf/brdf/Half.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace fbrdf;

namespace {

/// IEEE 754-2008, section 3.4: sign, 5 bits of exponent, 10 of fraction.
double valueOf(uint32_t bits)
{
    const double sign = bits & 0x8000u ? -1.0 : 1.0;
    const int exponent = static_cast<int>(bits >> 10 & 0x1fu);
    const double fraction = bits & 0x3ffu;
    if (exponent == 31) return fraction > 0.0 ? std::nan("") : sign * double(INFINITY);
    if (exponent == 0) return sign * std::ldexp(fraction, -24);
    return sign * std::ldexp(1024.0 + fraction, exponent - 25);
}

/// The nearest half of a double, ties to even: nearbyint in units of the last place.
double nearestHalf(double value)
{
    if (value == 0.0 || !std::isfinite(value)) return value;
    const double unit = std::ldexp(1.0, std::max(std::ilogb(value), -14) - 10);
    const double rounded = std::nearbyint(value / unit) * unit;
    return std::abs(rounded) > 65504.0 ? std::copysign(INFINITY, value) : rounded;
}

TEST(Half, EveryCodeHasItsValue)
{
    for (uint32_t bits = 0; bits < 65536; ++bits) {
        const double expected = valueOf(bits), found = double(floatFromHalf(uint16_t(bits)));
        if (std::isnan(expected))
            ASSERT_TRUE(std::isnan(found)) << bits;
        else
            ASSERT_EQ(found, expected) << bits;
        ASSERT_EQ(std::signbit(found), bits >= 0x8000u) << bits;
    }
}

TEST(Half, EveryCodeComesBack)
{
    for (uint32_t bits = 0; bits < 65536; ++bits) {
        const float value = floatFromHalf(uint16_t(bits));
        if (std::isnan(value))
            ASSERT_TRUE(std::isnan(floatFromHalf(halfFromFloat(value)))) << bits;
        else
            ASSERT_EQ(halfFromFloat(value), bits);
    }
}

TEST(Half, TiesGoToEvenAndTheRestToTheNearest)
{
    for (uint32_t bits = 0; bits < 0x7bffu; ++bits) {  // all neighbouring pairs of finite numbers
        const float low = floatFromHalf(uint16_t(bits)), high = floatFromHalf(uint16_t(bits + 1));
        const float middle = 0.5f * (low + high);  // exact: 12 bits suffice
        const uint32_t even = bits % 2 ? bits + 1 : bits;
        ASSERT_EQ(halfFromFloat(middle), even) << bits;
        ASSERT_EQ(halfFromFloat(std::nextafter(middle, low)), bits);
        ASSERT_EQ(halfFromFloat(std::nextafter(middle, high)), bits + 1);
        ASSERT_EQ(halfFromFloat(-middle), even | 0x8000u);
    }
}

TEST(Half, AgreesWithArithmeticOverAllExponents)
{
    std::mt19937 random(1);
    for (int n = 0; n < 200000; ++n) {
        const float value = std::ldexp(1.0f + static_cast<float>(random() % 8388608u) / 8388608.0f,
                                       static_cast<int>(random() % 60) - 32);
        ASSERT_EQ(double(floatFromHalf(halfFromFloat(value))), nearestHalf(double(value))) << value;
    }
}

TEST(Half, OverflowsToInfinityFromHalfwayToTheNextPower)
{
    EXPECT_EQ(halfFromFloat(65504.0f), 0x7bff);
    EXPECT_EQ(halfFromFloat(std::nextafter(65520.0f, 0.0f)), 0x7bff);
    EXPECT_EQ(halfFromFloat(65520.0f), 0x7c00);
    EXPECT_EQ(halfFromFloat(-65520.0f), 0xfc00);
    EXPECT_EQ(halfFromFloat(std::numeric_limits<float>::max()), 0x7c00);
    EXPECT_EQ(halfFromFloat(INFINITY), 0x7c00);
}

TEST(Half, UnderflowsToZeroOfTheSameSign)
{
    EXPECT_EQ(halfFromFloat(std::ldexp(1.0f, -25)), 0x0000);  // a tie, and 0 is even
    EXPECT_EQ(halfFromFloat(std::nextafter(std::ldexp(1.0f, -25), 1.0f)), 0x0001);
    EXPECT_EQ(halfFromFloat(std::numeric_limits<float>::denorm_min()), 0x0000);
    EXPECT_EQ(halfFromFloat(-0.0f), 0x8000);
}

}  // namespace
