// TaskQueue.h - tasks that several threads take in turn, and the first failure among them.
#pragma once
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace fbrdf {

class TaskQueue {
public:
    TaskQueue(size_t tasks, const std::function<void(size_t)>& work) : tasks_(tasks), work_(work) {}

    /// Takes tasks until there are none left, or one has failed. Never throws.
    void takeAll()
    {
        for (size_t task = next_++; task < tasks_; task = next_++) try {
                work_(task);
            } catch (...) {
                addFailure(task, std::current_exception());
                next_ = tasks_;
            }
    }

    /// To be called when no thread takes tasks any more.
    void rethrow() const
    {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    // Tasks begin in order, so that those before the one that failed have all begun, and the first
    // that failed is the same one however the threads run.
    void addFailure(size_t task, std::exception_ptr failure)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (failure_ && failed_ < task) return;
        failed_ = task;
        failure_ = std::move(failure);
    }

    const size_t tasks_;
    const std::function<void(size_t)>& work_;
    std::atomic<size_t> next_{0};
    std::mutex mutex_;
    size_t failed_ = 0;
    std::exception_ptr failure_;
};

}  // namespace fbrdf
