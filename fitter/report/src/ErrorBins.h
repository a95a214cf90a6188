// ErrorBins.h - the error of a fit by theta_h and theta_d.
#pragma once
#include "ComparisonSet.h"

#include <vector>

namespace fbrdf {

/// Bins along each angle. theta_h is divided evenly in its square root, so that the highlight has
/// as many bins as the rest.
constexpr int kErrorBins = 18;

struct ErrorBin {
    size_t samples = 0;
    /// Median of |ln g / f| over the channels above the noise floor; NaN when there is none.
    double median = 0;
    /// Share in the sum over all samples of (c (g - f))^2, c = cos theta_i; 0 when that sum is 0.
    double share = 0;
};

struct ErrorBins {
    std::vector<ErrorBin> bins;  ///< kErrorBins x kErrorBins, theta_h contiguous

    const ErrorBin& at(int h, int d) const { return bins[static_cast<size_t>(d * kErrorBins + h)]; }
};

/// Lower edge of bin i, degrees; i = kErrorBins gives 90.
double edgeOfThetaH(int i);
double edgeOfThetaD(int i);

ErrorBins errorBins(const ComparisonSet& set, const Vec3f& noiseFloor);

}  // namespace fbrdf
