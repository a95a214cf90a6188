// Progress.h - one line on stderr that shows what long work is doing, unless stderr is not a
// terminal. The line is removed at the end, so only the result stays on the screen.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace fbrdf::tool {

class Progress {
public:
    /// Silent unless `wanted` and stderr is a terminal.
    explicit Progress(bool wanted);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// "fitting garnet_red ..."
    void phase(const std::string& text);
    /// A bar with a percentage, redrawn at most ten times a second; `total` 0 shows none.
    void bar(uint64_t done, uint64_t total, const std::string& text);
    /// Removes the line, so that something else can be written.
    void clear();

private:
    void show(const std::string& line);

    bool visible_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point last_{};
};

/// "[#####.....]" with the bar's `width` cells, `share` in [0, 1] of them full.
std::string barText(double share, int width);

}  // namespace fbrdf::tool
