// SeenErrors.h - the errors of a fit that a person sees in a picture of it.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <vector>

namespace fbrdf {

/// Three errors, each relative, of values against samples.
struct SeenErrors {
    double body = 0;  ///< SampleErrors::logMedian: how far most directions are off
    /// The brightest directions: SampleErrors::cosRms, and beside it how far the channels of the
    /// highlight have come apart, the rms of |ln(g_a / g_b) - ln(f_a / f_b)| over pairs of channels
    /// a, b, weighted by (max f cos theta_i)^2; the root of the sum of both squared. A highlight
    /// whose brightness is right in two channels and wrong in the third is a coloured spot.
    double peak = 0;
    double both = 0;  ///< SampleErrors::cubeRootRms, which sees body and highlights alike
};

/// `fitted`: as many values as samples. A channel at or below `floor` has no hue.
SeenErrors seenErrors(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted,
                      const Vec3f& floor);

/// The mean of their logarithms; with another metric than log, the logarithm of its own error. The
/// less the better: a difference of 0.1 is errors a tenth larger.
double markOf(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted,
              const Vec3f& floor, Metric metric);
double markOf(const SeenErrors& errors);

/// A mark of three errors, and as a fourth the difference of two pictures: `deltaE` is the mean
/// Delta-E ITP, of which 1 is just seen, as 1 % is of the other errors.
double withPicture(double mark, double deltaE);

/// The largest factor by which log_median, cos_rms or cuberoot_rms of `a` is above that of `b`.
double mostAbove(const SampleErrors& a, const SampleErrors& b);

}  // namespace fbrdf
