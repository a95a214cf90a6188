// fbrdf models: the analytic models, their parameters, defaults and papers.
#include "Commands.h"
#include "Errors.h"
#include "Output.h"
#include "TextTable.h"

#include <fbrdf/sources/Model.h>
#include <fmt/format.h>

namespace fbrdf::tool {
namespace {

const char* kindName(ModelParameter::Kind kind)
{
    switch (kind) {
        case ModelParameter::Kind::scalar: return "number";
        case ModelParameter::Kind::colour: return "r/g/b";
        case ModelParameter::Kind::shorthand: return "shorthand";
    }
    return "?";
}

bool isShorthand(const ModelParameter& parameter)
{
    return parameter.kind == ModelParameter::Kind::shorthand;
}

Json parameterJson(const ModelParameter& parameter)
{
    Json json{{"name", parameter.name},
              {"kind", kindName(parameter.kind)},
              {"range", {parameter.lower, parameter.upper}},
              {"meaning", parameter.meaning}};
    if (isShorthand(parameter))
        json["sets"] = parameter.sets;
    else
        json["default"] = parameter.initial;
    return json;
}

Json modelJson(const Model& model)
{
    Json parameters = Json::array();
    for (const ModelParameter& parameter : model.parameters)
        parameters.push_back(parameterJson(parameter));
    return {{"name", model.name},
            {"title", model.title},
            {"paper", model.paper},
            {"conserves_energy", model.energy.condition},
            {"parameters", parameters}};
}

Json presetJson(const ModelPreset& preset)
{
    Json values = Json::object();
    for (const auto& [name, value] : preset.values) values[name] = jsonOf(value);
    return {{"name", preset.name},
            {"model", preset.model},
            {"origin", preset.origin},
            {"values", values}};
}

Json modelsJson()
{
    Json all = Json::array(), presets = Json::array();
    for (const Model& model : models()) all.push_back(modelJson(model));
    for (const ModelPreset& preset : modelPresets()) presets.push_back(presetJson(preset));
    return {{"models", all}, {"presets", presets}};
}

std::string valueText(const Vec3d& v)
{
    return v.x == v.y && v.y == v.z ? fmt::format("{:.6g}", v.x)
                                    : fmt::format("{:.6g}/{:.6g}/{:.6g}", v.x, v.y, v.z);
}

std::string modelText(const Model& model)
{
    std::vector<std::vector<std::string>> rows{{"parameter", "", "default", "range", "meaning"}};
    for (const ModelParameter& p : model.parameters)
        rows.push_back({p.name, isShorthand(p) ? "" : kindName(p.kind),
                        isShorthand(p) ? "" : fmt::format("{:.6g}", p.initial),
                        fmt::format("{:.4g} to {:.4g}", p.lower, p.upper), p.meaning});
    const std::string& condition = model.energy.condition;
    const Align l = Align::left, r = Align::right;
    return model.name + " - " + model.title + "\n" + wrapped(model.paper, 2) +
           wrapped("energy: " + (condition.empty()
                                     ? "may reflect more than it receives"
                                     : (condition == "always" ? "always conserved"
                                                              : "conserved where " + condition)),
                   2) +
           alignedTable({l, l, r, l, l}, rows, 4) + "\n";
}

std::string presetsText()
{
    std::vector<std::vector<std::string>> rows;
    for (const ModelPreset& preset : modelPresets()) {
        std::string values = preset.model + ":";
        for (const auto& [name, value] : preset.values)
            values += (values.back() == ':' ? "" : ",") + name + "=" + valueText(value);
        rows.push_back({preset.name, values, preset.origin});
    }
    return "presets\n" + alignedTable({Align::left, Align::left, Align::left}, rows);
}

std::string modelsText()
{
    std::string text;
    for (const Model& model : models()) text += modelText(model);
    return text + presetsText() +
           "\nA model or preset is a SOURCE: NAME, or NAME:key=value,key=value; colours as "
           "r/g/b.\n";
}

}  // namespace

void addModelsCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("models", "the analytic models and their parameters");
    const auto json = std::make_shared<bool>(false);
    sub->add_flag("--json", *json, "print one JSON object");
    sub->callback([json, &action] {
        action = [json] {
            writeOut(*json ? text(modelsJson()) : modelsText());
            return 0;
        };
    });
}

}  // namespace fbrdf::tool
