#include "solve/Coarse.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr int kSmallest = 4;

int half(int size)
{
    return size <= kSmallest ? size : std::max(kSmallest, (size + 1) / 2);
}

// Position in the coarse table of a texel of the fine one: the same point of the domain.
Vec3d positionIn(const Domain& coarse, const Domain& fine, int texel)
{
    const auto size = domainSize(fine), coarseSize = domainSize(coarse);
    const int coordinates[3] = {texel % size[0], texel / size[0] % size[1],
                                texel / (size[0] * size[1])};
    Vec3d position(0.0);
    for (int d = 0; d < 3; ++d) {
        const auto axis = static_cast<size_t>(d);
        if (size[axis] < 2) continue;
        position[d] =
            static_cast<double>(coordinates[d]) * (coarseSize[axis] - 1) / (size[axis] - 1);
    }
    return position;
}

}  // namespace

Form halved(const Form& form)
{
    Form coarse = form;
    for (TableSpec& spec : coarse.tables) {
        if (auto* disc = std::get_if<DiscDomain>(&spec.domain)) {
            const double scale = disc->radius / (disc->size - 1);
            disc->size = half(disc->size);
            disc->radius = scale * (disc->size - 1);
        } else {
            for (Axis& axis : std::get<GridDomain>(spec.domain).axes) axis.size = half(axis.size);
        }
    }
    return coarse;
}

State prolonged(const LeastSquares& coarse, const State& x, const LeastSquares& fine)
{
    const size_t columns = fine.columns(), from = coarse.unknowns(), to = fine.unknowns();
    FBRDF_ASSERT(x.size(), ==, columns * from);
    FBRDF_ASSERT(coarse.form().tables.size(), ==, fine.form().tables.size());
    State result(columns * to);
    for (size_t t = 0; t < fine.form().tables.size(); ++t) {
        const Domain &coarseDomain = coarse.form().tables[t].domain,
                     &domain = fine.form().tables[t].domain;
        for (int texel = 0; texel < texelCount(domain); ++texel) {
            const Stencil<double> stencil =
                stencilAt(coarseDomain, positionIn(coarseDomain, domain, texel));
            const auto target = static_cast<size_t>(fine.layout().unknownOf(t, texel));
            for (size_t c = 0; c < columns; ++c) {
                double value = 0.0;
                for (size_t k = 0; k < static_cast<size_t>(stencil.count); ++k)
                    value += stencil.weight[k] *
                             x[c * from +
                               static_cast<size_t>(coarse.layout().unknownOf(t, stencil.texel[k]))];
                result[c * to + target] = value;
            }
        }
    }
    for (size_t t = 0; fine.layout().sharedShape() && t < fine.form().terms.size(); ++t)
        for (int c = 0; c < 3; ++c)
            result[static_cast<size_t>(fine.layout().levelOf(t, c))] =
                x[static_cast<size_t>(coarse.layout().levelOf(t, c))];
    return result;
}

}  // namespace fbrdf
