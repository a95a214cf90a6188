// Filtered importance sampling (Krivanek and Colbert 2008, "Real-time Shading with Filtered
// Importance Sampling") with cells in the place of random samples: the energy of a lobe in each
// cell is exact, and a cell is one look-up of the mip level whose texels are as large.
#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/environment/Prefilter.h>

#include "CubeSample.h"

#include <cmath>

namespace fbrdf {
namespace {

/// A cell turned to an axis, with what levelOfCell makes of its solid angle alone.
struct TurnedCell {
    Vec3d direction;
    double weight, level;
};

double levelAtFaceCentre(double solidAngle, int size)
{
    return 0.5 * std::log2(0.25 * solidAngle * size * size);
}

/// By how many levels texels are smaller at a place than at the centre of a face.
double levelsBelowCentre(const Vec3d& direction)
{
    // A texel at s, t covers (1 + s^2 + t^2)^(-3/2) of the solid angle of one at the centre; the
    // largest component of a unit direction is (1 + s^2 + t^2)^(-1/2).
    const Vec3d a = glm::abs(direction);
    return -1.5 * std::log2(std::max(a.x, std::max(a.y, a.z)));
}

Vec3f convolved(const CubeImage& source, const std::vector<TurnedCell>& cells, const Vec3d& axis)
{
    const LobeFrame frame = lobeFrame(axis);
    Vec3d sum(0.0);
    for (const TurnedCell& cell : cells) {
        const Vec3d direction =
            frame.x * cell.direction.x + frame.y * cell.direction.y + axis * cell.direction.z;
        const double level = cell.level + levelsBelowCentre(direction);
        sum += cell.weight * Vec3d(sampleCubeAt(source, cubePlace(direction), level));
    }
    return Vec3f(sum);
}

std::vector<TurnedCell> turnedCells(int lobeLevel, int size)
{
    std::vector<TurnedCell> cells;
    for (const LobeCell& cell : lobeCells(lobeLevel))
        cells.push_back({Vec3d(cell.direction), double(cell.weight),
                         levelAtFaceCentre(double(cell.solidAngle), size)});
    return cells;
}

std::vector<Vec3f> prefilteredLevel(const CubeImage& source, int lobeLevel, int size, int threads)
{
    const std::vector<TurnedCell> cells = turnedCells(lobeLevel, source.size);
    const auto side = static_cast<size_t>(size);
    std::vector<Vec3f> texels(6 * side * side);
    parallelTasks(6 * side, threads, [&](size_t row) {
        for (size_t x = 0; x < side; ++x)
            texels[row * side + x] =
                convolved(source, cells,
                          cubeTexelDirection(static_cast<int>(row / side), static_cast<int>(x),
                                             static_cast<int>(row % side), size));
    });
    return texels;
}

}  // namespace

int prefilteredLevels(int size)
{
    int levels = 1;
    while (levels < kLobeLevels && (kSmallestFace << levels) <= size) ++levels;
    return levels;
}

LobeFrame lobeFrame(const Vec3d& axis)
{
    const auto axes = axesAbout(axis);
    return {axes[0], axes[1]};
}

double levelOfCell(double solidAngle, const Vec3d& direction, int size)
{
    return levelAtFaceCentre(solidAngle, size) + levelsBelowCentre(direction);
}

CubeImage prefiltered(const CubeImage& source, int size, int threads)
{
    FBRDF_ASSERT(size, >=, kSmallestFace);
    FBRDF_ASSERT((size & (size - 1)), ==, 0);
    FBRDF_ASSERT(source.levels.size(), >=, size_t(1));
    CubeImage cube{size, {}};
    const int levels = prefilteredLevels(size);
    for (int level = 0; level < levels; ++level)
        cube.levels.push_back(
            prefilteredLevel(source, kLobeLevels - levels + level, size >> level, threads));
    return cube;
}

}  // namespace fbrdf
