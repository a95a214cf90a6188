// LobeInfo.h - what `fit` and `info` say about the lobes of a material.
#pragma once
#include "Errors.h"

#include <fbrdf/brdf/LobeTable.h>

#include <string>

namespace fbrdf::tool {

/// null for an empty table.
Json lobesJson(const LobeTable& lobes);
std::string lobesText(const LobeTable& lobes);

}  // namespace fbrdf::tool
