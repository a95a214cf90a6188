// NormalSystem.h - normal equations as sums over rows.
//
// The matrix has a banded block (Layout), a dense border that couples it to the other unknowns, and
// a dense rest. For hdio, 1024 banded and 136 other unknowns, that is an eighth of the numbers of a
// dense matrix and a thirtieth of the work to factor it.
#pragma once
#include "solve/RowKernel.h"
#include "solve/Rows.h"
#include "solve/Solver.h"
#include "solve/Workspace.h"

#include <array>
#include <vector>

namespace fbrdf {

constexpr size_t kLanes = kRowLanes;
using Lanes = std::array<double, kLanes>;

BorderedShape shapeOf(const Layout& layout);

/// Sums of w b b^T and w b r over rows.
class NormalSums {
public:
    NormalSums() = default;
    /// Zeros. matrices: kLanes, one a channel; 1, lane 0 for all channels; or 0, none: a known
    /// matrix. `workspace` must outlive the object.
    NormalSums(const BorderedShape& shape, size_t matrices, Workspace& workspace);
    bool empty() const { return right_.values().empty(); }

    NormalSums& operator+=(const NormalSums& other);

    /// The system of one lane, in memory of `workspace`.
    BorderedMatrix matrix(size_t lane, Workspace& workspace) const;
    std::vector<double> right(size_t lane) const;

    const BorderedShape& shape() const { return shape_; }
    size_t matrixLanes() const { return matrixLanes_; }
    /// All sums, for adding them up over processes.
    SystemNumbers& matrixSums() { return matrix_.values(); }
    SystemNumbers& rightSums() { return right_.values(); }

private:
    BorderedShape shape_;
    size_t matrixLanes_ = 1;
    WorkArray matrix_;  ///< as BorderedMatrix, lane contiguous
    WorkArray right_;   ///< unknowns x kLanes
};

/// Adds rows to the sums of their groups, all of one shape and as many matrices. `scratch`: of any
/// size, kept by the caller from call to call.
void addRows(const KernelRows& rows, int entryLanes, std::vector<NormalSums>& groups,
             std::vector<double>& scratch);

}  // namespace fbrdf
