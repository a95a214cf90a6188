// LobeRows.h - a LobeTable as programs take it: a few vec4 for each knot, knots in the table's
// order.
//   row 0           weight of the cosine (0 where the share is without it), tilt of the first lobe
//   row 1 + k       weight and level of lobe k of the share
//   one row more    tilts of the second and third lobe, where there is a second tilted one
#pragma once
#include <fbrdf/plan/Lobes.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace fbrdf {

/// The rows of a share of the table, share.knotVectors() of them. share: of layoutOf(table).
std::vector<glm::vec4> lobeRows(const LobeTable& table, const LobeShare& share);

/// By how much neighbouring lobes bend the normal, along the tangent and the bitangent.
glm::vec2 lobeBend(const LobeTable& table);

}  // namespace fbrdf
