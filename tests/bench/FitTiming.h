// FitTiming.h - seconds and memory of a fit, for fbrdf-fit-bench.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <atomic>
#include <string>
#include <thread>

namespace fbrdf {

/// The peak of the anonymous memory of the process while the object lives, sampled every 5 ms from
/// RssAnon of /proc/self/status. Pages of mapped files do not count: the kernel can drop them.
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
    double seconds = 0.0;    ///< wall time of the fit alone
    double cpu = 0.0;        ///< processor time of the same, in seconds
    double megabytes = 0.0;  ///< AnonymousPeak

    Timing& operator+=(const Timing& other);
};

/// One fit without held-out errors, which need further fits.
Timing timed(const Source& source, FitOptions options);
/// The fastest of `repeat` fits, to leave out the load of other processes.
Timing best(int repeat, const Source& source, const FitOptions& options);

void print(const std::string& what, const Timing& timing, const std::string& more = "");

}  // namespace fbrdf
