#include "Progress.h"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fbrdf::tool {
namespace {

constexpr int kBarCells = 30;
constexpr std::chrono::milliseconds kBetweenFrames{100};

bool isPlainTerminal()
{
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) && !(terminal && std::strcmp(terminal, "dumb") == 0);
}

size_t terminalWidth()
{
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

}  // namespace

std::string barText(double share, int width)
{
    const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * width);
    return "[" + std::string(static_cast<size_t>(full), '#') +
           std::string(static_cast<size_t>(width - full), '.') + "]";
}

Progress::Progress(bool wanted) : visible_(wanted && isPlainTerminal()) {}

Progress::~Progress()
{
    clear();
}

void Progress::phase(const std::string& text)
{
    if (visible_) show(text + " ...");
}

void Progress::bar(uint64_t done, uint64_t total, const std::string& text)
{
    const auto now = std::chrono::steady_clock::now();
    if (!visible_ || total == 0 || (drawn_ && now - last_ < kBetweenFrames)) return;
    last_ = now;
    const double share = static_cast<double>(done) / static_cast<double>(total);
    show(fmt::format("{} {:3.0f} %  {}", barText(share, kBarCells), 100.0 * share, text));
}

void Progress::clear()
{
    if (drawn_) std::fputs("\r\x1b[K", stderr);
    drawn_ = false;
}

// A line that wraps cannot be removed again, so it is cut one cell before the margin.
void Progress::show(const std::string& line)
{
    const std::string cut = line.substr(0, terminalWidth() - 1);
    fmt::print(stderr, "\r\x1b[K{}", cut);
    std::fflush(stderr);
    drawn_ = true;
}

}  // namespace fbrdf::tool
