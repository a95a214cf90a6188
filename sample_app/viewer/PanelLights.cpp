#include "PanelSections.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::viewer {
namespace {

constexpr float kHandleRadius = 7.0f, kSelectedRadius = 11.0f;  // pixels
constexpr float kStepOfDrag = 0.01f;                            // world units a pixel

/// Intensities reach over powers of ten: the colour, the largest channel 1, and its factor.
bool drawColour(const char* unit, Vec3f& light)
{
    float strength = std::max({light.x, light.y, light.z});
    Vec3f colour = strength > 0.0f ? light / strength : Vec3f(1.0f);
    const bool coloured = ImGui::ColorEdit3("colour", &colour.x, ImGuiColorEditFlags_Float);
    const bool stronger = ImGui::DragFloat(unit, &strength, std::max(0.01f, 0.01f * strength), 0.0f,
                                           1e6f, "%.3g", ImGuiSliderFlags_AlwaysClamp);
    if (!coloured && !stronger) return false;
    light = std::max(strength, 0.0f) * clamp(colour, Vec3f(0.0f), Vec3f(1.0f));
    return true;
}

/// A direction that is typed may be 0 for a moment; then the old one stays.
bool drawDirection(const char* label, Vec3f& direction)
{
    Vec3f typed = direction;
    if (!ImGui::DragFloat3(label, &typed.x, kStepOfDrag, -1.0f, 1.0f, "%.2f") ||
        typed == Vec3f(0.0f))
        return false;
    direction = glm::normalize(typed);
    return true;
}

bool drawPlace(const char* label, Vec3f& place)
{
    return ImGui::DragFloat3(label, &place.x, kStepOfDrag, -1e6f, 1e6f, "%.2f");
}

bool drawLength(const char* label, float& length)
{
    return ImGui::DragFloat(label, &length, kStepOfDrag, 1e-3f, 1e6f, "%.2f",
                            ImGuiSliderFlags_AlwaysClamp);
}

bool drawCone(Light& light)
{
    constexpr float kLargest = 180.0f;
    const auto degree = static_cast<float>(kDegree);
    float inner = light.innerAngle / degree, outer = light.outerAngle / degree;
    const bool changed =
        static_cast<int>(ImGui::SliderFloat("inner", &inner, 0.0f, outer, "%.0f degrees")) +
            static_cast<int>(ImGui::SliderFloat("outer", &outer, inner, kLargest, "%.0f degrees")) >
        0;
    light.innerAngle = std::min(std::min(inner, outer) * degree, static_cast<float>(kPi));
    light.outerAngle = std::min(outer * degree, static_cast<float>(kPi));
    return changed;
}

bool drawLight(Light& light)
{
    Light changed = light;
    bool isChanged = false;
    if (light.type == Light::Type::directional) {
        isChanged |= drawDirection("direction", changed.position);
        isChanged |= drawColour("irradiance", changed.intensity);
    } else {
        isChanged |= drawPlace("position", changed.position);
        isChanged |= drawColour("W/sr", changed.intensity);
        isChanged |= ImGui::DragFloat("reaches", &changed.radius, kStepOfDrag, 0.0f, 1e6f,
                                      changed.radius > 0.0f ? "%.2f" : "everything",
                                      ImGuiSliderFlags_AlwaysClamp);
    }
    if (light.type == Light::Type::spot) {
        isChanged |= drawDirection("axis", changed.axis);
        isChanged |= drawCone(changed);
    }
    if (isChanged) light = changed;
    return isChanged;
}

bool drawAreaLight(AreaLight& light)
{
    using Shape = AreaLight::Shape;
    AreaLight changed = light;
    bool isChanged = drawColour("radiance", changed.radiance);
    if (light.shape != Shape::polygon)
        isChanged |= drawPlace(light.shape == Shape::tube ? "from" : "position", changed.position);
    if (light.shape == Shape::tube) isChanged |= drawPlace("to", changed.end);
    if (light.shape == Shape::disc) isChanged |= drawDirection("normal", changed.normal);
    if (light.shape == Shape::rectangle) {
        isChanged |= drawPlace("half side u", changed.axisU);
        isChanged |= drawPlace("half side v", changed.axisV);
    } else if (light.shape != Shape::polygon) {
        isChanged |= drawLength("size", changed.size);
    }
    if (light.shape != Shape::sphere && light.shape != Shape::tube)
        isChanged |= ImGui::Checkbox("two-sided", &changed.twoSided);
    // What is typed may be no light for a moment, as a rectangle of no area.
    if (!isChanged || !whyInvalid(changed).empty()) return false;
    light = changed;
    return true;
}

/// The fields of the selected light. They are those of the document: before the lights orbit.
void drawSelected(scene::ViewState& state, const PanelFacts& facts)
{
    scene::SceneLights& lights = state.document.lights;
    scene::LightSet set = lights.made > 0 ? *facts.drawnLights : lights.list;
    const auto count = static_cast<int>(set.size());
    if (state.light < 0 || state.light >= count) return;
    const auto index = static_cast<size_t>(state.light);
    ImGui::TextUnformatted(
        fmt::format("{} light, {} of {}", lightKindName(kindOf(set, state.light)), index + 1, count)
            .c_str());
    const bool isChanged = index < set.lights.size()
                               ? drawLight(set.lights[index])
                               : drawAreaLight(set.areaLights[index - set.lights.size()]);
    if (isChanged) lights = {0, lights.seed, std::move(set)};
    if (ImGui::Button("remove (Del)")) state.lightWishes.remove = true;
}

}  // namespace

