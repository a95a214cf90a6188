// Parameters.h - parameter sets of a model to test it with: defaults, corners, and random ones.
#pragma once
#include <fbrdf/base/Number.h>
#include <fbrdf/sources/Model.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace fbrdf::test {

inline ModelValues defaultValues(const Model& model)
{
    return parseModelSpec(model.name).values;
}

/// A value in the parameter's range: logarithmic where the range spans decades, otherwise uniform;
/// one in five is an end of the range.
inline double randomValue(const ModelParameter& parameter, std::mt19937& random)
{
    const double u = std::uniform_real_distribution<double>(0.0, 1.0)(random);
    if (u < 0.1) return parameter.lower;
    if (u > 0.9) return parameter.upper;
    const double t = (u - 0.1) / 0.8;
    if (parameter.upper <= 20.0) return parameter.lower + t * (parameter.upper - parameter.lower);
    const double smallest = std::max(parameter.lower, 1e-3);
    return smallest * std::pow(parameter.upper / smallest, t);
}

inline ModelValues randomValues(const Model& model, std::mt19937& random)
{
    ModelValues values;
    for (const ModelParameter& parameter : model.parameters) {
        if (parameter.kind == ModelParameter::Kind::shorthand) continue;
        Vec3d value(randomValue(parameter, random));
        if (parameter.kind == ModelParameter::Kind::colour)
            for (int c = 1; c < 3; ++c) value[c] = randomValue(parameter, random);
        values[parameter.name] = value;
    }
    return values;
}

/// All parameters at their lower and all at their upper ends, the defaults, and `count` random
/// sets.
inline std::vector<ModelValues> valueSets(const Model& model, int count)
{
    std::vector<ModelValues> sets = {defaultValues(model), defaultValues(model),
                                     defaultValues(model)};
    for (const ModelParameter& parameter : model.parameters) {
        if (parameter.kind == ModelParameter::Kind::shorthand) continue;
        sets[1][parameter.name] = Vec3d(parameter.lower);
        sets[2][parameter.name] = Vec3d(parameter.upper);
    }
    std::mt19937 random(20010801);
    for (int k = 0; k < count; ++k) sets.push_back(randomValues(model, random));
    return sets;
}

/// The specification of these values: what a user would type to get them.
inline std::string specOf(const Model& model, const ModelValues& values)
{
    std::string text = model.name;
    char separator = ':';
    for (const auto& [name, value] : values) {
        text += separator + name + "=";
        const bool grey = value.x == value.y && value.y == value.z;
        for (int c = 0; c < (grey ? 1 : 3); ++c) text += (c ? "/" : "") + numberText(value[c], 17);
        separator = ',';
    }
    return text;
}

}  // namespace fbrdf::test
