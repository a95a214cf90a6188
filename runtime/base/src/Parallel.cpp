#include <fbrdf/base/Parallel.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace fbrdf {
namespace {

// The first of the tasks that failed. Tasks begin in order, so that those before it have all
// begun, and it is the same one however the threads run.
class FirstFailure {
public:
    void add(size_t task, std::exception_ptr failure)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (failure_ && task_ < task) return;
        task_ = task;
        failure_ = std::move(failure);
    }
    void rethrow() const
    {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    std::mutex mutex_;
    size_t task_ = 0;
    std::exception_ptr failure_;
};

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
    std::atomic<size_t> next{0};
    FirstFailure failure;
    const auto takeTasks = [&] {
        for (size_t task = next++; task < tasks; task = next++) try {
                work(task);
            } catch (...) {
                failure.add(task, std::current_exception());
                next = tasks;
            }
    };
    if (tasks == 0) return;
    runOnThreads(std::min(static_cast<size_t>(threadCount(threads)), tasks), takeTasks);
    failure.rethrow();
}

}  // namespace fbrdf
