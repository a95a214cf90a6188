// Lights.h - lists of lights: as JSON, and made by number and seed.
//
// {"lights": [{"type": "point", "position": [x, y, z], "intensity": [r, g, b], "radius": R},
//             {"type": "spot", ..., "axis": [x, y, z], "inner_degrees": a, "outer_degrees": b},
//             {"type": "directional", "direction": [x, y, z], "intensity": [r, g, b]}]}
// All is in world space. A direction points towards the light, an axis to where a spot shines;
// neither need be unit. Angles are measured from the axis, and a spot has all fields of a point.
// The radius is optional; without one the influence is unlimited. Other keys are ignored. Units are
// in fbrdf/plan/Light.h.
#pragma once
#include <fbrdf/plan/Light.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf::scene {

/// Throws Error(input) naming file, light and field for text that is not JSON (with line and
/// column), and for a field that is missing, of the wrong kind, not finite, or negative where it
/// may not be.
std::vector<Light> readLights(const std::string& path);

/// The same from memory; `where` stands for the file's name in errors.
std::vector<Light> lightsFromJson(std::string_view text, const std::string& where);

/// Inverse of lightsFromJson: the same floats come back, but for directions
/// and axes, which become unit, and angles, up to rounding.
std::string lightsToJson(const std::vector<Light>& lights);

/// `count` point lights around the origin, the same for the same seed on every machine: a warm key
/// from above on the right, then dimmer ones all around in soft colours, most of them in front. The
/// irradiance they add up to at the origin does not depend on count, so neither does the exposure.
std::vector<Light> makeLights(int count, uint32_t seed = 0);

}  // namespace fbrdf::scene
