#include <fbrdf/base/Found.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

TEST(Found, ReadsAsASentence)
{
    EXPECT_EQ(Found("2 columns").expected("3 or 6"), "found 2 columns, expected 3 or 6");
}

}  // namespace
}  // namespace fbrdf
