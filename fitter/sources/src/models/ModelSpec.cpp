// Parses "NAME:key=value,key=value".
#include <fbrdf/base/Text.h>
#include "NearestName.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/sources/Model.h>
#include <fmt/format.h>

namespace fbrdf {
namespace {

std::string nameOf(const std::string& spec)
{
    return spec.substr(0, spec.find(':'));
}

const ModelPreset* findPreset(const std::string& name)
{
    for (const ModelPreset& preset : modelPresets())
        if (preset.name == name) return &preset;
    return nullptr;
}

std::vector<std::string> allNames()
{
    std::vector<std::string> names;
    for (const Model& model : models()) names.push_back(model.name);
    for (const ModelPreset& preset : modelPresets()) names.push_back(preset.name);
    return names;
}

std::vector<std::string> parameterNames(const Model& model)
{
    std::vector<std::string> names;
    for (const ModelParameter& parameter : model.parameters) names.push_back(parameter.name);
    return names;
}

ModelValues defaultsOf(const Model& model)
{
    ModelValues values;
    for (const ModelParameter& parameter : model.parameters)
        if (parameter.kind != ModelParameter::Kind::shorthand)
            values[parameter.name] = Vec3d(parameter.initial);
    return values;
}

/// The model or preset of a name, with its values.
ModelSpec startOf(const std::string& name)
{
    if (const Model* model = findModel(name)) return {model, defaultsOf(*model)};
    const ModelPreset* preset = findPreset(name);
    if (!preset)
        throw Error(ErrorKind::usage, "model",
                    fmt::format(Found("{}").expected("a file that exists or a model{}"),
                                inQuotes(name), suggestion(name, allNames())));
    const Model* model = findModel(preset->model);
    ModelSpec spec{model, defaultsOf(*model)};
    for (const auto& [key, value] : preset->values) spec.values[key] = value;
    return spec;
}

/// Reads the assignments of one specification into its values.
class Assignments {
public:
    explicit Assignments(ModelSpec& spec) : spec_(spec), where_("model " + spec.model->name) {}

    void read(std::string_view text)
    {
        std::vector<std::string_view> fields;
        splitFields(text, ',', fields);
        for (const std::string_view field : fields) assign(field);
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(ErrorKind::usage, where_, what);
    }

    void assign(std::string_view field)
    {
        const size_t equals = field.find('=');
        if (equals == std::string_view::npos)
            fail(fmt::format(Found("{}").expected("key=value"), inQuotes(field)));
        const std::string key(trimmed(field.substr(0, equals)));
        const ModelParameter& parameter = parameterOf(key);
        const Vec3d value = valueOf(parameter, field.substr(equals + 1));
        if (parameter.kind != ModelParameter::Kind::shorthand) return store(key, value);
        for (const std::string& target : parameter.sets) store(target, value);
    }

    const ModelParameter& parameterOf(const std::string& key) const
    {
        for (const ModelParameter& parameter : spec_.model->parameters)
            if (parameter.name == key) return parameter;
        const std::vector<std::string> names = parameterNames(*spec_.model);
        fail(fmt::format(Found("the parameter {}").expected("one of {}{}"), inQuotes(key),
                         fmt::join(names, ", "), suggestion(key, names)));
    }

    Vec3d valueOf(const ModelParameter& parameter, std::string_view text) const
    {
        std::vector<std::string_view> parts;
        splitFields(text, '/', parts);
        const bool colour = parameter.kind == ModelParameter::Kind::colour;
        if (parts.size() != 1 && !(colour && parts.size() == 3))
            fail(fmt::format(Found("{}={}").expected("{}"), parameter.name, inQuotes(text),
                             colour ? "one number or r/g/b" : "one number"));
        if (parts.size() == 1) return Vec3d(numberOf(parameter, parts[0]));
        return {numberOf(parameter, parts[0]), numberOf(parameter, parts[1]),
                numberOf(parameter, parts[2])};
    }

    double numberOf(const ModelParameter& parameter, std::string_view text) const
    {
        double value = 0.0;
        if (!parseNumber(text, value))
            fail(fmt::format(Found("{}={}").expected("a number"), parameter.name, inQuotes(text)));
        // Written so that NaN is out of range.
        if (!(value >= parameter.lower && value <= parameter.upper))
            fail(fmt::format(Found("{}={}").expected("{} to {}"), parameter.name, value,
                             parameter.lower, parameter.upper));
        return value;
    }

    void store(const std::string& name, const Vec3d& value)
    {
        if (!given_.emplace(name, value).second)
            fail(fmt::format(Found("{} set twice").expected("it once"), name));
        spec_.values[name] = value;
    }

    ModelSpec& spec_;
    std::string where_;
    ModelValues given_;
};

/// Below this the rounding of a unit vector's components decides on which side of the horizon it
/// is.
constexpr double kHorizon = 1e-12;

}  // namespace

bool namesModel(const std::string& spec)
{
    const std::string name = nameOf(spec);
    return findModel(name) || findPreset(name);
}

ModelSpec parseModelSpec(const std::string& text)
{
    ModelSpec spec = startOf(nameOf(text));
    const size_t colon = text.find(':');
    if (colon != std::string::npos)
        Assignments(spec).read(std::string_view(text).substr(colon + 1));
    return spec;
}

std::string modelSpecText(const ModelSpec& spec)
{
    constexpr int kDigits = 17;
    std::string text = spec.model->name;
    char separator = ':';
    for (const auto& [name, value] : spec.values) {
        text += separator + name + '=' + numberText(value.x, kDigits);
        if (value.y != value.x || value.z != value.x)
            text += '/' + numberText(value.y, kDigits) + '/' + numberText(value.z, kDigits);
        separator = ',';
    }
    return text;
}

Source makeModelSource(const std::string& text)
{
    const ModelSpec spec = parseModelSpec(text);
    Source source;
    source.name = text;
    source.format = "model";
    source.description = spec.model->title + ", 1/sr; " + spec.model->paper;
    source.isotropic = spec.model->isotropic(spec.values);
    source.evaluate = [f = spec.model->make(spec.values)](const Vec3d& wo, const Vec3d& wi) {
        return wo.z < kHorizon || wi.z < kHorizon ? Vec3d(0.0) : f(wo, wi);
    };
    return source;
}

}  // namespace fbrdf
