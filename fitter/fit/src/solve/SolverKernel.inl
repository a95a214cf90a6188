// Included by SolverBaseline.cpp and SolverAvx2.cpp with FBRDF_FACTOR and FBRDF_SOLVE naming the
// functions, and Eigen renamed, so that the two compilations share no symbol.
#include <Eigen/Cholesky>

namespace fbrdf {
namespace {

using Index = std::ptrdiff_t;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1>;
using Segment = Eigen::Map<const Vector>;

// L(row, from .. row - 1), contiguous.
const double* bandRow(const BorderedParts& m, Index row, Index from)
{
    return m.band + row * (m.bandwidth + 1) + m.bandwidth - (row - from);
}

Index bandStart(const BorderedParts& m, Index row)
{
    return row > m.bandwidth ? row - m.bandwidth : 0;
}

bool factorBand(const BorderedParts& m)
{
    for (Index i = 0; i < m.banded; ++i) {
        const Index start = bandStart(m, i);
        double* row = m.band + i * (m.bandwidth + 1) + m.bandwidth - i;  // row[j] is A(i, j)
        for (Index j = start; j <= i; ++j) {
            const Index from = bandStart(m, j) > start ? bandStart(m, j) : start;
            const double sum =
                row[j] - Segment(row + from, j - from).dot(Segment(bandRow(m, j, from), j - from));
            if (j < i) {
                row[j] = sum / *bandRow(m, j, j);
                continue;
            }
            if (!(sum > 0.0)) return false;
            row[i] = sqrt(sum);
        }
    }
    return true;
}

// W = L^-1 C, some rows at a time: a product of matrices reads each row of W from memory once,
// where products of rows would read as many as the band is wide.
void solveBorder(const BorderedParts& m, Eigen::Map<RowMatrix>& border)
{
    constexpr Index kRows = 32;
    RowMatrix factor;
    for (Index first = 0; first < m.banded; first += kRows) {
        const Index last = first + kRows < m.banded ? first + kRows : m.banded,
                    start = bandStart(m, first), before = first - start, count = last - first;
        factor.setZero(count, last - start);
        for (Index i = first; i < last; ++i) {
            const Index from = bandStart(m, i);
            factor.row(i - first).segment(from - start, i - from + 1).transpose() =
                Segment(bandRow(m, i, from), i - from + 1);
        }
        auto rows = border.middleRows(first, count);
        rows.noalias() -= factor.leftCols(before) * border.middleRows(start, before);
        factor.rightCols(count).triangularView<Eigen::Lower>().solveInPlace(rows);
    }
}

}  // namespace

bool FBRDF_FACTOR(const BorderedParts& m)
{
    if (!factorBand(m)) return false;
    if (m.size == 0) return true;
    Eigen::Map<RowMatrix> border(m.border, m.banded, m.size);
    solveBorder(m, border);
    Eigen::Map<Matrix> dense(m.dense, m.size, m.size);
    if (m.banded > 0)  // Eigen divides by the depth of the update
        dense.selfadjointView<Eigen::Lower>().rankUpdate(border.transpose(), -1.0);
    Eigen::Ref<Matrix> reference(dense);
    if (Eigen::LLT<Eigen::Ref<Matrix>>(reference).info() != Eigen::Success) return false;
    return dense(m.size - 1, m.size - 1) > 0.0;  // what is no number gets that far unnoticed
}

void FBRDF_SOLVE(const BorderedParts& m, double* values, Index columns)
{
    const Eigen::Map<const RowMatrix> border(m.border, m.banded, m.size);
    const Eigen::Map<const Matrix> dense(m.dense, m.size, m.size);
    for (Index c = 0; c < columns; ++c) {
        double* x = values + c * (m.banded + m.size);
        Eigen::Map<Vector> upper(x, m.banded), lower(x + m.banded, m.size);
        for (Index i = 0; i < m.banded; ++i) {
            const Index start = bandStart(m, i);
            x[i] -= Segment(bandRow(m, i, start), i - start).dot(Segment(x + start, i - start));
            x[i] /= *bandRow(m, i, i);
        }
        if (m.size > 0) {
            if (m.banded > 0) lower.noalias() -= border.transpose() * upper;
            dense.triangularView<Eigen::Lower>().solveInPlace(lower);
            dense.triangularView<Eigen::Lower>().transpose().solveInPlace(lower);
            if (m.banded > 0) upper.noalias() -= border * lower;
        }
        for (Index i = m.banded - 1; i >= 0; --i) {
            const Index start = bandStart(m, i);
            x[i] /= *bandRow(m, i, i);
            Eigen::Map<Vector>(x + start, i - start) -=
                x[i] * Segment(bandRow(m, i, start), i - start);
        }
    }
}

}  // namespace fbrdf
