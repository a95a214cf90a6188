#include "PanelCompare.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace fbrdf::viewer {
namespace {

constexpr float kBrowserHeight = 150.0f;  // of the materials along the lower border
constexpr float kCursorWidth = 340.0f, kPlotRadius = 96.0f, kMapPixels = 64.0f;
constexpr ImU32 kColourOf[] = {IM_COL32(90, 180, 255, 255), IM_COL32(255, 170, 60, 255)};
constexpr ImU32 kGridColour = IM_COL32(255, 255, 255, 46), kDimInk = IM_COL32(210, 210, 210, 255),
                kSampleColour = IM_COL32(255, 255, 255, 170);

/// Takes shares of the plot's radius to the screen.
struct PlotFrame {
    ImVec2 origin;

    ImVec2 at(const Vec2<double>& place) const
    {
        return {origin.x + kPlotRadius * static_cast<float>(place.x),
                origin.y - kPlotRadius * static_cast<float>(place.y)};
    }
};

void drawGrid(ImDrawList& list, const PlotFrame& frame, double most)
{
    for (const double share : {0.125, 1.0}) {
        const float radius = kPlotRadius * static_cast<float>(std::cbrt(share));
        list.PathArcTo(frame.origin, radius, static_cast<float>(kPi), static_cast<float>(2.0 * kPi),
                       48);
        list.PathStroke(kGridColour, 0, 1.0f);
        const std::string text = fmt::format("{:.3g}", share * most);
        list.AddText(
            {frame.origin.x + radius - ImGui::CalcTextSize(text.c_str()).x, frame.origin.y + 2.0f},
            kDimInk, text.c_str());
    }
    for (const double degrees : {-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0})
        list.AddLine(frame.origin, frame.at(plotted({degrees, 1.0}, 1.0)), kGridColour);
}

/// The light from its side, and the view.
void drawDirections(ImDrawList& list, const PlotFrame& frame, const ProbeAngles& angles)
{
    const auto ray = [&](double theta, ImU32 colour, const char* name) {
        const ImVec2 end = frame.at(plotted({theta, 1.0}, 1.0));
        list.AddLine(frame.origin, end, colour, 1.5f);
        list.AddText({end.x - 6.0f, end.y - 14.0f}, colour, name);
    };
    ray(-angles.theta_i, IM_COL32(255, 240, 140, 200), "wi");
    if (!(angles.theta_o < 90.0)) return;
    const bool isInPlane = std::min(angles.phi, 180.0 - angles.phi) < kPlaneTolerance;
    ray(angles.phi > 90.0 ? angles.theta_o : -angles.theta_o,
        IM_COL32(160, 255, 160, isInPlane ? 220 : 110), isInPlane ? "wo" : "wo, off plane");
}

void drawCurve(ImDrawList& list, const PlotFrame& frame, const PolarCurve& curve, double most,
               ImU32 colour)
{
    std::vector<ImVec2> points;
    points.reserve(curve.size());
    for (const PolarPoint& point : curve) points.push_back(frame.at(plotted(point, most)));
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.8f);
}

void drawPlot(const CursorFacts& facts)
{
    constexpr float kBelow = 18.0f, kAbove = 18.0f;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const PlotFrame frame{{corner.x + 0.5f * width, corner.y + kAbove + kPlotRadius}};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawGrid(list, frame, facts.most);
    drawDirections(list, frame, facts.angles);
    for (const PolarPoint& sample : facts.samples)
        list.AddCircleFilled(frame.at(plotted(sample, facts.most)), 1.7f, kSampleColour, 6);
    for (size_t i = 2; i-- > 0;)
        drawCurve(list, frame, facts.subjects[i].curve, facts.most, kColourOf[i]);
    ImGui::Dummy({width, kAbove + kPlotRadius + kBelow});
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("f in the plane of incidence, 1/sr, drawn by its cube root");
    ImGui::TextDisabled("%s", facts.samplesNote.c_str());
}

std::string valueText(const Vec3d& f)
{
    return fmt::format("{:.4g} {:.4g} {:.4g}", f.x, f.y, f.z);
}

