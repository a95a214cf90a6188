// PriorSystem.h - the normal equations of samples under a prior.
//
// Tables are mean + modes z + e with z ~ N(0, I) and e ~ N(0, tau^2 S). With e and z as unknowns
// both precisions are simple: that of e is banded as the equations of the data are, and z, of which
// there are few, joins the dense unknowns.
#pragma once
#include "prior/PriorCovariance.h"
#include "prior/PriorFit.h"

namespace fbrdf {

/// The samples of a fit: rows A, weights W, and residuals r of log2 f from what the mean predicts.
class PriorSystem {
public:
    /// Samples of `excludedFold` take no part. `prior` must outlive the object.
    PriorSystem(const LeastSquares& problem, const PriorCovariance& prior, int excludedFold);

    /// The most probable e and z, and log p(r | weights) up to a constant.
    struct Posterior {
        PriorMatrix e;  ///< unknowns x 3
        PriorMatrix z;  ///< modes x 3
        double evidence = 0;
    };
    Posterior posterior(const PriorWeights& weights) const;

private:
    void add(const LeastSquares& problem, const RowStore::Block& block, size_t i);
    BorderedMatrix matrix(const PriorWeights& weights) const;

    const PriorCovariance& prior_;
    double count_ = 0, squares_ = 0;  ///< of samples, and of their residuals: sum of r^T W r
    BorderedMatrix tables_;           ///< A^T W A
    PriorMatrix tablesByModes_;       ///< A^T W A U
    PriorMatrix modes_;               ///< U^T A^T W A U
    PriorMatrix right_;               ///< A^T W r: unknowns x 3
};

}  // namespace fbrdf
