// Solver.h - symmetric positive definite systems with a banded block, the last step of every fit.
//
//     [ A  C ]   A banded n x n, D dense m x m:  A = L L^T, W = L^-1 C, D - W^T W = S S^T.
//     [ C^T D]   Golub and Van Loan, "Matrix Computations", sections 4.2, 4.3 (band) and 3.2
//     (blocks).
#pragma once
#include "solve/HugePages.h"

namespace fbrdf {

struct BorderedShape {
    size_t banded = 0;     ///< n: unknowns of the banded block; they come first
    size_t bandwidth = 0;  ///< of A below its diagonal, < n
    size_t dense = 0;      ///< m: the other unknowns

    size_t unknowns() const { return banded + dense; }
    /// Numbers of A, C and D as BorderedMatrix stores them.
    size_t bandSize() const { return banded * (bandwidth + 1); }
    size_t borderSize() const { return banded * dense; }
    size_t size() const { return bandSize() + borderSize() + dense * dense; }
    /// Where A(row, column), C(row, column), D(row, column) stand among them; column <= row for A
    /// and D.
    size_t bandAt(size_t row, size_t column) const
    {
        return row * bandwidth + bandwidth + column;  // row (w + 1) + w - (row - column)
    }
    size_t borderAt(size_t row, size_t column) const { return bandSize() + row * dense + column; }
    size_t denseAt(size_t row, size_t column) const
    {
        return bandSize() + borderSize() + column * dense + row;
    }
};

/// Lower triangle: A by rows of bandwidth + 1, C by rows, D by columns.
struct BorderedMatrix {
    BorderedShape shape;
    SystemNumbers values;  ///< shape.size()

    explicit BorderedMatrix(const BorderedShape& s = {}) : shape(s), values(s.size(), 0.0) {}
    /// Precondition: as many values.
    BorderedMatrix(const BorderedShape& s, SystemNumbers v) : shape(s), values(std::move(v)) {}
    /// The entry of two unknowns; column <= row, and within the band where both are banded.
    double& at(size_t row, size_t column)
    {
        const size_t n = shape.banded;
        if (row < n) return values[shape.bandAt(row, column)];
        return values[column < n ? shape.borderAt(column, row - n)
                                 : shape.denseAt(row - n, column - n)];
    }
    double at(size_t row, size_t column) const
    {
        return const_cast<BorderedMatrix&>(*this).at(row, column);
    }
};

/// Cholesky factorization, kept for any number of right-hand sides.
class Cholesky {
public:
    /// ok() is false when the matrix is not positive definite.
    explicit Cholesky(BorderedMatrix matrix);
    bool ok() const { return ok_; }
    /// In place: right-hand side in, solution out. `values`: unknowns x columns, column contiguous.
    void solve(double* values, size_t columns) const;
    /// The natural logarithm of the determinant of the matrix. Precondition: ok().
    double logDeterminant() const;
    /// The memory of the matrix, for another; this object is of no use afterwards.
    SystemNumbers takeValues() { return std::move(factor_.values); }

private:
    BorderedMatrix factor_;
    bool ok_ = false;
};

}  // namespace fbrdf
