// Solver.h - dense symmetric positive definite systems, the last step of every fit.
#pragma once
#include <cstddef>
#include <vector>

namespace fbrdf {

/// n x n, row-major; only the lower triangle (column <= row) is read.
struct SymmetricMatrix {
    size_t size = 0;
    std::vector<double> lower;

    explicit SymmetricMatrix(size_t n = 0) : size(n), lower(n * n, 0.0) {}
    double& at(size_t row, size_t column) { return lower[row * size + column]; }
    double at(size_t row, size_t column) const { return lower[row * size + column]; }
};

/// Cholesky factorization, kept for any number of right-hand sides.
class Cholesky {
public:
    /// ok() is false when the matrix is not positive definite.
    explicit Cholesky(SymmetricMatrix matrix);
    bool ok() const { return ok_; }
    /// In place: right-hand side in, solution out. `values`: n x columns, column contiguous.
    void solve(double* values, size_t columns) const;

private:
    size_t size_ = 0;
    bool ok_ = false;
    std::vector<double> factor_;
};

}  // namespace fbrdf
