// Controls.h - what the keys and the mouse of the window do to what is shown; no window here.
#pragma once
#include <fbrdf/scene/BrowserView.h>
#include <fbrdf/scene/CompareView.h>
#include <fbrdf/scene/CursorView.h>
#include <fbrdf/scene/Document.h>

#include <string>
#include <vector>

namespace fbrdf::scene {

/// What is wished for the lights.
struct LightWishes {
    int add = -1;         ///< a LightKind (LightEdit.h); -1: none
    bool remove = false;  ///< the selected one
    bool next = false;    ///< select the next one
    Vec3d push{0.0};      ///< steps of the selected one to the right, up and away from the camera
};

/// What the window shows, and what is wished for it.
struct ViewState {
    Document document;                              ///< with a camera
    Camera home;                                    ///< what `r` goes back to
    std::vector<std::string> meshes, environments;  ///< names that keys and lists go through
    BrowserView browser;
    CompareView compare;
    CursorView cursor;
    int light = -1;           ///< selected, as in LightEdit.h; -1: none
    bool showsLights = true;  ///< by handles over the picture
    LightWishes lightWishes;
    bool help = false;
    bool screenshot = false, screenshotExr = false, frame = false, cancel = false, close = false,
         undo = false, redo = false, save = false;  ///< wishes, for the window to fulfil
    std::vector<std::string> dropped;               ///< files, in the order in which they came
};

/// Applies a key by its character (lower case; escape is 27). Returns false for a key without
/// meaning, leaving the state as it was.
bool applyKey(ViewState& state, char key);
/// The same for a key with Ctrl.
bool applyControlKey(ViewState& state, char key, bool withShift);

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
