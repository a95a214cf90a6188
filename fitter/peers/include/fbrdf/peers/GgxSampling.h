// GgxSampling.h - how renderers draw directions of a material of which they know a roughness: by
// the cosine for its diffuse part, by the visible normals of GGX (Heitz 2018, "Sampling the GGX
// Distribution of Visible Normals") for its highlight.
#pragma once
#include <fbrdf/metrics/SamplingVariance.h>

namespace fbrdf {

struct GgxSampling {
    double alphaX = 1.0, alphaY = 1.0;
    double highlight = 0.5;  ///< share of the directions that are drawn from GGX

    /// The density in 1/sr with which wi is drawn; both unit, above the horizon.
    double density(const Vec3d& wo, const Vec3d& wi) const;
};

struct GgxSamplingFit {
    GgxSampling sampling;
    double deviation = 0.0;  ///< ReflectedLight::deviation
    /// The same where each view direction has the share that is best there, with the widths that
    /// are then the best: more than a renderer could know.
    double deviationOfFreeShares = 0.0;
};

/// The widths, one where the material is isotropic, and the share that have the least deviation on
/// the material itself, by a search over all of them.
GgxSamplingFit bestGgxSampling(const ReflectedLight& light);

}  // namespace fbrdf
