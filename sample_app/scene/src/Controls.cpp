#include <fbrdf/scene/Controls.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr char kEscape = 27;
constexpr float kExposureStep = 1.122462f;  // 2^(1/6): six presses a stop
constexpr double kWheelZoom = 0.9;          // of the distance, a step
constexpr float kEnvironmentStep = 15.0f;   // degrees
constexpr int kMostMadeByKeys = 4096;

/// The next of `count` things, the first after the last.
int following(int index, int count)
{
    return (index + 1) % std::max(1, count);
}

/// The name after one in a list, the first after the last and where it is not in there.
std::string nextName(const std::vector<std::string>& names, const std::string& name)
{
    if (names.empty()) return name;
    const auto known = std::find(names.begin(), names.end(), name);
    const auto place = static_cast<int>(known - names.begin());
    const auto count = static_cast<int>(names.size());
    return names[static_cast<size_t>(place == count ? 0 : following(place, count))];
}

bool applyViewKey(ViewState& state, char key)
{
    switch (key) {
        case '+':
        case '=': state.document.exposure *= kExposureStep; return true;
        case '-': state.document.exposure /= kExposureStep; return true;
        case 'r': state.document.camera = state.home; return true;
        case 'f': state.frame = true; return true;
        case 's': state.screenshot = true; return true;
        case 'c': state.cancel = true; return true;
        case 'h': state.help = !state.help; return true;
        case 'q':
        case kEscape: state.close = true; return true;
        default: return false;
    }
}

/// Lights are made twice or half as many; those of a list give way to one that is made.
bool applyLightKey(ViewState& state, char key)
{
    switch (key) {
        case 'n': state.lightWishes.next = true; return true;
        case 'a': state.lightWishes.add = 0; return true;
        case 'w': state.showsLights = !state.showsLights; return true;
        case 'j': state.document.orbiting = !state.document.orbiting; return true;
        case 'l':
        case 'k': break;
        default: return false;
    }
    int& made = state.document.lights.made;
    made = key == 'l' ? std::clamp(2 * made, 1, kMostMadeByKeys) : std::max(1, made / 2);
    return true;
}

/// Moves or removes the selected light; without one arrows turn the view.
bool applyArrowKey(ViewState& state, char key)
{
    constexpr double kTurn = kPi / 36.0;  // of the view by an arrow, radians
    const double right = (key == kRightKey) - (key == kLeftKey),
                 up = (key == kUpKey) - (key == kDownKey),
                 away = (key == kPageUpKey) - (key == kPageDownKey);
    if (state.light >= 0 && key == kDeleteKey)
        state.lightWishes.remove = true;
    else if (state.light >= 0)
        state.lightWishes.push += Vec3d(right, up, away);
    else
        state.document.camera = orbited(*state.document.camera, kTurn * right, kTurn * up, 1.0);
    return key == kDeleteKey || right != 0.0 || up != 0.0 || away != 0.0;
}

bool applyEnvironmentKey(ViewState& state, char key)
{
    SceneEnvironment& environment = state.document.environment;
    switch (key) {
        case 'e': environment.name = nextName(state.environments, environment.name); return true;
        case ',':
        case '.': {
            const float turned =
                environment.degrees + (key == '.' ? kEnvironmentStep : -kEnvironmentStep);
            environment.degrees = std::remainder(turned, 360.0f);
            return true;
        }
        case ' ': state.document.turning = !state.document.turning; return true;
        default: return false;
    }
}

}  // namespace

bool applyKey(ViewState& state, char key)
{
    Document& document = state.document;
    switch (key) {
        case 'm':
            document.shown = following(document.shown, static_cast<int>(document.materials.size()));
            return true;
        case 'o': document.mesh = nextName(state.meshes, document.mesh); return true;
        case 't':
            document.technique = static_cast<ViewTechnique>(
                following(static_cast<int>(document.technique), kViewTechniqueCount));
            return true;
        default:
            return applyCompareKey(state.compare, key) || applyCursorKey(state.cursor, key) ||
                   applyBrowserKey(state.browser, key) || applyLightKey(state, key) ||
                   applyArrowKey(state, key) || applyEnvironmentKey(state, key) ||
                   applyViewKey(state, key);
    }
}

bool applyControlKey(ViewState& state, char key, bool withShift)
{
    switch (key) {
        case 'z': (withShift ? state.redo : state.undo) = true; return true;
        case 'y': state.redo = true; return true;
        case 's': state.save = true; return true;
        case 'e': state.screenshotExr = true; return true;
        default: return false;
    }
}

void applyDrag(ViewState& state, double right, double down, int windowHeight)
{
    // A drag across the height of the window turns the object by half a turn, along with the mouse.
    const double turn = kPi / std::max(1, windowHeight);
    state.document.camera = orbited(*state.document.camera, -turn * right, turn * down, 1.0);
}

void applyScroll(ViewState& state, double steps)
{
    state.document.camera = orbited(*state.document.camera, 0.0, 0.0, std::pow(kWheelZoom, steps));
}

const std::vector<KeyHelp>& keyHelp()
{
    static const std::vector<KeyHelp> lines{{"drag, wheel", "orbit, zoom"},
                                            {"M", "next material"},
                                            {"Y, arrows", "choose a material"},
                                            {"Enter", "show or open it"},
                                            {"T", "next technique"},
                                            {"L / K", "lights x2, / 2"},
                                            {"A", "add a light"},
                                            {"N", "select the next light"},
                                            {"arrows, Page", "move it"},
                                            {"Del", "remove it"},
                                            {"W", "show lights"},
                                            {"J", "lights orbit"},
                                            {"+ / -", "exposure"},
                                            {"O", "next mesh"},
                                            {"E", "next environment"},
                                            {", / .", "turn it"},
                                            {"Space", "turntable"},
                                            {"F", "frame the mesh"},
                                            {"R", "camera home"},
                                            {"S, Ctrl+E", "picture PNG, EXR"},
                                            {"C", "cancel fits"},
                                            {"V", "compare: next way"},
                                            {"1 / 2", "next side A / B"},
                                            {"3", "exchange, flip"},
                                            {"P", "hold flip, wipe"},
                                            {"[ / ]", "move the line"},
                                            {"D", "gain of differences"},
                                            {"< / >", "singular values"},
                                            {"I, arrows", "explain a place"},
                                            {"drop a file", "open it"},
                                            {"Ctrl+Z", "undo"},
                                            {"Ctrl+Shift+Z", "redo"},
                                            {"Ctrl+S", "save the scene"},
                                            {"H, F1", "this help"},
                                            {"Q, Esc", "quit"}};
    return lines;
}

}  // namespace fbrdf::scene
