// DirectionMap.h - tables over one direction recombined into maps whose coordinate is the direction
// itself: a parabolic map, or a cube map.
//
// A disc map (Projection.h) is warped, which costs a shader two square roots for each look-up. A
// recombined map costs none: its texels are the table's values, log2 F, at the directions of the
// new texels, and hardware interpolates between them. That differs from the table's own
// interpolation by an error that is computed, not guessed. Pure. References: Heidrich and Seidel
// 1998 (parabolic maps);
// McCool, Ang, Ahmad 2001, section 4.2 (both kinds, for these factors); OpenGL 4.6, table 8.19
// (faces), section 8.14.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/brdf/Table.h>

#include <string>

namespace fbrdf {

/// How a factor over one direction reads its map. native: at the table's own discPosition;
/// parabolic: at (x, y) / (1 + z); cube: at (x, y, z).
enum class LookUp { native, parabolic, cube };

const char* lookUpName(LookUp lookUp);           ///< "native", "parabolic", "cube"
LookUp lookUpFromName(const std::string& name);  ///< throws Error(usage)

/// Why a table of the form cannot be recombined, or "" where it can: it must hold logs, and all its
/// factors must look it up with a direction that is never below the horizon. Expects a form that
/// validate accepts and the index of one of its tables.
std::string whyNotRecombined(const Form& form, int table, Storage storage);

constexpr int kLeastMapSize = 2, kLargestMapSize = 2048;

struct DirectionMapRequest {
    LookUp lookUp = LookUp::cube;  ///< not native
    /// Texels on a side, an even number from kLeastMapSize to kLargestMapSize. 0 chooses the least
    /// power of two from 16 on whose error is at most 1/64, but no more than 512 (parabolic), 256
    /// (cube) or `largest`.
    int size = 0;
    int largest = kLargestMapSize;  ///< texels on a side that the context can have
    /// True where cube maps are certain to be filtered across the edges of their faces. With false
    /// the error covers both ways of filtering.
    bool seamless = false;
};

struct DirectionMap {
    LookUp lookUp = LookUp::native;
    /// log2 F as float32. parabolic: a disc of gamma 1. cube: the texels of six faces in the order
    /// and orientation of OpenGL, stacked along the third axis of a grid whose maps mean nothing.
    Table table;
    /// The largest |log2| between the map and the table, over directions of the hemisphere a
    /// quarter of a texel apart in the map and an eighth in the table, plus a sixteenth of that
    /// value for the directions between them.
    double error = 0.0;
    int size() const { return domainSize(table.domain)[0]; }
};

/// As contrast(map.table); neighbours across the edges of a cube count too.
double contrast(const DirectionMap& map);

/// Expects a table over a disc, in logs. Throws Error(usage) for a size out of range.
DirectionMap recombined(const Table& table, const DirectionMapRequest& request);

}  // namespace fbrdf
