// SolverKernel.h - the numeric kernels of Solver.h, compiled once for every x86-64 and once with
// AVX2 and FMA (Solver.cpp picks). Raw pointers only: an inline function of the standard library
// instantiated under AVX2 could be the one that the linker keeps for the whole program.
#pragma once
#include <cstddef>

namespace fbrdf {

/// A bordered matrix by its parts, stored as in BorderedMatrix.
struct BorderedParts {
    double *band, *border, *dense;
    std::ptrdiff_t banded, bandwidth, size;  ///< n, w, m
};

/// Factors in place; false if not positive definite.
using FactorKernel = bool (*)(const BorderedParts& matrix);
/// Solves with the factor, in place, for unknowns x columns right-hand sides.
using SolveKernel = void (*)(const BorderedParts& factor, double* values, std::ptrdiff_t columns);

bool factorBaseline(const BorderedParts& matrix);
void solveBaseline(const BorderedParts& factor, double* values, std::ptrdiff_t columns);
bool factorAvx2(const BorderedParts& matrix);
void solveAvx2(const BorderedParts& factor, double* values, std::ptrdiff_t columns);

}  // namespace fbrdf
