// Source.h - reflectance from anywhere: scattered samples, a function, or both.
// Samples are in memory (`samples`) or made when asked for (`stream`); forEachBlock serves both.
// Conventions: runtime/brdf/include/fbrdf/brdf/Conventions.h. Every reader turns its file's own
// into these.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fbrdf {

/// f(wo, wi) in 1/sr, linear RGB, of two unit directions; 0 where either is below the horizon.
using BrdfFunction = std::function<Vec3d(const Vec3d& wo, const Vec3d& wi)>;

/// One measurement: f(wo, wi) in 1/sr, linear RGB. Below the noise floor f may be 0 or negative.
struct Sample {
    Vec3f wo, wi, f;
    float weight = 1.0f;
};

/// What a reader found. Nothing is dropped silently: given = usable samples + nonFinite +
/// belowHorizon + invalid.
struct SampleReport {
    uint64_t given = 0;         ///< rows in the file
    uint64_t nonFinite = 0;     ///< dropped: a value or angle that is not a finite number
    uint64_t belowHorizon = 0;  ///< dropped: wo or wi at or below the horizon
    uint64_t invalid = 0;       ///< dropped: marked by the file as not measured (MERL's negatives)
    uint64_t negative = 0;      ///< kept, for the fitter to censor: a channel below 0
    uint64_t zero = 0;          ///< kept, for the fitter to censor: a channel that is exactly 0
    /// Spectra whose linear sRGB has a negative channel; they count in `negative` as well.
    uint64_t outOfGamut = 0;

    SampleReport& operator+=(const SampleReport& other);
};

/// Takes `count` samples that are valid during the call only.
using SampleVisitor = std::function<void(const Sample* samples, size_t count)>;

/// Samples that are made when asked for: rows of a file too large for memory, or the native grid of
/// a table. Empty (false) when there are none.
struct SampleStream {
    uint64_t rows = 0;  ///< rows in all, usable or not
    /// Equal for two sources whose row k is the same pair of directions for every k; empty where
    /// that is not known. What a fitter may key a cache of geometry by.
    std::string geometry;
    /// Appends the usable samples among rows [first, first + count), count <= rows - first, to
    /// `out` and adds what it found to `report`. Safe to call from threads.
    std::function<void(uint64_t first, size_t count, std::vector<Sample>& out,
                       SampleReport& report)>
        read;

    explicit operator bool() const { return static_cast<bool>(read); }
    /// All usable samples, in order, in blocks.
    void operator()(const SampleVisitor& visit) const;
};

struct Source {
    std::string name;         ///< "garnet_red", "ggx:alpha=0.1"
    std::string format;       ///< "csv", "cornell", "model", "material", ...
    std::string description;  ///< one line for people: units, wavelengths, paper
    /// What the file does not state and the reader took for granted: units, the white of XYZ, the
    /// side, the band, the symmetry. One entry for each, for people.
    std::vector<std::string> assumptions;
    bool isotropic = false;       ///< known to be unchanged by a rotation about the normal
    bool exact = false;           ///< samples or stream are values of `evaluate`, without noise
    std::vector<Sample> samples;  ///< empty when streamed, or when only a function
    SampleStream stream;          ///< empty when all are in `samples`, or when only a function
    SampleReport report;          ///< of `samples`; of a stream see reportOf
    /// Takes any unit pair; empty when only samples are known. Safe to call from threads.
    BrdfFunction evaluate;
};

/// True when the source has samples of its own, in memory or streamed.
bool hasSamples(const Source& source);

/// Visits every usable sample once, in order, in blocks of at most kSampleBlock.
void forEachBlock(const Source& source, const SampleVisitor& visit);
constexpr size_t kSampleBlock = 65536;

/// The source's report: known at once for samples in memory, a pass over all rows for a stream.
SampleReport reportOf(const Source& source);

}  // namespace fbrdf
