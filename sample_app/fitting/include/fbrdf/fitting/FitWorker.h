// FitWorker.h - fits materials on a thread of its own, for programs that go on drawing meanwhile.
//
// An order that comes while another is being fitted waits, and takes the place of one that waits
// already: while a slider is dragged the newest position counts, and every fit that has begun is
// finished, so that there is always a next picture.
#pragma once
#include <fbrdf/fitting/FitOrder.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace fbrdf::fitting {

/// All functions return at once, and are called from one thread.
class FitWorker {
public:
    FitWorker();
    /// Stops what is being fitted, and waits for that.
    ~FitWorker();
    FitWorker(const FitWorker&) = delete;
    FitWorker& operator=(const FitWorker&) = delete;

    /// Begins the order, whose watch and cache the worker sets, or leaves it to wait. Returns its
    /// number, from 1 up; orders whose place was taken get no reply.
    int order(FitOrder order);
    /// Forgets what waits, and stops what is being fitted, or was about to be: its reply says so.
    void stop();
    /// The reply that came last, once.
    std::optional<FitReply> take();
    /// What is being done, for people: "trying hdio"; empty: nothing is, and nothing waits.
    std::string doing() const;

private:
    struct Numbered {
        int number;
        FitOrder order;
    };
    void run();
    FitReply fit(Numbered& numbered);
    std::shared_ptr<const Source> sourceOf(const FitOrder& order);
    FitWatch watch();

    mutable std::mutex mutex_;  ///< guards what follows
    std::condition_variable changed_;
    std::optional<Numbered> waiting_;
    std::optional<FitReply> reply_;
    std::string doing_;
    int last_ = 0, running_ = 0;  ///< numbers of orders; running 0: none is being fitted
    int stopped_ = 0;             ///< orders up to this one are to be given up
    bool ends_ = false;

    // Of the thread alone: what the next order may use again.
    std::shared_ptr<FitCache> cache_ = makeFitCache();
    std::shared_ptr<const Source> source_;
    std::string sourceKey_;  ///< of source_

    std::thread thread_;
};

}  // namespace fbrdf::fitting
