// WindowTimes.h - how soon a window shows something and how smoothly it goes on, for its stats.
#pragma once
#include <fbrdf/scene/Stats.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

class WindowTimes {
public:
    /// A frame begins, while something is being fitted, and while something of the panel is held.
    void begin(bool isFitting, bool isHeld);
    /// The frame is on the screen. Returns the milliseconds that it took.
    double presented();
    /// A file was dropped, or opened in another way.
    void dropped(const std::string& file);
    /// It could not be opened.
    void refused(const std::string& file, const std::string& why);
    /// A material was made of a file or a model: the next frame shows it.
    void made(const std::string& source);

    const scene::WindowStats& stats() const { return stats_; }

private:
    using Clock = std::chrono::steady_clock;

    void addFrame(double taken);
    scene::OpenedStats* waiting(const std::string& file);

    scene::WindowStats stats_;
    Clock::time_point frame_ = {};
    std::optional<Clock::time_point> shown_;    ///< when the last frame was on the screen
    std::vector<Clock::time_point> droppedAt_;  ///< of stats_.opened
    std::vector<size_t> ready_;                 ///< of stats_.opened: the next frame shows them
    bool isFitting_ = false, isHeld_ = false;
};

/// Seconds since the system started this program; where it does not tell, since the first call.
double secondsSinceStart();

}  // namespace fbrdf::viewer
