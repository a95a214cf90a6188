// ConjugateGradients.h - large systems by preconditioned conjugate gradients, the matrix known only
// by what it does to a vector. Reference: Golub and Van Loan, "Matrix Computations", 11.5.
#pragma once
#include "solve/NormalSystem.h"

#include <functional>
#include <vector>

namespace fbrdf {

using LaneVector = std::vector<Lanes>;  ///< one an unknown: a system a lane, side by side

struct ConjugateGradientOptions {
    double tolerance = 1e-5;   ///< solved when |b - A x| <= tolerance |b| in every lane
    int maxIterations = 2000;  ///< iterations <= maxIterations, solved or not
};

struct ConjugateGradientSummary {
    int iterations = 0;
    double residual = 0.0;  ///< |b - A x| / |b| of the worst lane
    bool isSolved = true;   ///< the residual is within the tolerance
};

/// Solves A x = b from x = 0 in all lanes at once. apply: A p; diagonal: that of A, > 0 where b is
/// not 0.
ConjugateGradientSummary solveByConjugateGradients(
    const std::function<LaneVector(const LaneVector& p)>& apply, const LaneVector& diagonal,
    const LaneVector& right, const ConjugateGradientOptions& options, LaneVector& x);

}  // namespace fbrdf
