#include "PanelSections.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/sources/Model.h>

#include <algorithm>
#include <charconv>

namespace fbrdf::viewer {
namespace {

/// A number of a model; those that reach over several powers of ten move along a logarithm.
void drawScalar(const ModelParameter& parameter, Vec3d& value)
{
    constexpr double kWide = 100.0;
    const bool isWide = parameter.lower >= 0.0 && parameter.upper > kWide;
    auto number = static_cast<float>(value.x);
    if (ImGui::SliderFloat(
            parameter.name.c_str(), &number, static_cast<float>(parameter.lower),
            static_cast<float>(parameter.upper), "%.3g",
            ImGuiSliderFlags_AlwaysClamp | (isWide ? ImGuiSliderFlags_Logarithmic : 0)))
        value = Vec3d(std::clamp(shortNumber(number), parameter.lower, parameter.upper));
}

void drawColour(const ModelParameter& parameter, Vec3d& value)
{
    Vec3f colour(value);
    if (ImGui::ColorEdit3(parameter.name.c_str(), &colour.x, ImGuiColorEditFlags_Float))
        for (int c = 0; c < 3; ++c)
            value[c] = std::clamp(shortNumber(colour[c]), parameter.lower, parameter.upper);
}

/// Shows the first of the parameters that it sets; when it is moved, they are one number.
void drawShorthand(const ModelParameter& parameter, ModelValues& values)
{
    const Vec3d before = values.at(parameter.sets.front());
    Vec3d value = before;
    drawScalar(parameter, value);
    if (value == before) return;
    for (const std::string& set : parameter.sets) values.at(set) = value;
}

/// Changes the source of a material to the model that its sliders say.
void drawModel(std::string& source)
{
    ModelSpec spec = parseModelSpec(source);
    const ModelValues before = spec.values;
    for (const ModelParameter& parameter : spec.model->parameters) {
        if (parameter.kind == ModelParameter::Kind::shorthand)
            drawShorthand(parameter, spec.values);
        else if (parameter.kind == ModelParameter::Kind::colour)
            drawColour(parameter, spec.values.at(parameter.name));
        else
            drawScalar(parameter, spec.values.at(parameter.name));
        if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
            ImGui::SetTooltip("%s", parameter.meaning.c_str());
    }
    if (spec.values != before) source = modelSpecText(spec);
}

void drawSmoothness(std::optional<double>& smoothness)
{
    constexpr double kFirst = 1e-3;
    bool isChosen = !smoothness;
    if (ImGui::Checkbox("smoothness by held-out error", &isChosen)) {
        smoothness.reset();
        if (!isChosen) smoothness = kFirst;
    }
    if (!smoothness) return;
    auto number = static_cast<float>(*smoothness);
    if (ImGui::SliderFloat("smooth", &number, 1e-6f, 1.0f, "%.1e",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        smoothness = shortNumber(number);
}

void drawFit(scene::SceneMaterial& fields)
{
    constexpr int kMostTexels = 128, kMostKilobytes = 64;
    if (namesModel(fields.source)) drawModel(fields.source);
    const std::vector<NamedForm>& forms = namedForms();
    const auto known = std::find_if(forms.begin(), forms.end(), [&fields](const NamedForm& form) {
        return form.name == fields.form;
    });
    auto index = static_cast<int>(known - forms.begin());
    const int before = index;
    choose("form", index, static_cast<int>(forms.size()), [&](int i) {
        return i < static_cast<int>(forms.size()) ? forms[static_cast<size_t>(i)].name
                                                  : fields.form;  // a sum, or auto
    });
    if (index != before) fields.form = forms[static_cast<size_t>(index)].name;
    ImGui::SliderInt("texels", &fields.resolution, 0, kMostTexels,
                     fields.resolution == 0 ? "the form's own" : "%d",
                     ImGuiSliderFlags_AlwaysClamp);
    ImGui::SliderInt("KiB", &fields.kilobytes, 0, kMostKilobytes,
                     fields.kilobytes == 0 ? "no limit" : "%d", ImGuiSliderFlags_AlwaysClamp);
    drawSmoothness(fields.smoothness);
}

void drawFitFacts(scene::ViewState& state, const FitFacts& fit)
{
    if (!fit.result.empty()) ImGui::TextWrapped("%s", fit.result.c_str());
    if (!fit.problem.empty()) ImGui::TextWrapped("%s", fit.problem.c_str());
    if (fit.doing.empty()) return;
    ImGui::TextWrapped("%s ...", fit.doing.c_str());
    if (ImGui::SmallButton("cancel (C)")) state.cancel = true;
}

}  // namespace

double shortNumber(float place)
{
    constexpr int kDigits = 4;
    const std::string text = numberText(static_cast<double>(place), kDigits);
    double number = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

void drawMaterialSection(scene::ViewState& state, const PanelFacts& facts)
{
    scene::Document& document = state.document;
    choose("material", document.shown, static_cast<int>(document.materials.size()), [&](int i) {
        const scene::SceneMaterial& material = document.materials[static_cast<size_t>(i)];
        return shortName(material.source) + (material.slot < 0 ? " ..." : "");
    });
    scene::SceneMaterial* const material = shownMaterial(document);
    if (material && facts.isFitted) drawFit(*material);
    drawFitFacts(state, facts.fit);
}

}  // namespace fbrdf::viewer
