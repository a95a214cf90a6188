// Workers.h - threads that wait between loops, for loops so short that starting a thread would take
// longer than they do. For one long loop use parallelTasks (Parallel.h).
#pragma once
#include <cstddef>
#include <functional>
#include <memory>

namespace fbrdf {

class Workers {
public:
    /// threads: how many work on a loop (0: one a core); the one that calls is among them. The
    /// others are started by the first loop that needs them.
    explicit Workers(int threads);
    ~Workers();  ///< waits until its threads have ended
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// As parallelTasks: calls work(task) for task = 0 .. tasks - 1, each once, and throws the
    /// exception of the first task that failed. A thread that wakes up after the last task has
    /// begun is not waited for. One thread may call it at a time.
    void run(size_t tasks, const std::function<void(size_t)>& work);

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

}  // namespace fbrdf
