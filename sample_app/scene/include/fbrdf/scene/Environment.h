// Environment.h - light from everywhere in a scene, and what is seen behind its objects.
#pragma once
#include <fbrdf/environment/Panorama.h>
#include <fbrdf/gl/Draw.h>
#include <fbrdf/scene/Image.h>

#include <optional>
#include <string>

namespace fbrdf::scene {

struct EnvironmentLight {
    Panorama panorama;
    double rotation = 0.0;   ///< radians about +y, counter-clockwise seen from above
    double intensity = 1.0;  ///< >= 0, times the radiance of the panorama
    std::string note = {};   ///< what its file was taken for, and what was repaired; empty without

    Vec3d toEnvironment(const Vec3d& world) const;
    Vec3d fromEnvironment(const Vec3d& inEnvironment) const;
    /// Radiance from a direction in the world, filtered linearly between texels.
    Vec3d radianceFrom(const Vec3d& world) const;
    /// The irradiance of a surface that faces up.
    Vec3d upwardIrradiance() const { return intensity * fbrdf::upwardIrradiance(panorama); }
};

/// What is behind the objects: their environment, one colour (linear radiance), or nothing.
struct Background {
    bool environment = false;
    std::optional<Vec3f> colour = {};
    bool isNone() const { return !environment && !colour; }
};

/// "environment", "none" or "R,G,B" of numbers >= 0. Throws Error(usage) naming --background.
Background backgroundFromText(const std::string& text);

/// Adds the background to every pixel that objects do not cover, or cover in part: as much of it as
/// 1 - alpha. Alpha stays, so that the picture still says what is covered. environment: not null
/// where the background is one.
void fillBackground(Image& image, const Background& background, const EnvironmentLight* environment,
                    const gl::View& view);

}  // namespace fbrdf::scene
