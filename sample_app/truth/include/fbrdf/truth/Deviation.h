// Deviation.h - how far a picture is from the truth, and from what its plan promises.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <vector>

namespace fbrdf::truth {

/// What a target holds of radiance (RGBA, alpha left alone) after the transfer, exposure 1; unorm:
/// at most 1.
std::vector<double> storedImage(std::vector<double> radiance, Transfer transfer, bool unorm);

struct Deviation {
    double relative = 0.0;  ///< largest |found - exact| / max(|exact|, mean / 100)
    double absolute = 0.0;  ///< largest |found - exact|
    double share = 0.0;     ///< largest part of what the bound allows; above 1 it does not hold
};
/// found, exact: of one size.
Deviation deviationOf(const std::vector<float>& found, const std::vector<double>& exact,
                      const ErrorBound& bound);

}  // namespace fbrdf::truth
