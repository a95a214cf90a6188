// Panorama.h - light from everywhere as a picture: latitude and longitude of the direction.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <string>
#include <vector>

namespace fbrdf {

/// Radiance from every direction, linear Rec. 709, constant over each texel. Row 0 is at +y;
/// u = 0.5 + atan2(x, -z) / (2 pi), so the middle column is at -z and +x is to the right of it.
struct Panorama {
    int width = 0, height = 0;
    std::vector<Vec3f> texels;  ///< rows from the top, each from the left

    const Vec3f& texel(int x, int y) const
    {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

/// Throws Error(input) naming `where` unless there is at least one texel, as many as promised, and
/// each is finite and not negative.
void validate(const Panorama& panorama, const std::string& where);

/// The unit direction of a place of the picture, u and v in [0, 1]; v = 0 is +y.
Vec3d panoramaDirection(double u, double v);
/// (u, v) of a direction, which need not be unit; u is 0.5 at the poles.
Vec2<double> panoramaPlace(const Vec3d& direction);
/// The solid angle of a texel in row y, in sr: those of all texels add up to 4 pi.
double texelSolidAngle(const Panorama& panorama, int y);
/// The irradiance of a surface that faces up.
Vec3d upwardIrradiance(const Panorama& panorama);

/// The panorama with at most `most` texels on a side, >= 1: each the mean over its solid angle.
Panorama reduced(const Panorama& panorama, int most);

}  // namespace fbrdf
