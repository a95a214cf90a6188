#include <fbrdf/plan/LightClusters.h>

#include "ClusterLists.h"
#include "ListEdits.h"
#include "StrongestLights.h"
#include "WorkVectors.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// Waking a thread takes as long as the lists of some hundred lights.
constexpr size_t kFewLights = 512;
constexpr int kMostThreads = 4;
constexpr int kMostOnASide = std::numeric_limits<int16_t>::max();  // of a span

void checkGrid(const ClusterGrid& grid)
{
    for (const int side : {grid.columns, grid.rows, grid.slices})
        if (side < 0 || side > kMostOnASide)
            throw Error(ErrorKind::usage, "lists of lights",
                        Found("a grid with " + std::to_string(side) + " on a side")
                            .expected("0 to " + std::to_string(kMostOnASide)));
}

int longestOf(const LightClusters& clusters)
{
    int32_t longest = 0;
    for (size_t k = 1; k < clusters.lists.size(); k += 2)
        longest = std::max(longest, clusters.lists[k]);
    return clusters.lists.empty() ? 0 : clusters.everywhere + longest;
}

}  // namespace

/// What is asked of the builder beside lights.
struct ClusterBuilder::Asked {
    glm::dmat4 projection{1.0};
    ClusterGrid grid;
    int mostPerList = 0;
    bool lists = true;  ///< false: what a GPU makes them from

    bool operator==(const Asked& other) const
    {
        return projection == other.projection && grid == other.grid &&
               mostPerList == other.mostPerList && lists == other.lists;
    }
};

/// What the lists were made from, and what making them needs. Memory is kept because so much of it
/// costs more than filling it.
struct ClusterBuilder::Scratch {
    Asked asked;        ///< in the last call
    bool made = false;  ///< the lists are whole

    KnownLights known;
    ReachSums sums;
    ClusterTiles tiles;
    ListMemory lists;
    EditMemory edits;
    ClusterWork work;
    Workers alone{1}, crew{std::min(threadCount(0), kMostThreads)};

    Workers& workersFor(size_t lights) { return lights < kFewLights ? alone : crew; }
    bool edit(LightClusters& clusters, const std::vector<LightVectors>& lights,
              const Comparison& comparison);
    void remember(const Comparison& comparison);
    void setLights(LightClusters& clusters, const std::vector<LightVectors>& lights) const;
    void make(LightClusters& clusters, const std::vector<LightVectors>& lights);
};

/// Changes the lists; returns false where they have to be made anew.
bool ClusterBuilder::Scratch::edit(LightClusters& clusters, const std::vector<LightVectors>& lights,
                                   const Comparison& comparison)
{
    // A list is changed in the time in which so many entries of new ones are made.
    constexpr size_t kEntriesPerEdit = 64;
    if (!asked.lists || asked.mostPerList > 0 || !(rounded(comparison.sums) == sums)) return false;
    const auto hasRadius = [&](const LightChange& change) {
        const auto place = static_cast<size_t>(change.place);
        const int32_t slot = known.slots[place];
        return !isUnlimited(lights[place]) &&
               (slot < 0 || !isUnlimited(clusters.lights[static_cast<size_t>(slot)]));
    };
    for (const auto& block : comparison.changes)
        if (!std::all_of(block.begin(), block.end(), hasRadius)) return false;
    ListEditor editor(clusters, tiles, known, edits, edits.entries / kEntriesPerEdit);
    for (const auto& block : comparison.changes)
        for (const LightChange& change : block)
            if (!editor.apply(change, lights[static_cast<size_t>(change.place)])) return false;
    return true;
}

/// For lists that are made anew, which only asks whether a slot is negative.
void ClusterBuilder::Scratch::remember(const Comparison& comparison)
{
    for (const auto& block : comparison.changes)
        for (const LightChange& change : block) {
            const auto place = static_cast<size_t>(change.place);
            known.slots[place] = change.isSeen ? 0 : -1;
            known.reaches[place] = change.reach;
        }
}

