// Numbers as text are those of the locale "C", whatever the host has set.
#include "support/CommaLocale.h"

#include <fbrdf/base/ClassicLocale.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace fbrdf;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kValues[] = {
    0.0,         -0.0,      0.25,  1.0 / 3.0, 1e-7,
    123456789.0, -2.088575, 1e300, 5e-324,    std::numeric_limits<double>::max(),
    kInfinity,   -kInfinity};

std::string printed(const char* format, int precision, double value)
{
    char text[512];
    std::snprintf(text, sizeof text, format, precision, value);
    return text;
}

}  // namespace

TEST(Number, IsWhatPrintfWritesInTheLocaleC)
{
    const ClassicLocale classic;
    for (const double value : kValues)
        for (const int precision : {1, 6, 9, 17}) {
            EXPECT_EQ(numberText(value, precision), printed("%.*g", precision, value));
            EXPECT_EQ(fixedText(value, precision), printed("%.*f", precision, value));
        }
    EXPECT_EQ(numberText(0.25), "0.25");
    EXPECT_EQ(fixedText(0.25), "0.250000");
    EXPECT_NE(numberText(std::numeric_limits<double>::quiet_NaN()).find("nan"), std::string::npos);
}

TEST(Number, StaysTheSameWhereTheDecimalSignIsAComma)
{
    std::string before, after;
    for (const double value : kValues) before += numberText(value, 9) + fixedText(value) + ' ';
    {
        const test::CommaLocale comma;
        EXPECT_EQ(printed("%.*f", 1, 0.5), test::CommaLocale::setsC() ? "0,5" : "0.5");
        for (const double value : kValues) after += numberText(value, 9) + fixedText(value) + ' ';
        double number = 0.0;
        EXPECT_TRUE(parseNumber("-2.088575e3", number) && number == -2088.575);
        EXPECT_TRUE(parseNumber("1.5e999", number) && std::isinf(number));
    }
    EXPECT_EQ(before, after);
}

TEST(ClassicLocale, IsThatOfTheThreadWhileItLives)
{
    const test::CommaLocale comma;
    const std::string there = printed("%.*f", 1, 0.5);
    {
        const ClassicLocale classic;
        EXPECT_EQ(printed("%.*f", 1, 0.5), "0.5");
        EXPECT_EQ(std::strtod("0.5", nullptr), 0.5);
    }
    EXPECT_EQ(printed("%.*f", 1, 0.5), there);
}
