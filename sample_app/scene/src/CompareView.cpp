#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Conventions.h>
#include <fbrdf/scene/CompareView.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace fbrdf::scene {
namespace {

constexpr std::array<const char*, kCompareModeCount> kModeNames{"split", "wipe", "flip",
                                                                "difference", "heat"};
constexpr float kLineStep = 1.0f / 32.0f;  // of the width, a press

int nextSide(int side, int count)
{
    return (side + 1) % std::max(1, count);
}

/// Off, then each mode in turn.
void toNextMode(CompareView& compare)
{
    const int next = compare.on ? static_cast<int>(compare.mode) + 1 : 0;
    compare.on = next < kCompareModeCount;
    compare.mode = static_cast<CompareMode>(next % kCompareModeCount);
}

void exchange(CompareView& compare)
{
    if (compare.on && compare.mode == CompareMode::flip) {
        compare.showsB = compare.holds ? !compare.showsB : true;
        compare.holds = true;
    } else {
        std::swap(compare.a, compare.b);
    }
}

}  // namespace

const char* compareModeName(CompareMode mode)
{
    return kModeNames[static_cast<size_t>(mode)];
}

std::string compareModeNames()
{
    std::string all;
    for (const char* name : kModeNames) all += (all.empty() ? "" : ", ") + std::string(name);
    return all;
}

CompareMode compareModeFromName(const std::string& name)
{
    const auto found = std::find(kModeNames.begin(), kModeNames.end(), name);
    if (found == kModeNames.end())
        throw Error(ErrorKind::usage, "--compare-mode",
                    Found("'" + name + "'").expected("one of " + compareModeNames()));
    return static_cast<CompareMode>(found - kModeNames.begin());
}

bool Comparison::operator==(const Comparison& other) const
{
    const auto values = [](const Comparison& c) {
        return std::tie(c.on, c.mode, c.a, c.b, c.at, c.gain, c.holds);
    };
    return values(*this) == values(other);
}

float CompareView::lineAt(double seconds) const
{
    if (mode != CompareMode::wipe || holds) return at;
    // A cosine: slow at the borders, where it turns.
    return static_cast<float>(0.5 - 0.5 * std::cos(2.0 * kPi * seconds / kWipeSeconds));
}

bool CompareView::flipsToB(double seconds) const
{
    if (holds) return showsB;
    return std::fmod(seconds, 2.0 * kFlipSeconds) >= kFlipSeconds;
}

bool applyCompareKey(CompareView& compare, char key)
{
    switch (key) {
        case 'v': toNextMode(compare); return true;
        case '1': compare.a = nextSide(compare.a, compare.sideCount); return true;
        case '2': compare.b = nextSide(compare.b, compare.sideCount); return true;
        case '3': exchange(compare); return true;
        case 'p': compare.holds = !compare.holds; return true;
        case 'd':
            compare.gain = compare.gain >= kMostGain ? kLeastGain : 2.0f * compare.gain;
            return true;
        case '[':
        case ']':
            compare.at = std::clamp(compare.at + (key == ']' ? kLineStep : -kLineStep), 0.0f, 1.0f);
            return true;
        case '<':
        case '>':
            compare.terms = std::clamp(compare.terms + (key == '>' ? 1 : -1), 1, kMostCompareTerms);
            return true;
        default: return false;
    }
}

}  // namespace fbrdf::scene
