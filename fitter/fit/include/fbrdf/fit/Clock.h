// Clock.h - stopwatches of elapsed time, which never runs backwards, and of processor time.
#pragma once
#include <chrono>
#include <ctime>

namespace fbrdf {

class Clock {
public:
    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Processor time of all threads of the process since the clock was made. It is that of one fit
/// where nothing else runs beside it.
class ProcessorClock {
public:
    double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

private:
    std::clock_t start_ = std::clock();
};

}  // namespace fbrdf
