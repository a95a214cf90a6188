// TableNumbers.h - the order of a prior's numbers, and where they stand among the unknowns of a
// layout.
#pragma once
#include "solve/Rows.h"

namespace fbrdf {

/// The unknown of every number (see TablePrior) of a form. Precondition: no shared shape.
std::vector<size_t> unknownsInOrder(const Form& form, const Layout& layout);

}  // namespace fbrdf
