// Metrics.h - how far a function is from reflectance: on samples, as pictures, and against physics.
#pragma once
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/metrics/StandardSphere.h>
#include <fbrdf/sources/Source.h>

#include <map>
#include <string>
#include <vector>

namespace fbrdf {

/// Differences g - f over samples; c = cos theta_i. Means over samples, each channel alone, then
/// averaged.
struct SampleErrors {
    double logRms = 0;            ///< rms of ln(g / f) over samples above the noise floor
    double logMedian = 0;         ///< median of |ln(g / f)|, likewise
    Vec3d logMedianChannel{0.0};  ///< the same for R, G, B
    double cosRms = 0;            ///< sqrt(sum (c (g - f))^2 / sum (c f)^2)
    double cubeRootRms = 0;       ///< the same on (c f)^(1/3)
    /// Mean |ln(1 + c g) - ln(1 + c f)| (Sztrajman et al. 2021, Eq. 5).
    double nbrdfLoss = 0;
};

/// `fitted`: as many values as samples. `noiseFloor`: a channel of f at or below it takes no part
/// in the log errors. Negative f counts as 0.
SampleErrors sampleErrors(const std::vector<Sample>& samples, const std::vector<Vec3f>& fitted,
                          const Vec3f& noiseFloor);

/// g evaluated (float, as the shader does) at the samples' pairs.
std::vector<Vec3f> evaluateAt(const Material& material, const std::vector<Sample>& samples,
                              int threads);
std::vector<Vec3f> evaluateAt(const BrdfFunction& brdf, const std::vector<Sample>& samples,
                              int threads);

/// Median |ln f(a, b) / f(b, a)| over the uniform test set, all channels; or over a smaller set
/// that is made in the same way.
double medianReciprocityError(const BrdfFunction& brdf, int threads,
                              size_t pairCount = kUniformTestPairs);

/// w mirrored at the plane of the normal and x.
inline Vec3d mirrored(const Vec3d& w)
{
    return {w.x, -w.y, w.z};
}

/// The same of f and its mirror image: of an isotropic f, how unlike each other the two sides of
/// the plane of incidence are.
double medianMirrorError(const BrdfFunction& brdf, int threads,
                         size_t pairCount = kUniformTestPairs);

struct PhysicsErrors {
    /// What medianReciprocityError gives for the whole set.
    double reciprocity = 0;
    /// Largest directional albedo over 16 incidences from 0 to 85 degrees, any channel.
    double albedoMax = 0;
};
PhysicsErrors physicsErrors(const BrdfFunction& brdf, int threads);

/// Directional albedo: integral of f cos theta_o over wo, for light at zenith angle theta_i,
/// azimuth phi_i. Within 1e-4 for tables of up to some hundred texels a side; a function with steps
/// costs up to 130,000 evaluations, others a tenth of that.
Vec3d directionalAlbedo(const BrdfFunction& brdf, double theta_i, double phi_i = 0.0);

/// The errors by their names in docs/method.md, section Errors: "log_rms", "cos_rms", ...
std::map<std::string, double> named(const SampleErrors& errors);
std::map<std::string, double> named(const ImageErrors& errors);
std::map<std::string, double> named(const PhysicsErrors& errors);

}  // namespace fbrdf
