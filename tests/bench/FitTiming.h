// FitTiming.h - seconds and memory of a fit, for fbrdf-fit-bench.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <atomic>
#include <string>
#include <thread>

namespace fbrdf {

/// The most anonymous memory of the process while the object lives, looked at every 5 ms: RssAnon
/// of /proc/self/status. Pages of mapped files are not in it: the kernel drops them when it likes.
class AnonymousPeak {
public:
    AnonymousPeak();
    ~AnonymousPeak();
    AnonymousPeak(const AnonymousPeak&) = delete;
    double megabytes() const { return static_cast<double>(most_) / 1024.0; }

private:
    std::atomic<bool> done_{false};
    std::atomic<long> most_;  ///< KiB
    std::thread watch_;
};

struct Timing {
    double seconds = 0.0;    ///< of the fit alone
    double cpu = 0.0;        ///< of processors, for the same
    double megabytes = 0.0;  ///< AnonymousPeak

    Timing& operator+=(const Timing& other);
};

/// One fit, without held-out errors: those are fits of their own.
Timing timed(const Source& source, FitOptions options);
/// The fastest of `repeat`: what other processes take is no part of the figure.
Timing best(int repeat, const Source& source, const FitOptions& options);

void print(const std::string& what, const Timing& timing, const std::string& more = "");

}  // namespace fbrdf
