// LobeJson.h - tables of lobes in files of materials (docs/format.md, section Lobes).
#pragma once
#include "FormJson.h"

#include <fbrdf/brdf/LobeTable.h>

namespace fbrdf {

/// All but the numbers of the knots. Expects a table that is not empty.
Json jsonFromLobes(const LobeTable& lobes);
/// The numbers of the knots, in the order of the knots.
std::vector<float> lobeNumbers(const LobeTable& lobes);

/// The table, validated. Throws Error(input) that names the place.
LobeTable lobesFromJson(const JsonField& json, const std::vector<float>& numbers);

}  // namespace fbrdf
