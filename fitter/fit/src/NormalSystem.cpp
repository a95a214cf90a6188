#include "NormalSystem.h"

namespace fbrdf {
namespace {

// What one row adds to sums of N lanes: 1 for all channels, or one each.
template <size_t N, class Entry>
struct RowSums {
    const NormalRow<Entry>& row;
    using Factor = std::array<double, N>;

    size_t unknownOf(size_t k) const { return static_cast<size_t>(row.unknown[k]); }
    Factor scaled(size_t k) const
    {
        Factor result;
        for (size_t l = 0; l < N; ++l) result[l] = row.weight[l] * laneOf(row.entry[k], l);
        return result;
    }
    /// Adds factor b for the entries [from, to) whose unknowns are counted, to a line of sums whose
    /// first belongs to unknown `first`.
    template <class Counts>
    void add(double* line, size_t first, const Factor& factor, size_t from, size_t to,
             const Counts& counts) const
    {
        for (size_t k = from; k < to; ++k) {
            if (!counts(unknownOf(k))) continue;
            double* sum = line + N * (unknownOf(k) - first);
            for (size_t l = 0; l < N; ++l) sum[l] += factor[l] * laneOf(row.entry[k], l);
        }
    }
};

template <size_t N, class Entry>
void addRow(const NormalRow<Entry>& row, const BorderedShape& shape, double* matrix)
{
    const RowSums<N, Entry> sums{row};
    const size_t first = row.bandedFirst, last = row.bandedLast, banded = shape.banded;
    const auto every = [](size_t) { return true; };
    for (size_t a = first; a < last; ++a) {
        const size_t u = sums.unknownOf(a);
        const auto factor = sums.scaled(a);
        sums.add(matrix + N * shape.bandAt(u, 0), 0, factor, first, last,
                 [u](size_t column) { return column <= u; });
        double* border = matrix + N * shape.borderAt(u, 0);
        sums.add(border, banded, factor, 0, first, every);
        sums.add(border, banded, factor, last, row.width, every);
    }
    for (size_t a = 0; a < row.width; ++a) {
        if (a >= first && a < last) continue;
        const size_t u = sums.unknownOf(a);
        const auto factor = sums.scaled(a);
        double* dense = matrix + N * shape.denseAt(0, u - banded);
        const auto below = [u](size_t other) { return other >= u; };
        sums.add(dense, banded, factor, 0, first, below);
        sums.add(dense, banded, factor, last, row.width, below);
    }
}

}  // namespace

BorderedShape shapeOf(const Layout& layout)
{
    const auto banded = static_cast<size_t>(layout.banded());
    return {banded, static_cast<size_t>(layout.bandwidth()),
            static_cast<size_t>(layout.unknowns()) - banded};
}

NormalSums::NormalSums(const BorderedShape& shape, size_t matrices)
    : shape_(shape),
      matrixLanes_(matrices),
      matrix_(matrices * shape.size(), 0.0),
      right_(kLanes * shape.unknowns(), 0.0)
{
}

template <class Entry>
void NormalSums::add(const NormalRow<Entry>& row)
{
    if (matrixLanes_ == kLanes)
        addRow<kLanes>(row, shape_, matrix_.data());
    else if (matrixLanes_ == 1)
        addRow<1>(row, shape_, matrix_.data());
    Lanes pull;
    for (size_t l = 0; l < kLanes; ++l) pull[l] = row.weight[l] * row.residual[l];
    RowSums<kLanes, Entry>{row}.add(right_.data(), 0, pull, 0, row.width,
                                    [](size_t) { return true; });
}
template void NormalSums::add(const NormalRow<double>&);
template void NormalSums::add(const NormalRow<Lanes>&);

NormalSums& NormalSums::operator+=(const NormalSums& other)
{
    if (other.empty()) return *this;
    if (empty()) return *this = other;
    for (size_t i = 0; i < matrix_.size(); ++i) matrix_[i] += other.matrix_[i];
    for (size_t i = 0; i < right_.size(); ++i) right_[i] += other.right_[i];
    return *this;
}

BorderedMatrix NormalSums::matrix(size_t lane) const
{
    BorderedMatrix result(shape_);
    const size_t from = matrixLanes_ == kLanes ? lane : 0;
    for (size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = matrix_[matrixLanes_ * i + from];
    return result;
}

std::vector<double> NormalSums::right(size_t lane) const
{
    std::vector<double> result(shape_.unknowns());
    for (size_t u = 0; u < result.size(); ++u) result[u] = right_[kLanes * u + lane];
    return result;
}

}  // namespace fbrdf
