// CubeLayout.h - pictures of the six faces of a cube as panoramas.
#pragma once
#include "LightPicture.h"

#include <fbrdf/environment/Panorama.h>

#include <array>

namespace fbrdf {

/// How a picture shows all directions, by its sides.
enum class LightLayout {
    latLong,
    horizontalCross,
    verticalCross,
    horizontalStrip,
    verticalStrip,
    face,
    none
};
LightLayout layoutOf(int width, int height);
/// "lat-long", "vertical cross", ...
const char* nameOf(LightLayout layout);

/// One picture of six faces; not for latLong, face and none.
Panorama panoramaOfFaces(const LightPicture& picture, LightLayout layout);
/// Square faces of the same size: right, left, up, down, forward, back.
Panorama panoramaOfFaces(const std::array<LightPicture, 6>& faces);

}  // namespace fbrdf
