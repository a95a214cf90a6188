// Controls.h - what the keys and the mouse of the window do to what is shown; no window here.
#pragma once
#include <fbrdf/scene/Camera.h>

#include <string>
#include <vector>

namespace fbrdf::scene {

/// How a picture is made: by a technique of the runtime (fbrdf/plan/Technique.h), which keeps its
/// number, or by one that the CPU draws (CpuRenderer.h, fbrdf/truth/PathTracer.h).
enum class ViewTechnique { vertex = kTechniqueCount, reference, path };
constexpr int kViewTechniqueCount = kTechniqueCount + 3;
constexpr ViewTechnique viewTechnique(Technique technique)
{
    return static_cast<ViewTechnique>(technique);
}
constexpr int kMostLights = 1024;  ///< that keys and panel ask for

const char* viewTechniqueName(ViewTechnique technique);        ///< "two-lookup", ...
ViewTechnique viewTechniqueFromName(const std::string& name);  ///< throws Error(usage)
std::string viewTechniqueHelp();  ///< names, with what those on the CPU draw
bool isOnCpu(ViewTechnique technique);
Technique runtimeTechnique(ViewTechnique technique);  ///< expects !isOnCpu(technique)

/// What the window shows.
struct ViewState {
    Camera camera, home;  ///< home: what `r` goes back to
    ViewTechnique technique = viewTechnique(Technique::single);
    int material = 0, materialCount = 1;
    int mesh = 0, meshCount = 1;
    int lightCount = 1;
    bool madeLights = true;  ///< lights come by number; false: from a file, and stay
    float exposure = 1.0f;
    int environment = 0, environmentCount = 1;
    float environmentDegrees = 0.0f, environmentIntensity = 1.0f;  ///< about +y; of its radiance
    int environmentLobes = 0;                                      ///< at most; 0: all there are
    bool turning = false;                                          ///< objects and ground
    bool help = false;
    bool screenshot = false, frame = false, cancel = false,
         close = false;                ///< wishes, for the window to fulfil
    std::vector<std::string> dropped;  ///< files, in the order in which they came
};

/// Applies a key by its character (lower case; escape is 27). Returns false for a key without
/// meaning, leaving the state as it was.
bool applyKey(ViewState& state, char key);

/// Applies a drag with the left button: pixels to the right and down, in a window of that height.
void applyDrag(ViewState& state, double right, double down, int windowHeight);
/// Applies turns of the wheel; upwards the camera comes nearer.
void applyScroll(ViewState& state, double steps);

/// The lines of the help: key, meaning.
struct KeyHelp {
    const char *key, *meaning;
};
const std::vector<KeyHelp>& keyHelp();

}  // namespace fbrdf::scene
