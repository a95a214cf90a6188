// Albedo.h - the directional albedo of a function at a few incidences, as JSON and as text.
#pragma once
#include "Errors.h"

#include <string>
#include <vector>

namespace fbrdf::tool {

struct AlbedoAt {
    double degrees;  ///< theta_i, for light in the plane of the tangent
    Vec3d albedo;
};

/// The albedo for light from 0, 15, ... 75 and 85 degrees.
std::vector<AlbedoAt> albedoTable(const BrdfFunction& brdf, int threads);

/// [{"theta_i_degrees": .., "rgb": [..]}, ...]
Json jsonOf(const std::vector<AlbedoAt>& table);
std::string textOf(const std::vector<AlbedoAt>& table);

}  // namespace fbrdf::tool
