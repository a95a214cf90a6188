// Source.h - reflectance from anywhere: scattered samples, a function, or both.
// Conventions: runtime/brdf/include/fbrdf/brdf/Conventions.h. Every reader turns its file's own
// into these.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fbrdf {

/// One measurement: f(wo, wi) in 1/sr, linear RGB. Below the noise floor f may be 0 or negative.
struct Sample {
    Vec3f wo, wi, f;
    float weight = 1.0f;
};

/// What a reader found. Nothing is dropped silently: given = samples.size() + nonFinite +
/// belowHorizon.
struct SampleReport {
    uint64_t given = 0;         ///< rows in the file
    uint64_t nonFinite = 0;     ///< dropped: a value or angle that is not a finite number
    uint64_t belowHorizon = 0;  ///< dropped: wo or wi at or below the horizon
    uint64_t negative = 0;      ///< kept, for the fitter to censor: a channel below 0
    uint64_t zero = 0;          ///< kept, for the fitter to censor: a channel that is exactly 0
    uint64_t outOfGamut =
        0;  ///< spectra whose linear sRGB has a negative channel (also counted in `negative`)
};

struct Source {
    std::string name;             ///< "garnet_red", "ggx:alpha=0.1"
    std::string format;           ///< "csv", "cornell", "model", "material", ...
    std::string description;      ///< one line for people: units, wavelengths, paper
    bool isotropic = false;       ///< known to be unchanged by a rotation about the normal
    std::vector<Sample> samples;  ///< empty when only a function
    SampleReport report;
    /// f(wo, wi) for any unit pair, 0 below the horizon; empty when only samples are known. Safe to
    /// call from threads.
    std::function<Vec3d(const Vec3d& wo, const Vec3d& wi)> evaluate;
};

struct SourceOptions {
    bool cosine = false;  ///< CSV values include cos theta_o (--cosine)
};

/// Opens a file (recognised by content, then by extension) or an analytic model
/// "name:key=value,...". Materials (.fbrdf, the 2001 layout) are sources with `evaluate`. Throws
/// Error(usage) for an unknown model or a parameter out of range, Error(input) for a file that is
/// missing or invalid.
Source openSource(const std::string& spec, const SourceOptions& options = {});

}  // namespace fbrdf
