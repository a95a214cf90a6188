// Lookups.h - what a form costs in a shader.
#pragma once
#include <fbrdf/brdf/Form.h>

namespace fbrdf::tool {

/// Texture look-ups for each light: factors that change with the light and are not in uniforms.
/// The others (p(wo) of pqp) are looked up once, whatever the number of lights.
int lookupsPerLight(const Form& form);

}  // namespace fbrdf::tool