/// Sets the lights that can be seen, those without a radius first unless they stand in lists.
void ClusterBuilder::Scratch::setLights(LightClusters& clusters,
                                        const std::vector<LightVectors>& lights) const
{
    std::vector<int32_t> listed;
    clusters.places.clear();
    for (size_t i = 0; i < lights.size(); ++i) {
        if (known.slots[i] < 0) continue;
        const bool isEverywhere = asked.mostPerList == 0 && isUnlimited(lights[i]);
        (isEverywhere ? clusters.places : listed).push_back(static_cast<int32_t>(i));
    }
    clusters.everywhere = static_cast<int>(clusters.places.size());
    clusters.places.insert(clusters.places.end(), listed.begin(), listed.end());
    clusters.lights.clear();
    for (const int32_t place : clusters.places)
        clusters.lights.push_back(lights[static_cast<size_t>(place)]);
}

void ClusterBuilder::Scratch::make(LightClusters& clusters, const std::vector<LightVectors>& lights)
{
    setLights(clusters, lights);
    for (size_t slot = 0; slot < clusters.places.size(); ++slot)
        known.slots[static_cast<size_t>(clusters.places[slot])] = static_cast<int32_t>(slot);
    clusters.grid = asked.grid;
    clusters.dropped = 0;
    tiles = ClusterTiles(clusters, asked.projection, setGrid(clusters, sums));
    Workers& workers = workersFor(clusters.lights.size());
    if (!asked.lists) {
        clusters.lists.clear();
        clusters.indices.clear();
        return setWork(clusters, tiles, known.reaches, workers, work);
    }
    setLists(clusters, tiles, known.reaches, workers, lists);
    if (asked.mostPerList > 0) keepStrongest(clusters, tiles, asked.mostPerList);
    edits.rooms.clear();
    edits.entries = clusters.indices.size();
}

ClusterBuilder::ClusterBuilder() : scratch_(std::make_unique<Scratch>()) {}
ClusterBuilder::~ClusterBuilder() = default;
ClusterBuilder::ClusterBuilder(ClusterBuilder&&) noexcept = default;
ClusterBuilder& ClusterBuilder::operator=(ClusterBuilder&&) noexcept = default;

const ClusterWork& ClusterBuilder::work() const
{
    return scratch_->work;
}

bool ClusterBuilder::update(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid, int mostPerList)
{
    if (!update(lights, {projection, grid, mostPerList, true})) return false;
    clusters_.longest = longestOf(clusters_);
    return true;
}

bool ClusterBuilder::updateWork(const std::vector<LightVectors>& lights,
                                const glm::dmat4& projection, const ClusterGrid& grid)
{
    if (!update(lights, {projection, grid, 0, false})) return false;
    clusters_.longest = static_cast<int>(clusters_.lights.size());
    return true;
}

bool ClusterBuilder::update(const std::vector<LightVectors>& lights, const Asked& asked)
{
    checkGrid(asked.grid);
    Scratch& s = *scratch_;
    Workers& workers = s.workersFor(lights.size() / 4);
    const bool isComparable = s.made && lights.size() == s.known.slots.size() && asked == s.asked &&
                              !manyHaveChanged(lights, clusters_);
    s.made = false;  // until all of it is
    s.asked = asked;
    wereEdited_ = false;
    if (isComparable) {
        const Comparison comparison =
            compareLights(lights, asked.projection, clusters_, s.known, workers);
        if (comparison.count() == 0) {
            s.made = true;
            return false;
        }
        wereEdited_ = s.edit(clusters_, lights, comparison);
        if (!wereEdited_) s.remember(comparison);
        s.sums = rounded(comparison.sums);
    } else {
        s.sums = rounded(lookAfresh(lights, asked.projection, s.known, workers));
    }
    if (!wereEdited_) s.make(clusters_, lights);
    return s.made = true;
}

LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid, int mostPerList)
{
    ClusterBuilder builder;
    builder.update(lights, projection, grid, mostPerList);
    return builder.clusters();
}

LightList lightList(const LightClusters& clusters, const glm::dvec2& ndc, double distance)
{
    const ClusterGrid& grid = clusters.grid;
    const auto tile = [](double x, int count) {
        return std::clamp(static_cast<int>(std::floor((0.5 * x + 0.5) * count)), 0, count - 1);
    };
    const int cluster =
        (sliceOf(clusters, distance) * grid.rows + tile(ndc.y, grid.rows)) * grid.columns +
        tile(ndc.x, grid.columns);
    const auto at = 2 * static_cast<size_t>(cluster);
    return {clusters.lists[at], clusters.lists[at + 1]};
}

}  // namespace fbrdf
