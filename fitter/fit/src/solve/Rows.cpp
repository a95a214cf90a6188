#include "solve/Rows.h"

#include <algorithm>

namespace fbrdf {
namespace {

bool isSymmetric(const Domain& domain)
{
    const auto* grid = std::get_if<GridDomain>(&domain);
    return grid && grid->symmetric;
}

// Visits every line of texels along every axis: first texel, stride, length.
template <class Visit>
void forEachLine(const Domain& domain, const Visit& visit)
{
    const auto size = domainSize(domain);
    const int strides[3] = {1, size[0], size[0] * size[1]};
    for (size_t axis = 0; axis < 3; ++axis) {
        if (size[axis] < 2) continue;
        const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < size[u]; ++i)
            for (int j = 0; j < size[v]; ++j)
                visit(i * strides[u] + j * strides[v], strides[axis], size[axis]);
    }
}

// The table whose block is banded: the largest that a single factor looks up; none (-1) where every
// table is symmetric or looked up twice.
int bandedTable(const Form& form)
{
    std::vector<int> uses(form.tables.size(), 0);
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors) ++uses[static_cast<size_t>(factor.table)];
    int best = -1, most = 1;
    for (size_t t = 0; t < form.tables.size(); ++t) {
        const int texels = texelCount(form.tables[t].domain);
        if (uses[t] != 1 || isSymmetric(form.tables[t].domain) || texels <= most) continue;
        best = static_cast<int>(t);
        most = texels;
    }
    return best;
}

/// Strides of a numbering that runs along the shortest axis first.
struct BandOrder {
    std::array<int, 3> stride{};
    int bandwidth = 0;

    explicit BandOrder(const Domain& domain)
    {
        const auto size = domainSize(domain);
        std::array<size_t, 3> order{0, 1, 2};
        std::stable_sort(order.begin(), order.end(),
                         [&size](size_t a, size_t b) { return size[a] < size[b]; });
        int step = 1, cell = 0, curvature = 0;
        for (const size_t axis : order) {
            stride[axis] = step;
            if (size[axis] > 1) cell += step;  // opposite corners of a cell of interpolation
            if (size[axis] > 1) curvature = (size[axis] > 2 ? 2 : 1) * step;
            step *= size[axis];
        }
        bandwidth = std::max(cell, curvature);
    }
    int operator()(int texel, const std::array<int, 3>& size) const
    {
        return texel % size[0] * stride[0] + texel / size[0] % size[1] * stride[1] +
               texel / (size[0] * size[1]) * stride[2];
    }
};

}  // namespace

Layout::Layout(const Form& form, bool sharedShape) : unknownOf_(form.tables.size())
{
    const int first = bandedTable(form);
    if (first >= 0) {
        const Domain& domain = form.tables[static_cast<size_t>(first)].domain;
        const BandOrder order(domain);
        for (int t = 0; t < texelCount(domain); ++t)
            unknownOf_[static_cast<size_t>(first)].push_back(order(t, domainSize(domain)));
        count_ = banded_ = texelCount(domain);
        bandwidth_ = std::min(order.bandwidth, banded_ - 1);
    }
    for (size_t k = 0; k < form.tables.size(); ++k) {
        if (static_cast<int>(k) == first) continue;
        const Domain& domain = form.tables[k].domain;
        const int texels = texelCount(domain), side = domainSize(domain)[0];
        const auto mirrorOf = [side](int t) { return (t % side) * side + t / side; };
        const bool symmetric = isSymmetric(domain);
        std::vector<int> unknown(static_cast<size_t>(texels));
        // The texel of a mirrored pair that is met first gets a number, and the other shares it.
        for (int t = 0; t < texels; ++t)
            unknown[static_cast<size_t>(t)] =
                symmetric && mirrorOf(t) < t ? unknown[static_cast<size_t>(mirrorOf(t))] : count_++;
        unknownOf_[k] = std::move(unknown);
    }
    firstLevel_ = count_;
    if (sharedShape) count_ += 3 * static_cast<int>(form.terms.size());
}

RowMaker::RowMaker(const Form& form, const Layout& layout) : form_(form), layout_(layout)
{
    for (const TableSpec& spec : form.tables) sizes_.push_back(domainSize(spec.domain));
    int width = 0;
    for (const Term& term : form.terms) {
        for (const Factor& factor : term.factors) {
            int entries = 1;
            for (const int n : sizes_[static_cast<size_t>(factor.table)])
                if (n > 1) entries *= 2;
            width += entries;
            if (layout.banded() > 0 &&
                layout.unknownOf(static_cast<size_t>(factor.table), 0) < layout.banded()) {
                bandedFirst_ = width - entries;
                bandedLast_ = width;
            }
        }
        termEnd_.push_back(width);
    }
}

void RowMaker::make(const Sample& sample, int* unknown, float* weight) const
{
    const PairGeometry<float> geometry({sample.wo, sample.wi});
    for (const Term& term : form_.terms)
        for (const Factor& factor : term.factors) {
            const auto table = static_cast<size_t>(factor.table);
            const Domain& domain = form_.tables[table].domain;
            const Stencil<float> stencil =
                stencilAt(sizes_[table], texelPosition(domain, factor.argument, geometry));
            for (size_t k = 0; k < static_cast<size_t>(stencil.count); ++k) {
                *unknown++ = layout_.unknownOf(table, stencil.texel[k]);
                *weight++ = stencil.weight[k];
            }
        }
}

std::vector<SmoothnessRow> smoothnessRows(const Form& form, const Layout& layout, double firstOrder)
{
    std::vector<SmoothnessRow> rows;
    for (size_t t = 0; t < form.tables.size(); ++t) {
        const int table = static_cast<int>(t);
        forEachLine(form.tables[t].domain, [&](int first, int stride, int length) {
            const auto at = [&](int i) { return layout.unknownOf(t, first + i * stride); };
            for (int i = 0; i + 1 < length; ++i)
                rows.push_back({2, {at(i), at(i + 1), 0}, {-firstOrder, firstOrder, 0.0}, table});
            for (int i = 0; i + 2 < length; ++i)
                rows.push_back({3, {at(i), at(i + 1), at(i + 2)}, {1.0, -2.0, 1.0}, table});
        });
    }
    return rows;
}

}  // namespace fbrdf
