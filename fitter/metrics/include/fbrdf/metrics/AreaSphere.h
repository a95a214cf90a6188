// AreaSphere.h - the scene in which area lights are compared: a sphere (SpherePicture.h), once
// under each light.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/environment/AreaTruth.h>
#include <fbrdf/metrics/SpherePicture.h>
#include <fbrdf/plan/AreaVectors.h>

#include <string>

namespace fbrdf {

struct NamedAreaLight {
    std::string name;
    AreaLight light;
};

/// Four spheres far away that fill a radius of 15 degrees, and four rectangles, three of them
/// within a diameter of the sphere.
std::vector<NamedAreaLight> comparedAreaLights();

class AreaSphere {
public:
    /// size: pixels across the sphere. Expects valid lights, at least one.
    AreaSphere(const std::vector<NamedAreaLight>& lights, int size, int threads);

    const std::vector<NamedAreaLight>& lights() const { return lights_; }

    /// One image for each light: by brute force, and by the lobes as a renderer draws them.
    std::vector<SpherePicture> truth(const Reflectance& f) const;
    std::vector<SpherePicture> lit(const LobeTable& lobes) const;

    /// How far a picture under one light is from the truth.
    struct Errors {
        double psnr = 0.0;       ///< dB, peak 1, at the exposure of exposureFor
        double reflected = 0.0;  ///< of the sum of all radiance, relative
        double rms = 0.0;        ///< of the differences, relative to the largest radiance
        double largest = 0.0;    ///< difference, relative to the same
    };
    Errors errors(const SpherePicture& image, const SpherePicture& reference, size_t light) const;

private:
    int threads_;
    std::vector<NamedAreaLight> lights_;
    std::vector<AreaVectors> vectors_;
    std::vector<AreaTruth> truths_;
    std::vector<SpherePixel> pixels_;
    std::vector<double> exposures_;
};

}  // namespace fbrdf
