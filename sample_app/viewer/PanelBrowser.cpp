#include "PanelSections.h"

#include <fmt/core.h>

#include <cstdint>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

constexpr float kSide = 72.0f, kStripGap = 12.0f;  // of a thumbnail, and beside the strip
constexpr size_t kLongestLabel = 11;               // letters below a thumbnail

std::string thumbnailLabel(const std::string& source)
{
    const std::filesystem::path path(source);
    std::string label = std::filesystem::exists(path) ? path.stem().string() : source;
    if (label.size() > kLongestLabel) label = label.substr(0, kLongestLabel - 2) + "..";
    return label;
}

/// A thumbnail, or an empty box, with its name. Returns whether it was clicked.
bool drawItem(const BrowserItem& item, bool isShown, bool isChosen, float side)
{
    ImGui::BeginGroup();
    const ImVec4 border = isChosen  ? ImVec4(1.0f, 0.78f, 0.24f, 1.0f)
                          : isShown ? ImVec4(0.35f, 0.6f, 1.0f, 1.0f)
                                    : ImVec4(0.0f, 0.0f, 0.0f, 0.0f);
    ImGui::PushStyleColor(ImGuiCol_Button, border);
    bool isClicked = false;
    if (item.texture != 0)
        isClicked = ImGui::ImageButton(reinterpret_cast<ImTextureID>(uintptr_t{item.texture}),
                                       {side, side}, {0.0f, 0.0f}, {1.0f, 1.0f}, 2);
    else
        isClicked = ImGui::Button(item.place < 0 ? "fit" : "...", {side + 4.0f, side + 4.0f});
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", item.source.c_str());
    if (isChosen) ImGui::SetScrollHereX();
    ImGui::TextUnformatted(thumbnailLabel(item.source).c_str());
    ImGui::EndGroup();
    return isClicked;
}

}  // namespace

void drawBrowser(scene::ViewState& state, const PanelFacts& facts, float scale)
{
    scene::BrowserView& browser = state.browser;
    if (!browser.on || !facts.browser) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float left = 336.0f * scale, gap = kStripGap * scale;
    const float height = kSide * scale + 3.4f * ImGui::GetTextLineHeightWithSpacing() +
                         ImGui::GetStyle().ScrollbarSize;
    ImGui::SetNextWindowPos({left, size.y - height - gap});
    ImGui::SetNextWindowSize({std::max(100.0f, size.x - left - gap), height});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("browser", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextDisabled("%s", browser.focused
                                  ? "materials: left, right and Enter choose one (Y ends that)"
                                  : "materials (Y: choose by keys)");
    const auto count = static_cast<int>(facts.browser->size());
    for (int i = 0; i < count; ++i) {
        ImGui::PushID(i);
        const BrowserItem& item = (*facts.browser)[static_cast<size_t>(i)];
        const bool isShown = item.place >= 0 && item.place == state.document.shown;
        if (drawItem(item, isShown, browser.focused && i == browser.chosen, kSide * scale)) {
            browser.chosen = i;
            browser.open = true;
        }
        ImGui::PopID();
        if (i + 1 < count) ImGui::SameLine();
    }
    ImGui::End();
}

}  // namespace fbrdf::viewer
