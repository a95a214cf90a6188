#include "solve/HugePages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace fbrdf {
namespace {

// Sizes below, at and above those for which huge pages are worth it.
TEST(HugePages, ArraysOfEverySizeKeepTheirNumbers)
{
    for (const size_t count : {size_t{1}, size_t{1000}, (size_t{4} << 20) / sizeof(double) - 1,
                               (size_t{4} << 20) / sizeof(double), size_t{3} << 20}) {
        SystemNumbers numbers(count, 0.0);
        EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 0.0), std::ptrdiff_t(count));
        std::iota(numbers.begin(), numbers.end(), 1.0);
        SystemNumbers copy = numbers;
        copy.resize(count + 7);
        EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), copy.begin())) << count;
    }
}

TEST(HugePages, MoreThanThereIsIsAnError)
{
    EXPECT_THROW(allocatePages(size_t{1} << 60), std::bad_alloc);
}

}  // namespace
}  // namespace fbrdf
