// ListEdits.h - changes lists where a few lights have moved: each is taken out of the clusters that
// it has left and put into those that it has reached.
#pragma once
#include "ClusterSpans.h"
#include "SeenLights.h"

#include <vector>

namespace fbrdf {

/// What is kept between calls.
struct EditMemory {
    std::vector<int32_t> rooms;  ///< entries that each list may grow to; empty: as many as it has
    std::vector<LightSpan> before, after;
    size_t entries = 0;  ///< of all lists together
};

/// Applies changes to lists of lights that all have a radius, before and after. The order in a list
/// stays that of the places of its lights.
class ListEditor {
public:
    /// known, memory: of these clusters. most: lists to change at most.
    ListEditor(LightClusters& clusters, const ClusterTiles& tiles, KnownLights& known,
               EditMemory& memory, size_t most);

    /// Returns false where the lists would have to be made anew, because too many of them change;
    /// lights and places are right in any case, and some lists may not be.
    bool apply(const LightChange& change, const LightVectors& light);

private:
    void addSpansOf(const Reach& reach, std::vector<LightSpan>& spans) const;
    void changeLists(int32_t slot);
    void changeRow(const LightSpan& row, int outFirst, int outLast, int inFirst, int inLast,
                   int32_t slot);
    void takeOut(size_t cluster, int32_t slot);
    void putIn(size_t cluster, int32_t slot);
    void makeRoom(size_t cluster);
    void freeSlot(int32_t slot);
    size_t clusterOf(const LightSpan& row, int column) const;
    /// The index in a list at which a light stands or would stand.
    int32_t* find(size_t cluster, int32_t slot) const;

    LightClusters& clusters_;
    const ClusterTiles& tiles_;
    KnownLights& known_;
    EditMemory& memory_;
    size_t left_;  ///< lists that may still change
};

}  // namespace fbrdf
