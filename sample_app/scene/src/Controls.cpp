#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/Controls.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::scene {
namespace {

struct CpuTechnique {
    const char *name, *description;
};
/// Those of ViewTechnique from kTechniqueCount on, in its order.
constexpr std::array<CpuTechnique, kViewTechniqueCount - kTechniqueCount> kCpuTechniques{{
    {"vertex", "true BRDF at the vertices"},
    {"reference", "true BRDF at every pixel, in double"},
    {"path", "the same with shadows and interreflection, path-traced"},
}};

const CpuTechnique& cpuTechnique(ViewTechnique technique)
{
    return kCpuTechniques[static_cast<size_t>(technique) - kTechniques.size()];
}

constexpr char kEscape = 27;
constexpr float kExposureStep = 1.122462f;  // 2^(1/6): six presses a stop
constexpr double kWheelZoom = 0.9;          // of the distance, a step
constexpr float kEnvironmentStep = 15.0f;   // degrees

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
        case 'c': state.cancel = true; return true;
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

bool applyEnvironmentKey(ViewState& state, char key)
{
    switch (key) {
        case 'e':
            state.environment = following(state.environment, state.environmentCount);
            return true;
        case ',':
        case '.': {
            const float turned =
                state.environmentDegrees + (key == '.' ? kEnvironmentStep : -kEnvironmentStep);
            state.environmentDegrees = std::remainder(turned, 360.0f);
            return true;
        }
        case ' ': state.turning = !state.turning; return true;
        default: return false;
    }
}

}  // namespace

const char* viewTechniqueName(ViewTechnique technique)
{
    return isOnCpu(technique) ? cpuTechnique(technique).name
                              : techniqueName(runtimeTechnique(technique));
}

ViewTechnique viewTechniqueFromName(const std::string& name)
{
    std::string all;
    for (int i = 0; i < kViewTechniqueCount; ++i) {
        const auto technique = static_cast<ViewTechnique>(i);
        if (name == viewTechniqueName(technique)) return technique;
        all += (i == 0 ? "" : ", ") + std::string(viewTechniqueName(technique));
    }
    throw Error(ErrorKind::usage, "--technique", Found("'" + name + "'").expected("one of " + all));
}

std::string viewTechniqueHelp()
{
    std::string onCpu;
    for (const CpuTechnique& t : kCpuTechniques)
        onCpu += std::string(onCpu.empty() ? "" : ", ") + t.name + " (" + t.description + ")";
    return techniqueNames() + "; on the CPU: " + onCpu;
}

bool isOnCpu(ViewTechnique technique)
{
    return static_cast<int>(technique) >= kTechniqueCount;
}

Technique runtimeTechnique(ViewTechnique technique)
{
    return isOnCpu(technique) ? Technique::single : static_cast<Technique>(technique);
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
        default:
            return applyLightKey(state, key) || applyEnvironmentKey(state, key) ||
                   applyViewKey(state, key);
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
        {"drag, wheel", "orbit, zoom"}, {"M", "next material"},
        {"T", "next technique"},        {"L / K", "lights x2, / 2"},
        {"+ / -", "exposure"},          {"O", "next mesh"},
        {"E", "next environment"},      {", / .", "turn it"},
        {"Space", "turntable"},         {"F", "frame the mesh"},
        {"R", "camera home"},           {"S", "screenshot"},
        {"C", "cancel fits"},           {"drop a file", "open it"},
        {"H, F1", "this help"},         {"Q, Esc", "quit"}};
    return lines;
}

}  // namespace fbrdf::scene
