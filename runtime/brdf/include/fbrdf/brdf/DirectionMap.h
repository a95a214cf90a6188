// DirectionMap.h - tables over one direction recombined into maps whose coordinate is the direction
// itself: a parabolic map, or a cube map.
//
// A disc map (Projection.h) is warped, which costs a shader two square roots a look-up. Recombined
// it costs none: the texels are the table's values at the directions of the new texels, log2 F, and
// between them hardware interpolates. That differs from what the table says between its texels; by
// how much is computed, not guessed. Pure. References: Heidrich and Seidel 1998 (parabolic maps);
// McCool, Ang, Ahmad 2001, section 4.2 (both kinds, for these factors); OpenGL 4.6, table 8.19
// (faces), section 8.14.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/brdf/Table.h>

#include <string>

namespace fbrdf {

/// How a factor over one direction reads its map. native: where the table says; parabolic: at
/// (x, y) / (1 + z); cube: at (x, y, z).
enum class LookUp { native, parabolic, cube };

const char* lookUpName(LookUp lookUp);           ///< "native", "parabolic", "cube"
LookUp lookUpFromName(const std::string& name);  ///< throws Error(usage)

/// Why a table of the form cannot be recombined; empty where it can: it holds logs, and all its
/// factors look it up with a direction that is never below the horizon. form: valid.
std::string whyNotRecombined(const Form& form, int table, Storage storage);

constexpr int kLeastMapSize = 2, kLargestMapSize = 2048;

struct DirectionMapRequest {
    LookUp lookUp = LookUp::cube;  ///< not native
    /// Texels on a side, even, kLeastMapSize to kLargestMapSize; 0: the least power of two from 16
    /// on whose error is at most 1/64, but no more than 512 (parabolic) or 256 (cube), nor
    /// `largest`.
    int size = 0;
    int largest = kLargestMapSize;  ///< that a context can hold
    /// Cube maps are filtered across the edges of their faces for certain. Otherwise the error
    /// holds whether they are or not.
    bool seamless = false;
};

struct DirectionMap {
    LookUp lookUp = LookUp::native;
    /// float32, log2 F. parabolic: a disc of gamma 1. cube: the texels of six faces in the order
    /// and orientation of OpenGL, stacked along the third axis of a grid that is nothing but their
    /// place.
    Table table;
    /// The largest |log2| between what the map and what the table says, over directions of the
    /// hemisphere a quarter of a texel apart in the map and an eighth in the table, and a sixteenth
    /// of that for what lies between them.
    double error = 0.0;
    int size() const { return domainSize(table.domain)[0]; }
};

/// table: over a disc, in logs. Throws Error(usage) for a size out of range.
DirectionMap recombined(const Table& table, const DirectionMapRequest& request);

}  // namespace fbrdf
