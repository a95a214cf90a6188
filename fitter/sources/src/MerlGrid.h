// MerlGrid.h - the cells of a MERL table: theta_h (square-root spaced), theta_d, phi_d.
// Cell (i, j, k) covers theta_h from (i / nh)^2 pi/2, theta_d from j / nd pi/2 and phi_d from
// k / np span; phi_d is contiguous. Matusik, Pfister, Brand, McMillan 2003, and the reader that
// comes with their database (BRDFRead.cpp).
#pragma once
#include <fbrdf/sources/Source.h>

#include <array>

namespace fbrdf {

class MerlGrid {
public:
    /// Cells along theta_h, theta_d, phi_d, each >= 1. `phiSpan` is pi for tables that use
    /// f(phi_d + pi) = f(phi_d) (reciprocity), 2 pi for the rest.
    explicit MerlGrid(std::array<int, 3> cells = {90, 90, 180}, double phiSpan = kPi);

    size_t size() const { return cos_h_.size() * cos_d_.size() * cos_p_.size(); }
    const std::array<int, 3>& cells() const { return cells_; }
    /// The value of SampleStream::geometry.
    std::string key() const;

    /// Pair at the centre of a cell, phi_h = 0. May lie below the horizon.
    DirectionPair<double> pair(size_t cell) const;
    /// Cell that a pair falls into, as BRDFRead.cpp finds it.
    size_t cellOf(const DirectionPair<double>& pair) const;

private:
    std::array<int, 3> cells_;
    double phiSpan_;
    std::vector<double> cos_h_, sin_h_, cos_d_, sin_d_, cos_p_, sin_p_;
};

/// The values of a function at the centres of the cells, made when asked for.
SampleStream streamOnGrid(MerlGrid grid, BrdfFunction evaluate);

}  // namespace fbrdf
