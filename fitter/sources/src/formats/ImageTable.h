// ImageTable.h - reflectance as the pixels of one image, whatever the format of its file: linear,
// 1/sr without the cosine. The layout gives the meaning of the pixels; where a file does not name
// it, the number of pixels does:
//   "utia"     288 x 288: UTIA's grid (UtiaTable.h); line = light, column = view, as in the images
//              of that database. Any 288 x 288 image without a layout.
//   "slice"    theta_h to the right and theta_d upwards, both 0 to 90 degrees over the image, at
//              phi_d = 90 degrees: the "image slices" of Burley 2012 ("Physically-Based Shading at
//              Disney"), theta_h = 0 at the left, theta_d = 0 at the bottom. Any other size.
//   "latlong"  tiles one above the other, each a view hemisphere for one incident direction: phi_o
//              to the right from 0 to 360 degrees, theta_o downwards from 0 to 90. `angles` lists
//              the zenith angles of the tiles in degrees, comma-separated, top first; wi is at
//              azimuth 0, away from the surface like wo.
// Values are at pixel centres. Slices and lat-long tables are of isotropic materials and have
// samples only; a pixel of a lat-long tile weighs sin theta_o, its share of the sphere.
#pragma once
#include "InputFile.h"

#include <fbrdf/brdf/Conventions.h>
#include <fbrdf/sources/Source.h>

#include <string>
#include <vector>

namespace fbrdf {

struct TableImage {
    size_t width = 0, height = 0;
    std::vector<Vec3f> pixels;  ///< height x width, top line first; grey where there is one channel
    std::string layout, angles;            ///< empty where the file does not give them
    std::vector<std::string> assumptions;  ///< about the meaning of the channels

    const Vec3f& at(size_t x, size_t y) const { return pixels[y * width + x]; }
};

/// The source that an image is. `format` is the file's, for people: "OpenEXR". Throws Error(input)
/// for unknown layouts and sizes that do not fit the layout.
Source sourceOfImage(const InputFile& file, TableImage image, const std::string& format);

}  // namespace fbrdf
