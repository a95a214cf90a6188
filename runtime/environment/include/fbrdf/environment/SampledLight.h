// SampledLight.h - what a surface reflects of an environment, by directions that are drawn from the
// lobes of its material, each looked up at the level of a cube whose texels are as large as the
// share of the sphere that it stands for: filtered importance sampling (Krivanek, Colbert 2008,
// "Real-time Shading with Filtered Importance Sampling"). What the renderer draws with
// EnvironmentLight::samples, on the CPU.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/CubeImage.h>
#include <fbrdf/environment/Reflectance.h>

namespace fbrdf {

/// The most directions that may be asked for: more gain nothing where each is filtered.
constexpr int kMostSamples = 4096;

/// The radiance that leaves towards wo (unit, above the horizon): the mean of f L cos theta_i / pdf
/// over the directions of a lattice (SampleLattice.h). cube: not prefiltered, with all levels, in
/// the frame's space. table: not empty. samples: 1 to kMostSamples.
Vec3d sampledLight(const CubeImage& cube, const LobeTable& table, const Reflectance& f,
                   const ShadingFrame<double>& frame, const Vec3d& wo, int samples);

}  // namespace fbrdf
