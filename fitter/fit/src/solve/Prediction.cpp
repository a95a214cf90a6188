#include "solve/Prediction.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {

Texels::Texels(const LeastSquares& problem, const State& x)
    : values_(problem.unknowns() * kLanes), levels_(problem.terms() * kLanes)
{
    const size_t n = problem.unknowns();
    const Layout& layout = problem.layout();
    FBRDF_ASSERT(x.size(), ==, problem.columns() * n);
    if (takeFlat(problem, x)) return;
    const size_t columnStep = layout.sharedShape() ? 0 : n;
    for (size_t i = 0; i < n; ++i)
        for (size_t c = 0; c < 3; ++c)
            values_[i * kLanes + c] = static_cast<float>(x[c * columnStep + i]);
    for (size_t t = 0; layout.sharedShape() && t < problem.terms(); ++t)
        for (int c = 0; c < 3; ++c)
            levels_[t * kLanes + static_cast<size_t>(c)] =
                static_cast<float>(x[static_cast<size_t>(layout.levelOf(t, c))]);
}

// True when every texel of a column is equal; the levels then are the sums over the factors.
bool Texels::takeFlat(const LeastSquares& problem, const State& x)
{
    const size_t n = problem.unknowns();
    if (problem.layout().sharedShape() || problem.terms() > 1) return false;
    for (size_t i = 0; i < x.size(); ++i)
        if (x[i] != x[i / n * n]) return false;
    values_.clear();
    const auto factors = static_cast<float>(problem.form().terms[0].factors.size());
    for (size_t c = 0; c < 3; ++c) levels_[c] = factors * static_cast<float>(x[c * n]);
    return true;
}

void predict(const LeastSquares& problem, const RowGeometry& rows, size_t first, size_t count,
             const Texels& texels, Prediction& predicted)
{
    FBRDF_ASSERT(first + count, <=, rows.count);
    const auto width = static_cast<size_t>(problem.maker().width());
    const size_t terms = problem.terms();
    predicted.logG.resize(count * kLanes);
    predicted.share.resize(terms > 1 ? count * terms * kLanes : 0);
    if (texels.isFlat()) {
        for (size_t k = 0; k < predicted.logG.size(); ++k)
            predicted.logG[k] = texels.levels()[k % kLanes];
        return;
    }
    KernelRows kernelRows{};
    kernelRows.count = static_cast<std::ptrdiff_t>(count);
    kernelRows.width = problem.maker().width();
    kernelRows.unknown = rows.unknown.data() + first * width;
    kernelRows.weight = rows.weight.data() + first * width;
    kernelRows.termEnd = problem.maker().termEnd().data();
    kernelRows.terms = static_cast<std::ptrdiff_t>(terms);
    rowKernels().predict(kernelRows, {texels.values(), texels.levels()}, predicted.logG.data(),
                         predicted.share.data());
}

}  // namespace fbrdf
