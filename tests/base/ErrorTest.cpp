#include "support/CommaLocale.h"

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <cerrno>

using namespace fbrdf;

TEST(SystemErrorText, IsEnglishWhateverTheHostHasSet)
{
    EXPECT_EQ(systemErrorText(ENOENT), "No such file or directory");
    const test::CommaLocale host;
    EXPECT_EQ(systemErrorText(ENOENT), "No such file or directory");
}

TEST(SystemErrorText, NumbersOfNoErrorHaveSomeText)
{
    EXPECT_FALSE(systemErrorText(123456).empty());
}