void drawLightSection(scene::ViewState& state, const PanelFacts& facts)
{
    constexpr int kMostBySlider = 4096;
    scene::SceneLights& lights = state.document.lights;
    int made = lights.made > 0 ? lights.made : facts.lights;
    if (ImGui::SliderInt("lights", &made, 1, kMostBySlider,
                         lights.made > 0 ? "%d made" : "%d of a list",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        lights.made = made;
    if (ImGui::BeginCombo("add", "a light (A)")) {
        for (int kind = 0; kind < scene::kLightKinds; ++kind)
            if (ImGui::Selectable(lightKindName(static_cast<scene::LightKind>(kind))))
                state.lightWishes.add = kind;
        ImGui::EndCombo();
    }
    ImGui::Checkbox("orbit", &state.document.orbiting);
    ImGui::SameLine();
    ImGui::Checkbox("show (W)", &state.showsLights);
    ImGui::SameLine();
    if (ImGui::Button("next (N)")) state.lightWishes.next = true;
    drawSelected(state, facts);
}

void drawLightHandles(const scene::ViewState& state, const PanelFacts& facts, float scale)
{
    const ImGuiIO& io = ImGui::GetIO();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const scene::LightHandle& handle : facts.handles) {
        const ImVec2 at(static_cast<float>(handle.at.x) / io.DisplayFramebufferScale.x,
                        static_cast<float>(handle.at.y) / io.DisplayFramebufferScale.y);
        const Vec3f& c = handle.colour;
        const ImU32 colour =
            ImGui::ColorConvertFloat4ToU32({std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z), 1.0f});
        const ImU32 dark = IM_COL32(0, 0, 0, 200);
        const int corners = handle.kind == scene::LightKind::directional ? 3
                            : handle.kind >= scene::LightKind::sphere    ? 4
                                                                         : 20;
        // Triangles and squares of the same area as the circle.
        const float radius = scale * kHandleRadius *
                             (corners == 3   ? 1.55f
                              : corners == 4 ? 1.25f
                                             : 1.0f);
        list.AddNgonFilled(at, radius + 1.5f, dark, corners);
        list.AddNgonFilled(at, radius, colour, corners);
        if (handle.kind == scene::LightKind::spot)
            list.AddCircleFilled(at, 0.4f * scale * kHandleRadius, dark);
        if (handle.light == state.light)
            list.AddCircle(at, scale * kSelectedRadius, IM_COL32(255, 200, 60, 255), 0, 2.0f);
    }
}

}  // namespace fbrdf::viewer
