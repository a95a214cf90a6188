// FrameTimes.h - how long frames take, for the programs that print what a plugin costs beside the
// plain runtime.
#pragma once
#include <algorithm>
#include <chrono>
#include <vector>

namespace fbrdf::test {

/// Of draw(), until finish() returns: glFinish of the context.
template <class Finish, class Draw>
double milliseconds(Finish finish, Draw draw)
{
    const auto start = std::chrono::steady_clock::now();
    draw();
    finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Expects an odd number of values.
inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace fbrdf::test
