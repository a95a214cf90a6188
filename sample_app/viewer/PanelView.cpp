#include "PanelSections.h"

#include <fbrdf/brdf/LobeTable.h>

namespace fbrdf::viewer {
namespace {

void drawEnvironment(scene::SceneEnvironment& environment, const scene::ViewState& state)
{
    chooseName("environment", environment.name, state.environments);
    if (environment.name.empty()) return;
    ImGui::SliderFloat("rotation", &environment.degrees, -180.0f, 180.0f, "%.0f degrees");
    ImGui::SliderFloat("intensity", &environment.intensity, 0.0f, 4.0f, "%.2f");
    choose("lobes", environment.lobes, kMostTiltedLobes + 1,
           [](int i) { return i == 0 ? std::string("all") : std::to_string(i); });
}

/// Behind the objects: the environment, a colour, or nothing.
void drawBackground(scene::Document& document)
{
    scene::Background& background = document.background;
    int kind = background.environment ? 1 : background.colour ? 2 : 0;
    choose("background", kind, 3, [](int i) {
        constexpr const char* kNames[] = {"none", "environment", "a colour"};
        return std::string(kNames[i]);
    });
    background.environment = kind == 1;
    if (kind != 2) {
        background.colour.reset();
        return;
    }
    Vec3f colour = background.colour.value_or(Vec3f(0.2f));
    ImGui::ColorEdit3("colour", &colour.x, ImGuiColorEditFlags_Float);
    background.colour = max(colour, Vec3f(0.0f));
}

}  // namespace

void drawViewSection(scene::ViewState& state)
{
    scene::Document& document = state.document;
    chooseName("mesh", document.mesh, state.meshes);
    drawEnvironment(document.environment, state);
    drawBackground(document);
    ImGui::SliderFloat("exposure", &document.exposure, 0.01f, 100.0f, "%.2f",
                       ImGuiSliderFlags_Logarithmic);
    ImGui::Checkbox("tone map", &document.toneMap);
    ImGui::SameLine();
    ImGui::Checkbox("turntable", &document.turning);
    ImGui::Checkbox("ground", &document.ground);
    ImGui::SameLine();
    ImGui::Checkbox("shadows", &document.shadows);
}

}  // namespace fbrdf::viewer
