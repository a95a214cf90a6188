#include "PanelCompare.h"

#include "HeatScale.h"

#include <fbrdf/base/Srgb.h>

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <string>

namespace fbrdf::viewer {
namespace {

using scene::CompareMode;

constexpr float kMarginPixels = 12.0f, kCompareWidth = 400.0f, kHandle = 9.0f, kPanelEnd = 330.0f;
constexpr ImU32 kPaperColour = IM_COL32(12, 13, 16, 190), kInkColour = IM_COL32(235, 235, 235, 255);

ImU32 shownColour(const Vec3f& linear)
{
    const auto code = [&linear](int c) {
        return static_cast<int>(255.0f * srgbFromLinear(linear[c]) + 0.5f);
    };
    return IM_COL32(code(0), code(1), code(2), 255);
}

/// Between the panel and the window of fields, where the top of the picture is seen.
struct FreeColumns {
    float from = kPanelEnd, to = std::max(kPanelEnd, ImGui::GetIO().DisplaySize.x - kCompareWidth -
                                                         2.0f * kMarginPixels);
    float middle() const { return 0.5f * (from + to); }
};

/// A label behind all windows; `align`: the share of it that is to the left of x.
void drawTag(float x, float y, float align, const std::string& text)
{
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const FreeColumns free;
    const float left =
        std::max(free.from, std::min(x - align * size.x, free.to - size.x - kMarginPixels));
    list->AddRectFilled({left - 6.0f, y - 3.0f}, {left + size.x + 6.0f, y + size.y + 3.0f},
                        kPaperColour, 4.0f);
    list->AddText({left, y}, kInkColour, text.c_str());
}

std::string tagOf(const char* letter, const CompareFacts::Seat& seat)
{
    if (!seat.doing.empty()) return fmt::format("{}: {} ({})", letter, seat.title, seat.doing);
    return std::string(letter) + ": " + seat.title + (seat.standsIn ? " (is not there)" : "");
}

/// The line with a handle that can be dragged; a drag stops a wipe.
void drawLine(scene::CompareView& compare, const CompareFacts& facts)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float line = compare.lineAt(facts.seconds);
    const float x = line * size.x;
    ImGui::SetNextWindowPos({x - kHandle, 0.0f});
    ImGui::SetNextWindowSize({2.0f * kHandle, size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::Begin("##line", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton("##handle", {2.0f * kHandle, std::max(1.0f, size.y)});
    const bool isHeld = ImGui::IsItemActive();
    if (isHeld || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (isHeld) {
        compare.holds = compare.holds || compare.mode == CompareMode::wipe;
        compare.at = std::clamp(ImGui::GetIO().MousePos.x / std::max(1.0f, size.x), 0.0f, 1.0f);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->AddLine({x, 0.0f}, {x, size.y}, IM_COL32(255, 255, 255, isHeld ? 255 : 170), 1.5f);
    list->AddCircleFilled({x, 0.5f * size.y}, kHandle, kInkColour);
    list->AddTriangleFilled({x - 6.0f, 0.5f * size.y}, {x - 2.0f, 0.5f * size.y - 4.0f},
                            {x - 2.0f, 0.5f * size.y + 4.0f}, kPaperColour);
    list->AddTriangleFilled({x + 6.0f, 0.5f * size.y}, {x + 2.0f, 0.5f * size.y + 4.0f},
                            {x + 2.0f, 0.5f * size.y - 4.0f}, kPaperColour);
}

void drawHeatBar()
{
    constexpr float kBarLength = 260.0f, kBarThickness = 12.0f;
    constexpr int kBarSteps = 64;
    const float left = FreeColumns().middle() - 0.5f * kBarLength, top = 48.0f;
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled({left - 10.0f, top - 8.0f}, {left + kBarLength + 10.0f, top + 34.0f},
                        kPaperColour, 4.0f);
    for (int i = 0; i < kBarSteps; ++i) {
        const float from = left + kBarLength * static_cast<float>(i) / kBarSteps;
        list->AddRectFilled({from, top},
                            {from + kBarLength / kBarSteps + 1.0f, top + kBarThickness},
                            shownColour(heatColour((static_cast<float>(i) + 0.5f) / kBarSteps)));
    }
    for (const int tick : {0, 5, 10}) {
        const std::string text = fmt::format("{} %{}", tick, tick == 10 ? " of white" : "");
        const float x = left + kBarLength * static_cast<float>(tick) / 10.0f;
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const float align = static_cast<float>(tick) / 10.0f;
        list->AddText({x - align * width, top + kBarThickness + 2.0f}, kInkColour, text.c_str());
    }
}

/// Names above the pictures.
void drawTags(const scene::CompareView& compare, const CompareFacts& facts)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float y = kMarginPixels, middle = FreeColumns().middle();
    const std::string a = tagOf("A", facts.seats[0]), b = tagOf("B", facts.seats[1]);
    switch (compare.mode) {
        case CompareMode::split:
        case CompareMode::wipe: {
            const float x = compare.lineAt(facts.seconds) * size.x;
            drawTag(x - 16.0f, y, 1.0f, a);
            drawTag(x + 16.0f, y, 0.0f, b);
            return;
        }
        case CompareMode::flip:
            return drawTag(middle, y, 0.5f, compare.flipsToB(facts.seconds) ? b : a);
        case CompareMode::difference:
            return drawTag(middle, y, 0.5f,
                           fmt::format("|{} - {}| x {:g}", facts.seats[0].title,
                                       facts.seats[1].title, compare.gain));
        case CompareMode::heat: break;
    }
    drawHeatBar();
    drawTag(middle, y, 0.5f, fmt::format("|{} - {}|", facts.seats[0].title, facts.seats[1].title));
}

void chooseSide(const char* label, int& side, const CompareFacts& facts)
{
    const auto count = static_cast<int>(facts.offers.size());
    if (!ImGui::BeginCombo(label, facts.offers[static_cast<size_t>(side)].title.c_str(),
                           ImGuiComboFlags_HeightLarge))
        return;
    for (int i = 0; i < count; ++i) {
        const CompareFacts::Offer& offer = facts.offers[static_cast<size_t>(i)];
        ImGui::BeginDisabled(!offer.whyNot.empty());
        if (ImGui::Selectable(offer.title.c_str(), i == side)) side = i;
        ImGui::EndDisabled();
        if (!offer.whyNot.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
            ImGui::SetTooltip("%s", offer.whyNot.c_str());
    }
    ImGui::EndCombo();
}

void drawSeat(const CompareFacts::Seat& seat)
{
    if (!seat.problem.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.65f, 0.4f, 1.0f});
        ImGui::TextWrapped("%s", seat.problem.c_str());
        ImGui::PopStyleColor();
    }
    if (!seat.doing.empty()) ImGui::TextWrapped("%s ... (C: cancel)", seat.doing.c_str());
    if (seat.standsIn) return;
    std::string text =
        fmt::format("{}, sample {} of {}", seat.technique, seat.samples, seat.samplesWanted);
    if (seat.bytes > 0) text += fmt::format(", {} bytes", seat.bytes);
    ImGui::TextDisabled("%s", text.c_str());
    if (seat.note.empty()) return;
    ImGui::TextDisabled("%s", seat.note.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", seat.note.c_str());
}

void drawMode(scene::CompareView& compare)
{
    int mode = static_cast<int>(compare.mode);
    for (int i = 0; i < scene::kCompareModeCount; ++i) {
        if (i > 0) ImGui::SameLine();
        ImGui::RadioButton(compareModeName(static_cast<CompareMode>(i)), &mode, i);
    }
    compare.mode = static_cast<CompareMode>(mode);
    switch (compare.mode) {
        case CompareMode::split:
            ImGui::SliderFloat("line [ ]", &compare.at, 0.0f, 1.0f, "%.2f",
                               ImGuiSliderFlags_AlwaysClamp);
            break;
        case CompareMode::wipe:
        case CompareMode::flip: ImGui::Checkbox("hold (P)", &compare.holds); break;
        case CompareMode::difference:
            ImGui::SliderFloat("gain (D)", &compare.gain, scene::kLeastGain, scene::kMostGain,
                               "x %.0f",
                               ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
            break;
        case CompareMode::heat: break;
    }
}

}  // namespace

void drawCompare(scene::CompareView& compare, const CompareFacts& facts)
{
    if (!compare.on || facts.offers.empty()) return;
    const bool hasLine = compare.mode == CompareMode::split || compare.mode == CompareMode::wipe;
    if (hasLine) drawLine(compare, facts);
    drawTags(compare, facts);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - kMarginPixels, kMarginPixels}, ImGuiCond_FirstUseEver,
                            {1.0f, 0.0f});
    ImGui::SetNextWindowSize({kCompareWidth, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.72f);
    ImGui::Begin("compare (V)", &compare.on, ImGuiWindowFlags_NoResize);
    ImGui::PushItemWidth(-76.0f);
    drawMode(compare);
    chooseSide("A (1)", compare.a, facts);
    drawSeat(facts.seats[0]);
    ImGui::PushID("B");
    chooseSide("B (2)", compare.b, facts);
    drawSeat(facts.seats[1]);
    ImGui::PopID();
    if (ImGui::SmallButton("exchange (3)")) std::swap(compare.a, compare.b);
    ImGui::SliderInt("terms < >", &compare.terms, 1, scene::kMostCompareTerms, "%d",
                     ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("of singular values");
    ImGui::TextUnformatted(facts.numbers.empty() ? "no numbers yet" : facts.numbers.c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "of what is shown, over the pixels of objects and ground; noise of paths counts "
            "until it is gone");
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace fbrdf::viewer
