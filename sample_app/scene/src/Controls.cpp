#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Controls.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr std::array<const char*, kViewTechniqueCount> kNames{"single", "batched", "two-lookup",
                                                              "vertex", "reference"};
constexpr char kEscape = 27;
constexpr float kExposureStep = 1.122462f;  // 2^(1/6): six presses a stop
constexpr double kWheelZoom = 0.9;          // of the distance, a step

/// The next of `count` things, the first after the last.
int following(int index, int count)
{
    return (index + 1) % std::max(1, count);
}

bool applyViewKey(ViewState& state, char key)
{
    switch (key) {
        case '+':
        case '=': state.exposure *= kExposureStep; return true;
        case '-': state.exposure /= kExposureStep; return true;
        case 'r': state.camera = state.home; return true;
        case 'f': state.frame = true; return true;
        case 's': state.screenshot = true; return true;
        case 'h': state.help = !state.help; return true;
        case 'q':
        case kEscape: state.close = true; return true;
        default: return false;
    }
}

bool applyLightKey(ViewState& state, char key)
{
    if (key != 'l' && key != 'k') return false;
    if (state.madeLights)
        state.lightCount = key == 'l' ? std::min(kMostLights, 2 * state.lightCount)
                                      : std::max(1, state.lightCount / 2);
    return true;
}

}  // namespace

const char* viewTechniqueName(ViewTechnique technique)
{
    return kNames[static_cast<size_t>(technique)];
}

ViewTechnique viewTechniqueFromName(const std::string& name)
{
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found != kNames.end()) return static_cast<ViewTechnique>(found - kNames.begin());
    std::string all;
    for (const char* known : kNames) all += (all.empty() ? "" : ", ") + std::string(known);
    throw Error(ErrorKind::usage, "--technique", "found '" + name + "', expected one of " + all);
}

bool isOnCpu(ViewTechnique technique)
{
    return technique == ViewTechnique::vertex || technique == ViewTechnique::reference;
}

Technique runtimeTechnique(ViewTechnique technique)
{
    if (technique == ViewTechnique::batched) return Technique::batched;
    return technique == ViewTechnique::twoLookup ? Technique::twoLookup : Technique::single;
}

bool applyKey(ViewState& state, char key)
{
    switch (key) {
        case 'm': state.material = following(state.material, state.materialCount); return true;
        case 'o': state.mesh = following(state.mesh, state.meshCount); return true;
        case 't':
            state.technique = static_cast<ViewTechnique>(
                following(static_cast<int>(state.technique), kViewTechniqueCount));
            return true;
        default: return applyLightKey(state, key) || applyViewKey(state, key);
    }
}

void applyDrag(ViewState& state, double right, double down, int windowHeight)
{
    // A drag across the height of the window turns the object by half a turn, along with the mouse.
    const double turn = kPi / std::max(1, windowHeight);
    state.camera = orbited(state.camera, -turn * right, turn * down, 1.0);
}

void applyScroll(ViewState& state, double steps)
{
    state.camera = orbited(state.camera, 0.0, 0.0, std::pow(kWheelZoom, steps));
}

const std::vector<KeyHelp>& keyHelp()
{
    static const std::vector<KeyHelp> lines{
        {"drag, wheel", "orbit, zoom"}, {"M", "next material"}, {"T", "next technique"},
        {"L / K", "lights x2, / 2"},    {"+ / -", "exposure"},  {"O", "next mesh"},
        {"F", "frame the mesh"},        {"R", "camera home"},   {"S", "screenshot"},
        {"H, F1", "this help"},         {"Q, Esc", "quit"}};
    return lines;
}

}  // namespace fbrdf::scene
