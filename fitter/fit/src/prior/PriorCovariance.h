// PriorCovariance.h - a prior as the fit of one problem needs it, in the order of its unknowns.
#pragma once
#include "prior/PriorMatrix.h"
#include "solve/Rows.h"
#include "solve/Solver.h"

#include <fbrdf/fit/TablePrior.h>

namespace fbrdf {

/// x ~ N(mean, modes modes^T + tau^2 S), of which S is what smoothness stands for: the inverse of
/// L^T L + kLevel I, where L are second differences along every axis of the tables and, a tenth as
/// strong, first ones; scaled so that the mean variance is 1.
struct PriorCovariance {
    Form form;
    PriorVector mean;          ///< unknowns
    PriorMatrix modes;         ///< unknowns x modes
    BorderedMatrix precision;  ///< S^-1

    explicit PriorCovariance(const TablePrior& prior);
};

/// L^T L of the class comment, and a lower triangular root with root^T root = S, for any form of
/// one term.
PriorMatrix roughness(const Form& form, const Layout& layout);
PriorMatrix smoothnessRoot(const Form& form);

}  // namespace fbrdf
