// FormFile.h - a form as a JSON file: what a material manifest holds under "form", by itself.
// {"name": "pq", "tables": [{"name": "q", "domain": {"disc": {"size": 48, "gamma": 0.5, "radius":
//  23.5}}}, {"name": "g", "uniform": true, "domain": {"grid": {"symmetric": false, "axes":
//  [{"size": 24, "from": "cos", "exponent": 0.5}]}}}],
//  "terms": [[{"table": 0, "argument": "h"}, {"table": 1, "argument": ["theta_i"]}]]}
// Directions are "wi", "wo", "h", "d", "mirror" and {"norm": [weights of wi, wo, n]}; angles
// "theta_h", "theta_d", "theta_i", "theta_o", "phi_d".
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>

namespace fbrdf {

/// A validated form. A manifest of a material gives the material's form. Throws Error(input) with
/// file and field.
Form readForm(const std::string& path);

}  // namespace fbrdf
