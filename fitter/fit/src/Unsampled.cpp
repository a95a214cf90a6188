#include "Unsampled.h"

#include "TexelWeights.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {
namespace {

Vec3d colourOf(const State& x, size_t unknowns, size_t u)
{
    return {x[u], x[unknowns + u], x[2 * unknowns + u]};
}

// log2 of the channels relative to their mean.
Vec3d hueOf(const Vec3d& colour)
{
    return colour - (colour.x + colour.y + colour.z) / 3.0;
}

// The neighbours of every texel of a table, as unknowns; those of a mirrored pair are listed at
// their common one.
std::vector<std::vector<size_t>> neighboursIn(const Form& form, const Layout& layout, size_t table)
{
    std::vector<std::vector<size_t>> neighbours(static_cast<size_t>(layout.unknowns()));
    const auto size = domainSize(form.tables[table].domain);
    const int strides[3] = {1, size[0], size[0] * size[1]};
    const auto unknownOf = [&](int texel) {
        return static_cast<size_t>(layout.unknownOf(table, texel));
    };
    for (int texel = 0; texel < size[0] * size[1] * size[2]; ++texel)
        for (size_t axis = 0; axis < 3; ++axis) {
            if (texel / strides[axis] % size[axis] + 1 == size[axis]) continue;
            const size_t a = unknownOf(texel), b = unknownOf(texel + strides[axis]);
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
    return neighbours;
}

/// Texels of one table, whose hues spread from those that are known.
class HueSpread {
public:
    HueSpread(const Form& form, const Layout& layout, size_t table,
              const std::vector<double>& weights, State& x)
        : unknowns_(static_cast<size_t>(layout.unknowns())),
          neighbours_(neighboursIn(form, layout, table)),
          isKnown_(unknowns_, false),
          x_(x)
    {
        for (size_t u = 0; u < unknowns_; ++u)
            if (!neighbours_[u].empty()) isKnown_[u] = weights[u] > kLeastTexelWeight;
    }

    void run()
    {
        for (auto edge = beside(); !edge.empty(); edge = beside()) {
            std::vector<Vec3d> hues;
            for (const size_t u : edge) hues.push_back(meanAround(u));
            for (size_t i = 0; i < edge.size(); ++i) give(edge[i], hues[i]);
        }
    }

private:
    // Unknown texels that have a known neighbour.
    std::vector<size_t> beside() const
    {
        std::vector<size_t> edge;
        for (size_t u = 0; u < unknowns_; ++u) {
            if (isKnown_[u]) continue;
            const auto& around = neighbours_[u];
            if (std::any_of(around.begin(), around.end(), [this](size_t v) { return isKnown_[v]; }))
                edge.push_back(u);
        }
        return edge;
    }

    Vec3d meanAround(size_t u) const
    {
        Vec3d sum(0.0);
        double count = 0.0;
        for (const size_t v : neighbours_[u]) {
            if (!isKnown_[v]) continue;
            sum += hueOf(colourOf(x_, unknowns_, v));
            ++count;
        }
        return sum / count;
    }

    void give(size_t u, const Vec3d& hue)
    {
        const Vec3d colour = colourOf(x_, unknowns_, u);
        const Vec3d next = colour - hueOf(colour) + hue;
        for (size_t c = 0; c < 3; ++c) x_[c * unknowns_ + u] = next[static_cast<int>(c)];
        isKnown_[u] = true;
    }

    size_t unknowns_;
    std::vector<std::vector<size_t>> neighbours_;
    std::vector<bool> isKnown_;
    State& x_;
};

}  // namespace

void extendHue(const Form& form, const Layout& layout, const std::vector<double>& weights, State& x)
{
    FBRDF_ASSERT(weights.size(), ==, static_cast<size_t>(layout.unknowns()));
    if (layout.sharedShape()) return;  // one hue everywhere
    for (size_t table = 0; table < form.tables.size(); ++table)
        HueSpread(form, layout, table, weights, x).run();
}

}  // namespace fbrdf
