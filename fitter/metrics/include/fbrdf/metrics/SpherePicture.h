// SpherePicture.h - a sphere of radius 1 about the origin, seen along -z by a parallel projection,
// as the pixels of its disc; what pictures of it are compared by.
#pragma once
#include <fbrdf/brdf/ShadingFrame.h>

#include <functional>
#include <vector>

namespace fbrdf {

struct SpherePixel {
    ShadingFrame<double> frame;  ///< frame.n is also the place on the sphere
    Vec3d wo;                    ///< local
    bool isSeen() const;         ///< views below half a degree are left black
};

/// Radiance of the pixels of the disc.
using SpherePicture = std::vector<Vec3d>;

/// The pixels whose centres are on the disc; size: pixels across it.
std::vector<SpherePixel> spherePixels(int size);

/// The picture of a function of a pixel that is seen. threads: 0: one a core.
SpherePicture spherePicture(const std::vector<SpherePixel>& pixels, int threads,
                            const std::function<Vec3d(const SpherePixel&)>& radiance);

/// The exposure at which a Lambertian of albedo 1/2 averages 0.4. irradiance: over pi.
double exposureFor(const SpherePicture& irradiance);

/// dB, peak 1, of what is shown at an exposure: values are clamped to [0, 1].
double psnr(const SpherePicture& image, const SpherePicture& reference, double exposure);

}  // namespace fbrdf
