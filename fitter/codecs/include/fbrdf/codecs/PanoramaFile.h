// PanoramaFile.h - light from everywhere, read from pictures as they are published.
#pragma once
#include <fbrdf/environment/Panorama.h>

#include <string>

namespace fbrdf {

/// Reads OpenEXR, Radiance HDR (.hdr, .pic), PNG, JPEG and TIFF, by their content. What the picture
/// shows follows from its sides:
/// - 2:1: latitude and longitude, as in Panorama.h;
/// - 4:3 and 3:4: a cross of the faces of a cube. The face in the middle is forward, -z of a
///   panorama; the lowest one of a vertical cross, the back, stands on its head;
/// - 6:1 and 1:6: the faces right, left, up, down, forward, back;
/// - 1:1: one of six files whose names differ in px nx py ny pz nz, posx negx ..., or right left
///   top bottom front back; pz and front are forward.
/// Pictures of more than 2^24 pixels are averaged while they are read. Negative values count as 0;
/// of those that are no number the one before in the row is taken, and infinite ones become the
/// largest half. Integer samples are taken for sRGB.
///
/// note: if not null, becomes one line that says what was taken and repaired. Throws Error(input).
Panorama readPanorama(const std::string& path, std::string* note = nullptr);

}  // namespace fbrdf
