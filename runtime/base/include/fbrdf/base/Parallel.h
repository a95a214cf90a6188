// Parallel.h - loops over threads whose result does not depend on how many threads there are.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace fbrdf {

/// Threads to use: the number asked for, or one a core when that is 0 or less.
int threadCount(int asked);

/// Calls work(task) for task = 0 .. tasks - 1, each once. The first exception is rethrown here.
template <class Work>
void parallelTasks(size_t tasks, int threads, const Work& work)
{
    const auto workers = std::min<size_t>(static_cast<size_t>(threadCount(threads)), tasks);
    std::atomic<size_t> next{0};
    std::vector<std::exception_ptr> failures(workers);
    const auto run = [&](size_t worker) {
        try {
            for (size_t task = next++; task < tasks; task = next++) work(task);
        } catch (...) {
            failures[worker] = std::current_exception();
            next = tasks;
        }
    };
    std::vector<std::thread> pool;
    for (size_t w = 1; w < workers; ++w) pool.emplace_back(run, w);
    if (workers > 0) run(0);
    for (std::thread& t : pool) t.join();
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

/// Calls work(i) for i = 0 .. count - 1 in blocks.
template <class Work>
void parallelFor(size_t count, int threads, const Work& work)
{
    constexpr size_t kBlock = 1024;
    parallelTasks((count + kBlock - 1) / kBlock, threads, [&](size_t block) {
        const size_t end = std::min(count, (block + 1) * kBlock);
        for (size_t i = block * kBlock; i < end; ++i) work(i);
    });
}

}  // namespace fbrdf
