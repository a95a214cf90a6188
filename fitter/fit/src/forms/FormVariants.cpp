#include "forms/FormVariants.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr int kFewestKnots = 4, kMostKnots = 128;
constexpr int kMostUniformKnots = 64;  // validate (Form.h)
constexpr double kLeastWarp = 0.1, kMostWarp = 2.0;

// A table that does not vary along an axis keeps that.
int scaledSize(int size, double factor, int most)
{
    if (size < 2) return size;
    const auto scaled = static_cast<int>(std::lround(size * factor));
    return std::clamp(scaled, std::min(size, kFewestKnots), std::max(size, most));
}

bool scaleWarp(double& warp, double factor)
{
    const double scaled = warp * factor;
    if (scaled < kLeastWarp || scaled > kMostWarp) return false;
    warp = scaled;
    return true;
}

}  // namespace

std::optional<Form> resized(const Form& form, size_t table, double factor)
{
    FBRDF_ASSERT(table, <, form.tables.size());
    FBRDF_ASSERT(factor, >, 0.0);
    Form result = form;
    TableSpec& spec = result.tables[table];
    if (auto* disc = std::get_if<DiscDomain>(&spec.domain)) {
        const double reach = disc->radius / (disc->size - 1);
        disc->size = scaledSize(disc->size, factor, kMostKnots);
        disc->radius = reach * (disc->size - 1);
    } else {
        const int most = spec.uniform ? kMostUniformKnots : kMostKnots;
        for (Axis& axis : std::get<GridDomain>(spec.domain).axes)
            axis.size = scaledSize(axis.size, factor, most);
    }
    if (sameDomain(spec.domain, form.tables[table].domain)) return std::nullopt;
    return result;
}

size_t warpCount(const Domain& domain)
{
    const auto* grid = std::get_if<GridDomain>(&domain);
    return !grid || grid->symmetric ? 1 : grid->axes.size();
}

std::optional<Form> rewarped(const Form& form, size_t table, size_t axis, double factor)
{
    FBRDF_ASSERT(table, <, form.tables.size());
    FBRDF_ASSERT(factor, >, 0.0);
    Form result = form;
    Domain& domain = result.tables[table].domain;
    if (axis >= warpCount(domain)) return std::nullopt;
    if (auto* disc = std::get_if<DiscDomain>(&domain))
        return scaleWarp(disc->gamma, factor) ? std::optional(result) : std::nullopt;
    auto& grid = std::get<GridDomain>(domain);
    if (!scaleWarp(grid.axes[axis].map.exponent, factor)) return std::nullopt;
    if (grid.symmetric) grid.axes[1] = grid.axes[0];
    return result;
}

}  // namespace fbrdf
