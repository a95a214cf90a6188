// Workers.h - the same work on several threads.
#pragma once
#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace fbrdf::tool {

/// The number asked for, or one a core when that is 0.
inline int workerCount(int asked)
{
    return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Calls work(0) .. work(count - 1) at the same time, the first on this thread. When some throw,
/// one of the exceptions is thrown here, after all have ended.
template <class Work>
void runWorkers(int threads, const Work& work)
{
    const int count = workerCount(threads);
    std::vector<std::exception_ptr> failures(static_cast<size_t>(count));
    const auto run = [&](int worker) {
        try {
            work(worker);
        } catch (...) {
            failures[static_cast<size_t>(worker)] = std::current_exception();
        }
    };
    std::vector<std::thread> pool;
    for (int w = 1; w < count; ++w) pool.emplace_back(run, w);
    run(0);
    for (std::thread& thread : pool) thread.join();
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

}  // namespace fbrdf::tool
