// AltaInputs.h - the coordinates in which files of the ALTA library give a pair of directions.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <string>

namespace fbrdf {

struct AltaInput {
    const char* name;  ///< as after #PARAM_IN
    size_t dimension;  ///< numbers a row
    bool isotropic;
    /// The pair of `dimension` numbers; a direction below the horizon or not finite where they
    /// stand for none. wo is ALTA's view V and wi its light L.
    DirectionPair<double> (*pair)(const double* x);
};

/// Null for a name that is none. `known` gets all names, comma-separated.
const AltaInput* altaInputNamed(const std::string& name, std::string& known);

}  // namespace fbrdf
