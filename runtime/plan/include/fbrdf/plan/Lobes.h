// Lobes.h - which lobes of an environment a pass adds, and what they take of its program. Pure.
//
// Each lobe, and the cosine, is one look-up in the prefiltered cube (LobeTable.h). Or directions
// are drawn by the lobes, and looked up in the cube that was not prefiltered (SampledLight.h). The
// table itself is in uniforms, a few vec4 for each knot, of which a program has room for so many:
// lobes are spread over passes as look-ups and uniforms allow.
#pragma once
#include <fbrdf/brdf/LobeTable.h>

namespace fbrdf {

/// What plans and programs depend on of a LobeTable.
struct LobeLayout {
    LobeAxes axes = LobeAxes::tilted;
    int lobes = 0;  ///< 0: there is no environment
    int thetas = 0, azimuths = 1;
    int knots() const { return thetas * azimuths; }
    bool operator==(const LobeLayout& other) const
    {
        return axes == other.axes && lobes == other.lobes && thetas == other.thetas &&
               azimuths == other.azimuths;
    }
};
LobeLayout layoutOf(const LobeTable& table);

/// The lobes `first` to `first + count - 1`, and the cosine about the normal where that is set.
struct LobeShare {
    LobeLayout table = {};
    int first = 0, count = 0;
    bool cosine = false;
    /// Where not 0, so many directions are drawn by the lobes, all of which the share then has, and
    /// each costs `perSample` look-ups: the material's, and one in the environment.
    int samples = 0, perSample = 0;

    bool isEmpty() const { return count == 0 && !cosine; }
    int lookups() const { return samples > 0 ? samples * perSample : count + (cosine ? 1 : 0); }
    /// vec4 of one knot: see lobeRows (LobeRows.h).
    int rows() const { return 1 + count + (table.axes == LobeAxes::tilted && count > 1 ? 1 : 0); }
    /// vec4 uniforms of the knots; the few others are among those that every program reserves.
    int vectors() const { return isEmpty() ? 0 : table.knots() * rows(); }
    /// True where one program serves both: it has the number of directions in a uniform.
    bool operator==(const LobeShare& other) const
    {
        return table == other.table && first == other.first && count == other.count &&
               cosine == other.cosine && (samples > 0) == (other.samples > 0);
    }
};

/// All lobes and the cosine.
inline LobeShare wholeShare(const LobeLayout& table)
{
    return {table, 0, table.lobes, true, 0, 0};
}

/// All lobes in as few shares as possible, the cosine with the first; empty where not even one
/// lobe fits. lookups, vectors: the most of a share, >= 0.
std::vector<LobeShare> lobeShares(const LobeLayout& table, int lookups, int vectors);

/// The table with fewer lobes: what the others reflect is added to the one that is most like them,
/// so that energy stays. Of bent ones the middle ones remain, an odd number. lobes >= 1.
LobeTable withFewerLobes(const LobeTable& table, int lobes);

}  // namespace fbrdf
