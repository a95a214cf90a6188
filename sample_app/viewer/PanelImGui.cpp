#include "Panel.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fbrdf/brdf/LobeTable.h>

#include <fmt/core.h>
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace fbrdf::viewer {
namespace {

constexpr float kMargin = 12.0f, kPanelWidth = 270.0f;

/// A list to choose one of; changes `index` to what is clicked.
template <class Name>
void choose(const char* label, int& index, int count, const Name& name)
{
    if (!ImGui::BeginCombo(label, std::string(name(index)).c_str())) return;
    for (int i = 0; i < count; ++i)
        if (ImGui::Selectable(std::string(name(i)).c_str(), i == index)) index = i;
    ImGui::EndCombo();
}

void drawFields(scene::ViewState& state, const PanelFacts& facts)
{
    const auto nameIn = [](const std::vector<std::string>& names) {
        return [&names](int i) { return names[static_cast<size_t>(i)]; };
    };
    choose("material", state.material, state.materialCount, nameIn(facts.materials));
    choose("mesh", state.mesh, state.meshCount, nameIn(facts.meshes));
    int technique = static_cast<int>(state.technique);
    choose("technique", technique, scene::kViewTechniqueCount, [](int i) {
        return std::string(viewTechniqueName(static_cast<scene::ViewTechnique>(i)));
    });
    state.technique = static_cast<scene::ViewTechnique>(technique);
    if (state.madeLights)
        ImGui::SliderInt("lights", &state.lightCount, 1, scene::kMostLights, "%d",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    else
        ImGui::Text("%d lights from a file", state.lightCount);
    choose("environment", state.environment, state.environmentCount, nameIn(facts.environments));
    ImGui::SliderFloat("rotation", &state.environmentDegrees, -180.0f, 180.0f, "%.0f degrees");
    ImGui::SliderFloat("intensity", &state.environmentIntensity, 0.0f, 4.0f, "%.2f");
    choose("lobes", state.environmentLobes, kMostTiltedLobes + 1,
           [](int i) { return i == 0 ? std::string("all") : std::to_string(i); });
    ImGui::Checkbox("turntable", &state.turning);
    ImGui::SliderFloat("exposure", &state.exposure, 0.01f, 100.0f, "%.2f",
                       ImGuiSliderFlags_Logarithmic);
}

void drawFacts(const scene::ViewState& state, const PanelFacts& facts)
{
    const auto line = [](const std::string& text) { ImGui::TextUnformatted(text.c_str()); };
    ImGui::Separator();
    if (isOnCpu(state.technique))
        line(fmt::format("{:.1f} ms on the CPU, in double", facts.milliseconds));
    else
        line(fmt::format("{:.2f} ms, {} pass{}, {} look-ups", facts.milliseconds, facts.passes,
                         facts.passes == 1 ? "" : "es", facts.maxLookups));
    line(fmt::format("sample {} of {}", facts.samples, facts.samplesWanted));
    line(fmt::format("{} triangles", facts.triangles));
    ImGui::TextWrapped("%s", facts.renderer.c_str());
    if (!facts.message.empty()) ImGui::TextWrapped("%s", facts.message.c_str());
    if (!state.help) ImGui::TextDisabled("H: keys");
}

void drawHelp()
{
    ImGui::Separator();
    for (const scene::KeyHelp& line : scene::keyHelp()) {
        ImGui::TextDisabled("%-12s", line.key);
        ImGui::SameLine(100.0f);
        ImGui::TextUnformatted(line.meaning);
    }
}

}  // namespace

Panel::Panel(GLFWwindow* window) : window_(window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // a viewer leaves no files behind
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 6.0f;
    ImGui::GetStyle().FrameRounding = 3.0f;
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

void Panel::draw(scene::ViewState& state, const PanelFacts& facts)
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({kMargin, kMargin}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({kPanelWidth, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.72f);
    ImGui::Begin("fbrdf", nullptr, ImGuiWindowFlags_NoResize);
    ImGui::PushItemWidth(-80.0f);
    drawFields(state, facts);
    drawFacts(state, facts);
    if (state.help) drawHelp();
    ImGui::PopItemWidth();
    ImGui::End();
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace fbrdf::viewer
