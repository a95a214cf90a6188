#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/Lobes.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

bool fits(const LobeShare& share, int lookups, int vectors)
{
    return share.lookups() <= lookups && share.vectors() <= vectors;
}

/// The kept lobe that stands for a dropped one: of bent lobes the nearer end of the middle ones, of
/// tilted ones the one of the nearest width.
int standIn(const LobeTable& table, const LobeKnot& knot, int dropped, int first, int kept)
{
    if (table.axes == LobeAxes::bent) return dropped < first ? first : first + kept - 1;
    const auto levelOf = [&knot](int lobe) { return knot.lobes[static_cast<size_t>(lobe)].level; };
    int best = 0;
    for (int k = 1; k < kept; ++k)
        if (std::abs(levelOf(k) - levelOf(dropped)) < std::abs(levelOf(best) - levelOf(dropped)))
            best = k;
    return best;
}

}  // namespace

LobeLayout layoutOf(const LobeTable& table)
{
    return {table.axes, table.lobes, table.thetas, table.azimuths};
}

std::vector<LobeShare> lobeShares(const LobeLayout& table, int lookups, int vectors)
{
    std::vector<LobeShare> shares;
    if (table.lobes == 0) return shares;
    LobeShare share{table, 0, 0, true};
    if (!fits(share, lookups, vectors)) return {};
    while (share.first + share.count < table.lobes) {
        LobeShare larger = share;
        ++larger.count;
        if (fits(larger, lookups, vectors)) {
            share = larger;
            continue;
        }
        // A lobe that does not fit alone fits nowhere.
        if (share.isEmpty()) return {};
        shares.push_back(share);
        share = {table, share.first + share.count, 0, false};
    }
    shares.push_back(share);
    return shares;
}

LobeTable withFewerLobes(const LobeTable& table, int lobes)
{
    FBRDF_ASSERT(lobes, >=, 1);
    const bool bent = table.axes == LobeAxes::bent;
    const int kept = std::min(table.lobes, bent && lobes % 2 == 0 ? lobes - 1 : lobes);
    if (kept == table.lobes) return table;
    const int first = bent ? (table.lobes - kept) / 2 : 0;
    LobeTable fewer = table;
    fewer.lobes = kept;
    for (size_t i = 0; i < table.knots.size(); ++i) {
        LobeKnot knot = table.knots[i];
        for (int k = 0; k < table.lobes; ++k)
            if (k < first || k >= first + kept)
                knot.lobes[static_cast<size_t>(standIn(table, knot, k, first, kept))].weight +=
                    table.knots[i].lobes[static_cast<size_t>(k)].weight;
        fewer.knots[i].lobes = {};
        for (int k = 0; k < kept; ++k)
            fewer.knots[i].lobes[static_cast<size_t>(k)] =
                knot.lobes[static_cast<size_t>(first + k)];
    }
    return fewer;
}

}  // namespace fbrdf
