// RowKernel.h - the loops over rows in which fits spend their time, compiled once for every x86-64
// and once with AVX2 and FMA; rowKernels() picks. Raw pointers only, as in SolverKernel.h.
#pragma once
#include <cstddef>

namespace fbrdf {

constexpr std::ptrdiff_t kRowLanes = 4;  ///< R, G, B and one that pads: what vector units like
constexpr unsigned char kNoGroup = 255;  ///< the group of a row that takes no part

/// Rows side by side, as they enter normal equations: row i has the entries b(i, k) = weight(i, k)
/// share(i, term of k), a sample's weight w and a residual r, the last three a lane a channel.
struct KernelRows {
    std::ptrdiff_t count, width;
    const int* unknown;   ///< count x width
    const float* weight;  ///< count x width
    const float* share;   ///< count x terms x kRowLanes; null: all 1
    const int* termEnd;   ///< one past the last entry of each term
    std::ptrdiff_t terms;
    std::ptrdiff_t bandedFirst, bandedLast;  ///< the entries of banded unknowns
    const float *sampleWeight, *residual;    ///< count x kRowLanes
    const unsigned char* group;              ///< count: whose sums the row adds to
};

/// A state as rows read it: texels and levels of terms, a lane a channel.
struct KernelTexels {
    const float* values;  ///< unknowns x kRowLanes
    const float* levels;  ///< terms x kRowLanes
};

/// Where sums of w b b^T (as BorderedMatrix, lane contiguous) and of w b r (unknowns x kRowLanes)
/// are made; one of each a group.
struct KernelSums {
    std::ptrdiff_t banded, bandwidth, dense;  ///< BorderedShape
    double *const *matrix, *const *right;
};

struct RowKernels {
    /// In place: log2 of normal numbers > 0.
    void (*log2)(float* numbers, std::ptrdiff_t count);
    /// logG: log2 g of rows, count x kRowLanes; share: what each term contributes to g, count x
    /// terms x kRowLanes, untouched for a form of one term. Uses only the geometry and the terms of
    /// `rows`. Terms are cut off at 2^-126 and 2^126.
    void (*predict)(const KernelRows& rows, const KernelTexels& texels, float* logG, float* share);
    /// entryLanes: 1 where all lanes have the same b, that of lane 0; matrixLanes: 0 (no matrix), 1
    /// (lane 0 for all) or kRowLanes. scratch: width x kRowLanes.
    void (*add)(const KernelRows& rows, const KernelSums& sums, int entryLanes, int matrixLanes,
                double* scratch);
    /// result += sum over rows of w b (b^T p); p, result: unknowns x kRowLanes.
    void (*apply)(const KernelRows& rows, int entryLanes, const double* p, double* result,
                  double* scratch);
    /// sum(0) += w b_k b_k, sum(1) += w b_k r of every unknown: unknowns x kRowLanes each.
    void (*diagonal)(const KernelRows& rows, int entryLanes, double* const* sum, double* scratch);
};
RowKernels rowKernels();

extern const RowKernels kRowKernelsBaseline, kRowKernelsAvx2;

}  // namespace fbrdf
