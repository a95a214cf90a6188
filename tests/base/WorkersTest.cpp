// WorkersTest.cpp - threads that wait between loops run every task once, loop after loop.
#include <fbrdf/base/Workers.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace fbrdf {
namespace {

TEST(Workers, RunEveryTaskOnceInEveryLoop)
{
    for (const int threads : {1, 2, 5}) {
        Workers workers(threads);
        for (size_t loop = 0; loop < 300; ++loop) {
            std::vector<std::atomic<int>> calls(loop % 7 * 3);
            workers.run(calls.size(), [&](size_t i) { ++calls[i]; });
            for (const auto& count : calls) ASSERT_EQ(count, 1) << threads;
        }
    }
}

TEST(Workers, RunOnSeveralThreads)
{
    Workers workers(3);
    for (int loop = 0; loop < 3; ++loop) {
        std::atomic<int> running{0};
        // Each waits until three have begun, which ends only where three run at once.
        workers.run(3, [&](size_t) {
            ++running;
            while (running < 3) std::this_thread::yield();
        });
        EXPECT_EQ(running, 3);
    }
}

TEST(Workers, ThrowTheFirstFailureAndGoOn)
{
    Workers workers(4);
    for (int loop = 0; loop < 20; ++loop) {
        try {
            workers.run(100, [](size_t i) {
                if (i >= 20) throw std::runtime_error(std::to_string(i));
            });
            FAIL();
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "20");
        }
        std::atomic<int> calls{0};
        workers.run(10, [&](size_t) { ++calls; });
        EXPECT_EQ(calls, 10);
    }
}

TEST(Workers, ThatNeverRanEnd)
{
    Workers workers(0);
    workers.run(0, [](size_t) { FAIL(); });
}

}  // namespace
}  // namespace fbrdf
