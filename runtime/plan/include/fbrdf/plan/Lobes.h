// Lobes.h - which lobes of a material a pass adds, what lights them, and what they take of its
// program. Pure.
//
// Each lobe, and the cosine, is one look-up in the prefiltered cube of an environment
// (LobeTable.h); area lights need none (AreaContour.h). Or directions are drawn by the lobes, and
// looked up in the cube that was not prefiltered (SampledLight.h). The table itself is in uniforms,
// a few vec4 for each knot, and so are area lights. A program has room for so many: lobes, and
// lights, are spread over passes as look-ups and uniforms allow.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/plan/AreaVectors.h>

namespace fbrdf {

/// What plans and programs depend on of a LobeTable.
struct LobeLayout {
    LobeAxes axes = LobeAxes::tilted;
    int lobes = 0;  ///< 0: the material has none
    int thetas = 0, azimuths = 1;
    int knots() const { return thetas * azimuths; }
    bool operator==(const LobeLayout& other) const
    {
        return axes == other.axes && lobes == other.lobes && thetas == other.thetas &&
               azimuths == other.azimuths;
    }
};
LobeLayout layoutOf(const LobeTable& table);

/// What a draw lights lobes with.
struct LobeLight {
    bool environment = false;
    int areaLights = 0;  ///< AreaVectors, >= 0
    bool isEmpty() const { return !environment && areaLights == 0; }
};

/// The lobes `first` to `first + count - 1`, and the cosine about the normal where that is set, lit
/// by the environment where that is set and by some area lights.
struct LobeShare {
    LobeLayout table = {};
    int first = 0, count = 0;
    bool cosine = false;
    bool environment = true;
    int firstArea = 0, areaCount = 0;
    int areaSlots = 0;  ///< area lights for which the program has room, at least areaCount
    /// Where not 0, so many directions of the environment are drawn by the lobes, all of which the
    /// share then has, and each costs `perSample` look-ups: the material's, and one in the
    /// environment. Such a share has no area lights.
    int samples = 0, perSample = 0;

    bool isEmpty() const { return count == 0 && !cosine; }
    int lookups() const
    {
        if (samples > 0) return samples * perSample;
        return environment ? count + (cosine ? 1 : 0) : 0;
    }
    /// vec4 of one knot: see lobeRows (LobeRows.h).
    int rows() const { return 1 + count + (table.axes == LobeAxes::tilted && count > 1 ? 1 : 0); }
    /// vec4 uniforms of the knots.
    int knotVectors() const { return isEmpty() ? 0 : table.knots() * rows(); }
    /// vec4 uniforms of knots and lights; the few others are among those that every program
    /// reserves.
    int vectors() const { return knotVectors() + kVectorsPerAreaLight * areaSlots; }
    /// True where one program serves both: it has the number of directions in a uniform.
    bool operator==(const LobeShare& other) const
    {
        return table == other.table && first == other.first && count == other.count &&
               cosine == other.cosine && environment == other.environment &&
               firstArea == other.firstArea && areaCount == other.areaCount &&
               areaSlots == other.areaSlots && (samples > 0) == (other.samples > 0);
    }
};

/// All lobes and the cosine.
inline LobeShare wholeShare(const LobeLayout& table)
{
    LobeShare share{table};
    share.count = table.lobes;
    share.cosine = true;
    return share;
}

/// What a pass has for lobes.
struct LobeRoom {
    int lookups = 0, vectors = 0;  ///< >= 0
    int areaLights = 0;            ///< the most in one pass, >= 1; slots do not count
};

/// All lobes in as few shares as possible, the cosine with the first, each with every light; empty
/// where nothing lights them or where not even one lobe fits.
std::vector<LobeShare> lobeShares(const LobeLayout& table, const LobeLight& light,
                                  const LobeRoom& room);

/// How many lobes of a table a draw has that asks for `lobes` >= 1: so many tilted ones at most; of
/// bent ones 1, 3, or from 3 on all.
int keptLobes(const LobeTable& table, int lobes);

/// The table with fewer lobes: the one that is most like the others takes their weights, so that
/// energy stays, and is as wide and as tilted as they are on average. Of bent ones the middle ones
/// remain, an odd number. Its error is that of LobeTable::fewerErrors, or the whole table's where
/// that is not known. lobes >= 1.
LobeTable withFewerLobes(const LobeTable& table, int lobes);

}  // namespace fbrdf
