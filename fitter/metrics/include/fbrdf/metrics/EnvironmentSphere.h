// EnvironmentSphere.h - the scene in which light from environments is compared: a sphere
// (SpherePicture.h), once in each environment. Environments are reduced to 128 x 64 texels, so that
// the sum over all of them stays affordable.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/environment/CubeImage.h>
#include <fbrdf/environment/EnvironmentTruth.h>
#include <fbrdf/metrics/SpherePicture.h>

#include <functional>
#include <vector>

namespace fbrdf {

/// The mean of whole blocks of texels, weighted by solid angle, down to at most width x height.
Panorama reduced(const Panorama& panorama, int width, int height);

class EnvironmentSphere {
public:
    using Image = SpherePicture;
    using Pixel = SpherePixel;

    /// size: pixels across the sphere; cubeSize: of the prefiltered cubes (Prefilter.h). Expects
    /// valid panoramas, at least one.
    EnvironmentSphere(const std::vector<Panorama>& environments, int size, int cubeSize,
                      int threads);

    /// A cube that is no finer than a sphere of so many pixels can show: 64 to 512.
    static int cubeSizeFor(int pixels);

    size_t environments() const { return panoramas_.size(); }
    const std::vector<Pixel>& pixels() const { return pixels_; }
    const std::vector<Panorama>& panoramas() const { return panoramas_; }

    /// One image for each environment: by brute force, and by the lobes as a renderer draws them.
    std::vector<Image> truth(const Reflectance& f) const;
    std::vector<Image> lit(const LobeTable& lobes) const;
    /// By directions that are drawn by the lobes (SampledLight.h).
    std::vector<Image> sampled(const LobeTable& lobes, const Reflectance& f, int samples) const;
    /// By any function of a pixel and an environment.
    std::vector<Image> imagesOf(
        const std::function<Vec3d(const Pixel&, size_t environment)>& radiance) const;
    /// Irradiance over pi of each pixel.
    const std::vector<Image>& irradiance() const { return irradiance_; }

    /// dB, peak 1, in one environment.
    double psnr(const Image& image, const Image& reference, size_t environment) const;

private:
    int threads_;
    std::vector<Panorama> panoramas_;
    EnvironmentTruth truth_;
    std::vector<CubeImage> unfiltered_, cubes_;
    std::vector<Pixel> pixels_;
    std::vector<Image> irradiance_;
    std::vector<double> exposures_;
};

}  // namespace fbrdf
