// GiveWayTest.cpp - the priority of threads that fit; Linux alone has one that anybody may lower.
#include <fbrdf/fitting/GiveWay.h>
#include <gtest/gtest.h>

#ifdef __linux__
#include <sys/resource.h>

#include <algorithm>
#include <thread>

namespace fbrdf::fitting {
namespace {

int niceness()
{
    return getpriority(PRIO_PROCESS, 0);
}

TEST(GiveWay, ConcernsTheThreadAndThoseThatItStarts)
{
    const int before = niceness();
    int unchanged = -1, lowered = -1, ofItsThread = -1;
    std::thread([&] {
        unchanged = niceness();
        giveWay();
        lowered = niceness();
        std::thread([&] { ofItsThread = niceness(); }).join();
    }).join();
    EXPECT_EQ(unchanged, before);
    EXPECT_EQ(lowered, std::min(19, before + 5));
    EXPECT_EQ(ofItsThread, lowered);
    EXPECT_EQ(niceness(), before) << "who draws goes on as before";
}

}  // namespace
}  // namespace fbrdf::fitting
#endif
