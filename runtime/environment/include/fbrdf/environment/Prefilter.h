// Prefilter.h - an environment convolved with the lobes of LobeTable.h: one cube for all materials.
//
// The levels of the cube are those of the lobes: with kSmallestFace << m texels on a side at level
// 0 it has m + 1 of them, at most kLobeLevels, and the last is always the cosine. A cube of 512 has
// all seven; one of 128 begins with lobe level 2, and narrower lobes read that.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/environment/CubeImage.h>

namespace fbrdf {

constexpr int kSmallestFace = 8;  ///< texels on a side of the cosine level of a cube up to 512

/// Levels of a prefiltered cube: expects a power of two from kSmallestFace on.
int prefilteredLevels(int size);
/// The level of a prefiltered cube at which a lobe level is stored; negative ones read level 0.
inline double cubeLevelOf(double lobeLevel, int size)
{
    return lobeLevel - (kLobeLevels - prefilteredLevels(size));
}

/// A right-handed frame whose z axis is a lobe's axis.
struct LobeFrame {
    Vec3d x, y;
};
/// The frame about a unit axis: axesAbout (AxesAbout.h). It jumps at z = 0. Twin: fbrdfLobeFrame.
LobeFrame lobeFrame(const Vec3d& axis);

/// One cell of the quadrature of a lobe about +z.
struct LobeCell {
    Vec3f direction;   ///< unit
    float weight;      ///< at least 0; all add up to 1
    float solidAngle;  ///< of the cell, sr
};
/// Rings of cells about as long as wide that cover the half sphere: fine where the lobe is high,
/// coarse in its tail. Their weights are those whose sum of look-ups (levelOfCell) is nearest to
/// the lobe: about its energy in the cell, less what linear filtering blurs. At most kMostCells,
/// and about 200 for the narrowest lobe. level: 0 to kCosineLevel.
std::vector<LobeCell> lobeCells(int level);
constexpr int kMostCells = 2048;

/// The level of a cube (of `size` texels on a side) whose texels are as large as a cell, at a unit
/// direction. Not clamped.
double levelOfCell(double solidAngle, const Vec3d& direction, int size);

/// Convolves: for each texel the sum over the cells of weight times the source at the level of the
/// cell. source: from cubeOfPanorama. size: as above.
CubeImage prefiltered(const CubeImage& source, int size, int threads = 0);

/// A lobe of a level, as the renderer looks it up.
inline Vec3d samplePrefiltered(const CubeImage& cube, const Vec3d& axis, double lobeLevel)
{
    return sampleCube(cube, axis, cubeLevelOf(lobeLevel, cube.size));
}

}  // namespace fbrdf
