// The list of models as text.
#include <fbrdf/sources/Model.h>
#include <fmt/format.h>

namespace fbrdf {
namespace {

std::string describe(const ModelParameter& parameter)
{
    const bool colour = parameter.kind == ModelParameter::Kind::colour;
    const std::string initial = parameter.kind == ModelParameter::Kind::shorthand
                                    ? ""
                                    : fmt::format(", default {}", parameter.initial);
    return fmt::format("    {:<15} {}{} [{}, {}]{}\n", parameter.name, parameter.meaning,
                       colour ? " (r/g/b)" : "", parameter.lower, parameter.upper, initial);
}

std::string describe(const Model& model)
{
    std::string text = fmt::format("{}: {}\n    {}\n", model.name, model.title, model.paper);
    const std::string& condition = model.energy.condition;
    text += fmt::format("    reflects at most what it receives: {}\n",
                        condition.empty() ? "not promised" : condition);
    for (const ModelParameter& parameter : model.parameters) text += describe(parameter);
    return text;
}

std::string describe(const ModelPreset& preset)
{
    std::string values;
    for (const auto& [name, value] : preset.values)
        values += fmt::format("{}{}={}", values.empty() ? "" : ",", name, value.x);
    return fmt::format("{}: {}:{} ({})\n", preset.name, preset.model, values, preset.origin);
}

}  // namespace

std::string describeModels()
{
    std::string text;
    for (const Model& model : models()) text += describe(model) + "\n";
    for (const ModelPreset& preset : modelPresets()) text += describe(preset);
    return text;
}

}  // namespace fbrdf
