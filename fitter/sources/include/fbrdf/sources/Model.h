// Model.h - analytic BRDFs by name: what each is, its parameters, and a Source made of one.
// Conventions: runtime/brdf/include/fbrdf/brdf/Conventions.h; x is along the tangent.
//
// Every model is reciprocal, non-negative and finite for every allowed parameter. A model with an
// `energy.holds` of true reflects no more than it receives; the others are as published, and may.
// A specification is NAME or NAME:key=value,key=value, where NAME is a model or a preset; a colour
// is r/g/b (linear RGB) or one number for grey. Parameters that are not given keep their defaults.
#pragma once
#include <fbrdf/sources/Source.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace fbrdf {

struct ModelParameter {
    enum class Kind {
        scalar,     ///< one number
        colour,     ///< three numbers, linear RGB
        shorthand,  ///< one number that sets all parameters of `sets`; holds no value itself
    };
    std::string name;
    Kind kind = Kind::scalar;
    double initial = 0.0;             ///< default; a colour's is grey; unused by a shorthand
    double lower = 0.0, upper = 1.0;  ///< allowed, both included, for each component
    std::string meaning;              ///< one line: meaning and unit
    std::vector<std::string> sets;    ///< shorthand only
};

/// Values of all parameters but shorthands, by name. A scalar has three equal components.
using ModelValues = std::map<std::string, Vec3d>;

struct ModelEnergy {
    /// When the directional albedo is at most 1, in words: "kd + ks <= 1". Empty: no promise.
    std::string condition;
    bool (*holds)(const ModelValues& values) = nullptr;  ///< the same, to be asked; never null
};

struct Model {
    std::string name;   ///< "ggx"
    std::string title;  ///< "GGX microfacets"
    std::string paper;  ///< author, year, title; deviations from it
    std::vector<ModelParameter> parameters;
    bool (*isotropic)(const ModelValues& values) = nullptr;  ///< for these values; never null
    ModelEnergy energy;
    /// The function for these values, which must be complete and in range. Safe to call from
    /// threads.
    BrdfFunction (*make)(const ModelValues& values) = nullptr;
};

/// A measured or well-known parameter set; its name can be used as a model's, also with
/// ":key=value" to change a part of it.
struct ModelPreset {
    std::string name;   ///< "ward-rolled-brass"
    std::string model;  ///< "ward"
    std::string origin;
    ModelValues values;  ///< what differs from the model's defaults
};

/// All models, in the order in which `fbrdf models` lists them.
const std::vector<Model>& models();
const std::vector<ModelPreset>& modelPresets();

/// Nothing, unless there is such a model (not a preset).
const Model* findModel(const std::string& name);

/// True when the part of `spec` before the first ':' names a model or a preset.
bool namesModel(const std::string& spec);

/// A specification taken apart: the model, and a value for each of its parameters.
struct ModelSpec {
    const Model* model = nullptr;
    ModelValues values;
};

/// Throws Error(usage) for a model or key that does not exist (with the nearest name that does), a
/// value that is not a number or out of range, a wrong number of components, and a parameter set
/// twice.
ModelSpec parseModelSpec(const std::string& spec);

/// A specification with all values, from which parseModelSpec makes the same ones.
std::string modelSpecText(const ModelSpec& spec);

/// The source of a specification; errors as parseModelSpec. Its `evaluate` is double precision and
/// returns 0 when either direction is less than 1e-12 above the horizon, where the rounding of a
/// unit vector, and no longer the caller, decides on the side.
Source makeModelSource(const std::string& spec);

/// The models and presets as text of several lines, for people.
std::string describeModels();

}  // namespace fbrdf
