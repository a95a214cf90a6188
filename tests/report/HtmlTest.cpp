#include "Html.h"

#include <gtest/gtest.h>

#include <limits>

namespace fbrdf {
namespace {

const std::string kReplacement = "\xEF\xBF\xBD";

TEST(Escaped, MarkupIsText)
{
    EXPECT_EQ(escaped("<script>alert('a & \"b\"')</script>"),
              "&lt;script&gt;alert(&#39;a &amp; &quot;b&quot;&#39;)&lt;/script&gt;");
}

TEST(Escaped, KeepsEveryLengthOfUtf8)
{
    const std::string text =
        "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x94\xA7";  // a, e acute, euro sign, spanner
    EXPECT_EQ(escaped(text), text);
}

TEST(Escaped, ReplacesWhatIsNoUtf8)
{
    EXPECT_EQ(escaped("a\xFF"
                      "b"),
              "a" + kReplacement + "b");
    EXPECT_EQ(escaped("\xC0\xAF"), kReplacement + kReplacement);        // overlong
    EXPECT_EQ(escaped("\xE2\x82"), kReplacement + kReplacement);        // cut off
    EXPECT_EQ(escaped("\xED\xA0\x80").substr(0, 3), kReplacement);      // surrogate
    EXPECT_EQ(escaped("\xF4\x90\x80\x80").substr(0, 3), kReplacement);  // beyond U+10FFFF
}

TEST(Escaped, ReplacesWhatXmlForbids)
{
    EXPECT_EQ(escaped(std::string("a\0b", 3)), "a" + kReplacement + "b");
    EXPECT_EQ(escaped("\x1b[31m"), kReplacement + "[31m");
    EXPECT_EQ(escaped("\xEF\xBF\xBF"), kReplacement);
    EXPECT_EQ(escaped("a\tb\n"), "a\tb\n");
}

TEST(Number, HasThreeDigits)
{
    EXPECT_EQ(number(57.345), "57.3");
    EXPECT_EQ(number(0.012345), "0.0123");
    EXPECT_EQ(number(-2.5), "-2.50");
    EXPECT_EQ(number(0.0), "0");
    EXPECT_EQ(number(12345.6), "12,346");
    EXPECT_EQ(number(-12345.6), "-12,346");
    EXPECT_EQ(number(1.234e-5), "1.2e-05");
}

TEST(Number, HasSignsForNotANumberAndInfinity)
{
    EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "\xE2\x80\x93");
    EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "\xE2\x88\x9E");
    EXPECT_EQ(shortNumber(0.5), "0.5");
    EXPECT_EQ(shortNumber(std::numeric_limits<double>::quiet_NaN()), "\xE2\x80\x93");
}

TEST(Grouped, ByThree)
{
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(1458000), "1,458,000");
}

TEST(Base64, MatchesTheVectorsOfRfc4648)
{
    const auto of = [](const std::string& text) { return base64({text.begin(), text.end()}); };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64({0xFB, 0xFF, 0xFE}), "+//+");
}

}  // namespace
}  // namespace fbrdf
