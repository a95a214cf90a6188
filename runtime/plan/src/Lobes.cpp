#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/Lobes.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

bool fits(const LobeShare& share, const LobeRoom& room)
{
    return share.lookups() <= room.lookups && share.vectors() <= room.vectors;
}

/// The lobes in as few shares as possible, lit by the environment and by one area light where there
/// are any.
std::vector<LobeShare> splitLobes(const LobeLayout& table, const LobeLight& light,
                                  const LobeRoom& room)
{
    std::vector<LobeShare> shares;
    LobeShare share{table, 0, 0, true, light.environment, 0, 0, std::min(1, light.areaLights)};
    const LobeShare rest{table, 0, 0, false, light.environment, 0, 0, share.areaSlots};
    if (!fits(share, room)) return {};
    while (share.first + share.count < table.lobes) {
        LobeShare larger = share;
        ++larger.count;
        if (fits(larger, room)) {
            share = larger;
            continue;
        }
        // A lobe that does not fit alone fits nowhere.
        if (share.isEmpty()) return {};
        shares.push_back(share);
        const int next = share.first + share.count;
        share = rest;
        share.first = next;
    }
    shares.push_back(share);
    return shares;
}

/// Slots for some lights: a power of two, so that a changed number seldom needs another program.
int slotsFor(int lights, int most)
{
    int slots = 1;
    while (slots < lights) slots *= 2;
    return std::max(lights, std::min(slots, most));
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

/// Adds the weight of the other lobe, between whose widths and directions the lobe then is.
void absorb(Lobe& lobe, const Lobe& other)
{
    const auto sizeOf = [](const Lobe& l) { return l.weight.x + l.weight.y + l.weight.z; };
    const float sum = sizeOf(lobe) + sizeOf(other);
    const float share = sum > 0.0f ? sizeOf(other) / sum : 0.0f;
    lobe.level += share * (other.level - lobe.level);
    lobe.tilt += share * (other.tilt - lobe.tilt);
    lobe.weight += other.weight;
}

}  // namespace

LobeLayout layoutOf(const LobeTable& table)
{
    return {table.axes, table.lobes, table.thetas, table.azimuths};
}

std::vector<LobeShare> lobeShares(const LobeLayout& table, const LobeLight& light,
                                  const LobeRoom& room)
{
    FBRDF_ASSERT(room.areaLights, >=, 1);
    std::vector<LobeShare> shares;
    if (table.lobes == 0 || light.isEmpty()) return shares;
    for (LobeShare share : splitLobes(table, light, room)) {
        if (light.areaLights == 0) {
            shares.push_back(share);
            continue;
        }
        const int slots = (room.vectors - share.knotVectors()) / kVectorsPerAreaLight,
                  most = std::min(slots, room.areaLights);
        for (int first = 0; first < light.areaLights; first += most) {
            share.firstArea = first;
            share.areaCount = std::min(most, light.areaLights - first);
            share.areaSlots = slotsFor(share.areaCount, slots);
            shares.push_back(share);
            share.environment = false;
        }
    }
    return shares;
}

int keptLobes(const LobeTable& table, int lobes)
{
    FBRDF_ASSERT(lobes, >=, 1);
    if (table.axes == LobeAxes::tilted) return std::min(table.lobes, lobes);
    return lobes >= 3 ? table.lobes : std::min(table.lobes, 2 * lobes - 1);
}

LobeTable withFewerLobes(const LobeTable& table, int lobes)
{
    const bool bent = table.axes == LobeAxes::bent;
    const int kept = keptLobes(table, lobes);
    if (kept == table.lobes) return table;
    const int first = bent ? (table.lobes - kept) / 2 : 0;
    LobeTable fewer = table;
    fewer.lobes = kept;
    if (!table.fewerErrors.empty()) fewer.error = table.fewerErrors[static_cast<size_t>(lobes) - 1];
    fewer.fewerErrors.clear();
    for (size_t i = 0; i < table.knots.size(); ++i) {
        LobeKnot knot = table.knots[i];
        for (int k = 0; k < table.lobes; ++k)
            if (k < first || k >= first + kept)
                absorb(knot.lobes[static_cast<size_t>(standIn(table, knot, k, first, kept))],
                       table.knots[i].lobes[static_cast<size_t>(k)]);
        fewer.knots[i].lobes = {};
        for (int k = 0; k < kept; ++k)
            fewer.knots[i].lobes[static_cast<size_t>(k)] =
                knot.lobes[static_cast<size_t>(first + k)];
    }
    return fewer;
}

}  // namespace fbrdf
