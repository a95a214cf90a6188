// Parallel.h - loops over threads whose result does not depend on how many threads there are.
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>

namespace fbrdf {

/// Threads to use: the number asked for, or one a core when that is 0 or less.
int threadCount(int asked);

/// Calls work(task) for task = 0 .. tasks - 1, each once, on `threads` threads (0: one a core);
/// this thread is one of them. Tasks begin in this order. After a task has thrown no further one
/// begins; the exception of the first task that failed is thrown here when all threads have ended.
void parallelTasks(size_t tasks, int threads, const std::function<void(size_t)>& work);

/// Calls work(i) for i = 0 .. count - 1 in blocks.
template <class Work>
void parallelFor(size_t count, int threads, const Work& work)
{
    constexpr size_t kBlock = 1024;  // so many calls cost far more than taking the next block
    parallelTasks((count + kBlock - 1) / kBlock, threads, [&](size_t block) {
        const size_t end = std::min(count, (block + 1) * kBlock);
        for (size_t i = block * kBlock; i < end; ++i) work(i);
    });
}

}  // namespace fbrdf
