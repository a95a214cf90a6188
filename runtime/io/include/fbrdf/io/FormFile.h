// FormFile.h - a form as JSON text, in memory or in a file of its own. The same text stands in
// every .fbrdf (fbrdf:form) and in every material manifest ("form").
// {"name": "pq", "tables": [{"name": "q", "domain": {"disc": {"size": 48, "gamma": 0.5, "radius":
//  23.5}}}, {"name": "g", "uniform": true, "domain": {"grid": {"symmetric": false, "axes":
//  [{"size": 24, "from": "cos", "exponent": 0.5}]}}}],
//  "terms": [[{"table": 0, "argument": "h"}, {"table": 1, "argument": ["theta_i"]}]]}
// Directions are "wi", "wo", "h", "d", "mirror" and {"norm": [weights of wi, wo, n]}; angles
// "theta_h", "theta_d", "theta_i", "theta_o", "phi_d", "half_phi_d",
// "side_phi_d".
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>

namespace fbrdf {

/// The form that a JSON text describes, validated. A material manifest gives its material's form.
/// Throws Error(input) that names `where` (a path, or whatever the caller calls the text) and the
/// field or byte.
Form formFromJson(const std::string& text, const std::string& where = "form");

/// formFromJson of a file's content.
Form readForm(const std::string& path);

}  // namespace fbrdf
