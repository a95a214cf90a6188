// Deviation.h - how far a picture is from the truth, and from what its plan promises.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <vector>

namespace fbrdf::truth {

/// The values that a target stores for a radiance (RGBA; alpha is left alone) after the transfer,
/// at exposure 1. Where `unorm` is set they are at most 1.
std::vector<double> storedImage(std::vector<double> radiance, Transfer transfer, bool unorm);

struct Deviation {
    double relative = 0.0;  ///< largest |found - exact| / max(|exact|, mean / 100)
    double absolute = 0.0;  ///< largest |found - exact|
    double share = 0.0;     ///< largest part of what the bound allows; above 1 the bound is broken
};
/// Expects pictures of one size.
Deviation deviationOf(const std::vector<float>& found, const std::vector<double>& exact,
                      const ErrorBound& bound);

}  // namespace fbrdf::truth
