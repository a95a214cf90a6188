// SystemSums.h - the rows of a problem added up to the systems of one step: one for every channel
// whose matrix differs, without each of some folds and of all samples. Rows are added up once for
// all strengths of smoothness and all folds.
#pragma once
#include "solve/NormalRows.h"

namespace fbrdf {

/// The systems of the channels [first, first + channels), which share one matrix. Element k of both
/// vectors is without the k-th of the folds asked for; the last is of all samples.
struct SharedSystems {
    size_t first, channels;
    std::vector<std::shared_ptr<const SmoothSystem>> systems;
    std::vector<std::vector<double>> right;  ///< unknowns x channels, column contiguous
};

/// The systems at x for all channels. `scale`: see residualScale. Samples of
/// options.excludedFold take no part. Precondition: `folds` do not contain it.
std::vector<SharedSystems> systemsAt(const LeastSquares& problem, const State& x,
                                     const StepOptions& options, const Vec3f& scale,
                                     const std::vector<int>& folds);

}  // namespace fbrdf
