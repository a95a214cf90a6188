// PolarFigures.h - polar plots of data against fit, on one logarithmic scale for all panels.
#pragma once
#include "PolarPanels.h"

#include <string>

namespace fbrdf {

/// A legend and one drawing a panel. R, G, B are drawn apart unless the material is grey.
std::string polarFigures(const std::vector<PolarPanel>& panels);

}  // namespace fbrdf
