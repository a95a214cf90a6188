// SkyModels.h - radiance of the procedural environments, in directions.
#pragma once
#include <fbrdf/environment/Panorama.h>

namespace fbrdf {

/// The studio, in any unit: continuous, so that four samples a texel show no steps.
Vec3d studioRadiance(const Vec3d& direction);

/// Luminance of the CIE standard overcast sky over that of the zenith (Moon and Spencer 1942);
/// direction above the horizon.
double overcastLuminance(const Vec3d& direction);

/// A clear sky and its sun, in kcd/m^2 and klx: the luminance of these linear Rec. 709 colours.
struct ClearSky {
    Vec3d toSun{0.0, 1.0, 0.0};  ///< unit
    double turbidity = 3.0;

    /// Without the sun (Preetham, Shirley, Smits 1999); direction unit, above the horizon.
    Vec3d radiance(const Vec3d& direction) const;
    /// Of the sun on a surface that faces it.
    Vec3d sunIrradiance() const;
};

}  // namespace fbrdf
