#include "Panel.h"
#include "PanelCompare.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/sources/Model.h>

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
        if (ImGui::Selectable((std::string(name(i)) + "##" + std::to_string(i)).c_str(),
                              i == index))
            index = i;
    ImGui::EndCombo();
}

/// The same of names, which are shown without folders.
void chooseName(const char* label, std::string& chosen, const std::vector<std::string>& names)
{
    auto index = static_cast<int>(std::find(names.begin(), names.end(), chosen) - names.begin());
    const auto count = static_cast<int>(names.size());
    choose(label, index, count,
           [&](int i) { return shortName(i < count ? names[static_cast<size_t>(i)] : chosen); });
    if (index < count) chosen = names[static_cast<size_t>(index)];
}

void drawLights(scene::SceneLights& lights, const PanelFacts& facts)
{
    constexpr int kMostBySlider = 4096;
    int made = lights.made > 0 ? lights.made : facts.lights;
    if (ImGui::SliderInt("lights", &made, 1, kMostBySlider,
                         lights.made > 0 ? "%d made" : "%d of a list",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        lights.made = made;
}

void drawEnvironment(scene::SceneEnvironment& environment, const scene::ViewState& state)
{
    chooseName("environment", environment.name, state.environments);
    ImGui::SliderFloat("rotation", &environment.degrees, -180.0f, 180.0f, "%.0f degrees");
    ImGui::SliderFloat("intensity", &environment.intensity, 0.0f, 4.0f, "%.2f");
    choose("lobes", environment.lobes, kMostTiltedLobes + 1,
           [](int i) { return i == 0 ? std::string("all") : std::to_string(i); });
}

void drawFields(scene::ViewState& state, const PanelFacts& facts)
{
    scene::Document& document = state.document;
    choose("material", document.shown, static_cast<int>(document.materials.size()), [&](int i) {
        const scene::SceneMaterial& material = document.materials[static_cast<size_t>(i)];
        return shortName(material.source) + (material.slot < 0 ? " ..." : "");
    });
    chooseName("mesh", document.mesh, state.meshes);
    int technique = static_cast<int>(document.technique);
    choose("technique", technique, scene::kViewTechniqueCount, [](int i) {
        return std::string(viewTechniqueName(static_cast<scene::ViewTechnique>(i)));
    });
    document.technique = static_cast<scene::ViewTechnique>(technique);
    drawLights(document.lights, facts);
    drawEnvironment(document.environment, state);
    ImGui::Checkbox("turntable", &document.turning);
    ImGui::Checkbox("compare (V)", &state.compare.on);
    ImGui::SameLine();
    ImGui::Checkbox("explain (I)", &state.cursor.on);
    ImGui::SliderFloat("exposure", &document.exposure, 0.01f, 100.0f, "%.2f",
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

/// Changes the source of a material to the model that its sliders say.
void drawModel(std::string& source)
{
    ModelSpec spec = parseModelSpec(source);
    const ModelValues before = spec.values;
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
    ImGui::Separator();
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

void drawFacts(const scene::ViewState& state, const PanelFacts& facts)
{
    const auto line = [](const std::string& text) { ImGui::TextUnformatted(text.c_str()); };
    ImGui::Separator();
    if (state.compare.on)
        line("two pictures, see compare");
    else if (isOnCpu(state.document.technique))
        line(fmt::format("{:.1f} ms on the CPU, in double", facts.milliseconds));
    else
        line(fmt::format("{:.2f} ms, {} pass{}, {} look-ups", facts.milliseconds, facts.passes,
                         facts.passes == 1 ? "" : "es", facts.maxLookups));
    if (!state.compare.on) line(fmt::format("sample {} of {}", facts.samples, facts.samplesWanted));
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

bool Panel::isHeld() const
{
    return ImGui::IsAnyItemActive();
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
    scene::SceneMaterial* const material = shownMaterial(state.document);
    if (material && facts.isFitted) drawFit(*material);
    drawFitFacts(state, facts.fit);
    drawFacts(state, facts);
    if (state.help) drawHelp();
    ImGui::PopItemWidth();
    ImGui::End();
    if (facts.compare) drawCompare(state.compare, *facts.compare);
    if (facts.cursor) drawCursor(state.cursor, *facts.cursor);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace fbrdf::viewer
