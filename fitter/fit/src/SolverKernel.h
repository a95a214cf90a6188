// SolverKernel.h - the two dense kernels, compiled once for every x86-64 and once with AVX2 and FMA
// (Solver.cpp picks). Raw pointers only: an inline function of the standard library instantiated
// under AVX2 could be the one that the linker keeps for the whole program.
#pragma once
#include <cstddef>

namespace fbrdf {

/// Factors the n x n column-major matrix in place, its lower triangle being what is read; false if
/// not positive definite.
using FactorKernel = bool (*)(double* matrix, std::ptrdiff_t n);
/// Solves with the factor, in place, for n x columns right-hand sides.
using SolveKernel = void (*)(const double* factor, std::ptrdiff_t n, double* values,
                             std::ptrdiff_t columns);

bool factorBaseline(double* matrix, std::ptrdiff_t n);
void solveBaseline(const double* factor, std::ptrdiff_t n, double* values, std::ptrdiff_t columns);
bool factorAvx2(double* matrix, std::ptrdiff_t n);
void solveAvx2(const double* factor, std::ptrdiff_t n, double* values, std::ptrdiff_t columns);

}  // namespace fbrdf
