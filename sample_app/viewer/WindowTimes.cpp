#include "WindowTimes.h"

#include <algorithm>
#include <charconv>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#ifdef __linux__
#include <unistd.h>
#endif

namespace fbrdf::viewer {
namespace {

double milliseconds(std::chrono::steady_clock::duration time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

}  // namespace

double secondsSinceStart()
{
#ifdef __linux__
    // proc(5): field 22 of stat, counted behind the name, which may contain spaces, is the start in
    // ticks since the system was.
    constexpr size_t kStartField = 19;
    std::ifstream file("/proc/self/stat");
    std::string line;
    std::getline(file, line);
    std::istringstream rest(line.substr(std::min(line.size(), line.rfind(')') + 2)));
    const std::vector<std::string> fields{std::istream_iterator<std::string>(rest), {}};
    timespec now = {};
    long long ticks = 0;
    const bool isThere =
        fields.size() > kStartField &&
        std::from_chars(fields[kStartField].data(),
                        fields[kStartField].data() + fields[kStartField].size(), ticks)
                .ec == std::errc() &&
        clock_gettime(CLOCK_BOOTTIME, &now) == 0;
    if (isThere)
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) -
               static_cast<double>(ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
#endif
    static const auto first = std::chrono::steady_clock::now();
    return 1e-3 * milliseconds(std::chrono::steady_clock::now() - first);
}

void WindowTimes::begin(bool isFitting, bool isHeld)
{
    frame_ = Clock::now();
    isFitting_ = isFitting;
    isHeld_ = isHeld;
}

double WindowTimes::presented()
{
    const Clock::time_point now = Clock::now();
    if (shown_)
        addFrame(milliseconds(now - *shown_));
    else
        stats_.firstPictureSeconds = secondsSinceStart();
    shown_ = now;
    ++stats_.frames;
    for (const size_t i : ready_)
        stats_.opened[i].seconds = 1e-3 * milliseconds(now - droppedAt_[i]);
    ready_.clear();
    return milliseconds(now - frame_);
}

/// What people wait for is the next picture, so rests between frames count as well.
void WindowTimes::addFrame(double taken)
{
    stats_.longestFrame = std::max(stats_.longestFrame, taken);
    if (isHeld_) stats_.secondsWhileHeld += 1e-3 * taken;
    if (!isFitting_) return;
    ++stats_.framesWhileFitting;
    stats_.longestWhileFitting = std::max(stats_.longestWhileFitting, taken);
}

scene::OpenedStats* WindowTimes::waiting(const std::string& file)
{
    const auto is = [&](const scene::OpenedStats& o) {
        return o.file == file && !o.seconds && o.why.empty();
    };
    const auto found = std::find_if(stats_.opened.begin(), stats_.opened.end(), is);
    return found == stats_.opened.end() ? nullptr : &*found;
}

void WindowTimes::dropped(const std::string& file)
{
    stats_.opened.push_back({file, {}, {}});
    droppedAt_.push_back(Clock::now());
}

void WindowTimes::refused(const std::string& file, const std::string& why)
{
    if (scene::OpenedStats* const opened = waiting(file)) opened->why = why;
}

void WindowTimes::made(const std::string& source)
{
    ++stats_.materialsMade;
    stats_.madeWhileHeld += isHeld_;
    if (const scene::OpenedStats* const opened = waiting(source))
        ready_.push_back(static_cast<size_t>(opened - stats_.opened.data()));
}

}  // namespace fbrdf::viewer
