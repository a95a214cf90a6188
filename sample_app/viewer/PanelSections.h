// PanelSections.h - the parts of the panel of Dear ImGui, a file for each, and what they share.
#pragma once
#include "Panel.h"

#include <imgui.h>

#include <string>
#include <vector>

namespace fbrdf::viewer {

/// Each draws fields, and changes the state as the user wants.
void drawMaterialSection(scene::ViewState& state, const PanelFacts& facts);
void drawViewSection(scene::ViewState& state);
void drawLightSection(scene::ViewState& state, const PanelFacts& facts);
void drawTechniqueSection(scene::ViewState& state, const PanelFacts& facts);
/// A strip of thumbnails below the picture. scale: of letters.
void drawBrowser(scene::ViewState& state, const PanelFacts& facts, float scale);
/// Draws over the picture where lights are. scale: of letters.
void drawLightHandles(const scene::ViewState& state, const PanelFacts& facts, float scale);

/// A list to choose one of; changes `index` to what is clicked.
template <class Name>
void choose(const char* label, int& index, int count, const Name& name)
{
    if (!ImGui::BeginCombo(label, std::string(name(index)).c_str())) return;
    for (int i = 0; i < count; ++i)
        if (ImGui::Selectable((std::string(name(i)) + "##" + std::to_string(i)).c_str(),
                              i == index))
            index = i;
    ImGui::EndCombo();
}

/// The same of names, which are shown without folders.
void chooseName(const char* label, std::string& chosen, const std::vector<std::string>& names);

/// What people would write for the place of a slider.
double shortNumber(float place);

}  // namespace fbrdf::viewer
