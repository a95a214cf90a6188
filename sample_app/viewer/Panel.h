// Panel.h - the text on the screen: what is drawn, how fast, and the help. With Dear ImGui a panel
// whose fields can be changed with the mouse (PanelImGui.cpp), else the window's title
// (PanelTitle.cpp).
#pragma once
#include "Browser.h"
#include "CompareStage.h"
#include "CursorInspector.h"
#include "MaterialEditor.h"
#include "PassList.h"

#include <fbrdf/scene/Controls.h>
#include <fbrdf/scene/LightEdit.h>

#include <string>
#include <vector>

struct GLFWwindow;

namespace fbrdf::viewer {

/// What the panel shows besides the state.
struct PanelFacts {
    int triangles = 0, passes = 0, maxLookups = 0;
    int lights = 0;                                     ///< area lights included
    const scene::LightSet* drawnLights = nullptr;       ///< as they are drawn
    std::vector<scene::LightHandle> handles;            ///< of lights, over the picture
    const std::vector<BrowserItem>* browser = nullptr;  ///< materials to choose from
    bool isFitted = false;  ///< the material that is shown is no file of one
    bool canUndo = false, canRedo = false;
    int samples = 0, samplesWanted = 0;  ///< of each pixel, so far and in the end
    bool isDrawing = false;              ///< the picture changes, or becomes better
    double milliseconds = 0.0;
    const std::vector<PassRow>* passRows = nullptr;  ///< of the last draw
    int passesLeft = 0;                              ///< without a row
    const scene::Stats* stats = nullptr;             ///< of the last draw
    std::string renderer;                            ///< of GL
    std::string message;                             ///< what happened last: "wrote ..."
    FitFacts fit;
    const CompareFacts* compare = nullptr;
    const CursorFacts* cursor = nullptr;
};

/// A file without its folders; a model, or what is no file, as it is; "none" for nothing.
std::string shortName(const std::string& spec);

class Panel {
public:
    /// Expects a window with a current GL context and callbacks of its own, which the panel calls.
    explicit Panel(GLFWwindow* window);
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    /// True while the mouse is over the panel and not meant for the scene.
    bool wantsMouse() const;
    /// True while a field of the panel takes keys.
    bool wantsKeys() const;
    /// True while a field is dragged or typed in.
    bool isHeld() const;
    /// Shows the state, and changes it as the user wants.
    void draw(scene::ViewState& state, const PanelFacts& facts);

private:
    /// Ends with dots while the picture is being drawn.
    void setTitle(std::string title, const PanelFacts& facts);

    GLFWwindow* window_;
    std::string title_;   ///< of the window
    float scale_ = 1.0f;  ///< of letters, by the monitor; unused without Dear ImGui
};

}  // namespace fbrdf::viewer
