#include "FitTiming.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>

namespace fbrdf {
namespace {

long anonymousKilobytes()
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "RssAnon:") {
            long value = 0;
            status >> value;
            return value;
        }
    return 0;
}

}  // namespace

AnonymousPeak::AnonymousPeak() : most_(anonymousKilobytes())
{
    watch_ = std::thread([this] {
        while (!done_) {
            most_ = std::max(most_.load(), anonymousKilobytes());
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    });
}

AnonymousPeak::~AnonymousPeak()
{
    done_ = true;
    watch_.join();
}

Timing& Timing::operator+=(const Timing& other)
{
    seconds += other.seconds;
    cpu += other.cpu;
    megabytes = std::max(megabytes, other.megabytes);
    return *this;
}

Timing timed(const Source& source, FitOptions options)
{
    options.heldOut = false;
    const AnonymousPeak peak;
    const FitResult result = fitMaterial(source, options);
    return {result.summary.seconds, result.summary.processorSeconds, peak.megabytes()};
}

Timing best(int repeat, const Source& source, const FitOptions& options)
{
    Timing least = timed(source, options);
    for (int i = 1; i < repeat; ++i) {
        const Timing t = timed(source, options);
        if (t.seconds < least.seconds) least = t;
    }
    return least;
}

void print(const std::string& what, const Timing& timing, const std::string& more)
{
    fmt::print("{:<48} {:>8.3f} s  cpu {:>8.3f} s  {:>5.0f} MB  {}\n", what, timing.seconds,
               timing.cpu, timing.megabytes, more);
    std::fflush(stdout);
}

}  // namespace fbrdf
