#include "Panel.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/LobeTable.h>

#include <fmt/core.h>
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <charconv>

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

/// What people would write for the place of a slider.
double shortNumber(float place)
{
    constexpr int kDigits = 4;
    const std::string text = numberText(static_cast<double>(place), kDigits);
    double number = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

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

void drawModel(ModelSpec& spec)
{
    for (const ModelParameter& parameter : spec.model->parameters) {
        const auto value = spec.values.find(parameter.name);
        if (value == spec.values.end()) continue;
        if (parameter.kind == ModelParameter::Kind::colour)
            drawColour(parameter, value->second);
        else
            drawScalar(parameter, value->second);
        if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
            ImGui::SetTooltip("%s", parameter.meaning.c_str());
    }
}

void drawFit(FitFields& fields)
{
    constexpr int kMostTexels = 128, kMostKilobytes = 64;
    ImGui::Separator();
    if (fields.model) drawModel(*fields.model);
    const std::vector<NamedForm>& forms = namedForms();
    const auto known = std::find_if(forms.begin(), forms.end(), [&fields](const NamedForm& form) {
        return form.name == fields.form;
    });
    auto index = static_cast<int>(known - forms.begin());
    const int before = index;
    choose("form", index, static_cast<int>(forms.size()), [&](int i) {
        return i < static_cast<int>(forms.size()) ? forms[static_cast<size_t>(i)].name
                                                  : fields.form;  // a sum
    });
    if (index != before) fields.form = forms[static_cast<size_t>(index)].name;
    ImGui::SliderInt("texels", &fields.resolution, 0, kMostTexels,
                     fields.resolution == 0 ? "the form's own" : "%d",
                     ImGuiSliderFlags_AlwaysClamp);
    ImGui::SliderInt("KiB", &fields.kilobytes, 0, kMostKilobytes,
                     fields.kilobytes == 0 ? "no limit" : "%d", ImGuiSliderFlags_AlwaysClamp);
    ImGui::Checkbox("smoothness by held-out error", &fields.choosesSmoothness);
    if (!fields.choosesSmoothness)
        ImGui::SliderFloat("smooth", &fields.smoothness, 1e-6f, 1.0f, "%.1e",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
}

void drawFitFacts(scene::ViewState& state, const FitFacts& fit)
{
    if (!fit.result.empty()) ImGui::TextWrapped("%s", fit.result.c_str());
    if (!fit.problem.empty()) ImGui::TextWrapped("%s", fit.problem.c_str());
    if (fit.doing.empty()) return;
    ImGui::TextWrapped("%s ...", fit.doing.c_str());
    if (ImGui::SmallButton("cancel (C)")) state.cancel = true;
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

void Panel::draw(scene::ViewState& state, const PanelFacts& facts, FitFields* fit)
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
    if (fit) drawFit(*fit);
    drawFitFacts(state, facts.fit);
    drawFacts(state, facts);
    if (state.help) drawHelp();
    ImGui::PopItemWidth();
    ImGui::End();
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace fbrdf::viewer
