#include "TaskQueue.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/base/Workers.h>

#include <condition_variable>
#include <system_error>
#include <thread>
#include <vector>

namespace fbrdf {

struct Workers::Shared {
    int wanted = 1;
    std::vector<std::thread> threads;
    std::mutex mutex;
    std::condition_variable hasWork, isIdle;
    // Guarded by the mutex:
    TaskQueue* queue = nullptr;  ///< null between loops
    size_t loop = 0;             ///< counts loops, so that a thread takes part in each once
    int busy = 0;                ///< threads that take tasks of `queue`
    bool ends = false;

    void work()
    {
        size_t done = 0;
        std::unique_lock<std::mutex> lock(mutex);
        while (true) {
            hasWork.wait(lock, [&] { return ends || (queue && loop != done); });
            if (ends) return;
            done = loop;
            TaskQueue* const current = queue;
            ++busy;
            lock.unlock();
            current->takeAll();
            lock.lock();
            if (--busy == 0) isIdle.notify_one();
        }
    }

    /// Starts as many threads as the system gives.
    void start()
    {
        try {
            while (static_cast<int>(threads.size()) + 1 < wanted)
                threads.emplace_back([this] { work(); });
        } catch (const std::system_error&) {
            wanted = static_cast<int>(threads.size()) + 1;
        }
    }
};

Workers::Workers(int threads) : shared_(std::make_unique<Shared>())
{
    shared_->wanted = threadCount(threads);
}

Workers::~Workers()
{
    {
        const std::lock_guard<std::mutex> lock(shared_->mutex);
        shared_->ends = true;
    }
    shared_->hasWork.notify_all();
    for (std::thread& thread : shared_->threads) thread.join();
}

void Workers::run(size_t tasks, const std::function<void(size_t)>& work)
{
    TaskQueue queue(tasks, work);
    if (tasks > 1 && shared_->wanted > 1) {
        shared_->start();
        {
            const std::lock_guard<std::mutex> lock(shared_->mutex);
            shared_->queue = &queue;
            ++shared_->loop;
        }
        shared_->hasWork.notify_all();
        queue.takeAll();
        std::unique_lock<std::mutex> lock(shared_->mutex);
        shared_->queue = nullptr;  // nobody begins with it any more
        shared_->isIdle.wait(lock, [&] { return shared_->busy == 0; });
    } else {
        queue.takeAll();
    }
    queue.rethrow();
}

}  // namespace fbrdf
