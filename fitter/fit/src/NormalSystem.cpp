#include "NormalSystem.h"

namespace fbrdf {
namespace {

// The sums of one row. N lanes: 1 matrix for all channels, or one each.
template <size_t N>
struct RowSums {
    const BorderedShape& shape;
    double* matrix;

    static void addTo(double* sum, const Lanes& a, const Lanes& b)
    {
        for (size_t l = 0; l < N; ++l) sum[l] += a[l] * b[l];
    }
    void bandedWith(size_t row, const Lanes& scaled, const int* unknown, const Lanes* entry,
                    size_t from, size_t to) const
    {
        for (size_t k = from; k < to; ++k) {
            const auto column = static_cast<size_t>(unknown[k]);
            if (column <= row) addTo(matrix + N * shape.bandAt(row, column), scaled, entry[k]);
        }
    }
    void borderWith(size_t row, const Lanes& scaled, const int* unknown, const Lanes* entry,
                    size_t from, size_t to) const
    {
        for (size_t k = from; k < to; ++k)
            addTo(matrix + N * shape.borderAt(row, static_cast<size_t>(unknown[k]) - shape.banded),
                  scaled, entry[k]);
    }
    void denseWith(size_t row, const Lanes& scaled, const int* unknown, const Lanes* entry,
                   size_t from, size_t to) const
    {
        for (size_t k = from; k < to; ++k) {
            const size_t column = static_cast<size_t>(unknown[k]) - shape.banded;
            if (column <= row) addTo(matrix + N * shape.denseAt(row, column), scaled, entry[k]);
        }
    }
};

template <size_t N>
void addRow(const RowSums<N>& sums, const NormalRow& row)
{
    const auto unknownOf = [&row](size_t k) { return static_cast<size_t>(row.unknown[k]); };
    const size_t first = row.bandedFirst, last = row.bandedLast;
    for (size_t a = first; a < last; ++a) {
        sums.bandedWith(unknownOf(a), row.scaled[a], row.unknown, row.entry, first, last);
        sums.borderWith(unknownOf(a), row.scaled[a], row.unknown, row.entry, 0, first);
        sums.borderWith(unknownOf(a), row.scaled[a], row.unknown, row.entry, last, row.width);
    }
    for (size_t a = 0; a < row.width; ++a) {
        if (a >= first && a < last) continue;
        const size_t dense = unknownOf(a) - sums.shape.banded;
        sums.denseWith(dense, row.scaled[a], row.unknown, row.entry, 0, first);
        sums.denseWith(dense, row.scaled[a], row.unknown, row.entry, last, row.width);
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

void NormalSums::add(const NormalRow& row)
{
    if (matrixLanes_ == kLanes)
        addRow(RowSums<kLanes>{shape_, matrix_.data()}, row);
    else if (matrixLanes_ == 1)
        addRow(RowSums<1>{shape_, matrix_.data()}, row);
    for (size_t k = 0; k < row.width; ++k)
        RowSums<kLanes>::addTo(&right_[kLanes * static_cast<size_t>(row.unknown[k])], row.scaled[k],
                               row.residual);
}

void NormalSums::addRight(const int* unknown, const float* entry, size_t width, const Lanes& weight,
                          const Lanes& residual)
{
    for (size_t k = 0; k < width; ++k) {
        double* sum = &right_[kLanes * static_cast<size_t>(unknown[k])];
        const auto factor = static_cast<double>(entry[k]);
        for (size_t l = 0; l < kLanes; ++l) sum[l] += weight[l] * factor * residual[l];
    }
}

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
