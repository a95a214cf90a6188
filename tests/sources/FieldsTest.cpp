// The rules by which every reader takes a line of a table apart.
#include <fbrdf/sources/Fields.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace fbrdf;

namespace {

/// The fields of a line, each followed by '|'.
std::string fieldsOf(std::string_view line, Separator separator)
{
    std::vector<std::string_view> fields;
    splitFields(line, separator, fields);
    std::string all;
    for (const std::string_view field : fields) all += std::string(field) + '|';
    return all;
}

}  // namespace

TEST(Fields, QuotesAreTakenOffAndHideSeparators)
{
    EXPECT_EQ(fieldsOf("\"a\", \"b, c\" ,d", Separator::comma), "a|b, c|d|");
    EXPECT_EQ(fieldsOf("\"a \"\"x\"\", b\",2", Separator::comma), "a \"\"x\"\", b|2|");
    EXPECT_EQ(fieldsOf("\"theta i\" \"30\"  4", Separator::blanks), "theta i|30|4|");
    EXPECT_EQ(fieldsOf("\"0,5\";1", Separator::semicolon), "0,5|1|");
    EXPECT_EQ(fieldsOf("\"open, 2", Separator::comma), "\"open|2|");
}

TEST(Fields, SeparatorsMakeOneFieldMoreThanThereAreOfThem)
{
    EXPECT_EQ(fieldsOf("a,,b,", Separator::comma), "a||b||");
    EXPECT_EQ(fieldsOf("", Separator::comma), "|");
    EXPECT_EQ(fieldsOf("1\t\t2", Separator::tab), "1||2|");
    EXPECT_EQ(fieldsOf("  1 \t 2 ", Separator::blanks), "1|2|");
    EXPECT_EQ(fieldsOf("   ", Separator::blanks), "");
}

TEST(Fields, ThePunctuationOfNamesDecides)
{
    EXPECT_EQ(separatorOfNames("a;b,c;d"), Separator::semicolon);
    EXPECT_EQ(separatorOfNames("a,\tb"), Separator::comma);
    EXPECT_EQ(separatorOfNames("\"a,b\"\tc"), Separator::tab);
    EXPECT_EQ(separatorOfNames("a b  c"), Separator::blanks);
}

TEST(Fields, ACommaSeparatesNumbersUnlessItCanOnlyBeADecimalSign)
{
    EXPECT_EQ(separatorOfNumbers("0.1, 0.2"), Separator::comma);
    EXPECT_EQ(separatorOfNumbers("0.1,0.2,0.3"), Separator::comma);
    EXPECT_EQ(separatorOfNumbers("1,2"), Separator::comma);
    EXPECT_EQ(separatorOfNumbers("0,1 2 0,3"), Separator::blanks);
    EXPECT_EQ(separatorOfNumbers("0,1;0,2"), Separator::semicolon);
    EXPECT_EQ(separatorOfNumbers("1\t2 3"), Separator::blanks);
    EXPECT_STREQ(nameOf(separatorOfNumbers("0,1;0,2")), "semicolons");
}

TEST(Fields, MissingValuesAreNotNumbers)
{
    for (const char* text : {"", "NA", "n/a", "#N/A", "NULL", "-", "nan", "-nan(ind)", "1.#QNAN"}) {
        double value = 0.0;
        EXPECT_TRUE(parseField(text, value)) << text;
        EXPECT_TRUE(std::isnan(value)) << text;
    }
    double value = 0.0;
    EXPECT_TRUE(parseField("0,5", value) && value == 0.5);
    for (const char* text : {"zero", "nap", "0x10", "1 2"}) EXPECT_FALSE(parseField(text, value));
}
