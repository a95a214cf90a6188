// Faces are as those of OpenGL, seen from inside, with +z of the cube forward. That frame is
// left-handed, and forward of a panorama is -z: only z changes its sign.
#include "CubeLayout.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/environment/CubeImage.h>

#include <algorithm>

namespace fbrdf {
namespace {

/// Where a face is in a picture, in faces.
struct FaceCell {
    int column, row;
    bool isUpsideDown;
};
using FaceCells = std::array<FaceCell, 6>;

constexpr FaceCells kHorizontalCross = {
    {{2, 1, false}, {0, 1, false}, {1, 0, false}, {1, 2, false}, {1, 1, false}, {3, 1, false}}};
constexpr FaceCells kVerticalCross = {
    {{2, 1, false}, {0, 1, false}, {1, 0, false}, {1, 2, false}, {1, 1, false}, {1, 3, true}}};
constexpr FaceCells kHorizontalStrip = {
    {{0, 0, false}, {1, 0, false}, {2, 0, false}, {3, 0, false}, {4, 0, false}, {5, 0, false}}};
constexpr FaceCells kVerticalStrip = {
    {{0, 0, false}, {0, 1, false}, {0, 2, false}, {0, 3, false}, {0, 4, false}, {0, 5, false}}};

/// Samples of a texel of the panorama on a side: texels are at most as large as those of faces.
constexpr int kSamplesOfTexel = 2;
/// 5792 x 2896 is about 2^24.
constexpr int kLargestFace = 1448;

const FaceCells& cellsOf(LightLayout layout)
{
    switch (layout) {
        case LightLayout::horizontalCross: return kHorizontalCross;
        case LightLayout::verticalCross: return kVerticalCross;
        case LightLayout::horizontalStrip: return kHorizontalStrip;
        default: return kVerticalStrip;
    }
}

void addFace(CubeImage& cube, const LightPicture& picture, const FaceCell& cell)
{
    const int size = cube.size;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int column = cell.column * size + (cell.isUpsideDown ? size - 1 - x : x),
                      row = cell.row * size + (cell.isUpsideDown ? size - 1 - y : y);
            cube.levels[0].push_back(
                picture.texels[static_cast<size_t>(row) * static_cast<size_t>(picture.width) +
                               static_cast<size_t>(column)]);
        }
}

Panorama panoramaOfCube(const CubeImage& cube)
{
    const int height = 2 * std::min(cube.size, kLargestFace), width = 2 * height;
    Panorama panorama{width, height, std::vector<Vec3f>(size_t(width) * size_t(height))};
    parallelTasks(static_cast<size_t>(height), 0, [&](size_t y) {
        for (int x = 0; x < width; ++x) {
            Vec3d sum(0.0);
            for (int i = 0; i < kSamplesOfTexel * kSamplesOfTexel; ++i) {
                const double u = x + (i % kSamplesOfTexel + 0.5) / kSamplesOfTexel,
                             v = double(y) + (i / kSamplesOfTexel + 0.5) / kSamplesOfTexel;
                const Vec3d w = panoramaDirection(u / width, v / height);
                sum += sampleCube(cube, {w.x, w.y, -w.z}, 0.0);
            }
            panorama.texels[y * size_t(width) + static_cast<size_t>(x)] =
                Vec3f(sum / double(kSamplesOfTexel * kSamplesOfTexel));
        }
    });
    return panorama;
}

bool hasRatio(int width, int height, int across, int down)
{
    return width % across == 0 && height % down == 0 && width / across == height / down;
}

}  // namespace

LightLayout layoutOf(int width, int height)
{
    if (hasRatio(width, height, 2, 1)) return LightLayout::latLong;
    if (hasRatio(width, height, 4, 3)) return LightLayout::horizontalCross;
    if (hasRatio(width, height, 3, 4)) return LightLayout::verticalCross;
    if (hasRatio(width, height, 6, 1)) return LightLayout::horizontalStrip;
    if (hasRatio(width, height, 1, 6)) return LightLayout::verticalStrip;
    return width == height ? LightLayout::face : LightLayout::none;
}

const char* nameOf(LightLayout layout)
{
    switch (layout) {
        case LightLayout::latLong: return "lat-long";
        case LightLayout::horizontalCross: return "horizontal cross";
        case LightLayout::verticalCross: return "vertical cross";
        case LightLayout::horizontalStrip: return "horizontal strip of six faces";
        case LightLayout::verticalStrip: return "vertical strip of six faces";
        case LightLayout::face: return "one of six faces";
        case LightLayout::none: break;
    }
    return "unknown";
}

Panorama panoramaOfFaces(const LightPicture& picture, LightLayout layout)
{
    const FaceCells& cells = cellsOf(layout);
    int columns = 0;
    for (const FaceCell& cell : cells) columns = std::max(columns, cell.column + 1);
    CubeImage cube{picture.width / columns, {{}}};
    for (const FaceCell& cell : cells) addFace(cube, picture, cell);
    return panoramaOfCube(cube);
}

Panorama panoramaOfFaces(const std::array<LightPicture, 6>& faces)
{
    CubeImage cube{faces[0].width, {{}}};
    for (const LightPicture& face : faces) addFace(cube, face, {0, 0, false});
    return panoramaOfCube(cube);
}

}  // namespace fbrdf
