#include <fbrdf/base/Error.h>
#include <fbrdf/fit/Clock.h>
#include <fbrdf/fitting/FitWorker.h>
#include <fbrdf/fitting/GiveWay.h>

#include <filesystem>
#include <new>
#include <utility>

namespace fbrdf::fitting {
namespace {

/// Of what the source is now: a file may be written anew while the program runs.
std::string keyOf(const FitOrder& order)
{
    const std::string path = order.source.substr(0, order.source.find_first_of("#@"));
    std::error_code none;
    const auto time = std::filesystem::last_write_time(path, none).time_since_epoch().count();
    return order.source + (order.sourceOptions.cosine ? " cosine " : " ") +
           (none ? "" : std::to_string(time));
}

FitReply stoppedReply(int number)
{
    FitReply reply;
    reply.number = number;
    reply.isStopped = true;
    reply.error = FitStopped().what();
    return reply;
}

}  // namespace

FitWorker::FitWorker()
    : thread_([this] {
          giveWay();
          run();
      })
{
}

FitWorker::~FitWorker()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
        stopped_ = last_;
    }
    changed_.notify_one();
    thread_.join();
}

int FitWorker::order(FitOrder order)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_ = Numbered{++last_, std::move(order)};
    if (doing_.empty()) doing_ = "waiting for a thread";
    changed_.notify_one();
    return last_;
}

void FitWorker::stop()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    // The thread may not have begun it yet: whoever ordered it waits for a reply.
    if (waiting_ && running_ == 0) reply_ = stoppedReply(waiting_->number);
    waiting_.reset();
    stopped_ = last_;
    if (running_ == 0) doing_.clear();
}

std::optional<FitReply> FitWorker::take()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(reply_, std::nullopt);
}

std::string FitWorker::doing() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return doing_;
}

void FitWorker::run()
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ends_ || waiting_; });
        if (ends_) return;
        Numbered next = std::move(*waiting_);
        waiting_.reset();
        running_ = next.number;
        lock.unlock();
        FitReply reply = fit(next);
        lock.lock();
        reply_ = std::move(reply);
        running_ = 0;
        if (!waiting_) doing_.clear();
    }
}

FitWatch FitWorker::watch()
{
    FitWatch watch;
    watch.tell = [this](const std::string& doing) {
        const std::lock_guard<std::mutex> lock(mutex_);
        doing_ = doing;
    };
    watch.isStopped = [this] {
        const std::lock_guard<std::mutex> lock(mutex_);
        return running_ <= stopped_;
    };
    return watch;
}

// Read once for all orders of the same source: a slider asks for it again and again.
std::shared_ptr<const Source> FitWorker::sourceOf(const FitOrder& order)
{
    if (order.opened) return order.opened;
    const std::string key = keyOf(order);
    if (!source_ || sourceKey_ != key) {
        source_.reset();
        source_ = std::make_shared<const Source>(openSource(order.source, order.sourceOptions));
        sourceKey_ = key;
    }
    return source_;
}

FitReply FitWorker::fit(Numbered& numbered)
{
    FitReply reply;
    const Clock clock;
    FitOrder& order = numbered.order;
    try {
        order.fit.watch = watch();
        order.fit.cache = cache_;
        order.fit.watch.say("opening " + order.source);
        reply = fitted(order, sourceOf(order));
    } catch (const FitStopped&) {
        reply = stoppedReply(numbered.number);
    } catch (const Error& error) {
        reply.error = error.what();
    } catch (const std::bad_alloc&) {
        reply.error = order.source + ": found too little memory, expected more";
    }
    reply.number = numbered.number;
    reply.seconds = clock.seconds();
    return reply;
}

}  // namespace fbrdf::fitting
