#include "PanelSections.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace fbrdf::viewer {
namespace {

constexpr std::array<ColourFormat, 3> kTargets{ColourFormat::rgba32f, ColourFormat::rgba16f,
                                               ColourFormat::rgba8};

void line(const std::string& text)
{
    ImGui::TextUnformatted(text.c_str());
}

void drawLimit(const char* label, int& limit, int most)
{
    ImGui::SliderInt(label, &limit, 0, most, limit == 0 ? "no limit" : "%d",
                     ImGuiSliderFlags_AlwaysClamp);
}

void drawChoices(scene::Document& document)
{
    int technique = static_cast<int>(document.technique);
    choose("technique", technique, scene::kViewTechniqueCount, [](int i) {
        return std::string(viewTechniqueName(static_cast<scene::ViewTechnique>(i)));
    });
    document.technique = static_cast<scene::ViewTechnique>(technique);
    if (isOnCpu(document.technique)) return;
    if (runtimeTechnique(document.technique) == Technique::batched)
        ImGui::SliderInt("a pass", &document.limits.lightsPerPass, 1, 64, "%d lights",
                         ImGuiSliderFlags_AlwaysClamp);
    drawLimit("look-ups", document.limits.lookups, 8);
    drawLimit("max lights", document.limits.lights, 64);
    int lookUp = static_cast<int>(document.lookUp);
    choose("maps", lookUp, 3,
           [](int i) { return std::string(lookUpName(static_cast<LookUp>(i))); });
    document.lookUp = static_cast<LookUp>(lookUp);
    ImGui::Checkbox("filter in the shader", &document.precise);
    auto target = static_cast<int>(std::find(kTargets.begin(), kTargets.end(), document.target) -
                                   kTargets.begin());
    choose("target", target, static_cast<int>(kTargets.size()),
           [](int i) { return std::string(colourFormatName(kTargets[static_cast<size_t>(i)])); });
    document.target = kTargets[static_cast<size_t>(target)];
}

const char* blendName(Blend blend)
{
    switch (blend) {
        case Blend::replace: return "replace";
        case Blend::add: return "add";
        case Blend::multiply: return "multiply";
    }
    return "";
}

void drawPasses(const PanelFacts& facts)
{
    if (!facts.passRows || facts.passRows->empty()) return;
    if (!ImGui::BeginTable("passes", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
    for (const char* name : {"look", "blend", "ms"}) ImGui::TableSetupColumn(name);
    ImGui::TableHeadersRow();
    const std::string groundName = scene::Ground::material().name;
    for (const PassRow& row : *facts.passRows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        line((row.material == groundName ? row.material + " " : "") + row.name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.material.c_str());
        ImGui::TableNextColumn();
        line(std::to_string(row.lookups));
        ImGui::TableNextColumn();
        line(blendName(row.blend));
        ImGui::TableNextColumn();
        line(row.milliseconds ? fmt::format("{:.2f}", *row.milliseconds) : "-");
    }
    ImGui::EndTable();
    if (facts.passesLeft > 0) line(fmt::format("and {} more", facts.passesLeft));
}

/// What was left out or replaced, and why.
void drawReasons(const scene::Document& document, const scene::Stats& stats)
{
    if (stats.lightsDropped > 0)
        ImGui::TextWrapped(
            "%d of %d lights dropped: %s", stats.lightsDropped, stats.lightsGiven,
            document.limits.lights > 0 ? "the weakest, above the limit" : "they are not valid");
    for (const std::string& reason :
         {stats.whyReplaced, stats.whyNoEnvironment, stats.whyNotSampled})
        if (!reason.empty()) ImGui::TextWrapped("%s", reason.c_str());
}

void drawCost(const scene::Document& document, const PanelFacts& facts)
{
    const scene::Stats& stats = *facts.stats;
    line(fmt::format("{:.2f} ms, {} pass{}, {} look-ups", facts.milliseconds, facts.passes,
                     facts.passes == 1 ? "" : "es", facts.maxLookups));
    line(fmt::format("error at most {:.2g} % + {:.2g}", 100.0 * stats.errorRelative,
                     stats.errorAbsolute));
    if (stats.environmentError > 0.0)
        line(fmt::format("lobes are off by {:.2g} %", 100.0 * stats.environmentError));
    line("lights add up in " + stats.accumulation);
    drawReasons(document, stats);
    drawPasses(facts);
}

}  // namespace

void drawTechniqueSection(scene::ViewState& state, const PanelFacts& facts)
{
    drawChoices(state.document);
    if (state.compare.on)
        line("two pictures, see compare");
    else if (isOnCpu(state.document.technique))
        line(fmt::format("{:.1f} ms on the CPU, in double", facts.milliseconds));
    else
        drawCost(state.document, facts);
    if (!state.compare.on) line(fmt::format("sample {} of {}", facts.samples, facts.samplesWanted));
    line(fmt::format("{} triangles", facts.triangles));
    ImGui::TextWrapped("%s", facts.renderer.c_str());
}

}  // namespace fbrdf::viewer
