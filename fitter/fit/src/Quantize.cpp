#include "Quantize.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

struct Range {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower, sum = 0.0;
    int count = 0;
};

// The index in a state at which the texels of a channel start.
size_t columnOf(const Layout& layout, int channel)
{
    return layout.sharedShape()
               ? 0
               : static_cast<size_t>(channel) * static_cast<size_t>(layout.unknowns());
}

// Subtracts the mean of the reachable texels, or their maximum for a storage whose largest value is
// 1; returns what it subtracted.
Vec3d normalised(Table& table, Storage storage)
{
    Vec3d levels(0.0);
    const int texels = texelCount(table.domain);
    for (int c = 0; c < table.channels; ++c) {
        Range range;
        const auto at = [&](int t) -> float& {
            return table.texels[static_cast<size_t>(t * table.channels + c)];
        };
        for (int t = 0; t < texels; ++t) {
            if (!isReachable(table.domain, t)) continue;
            const double value = static_cast<double>(at(t));
            range.lower = std::min(range.lower, value);
            range.upper = std::max(range.upper, value);
            range.sum += value;
            ++range.count;
        }
        levels[c] = isLog(storage) ? range.sum / range.count : range.upper;
        for (int t = 0; t < texels; ++t)
            at(t) = static_cast<float>(
                std::clamp(static_cast<double>(at(t)), range.lower, range.upper) - levels[c]);
    }
    return table.channels == 1 ? Vec3d(levels[0]) : levels;
}

}  // namespace

Material quantize(const Form& form, const Layout& layout, const State& x, Storage storage)
{
    FBRDF_ASSERT(x.size(), ==,
                 static_cast<size_t>(layout.unknowns()) * (layout.sharedShape() ? 1u : 3u));
    Material material;
    material.form = form;
    std::vector<Vec3d> levels;
    for (size_t t = 0; t < form.tables.size(); ++t) {
        Table table;
        table.name = form.tables[t].name;
        table.domain = form.tables[t].domain;
        table.channels = layout.sharedShape() ? 1 : 3;
        for (int i = 0; i < texelCount(table.domain); ++i)
            for (int c = 0; c < table.channels; ++c)
                table.texels.push_back(static_cast<float>(
                    x[columnOf(layout, c) + static_cast<size_t>(layout.unknownOf(t, i))]));
        levels.push_back(normalised(table, storage));
        material.tables.push_back(quantized(table, storage));
    }
    for (size_t t = 0; t < form.terms.size(); ++t) {
        Vec3d logScale(0.0);
        for (int c = 0; layout.sharedShape() && c < 3; ++c)
            logScale[c] = x[static_cast<size_t>(layout.levelOf(t, c))];
        for (const Factor& factor : form.terms[t].factors)
            logScale += levels[static_cast<size_t>(factor.table)];
        material.scales.push_back(
            Vec3f(Vec3d(std::exp2(logScale.x), std::exp2(logScale.y), std::exp2(logScale.z))));
    }
    return material;
}

}  // namespace fbrdf
