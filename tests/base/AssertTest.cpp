#include <fbrdf/base/Assert.h>

#include <gtest/gtest.h>

namespace {

TEST(Assert, PassesWhatIsTrue)
{
    FBRDF_ASSERT(1, <, 2);
    FBRDF_ASSERT(2, ==, 2);
}

#if defined(FBRDF_ASSERTIONS)
TEST(AssertDeathTest, ShowsBothValues)
{
    const int found = 3, limit = 2;
    EXPECT_DEATH(FBRDF_ASSERT(found, <=, limit), "found <= limit failed: found 3 <= 2");
}

TEST(AssertDeathTest, EvaluatesEachArgumentOnce)
{
    int calls = 0;
    FBRDF_ASSERT(++calls, ==, 1);
    EXPECT_EQ(calls, 1);
}
#else
TEST(Assert, EvaluatesNothingInRelease)
{
    int calls = 0;
    FBRDF_ASSERT(++calls, ==, 7);
    EXPECT_EQ(calls, 0);
}
#endif

}  // namespace
