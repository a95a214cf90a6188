// The lexing that every text reader stands on.
#include <fbrdf/base/Text.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace fbrdf;

namespace {

double number(std::string_view text)
{
    double value = -12345.0;
    EXPECT_TRUE(parseNumber(text, value)) << text;
    return value;
}

bool isNumber(std::string_view text)
{
    double ignored = 0.0;
    return parseNumber(text, ignored);
}

}  // namespace

TEST(Text, ParsesNumbersWhateverTheLocale)
{
    EXPECT_EQ(number("1.5"), 1.5);
    EXPECT_EQ(number("+1.5"), 1.5);
    EXPECT_EQ(number("-2.50E-01"), -0.25);
    EXPECT_EQ(number(".5"), 0.5);
    EXPECT_EQ(number("7."), 7.0);
    EXPECT_TRUE(std::isnan(number("nan")));
    EXPECT_EQ(number("inf"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("1e999"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("-1e999"), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("1e-999"), 0.0);
    // 17 digits and more come back exactly.
    EXPECT_EQ(number("0.26179938779914940782944654529274"), 0.26179938779914940782944654529274);
}

TEST(Text, RefusesWhatIsOnlyPartlyANumber)
{
    for (const char* text : {"", "+", "-", "e5", "1.5x", "1,5", "0x10", "1 2", "--1", "1e", " 1"})
        EXPECT_FALSE(isNumber(text)) << text;
}

TEST(Text, NumbersOutOfRangeKeepTheirSideInAnyNotation)
{
    const std::string zeros(400, '0');
    EXPECT_EQ(number("0." + zeros + "1"), 0.0);
    EXPECT_EQ(number("1" + zeros), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("0.5e99999999999999999999"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("2.5e-99999999999999999999"), 0.0);
    EXPECT_EQ(number("0e999"), 0.0);
}

TEST(Text, ACommaIsADecimalSignWhereItCanBeNothingElse)
{
    double value = 0.0;
    EXPECT_TRUE(parseLocalNumber("-0,25", value) && value == -0.25);
    EXPECT_TRUE(parseLocalNumber("1,5e-3", value) && value == 1.5e-3);
    EXPECT_TRUE(parseLocalNumber("2.5", value) && value == 2.5);
    for (const char* text : {"1,2,3", "1.234,5", "1,234.5", ",", "1,", "a,b", ""})
        EXPECT_FALSE(parseLocalNumber(text, value)) << text;
}

TEST(Text, CaseIsThatOfAsciiInEveryLocale)
{
    EXPECT_EQ(lowerCase("THETA_I \xC4"), "theta_i \xC4");
    EXPECT_TRUE(sameWord("Visible", "VISIBLE"));
    EXPECT_FALSE(sameWord("Visible", "Visibl"));
}

TEST(Text, ParsesWholeNumbers)
{
    long long value = 0;
    EXPECT_TRUE(parseInteger("+42", value) && value == 42);
    EXPECT_TRUE(parseInteger("-7", value) && value == -7);
    for (const char* text : {"", "1.0", "1e3", "99999999999999999999", "7 "})
        EXPECT_FALSE(parseInteger(text, value)) << text;
}

TEST(LineReader, CountsLinesAndTakesTheirEndsOff)
{
    LineReader lines(
        "\xEF\xBB\xBF"
        "a\r\n\n# c\n  b\nlast");
    std::string_view line;
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "a");
    ASSERT_TRUE(lines.nextData(line));
    EXPECT_EQ(line, "  b");
    EXPECT_EQ(lines.number(), 4u);
    ASSERT_TRUE(lines.nextData(line));
    EXPECT_EQ(line, "last");
    EXPECT_FALSE(lines.next(line));
    EXPECT_FALSE(LineReader("").next(line));
    EXPECT_FALSE(LineReader("\n \n#x").nextData(line));
}

TEST(LineReader, EndsLinesAsEverySystemDoes)
{
    LineReader lines("a\rb\r\nc\n\rd\r\n\r\ne");
    std::string_view line;
    std::string all;
    while (lines.next(line)) all += std::string(line) + '|';
    EXPECT_EQ(all, "a|b|c||d||e|");
    EXPECT_EQ(lines.number(), 7u);
}

TEST(LineReader, ALineBreakInQuotesBelongsToTheRecord)
{
    LineReader lines("\"a\nb\",c\n# no\n1,2\n5\" pipe\n3,4\n");
    std::string_view record;
    ASSERT_TRUE(lines.nextRecord(record));
    EXPECT_EQ(record, "\"a\nb\",c");
    EXPECT_EQ(lines.number(), 2u);
    ASSERT_TRUE(lines.nextRecord(record));
    EXPECT_EQ(record, "1,2");
    ASSERT_TRUE(lines.nextRecord(record));  // a quote that nothing closes is a character
    EXPECT_EQ(record, "5\" pipe");
    ASSERT_TRUE(lines.nextRecord(record));
    EXPECT_EQ(record, "3,4");
    EXPECT_FALSE(lines.nextRecord(record));
}

TEST(WordReader, SkipsAByteOrderMarkAndCountsReturns)
{
    WordReader words("\xEF\xBB\xBFone\rtwo\r\nthree # four\rfive #");
    std::string_view word;
    const std::pair<const char*, size_t> expected[] = {
        {"one", 1}, {"two", 2}, {"three", 3}, {"five", 4}};
    for (const auto& [text, line] : expected) {
        ASSERT_TRUE(words.next(word));
        EXPECT_EQ(word, text);
        EXPECT_EQ(words.line(), line);
    }
    EXPECT_FALSE(words.next(word));
}

TEST(WordReader, WalksWordsAcrossLinesWithoutComments)
{
    WordReader words(" one # two\n\tthree#four\n\n five");
    std::string_view word;
    const std::pair<const char*, size_t> expected[] = {{"one", 1}, {"three", 2}, {"five", 4}};
    for (const auto& [text, line] : expected) {
        ASSERT_TRUE(words.next(word));
        EXPECT_EQ(word, text);
        EXPECT_EQ(words.line(), line);
    }
    EXPECT_FALSE(words.next(word));
    EXPECT_EQ(words.line(), 4u);  // still that of the last word
    EXPECT_FALSE(WordReader("# only a comment").next(word));
}

TEST(Text, SplitsFieldsAndWords)
{
    std::vector<std::string_view> parts;
    splitFields(" a, b ,,c", ',', parts);
    EXPECT_EQ(parts, (std::vector<std::string_view>{"a", "b", "", "c"}));
    splitFields("", ',', parts);
    EXPECT_EQ(parts, std::vector<std::string_view>{""});
    splitWords("  a\tb  c ", parts);
    EXPECT_EQ(parts, (std::vector<std::string_view>{"a", "b", "c"}));
    splitWords(" \t", parts);
    EXPECT_TRUE(parts.empty());
}

TEST(Text, QuotesForMessages)
{
    EXPECT_EQ(inQuotes("abc"), "'abc'");
    EXPECT_EQ(inQuotes("a\nb\x01"), "'a?b?'");
    EXPECT_EQ(inQuotes(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(Text, TellsTextFromBinary)
{
    EXPECT_TRUE(looksLikeText("1 2\t3\r\n\xC3\xA9"));  // UTF-8 is text
    EXPECT_FALSE(looksLikeText(std::string_view("a\0b", 3)));
    EXPECT_FALSE(looksLikeText("\x01"));
}
