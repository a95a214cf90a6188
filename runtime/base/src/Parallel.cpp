#include "TaskQueue.h"

#include <fbrdf/base/Parallel.h>

#include <system_error>
#include <thread>
#include <vector>

namespace fbrdf {
namespace {

// Runs work on `count` threads, this one among them. Where the system gives fewer, those do it all.
void runOnThreads(size_t count, const std::function<void()>& work)
{
    std::vector<std::thread> others;
    try {
        while (others.size() + 1 < count) others.emplace_back(work);
    } catch (const std::system_error&) {
    }
    work();
    for (std::thread& thread : others) thread.join();
}

}  // namespace

int threadCount(int asked)
{
    return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallelTasks(size_t tasks, int threads, const std::function<void(size_t)>& work)
{
    if (tasks == 0) return;
    TaskQueue queue(tasks, work);
    runOnThreads(std::min(static_cast<size_t>(threadCount(threads)), tasks),
                 [&] { queue.takeAll(); });
    queue.rethrow();
}

}  // namespace fbrdf
