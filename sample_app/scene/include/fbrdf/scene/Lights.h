// Lights.h - lists of lights: as JSON, and made by number and seed.
//
// {"lights": [{"type": "point", "position": [x, y, z], "intensity": [r, g, b], "radius": R},
//             {"type": "spot", ..., "axis": [x, y, z], "inner_degrees": a, "outer_degrees": b},
//             {"type": "directional", "direction": [x, y, z], "intensity": [r, g, b]},
//             {"type": "sphere", "position": [x, y, z], "size": S, "radiance": [r, g, b]},
//             {"type": "disc", "position": ..., "normal": [x, y, z], "size": S, ...},
//             {"type": "rectangle", "position": ..., "axis_u": [x, y, z], "axis_v": ..., ...},
//             {"type": "tube", "from": [x, y, z], "to": [x, y, z], "size": S, ...},
//             {"type": "polygon", "vertices": [[x, y, z], ...], ...}]}
// All is in world space. A direction points towards the light, an axis to where a spot shines;
// neither need be unit. Angles are measured from the axis, and a spot has all fields of a point.
// Lights with a shape have a radiance; discs, rectangles and polygons may be "two_sided". The
// radius is optional; without one the influence is unlimited. Other keys are ignored. Units are in
// fbrdf/plan/Light.h and AreaLight.h.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Light.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf::scene {

/// What lights a scene beside its environment.
struct LightSet {
    std::vector<Light> lights;
    std::vector<AreaLight> areaLights;
    size_t size() const { return lights.size() + areaLights.size(); }
    bool operator==(const LightSet& other) const;
};

/// Throws Error(input) naming file, light and field for text that is not JSON (with line and
/// column), and for a field that is missing, of the wrong kind, not finite, or negative where it
/// may not be.
LightSet readLights(const std::string& path);

/// The same from memory; `where` stands for the file's name in errors.
LightSet lightsFromJson(std::string_view text, const std::string& where);

/// Inverse of lightsFromJson: the same floats come back, but for directions and axes, which become
/// unit, and angles, up to rounding. Lights with a shape come after the others.
std::string lightsToJson(const LightSet& set);

/// `count` point lights around the origin, the same for the same seed on every machine: a warm key
/// from above on the right, then dimmer ones all around in soft colours, most of them in front. The
/// irradiance they add up to at the origin does not depend on count, so neither does the exposure.
std::vector<Light> makeLights(int count, uint32_t seed = 0);

}  // namespace fbrdf::scene
