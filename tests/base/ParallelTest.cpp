// ParallelTest.cpp - every task runs once, and failures do not depend on the number of threads.
#include <fbrdf/base/Parallel.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace fbrdf {
namespace {

TEST(ThreadCount, IsWhatWasAskedForOrOneACore)
{
    EXPECT_EQ(threadCount(3), 3);
    EXPECT_GE(threadCount(0), 1);
    EXPECT_EQ(threadCount(-2), threadCount(0));
}

TEST(ParallelTasks, EveryTaskRunsOnce)
{
    for (const int threads : {0, 1, 4, 2000}) {
        std::vector<std::atomic<int>> calls(1000);
        parallelTasks(calls.size(), threads, [&](size_t i) { ++calls[i]; });
        for (const auto& count : calls) EXPECT_EQ(count, 1);
    }
    parallelTasks(0, 4, [](size_t) { FAIL(); });
}

TEST(ParallelTasks, RunOnSeveralThreads)
{
    std::mutex mutex;
    std::set<std::thread::id> threads;
    std::atomic<int> running{0};
    parallelTasks(4, 4, [&](size_t) {
        ++running;
        while (running < 4) std::this_thread::yield();  // ends only where four run at once
        const std::lock_guard<std::mutex> lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(threads.size(), 4u);
    EXPECT_EQ(threads.count(std::this_thread::get_id()), 1u);
}

std::string failureOf(size_t tasks, int threads, const std::function<void(size_t)>& work)
{
    try {
        parallelTasks(tasks, threads, work);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(ParallelTasks, TheFirstFailureIsThrown)
{
    for (const int threads : {1, 2, 8}) {
        const auto failing = [](size_t i) {
            if (i == 20) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            if (i >= 20) throw std::runtime_error(std::to_string(i));
        };
        EXPECT_EQ(failureOf(100, threads, failing), "20");
    }
}

TEST(ParallelTasks, NothingBeginsAfterAFailure)
{
    int calls = 0;
    EXPECT_EQ(failureOf(100, 1,
                        [&](size_t i) {
                            ++calls;
                            if (i == 5) throw std::runtime_error("five");
                        }),
              "five");
    EXPECT_EQ(calls, 6);
}

TEST(ParallelFor, EveryIndexIsSeenOnce)
{
    for (const size_t count : {0u, 1u, 1023u, 1024u, 5000u}) {
        std::vector<std::atomic<int>> calls(count);
        parallelFor(count, 3, [&](size_t i) { ++calls[i]; });
        for (const auto& times : calls) EXPECT_EQ(times, 1);
    }
}

}  // namespace
}  // namespace fbrdf
