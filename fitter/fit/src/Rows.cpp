#include "Rows.h"

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

}  // namespace

Layout::Layout(const Form& form)
{
    for (const TableSpec& spec : form.tables) {
        const int texels = texelCount(spec.domain), side = domainSize(spec.domain)[0];
        const auto mirrorOf = [&](int t) { return (t % side) * side + t / side; };
        const bool symmetric = isSymmetric(spec.domain);
        std::vector<int> unknown(static_cast<size_t>(texels));
        // Of a mirrored pair of texels the one met first gets the number, the other takes it over.
        for (int t = 0; t < texels; ++t)
            unknown[static_cast<size_t>(t)] =
                symmetric && mirrorOf(t) < t ? unknown[static_cast<size_t>(mirrorOf(t))] : count_++;
        unknownOf_.push_back(std::move(unknown));
    }
}

RowMaker::RowMaker(const Form& form, const Layout& layout) : form_(form), layout_(layout)
{
    int width = 0;
    for (const Term& term : form.terms) {
        for (const Factor& factor : term.factors) {
            int entries = 1;
            for (const int n : domainSize(form.tables[static_cast<size_t>(factor.table)].domain))
                if (n > 1) entries *= 2;
            width += entries;
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
                stencilAt(domain, texelPosition(domain, factor.argument, geometry));
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
