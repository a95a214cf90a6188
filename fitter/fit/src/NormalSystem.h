// NormalSystem.h - normal equations as sums over rows.
//
// The matrix has a banded block (Layout), a dense border that couples it to the other unknowns, and
// a dense rest. For hdio, 1024 banded and 136 other unknowns, that is an eighth of the numbers of a
// dense matrix and a thirtieth of the work to factor it.
#pragma once
#include "Rows.h"
#include "Solver.h"

#include <array>
#include <vector>

namespace fbrdf {

constexpr size_t kLanes = 4;  ///< R, G, B and one that pads: what vector units like
using Lanes = std::array<double, kLanes>;

BorderedShape shapeOf(const Layout& layout);

/// A row b with its weight w and residual r, a lane a channel. Entry: double where all lanes have
/// the same b, else Lanes.
template <class Entry>
struct NormalRow {
    const int* unknown;
    const Entry* entry;  ///< b
    size_t width;
    size_t bandedFirst, bandedLast;  ///< the entries of banded unknowns
    Lanes weight, residual;
};

inline double laneOf(double entry, size_t)
{
    return entry;
}
inline double laneOf(const Lanes& entry, size_t lane)
{
    return entry[lane];
}

/// Sums of w b b^T and w b r over rows.
class NormalSums {
public:
    NormalSums() = default;
    /// matrices: kLanes, one a channel; 1, lane 0 for all channels; or 0, none: a known matrix.
    NormalSums(const BorderedShape& shape, size_t matrices);
    bool empty() const { return right_.empty(); }

    template <class Entry>
    void add(const NormalRow<Entry>& row);
    NormalSums& operator+=(const NormalSums& other);

    /// The system of one lane.
    BorderedMatrix matrix(size_t lane) const;
    std::vector<double> right(size_t lane) const;

    /// All sums, for adding them up over processes.
    std::vector<double>& matrixSums() { return matrix_; }
    std::vector<double>& rightSums() { return right_; }

private:
    BorderedShape shape_;
    size_t matrixLanes_ = 1;
    std::vector<double> matrix_;  ///< as BorderedMatrix, lane contiguous
    std::vector<double> right_;   ///< unknowns x kLanes
};

}  // namespace fbrdf
