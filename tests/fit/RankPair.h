// RankPair.h - two threads that stand for two processes with one data set.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <array>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace fbrdf::test {

class RankPair {
public:
    RankSum rank(size_t index)
    {
        return {index, 2,
                [this, index](double* values, size_t count) { add(index, values, count); }};
    }

private:
    // The sums are ready when both have come; nobody comes again before both have left.
    void add(size_t index, double* values, size_t count)
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return leaving_ == 0; });
        given_[index].assign(values, values + count);
        ++arrived_;
        changed_.notify_all();
        changed_.wait(lock, [this] { return arrived_ == 2; });
        for (size_t i = 0; i < count; ++i) values[i] = given_[0][i] + given_[1][i];
        if (++leaving_ == 2) arrived_ = leaving_ = 0;
        changed_.notify_all();
        changed_.wait(lock, [this] { return leaving_ == 0; });
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::array<std::vector<double>, 2> given_;
    int arrived_ = 0, leaving_ = 0;
};

}  // namespace fbrdf::test
