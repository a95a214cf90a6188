#include "solve/NormalSystem.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {
namespace {

void addTo(SystemNumbers& sums, const SystemNumbers& others)
{
    FBRDF_ASSERT(sums.size(), ==, others.size());
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += others[i];
}

}  // namespace

BorderedShape shapeOf(const Layout& layout)
{
    const auto banded = static_cast<size_t>(layout.banded());
    return {banded, static_cast<size_t>(layout.bandwidth()),
            static_cast<size_t>(layout.unknowns()) - banded};
}

NormalSums::NormalSums(const BorderedShape& shape, size_t matrices, Workspace& workspace)
    : shape_(shape),
      matrixLanes_(matrices),
      matrix_(workspace, matrices * shape.size()),
      right_(workspace, kLanes * shape.unknowns())
{
}

void addRows(const KernelRows& rows, int entryLanes, std::vector<NormalSums>& groups,
             std::vector<double>& scratch)
{
    FBRDF_ASSERT(groups.size(), >, size_t{0});
    std::vector<double*> matrix, right;
    for (NormalSums& group : groups) {
        matrix.push_back(group.matrixSums().data());
        right.push_back(group.rightSums().data());
    }
    scratch.resize(static_cast<size_t>(rows.width) * kLanes);
    const BorderedShape& shape = groups[0].shape();
    rowKernels().add(
        rows,
        {static_cast<std::ptrdiff_t>(shape.banded), static_cast<std::ptrdiff_t>(shape.bandwidth),
         static_cast<std::ptrdiff_t>(shape.dense), matrix.data(), right.data()},
        entryLanes, static_cast<int>(groups[0].matrixLanes()), scratch.data());
}

NormalSums& NormalSums::operator+=(const NormalSums& other)
{
    addTo(matrix_.values(), other.matrix_.values());
    addTo(right_.values(), other.right_.values());
    return *this;
}

BorderedMatrix NormalSums::matrix(size_t lane, Workspace& workspace) const
{
    FBRDF_ASSERT(lane, <, kLanes);
    FBRDF_ASSERT(matrixLanes_, >, size_t{0});
    BorderedMatrix result(shape_, workspace.any(shape_.size()));
    const size_t from = matrixLanes_ == kLanes ? lane : 0;
    for (size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = matrix_.values()[matrixLanes_ * i + from];
    return result;
}

std::vector<double> NormalSums::right(size_t lane) const
{
    std::vector<double> result(shape_.unknowns());
    for (size_t u = 0; u < result.size(); ++u) result[u] = right_.values()[kLanes * u + lane];
    return result;
}

}  // namespace fbrdf
