#include <fbrdf/base/Percent.h>

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

TEST(Percent, EncodesWhatEndsWordsAndNames)
{
    EXPECT_EQ(percentEncoded("Car Paint:red,\"50%\""), "Car%20Paint%3Ared%2C%2250%25%22");
    EXPECT_EQ(percentEncoded("rims_2.front-left~"), "rims_2.front-left~");
    EXPECT_EQ(percentEncoded(""), "");
}

TEST(Percent, DecodesWhatItEncodes)
{
    std::string all;
    for (int c = 0; c < 256; ++c) all += static_cast<char>(static_cast<unsigned char>(c));
    EXPECT_EQ(percentDecoded(percentEncoded(all)), all);
    EXPECT_EQ(percentDecoded("%c3%9C"), "\xC3\x9C");
}

TEST(Percent, LeavesASignWithoutDigitsAsItIs)
{
    for (const char* text : {"%", "100%", "%2", "%zz", "%2x", "%-1", "%+1", "a%", "% 1"})
        EXPECT_EQ(percentDecoded(text), text);
}

}  // namespace
}  // namespace fbrdf
