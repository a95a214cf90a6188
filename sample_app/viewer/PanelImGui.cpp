#include "PanelCompare.h"
#include "PanelSections.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <fmt/core.h>
#include <GLFW/glfw3.h>

#include <algorithm>

namespace fbrdf::viewer {
namespace {

constexpr float kMargin = 12.0f, kPanelWidth = 300.0f, kLabelWidth = 96.0f;
constexpr float kFontPixels = 13.0f;

void drawMenu(scene::ViewState& state, const PanelFacts& facts)
{
    if (!ImGui::BeginMenuBar()) return;
    if (ImGui::BeginMenu("File")) {
        state.save |= ImGui::MenuItem("Save the scene", "Ctrl+S");
        state.screenshot |= ImGui::MenuItem("Save the picture as PNG", "S");
        state.screenshotExr |= ImGui::MenuItem("Save its radiance as EXR", "Ctrl+E");
        state.close |= ImGui::MenuItem("Quit", "Q");
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Edit")) {
        state.undo |= ImGui::MenuItem("Undo", "Ctrl+Z", false, facts.canUndo);
        state.redo |= ImGui::MenuItem("Redo", "Ctrl+Shift+Z", false, facts.canRedo);
        state.frame |= ImGui::MenuItem("Frame the mesh", "F");
        if (ImGui::MenuItem("Camera home", "R")) state.document.camera = state.home;
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Show")) {
        ImGui::MenuItem("Compare two pictures", "V", &state.compare.on);
        ImGui::MenuItem("Explain a place", "I", &state.cursor.on);
        ImGui::MenuItem("Lights", "W", &state.showsLights);
        ImGui::MenuItem("Materials to choose from", "Y", &state.browser.on);
        ImGui::EndMenu();
    }
    if (ImGui::MenuItem("Keys (H)")) state.help = !state.help;
    ImGui::EndMenuBar();
}

/// In a window of its own, at the right.
void drawHelp(float margin, float scale)
{
    constexpr float kMeaning = 110.0f;  // where the second column begins
    ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x - margin, margin}, ImGuiCond_Always,
                            {1.0f, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    for (const scene::KeyHelp& line : scene::keyHelp()) {
        ImGui::TextDisabled("%s", line.key);
        ImGui::SameLine(kMeaning * scale);
        ImGui::TextUnformatted(line.meaning);
    }
    ImGui::End();
}

/// Fields of different sections may have the same name.
template <class Draw>
void drawSection(const char* name, const Draw& draw)
{
    if (!ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID(name);
    draw();
    ImGui::PopID();
}

void drawSections(scene::ViewState& state, const PanelFacts& facts)
{
    drawSection("Material", [&] { drawMaterialSection(state, facts); });
    drawSection("Light", [&] { drawLightSection(state, facts); });
    drawSection("View", [&] { drawViewSection(state); });
    drawSection("Drawing", [&] { drawTechniqueSection(state, facts); });
    if (!facts.message.empty()) ImGui::TextWrapped("%s", facts.message.c_str());
}

/// Letters and gaps are as large on a monitor of many pixels as on another.
float contentScale(GLFWwindow* window)
{
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window, &x, &y);
    int points = 1, pixels = 1;
    glfwGetWindowSize(window, &points, nullptr);
    glfwGetFramebufferSize(window, &pixels, nullptr);
    // Where a window is measured in points already, they are scaled already.
    const float done =
        static_cast<float>(std::max(1, pixels)) / static_cast<float>(std::max(1, points));
    return std::clamp(x / done, 1.0f, 4.0f);
}

}  // namespace

void chooseName(const char* label, std::string& chosen, const std::vector<std::string>& names)
{
    auto index = static_cast<int>(std::find(names.begin(), names.end(), chosen) - names.begin());
    const auto count = static_cast<int>(names.size());
    choose(label, index, count,
           [&](int i) { return shortName(i < count ? names[static_cast<size_t>(i)] : chosen); });
    if (index < count) chosen = names[static_cast<size_t>(index)];
}

Panel::Panel(GLFWwindow* window) : window_(window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // a viewer leaves no files behind
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 6.0f;
    ImGui::GetStyle().FrameRounding = 3.0f;
    scale_ = contentScale(window_);
    ImGui::GetStyle().ScaleAllSizes(scale_);
    ImFontConfig font;
    font.SizePixels = std::round(kFontPixels * scale_);
    ImGui::GetIO().Fonts->AddFontDefault(&font);
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Panel::~Panel()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

bool Panel::wantsMouse() const
{
    return ImGui::GetIO().WantCaptureMouse;
}

bool Panel::wantsKeys() const
{
    return ImGui::GetIO().WantCaptureKeyboard;
}

bool Panel::isHeld() const
{
    return ImGui::IsAnyItemActive();
}

void Panel::draw(scene::ViewState& state, const PanelFacts& facts)
{
    const scene::SceneMaterial* const shown = shownMaterial(state.document);
    setTitle("fbrdf - " + shortName(shown ? shown->source : ""), facts);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const float margin = kMargin * scale_, width = kPanelWidth * scale_;
    const float height = std::max(1.0f, ImGui::GetIO().DisplaySize.y - 2.0f * margin);
    ImGui::SetNextWindowPos({margin, margin}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, height});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("fbrdf", nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_MenuBar);
    ImGui::PushItemWidth(-kLabelWidth * scale_);
    drawMenu(state, facts);
    drawSections(state, facts);
    ImGui::PopItemWidth();
    ImGui::End();
    if (state.help) drawHelp(margin, scale_);
    drawBrowser(state, facts, scale_);
    drawLightHandles(state, facts, scale_);
    if (facts.compare) drawCompare(state.compare, *facts.compare);
    if (facts.cursor) drawCursor(state.cursor, *facts.cursor);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace fbrdf::viewer