/// A map with the place that is read, and its texels in words.
void drawMap(const MapView& map)
{
    const float scale = kMapPixels / static_cast<float>(std::max(map.width, map.height));
    const float width = scale * static_cast<float>(map.width),
                height = std::max(10.0f, scale * static_cast<float>(map.height));
    ImGui::BeginGroup();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(map.texture)),
                 {width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 place{corner.x + width * (static_cast<float>(map.position.x) + 0.5f) /
                                      static_cast<float>(map.width),
                       corner.y + height * (static_cast<float>(map.position.y) + 0.5f) /
                                      static_cast<float>(map.height)};
    list.AddRect(corner, {corner.x + width, corner.y + height}, kGridColour);
    list.AddCircle(place, 5.0f, IM_COL32(0, 0, 0, 255), 12, 3.0f);
    list.AddCircle(place, 5.0f, IM_COL32(90, 255, 120, 255), 12, 1.5f);
    ImGui::TextUnformatted(map.name.c_str());
    ImGui::TextDisabled("%.1f %.1f", map.position.x, map.position.y);
    ImGui::EndGroup();
    if (!ImGui::IsItemHovered()) return;
    std::string text = "F = " + valueText(map.value);
    for (int i = 0; i < map.texels.count; ++i) {
        const int texel = map.texels.texel[static_cast<size_t>(i)];
        const int plane = map.width * map.height;
        text += fmt::format("\ntexel {} {}", texel % map.width, texel % plane / map.width);
        if (texel >= plane || map.position.z > 0.0) text += fmt::format(" {}", texel / plane);
        text += fmt::format(": weight {:.3f}", map.texels.weight[static_cast<size_t>(i)]);
    }
    ImGui::SetTooltip("%s", text.c_str());
}

void drawSubject(const CursorFacts::Subject& subject, size_t index, bool withMaps)
{
    ImGui::PushStyleColor(ImGuiCol_Text, kColourOf[index]);
    ImGui::TextWrapped("%s: %s", index == 0 ? "A" : "B", subject.title.c_str());
    ImGui::PopStyleColor();
    ImGui::Text("f = %s", valueText(subject.f).c_str());
    if (!withMaps) return;
    constexpr size_t kMapsALine = 2, kMostMaps = 6;
    for (size_t i = 0; i < std::min(kMostMaps, subject.maps.size()); ++i) {
        if (i % kMapsALine != 0) ImGui::SameLine(0.5f * kCursorWidth);
        drawMap(subject.maps[i]);
    }
    if (subject.maps.size() > kMostMaps)
        ImGui::TextDisabled("and %d look-ups more",
                            static_cast<int>(subject.maps.size() - kMostMaps));
}

/// A cross hair where the place is.
void drawPlace(const scene::CursorView& cursor)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const ImVec2 place{static_cast<float>(cursor.x) * size.x,
                       static_cast<float>(cursor.y) * size.y};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircle(place, 7.0f, IM_COL32(0, 0, 0, 255), 16, 3.0f);
    list.AddCircle(place, 7.0f, IM_COL32(90, 255, 120, 255), 16, 1.5f);
}

}  // namespace

void drawCursor(scene::CursorView& cursor, const CursorFacts& facts)
{
    if (!cursor.on) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f) cursor.followsMouse = true;
    if (cursor.followsMouse && !io.WantCaptureMouse && ImGui::IsMousePosValid()) {
        cursor.x = std::clamp(double(io.MousePos.x / std::max(1.0f, io.DisplaySize.x)), 0.0, 1.0);
        cursor.y = std::clamp(double(io.MousePos.y / std::max(1.0f, io.DisplaySize.y)), 0.0, 1.0);
    }
    drawPlace(cursor);
    ImGui::SetNextWindowPos({io.DisplaySize.x - 12.0f, io.DisplaySize.y - 12.0f - kBrowserHeight},
                            ImGuiCond_FirstUseEver, {1.0f, 1.0f});
    ImGui::SetNextWindowSize({kCursorWidth, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("under the cursor (I)", &cursor.on, ImGuiWindowFlags_NoResize);
    if (!facts.hits) {
        ImGui::TextDisabled("no object there; arrow keys move the place");
    } else {
        const ProbeAngles& a = facts.angles;
        ImGui::Text("theta_i %.1f  theta_o %.1f  phi %.1f", a.theta_i, a.theta_o, a.phi);
        ImGui::SameLine();
        ImGui::TextDisabled("%s", facts.light.name.c_str());
        ImGui::Text("theta_h %.1f  theta_d %.1f  phi_d %.1f", a.theta_h, a.theta_d, a.phi_d);
        drawPlot(facts);
        const auto& [first, second] = facts.subjects;
        drawSubject(first, 0, true);
        drawSubject(second, 1, second.material != first.material);
    }
    ImGui::End();
}

}  // namespace fbrdf::viewer
