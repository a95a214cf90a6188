// FitJob.h - the work that `fit` and `batch` share: one source becomes one material, with its
// errors and notes.
#pragma once
#include "Errors.h"
#include "Progress.h"
#include "Scene.h"

#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/sources/OpenSource.h>

#include <memory>
#include <string>

namespace fbrdf::tool {

struct FitJob {
    std::string source;  ///< as on the command line
    SourceOptions sourceOptions;
    FitOptions fit;
    LobeFitOptions lobes;  ///< for light from environments; 0 lobes: none are fitted
};

/// Seconds of each phase.
struct FitTimes {
    double read = 0.0, fit = 0.0, lobes = 0.0, measure = 0.0;
};

struct FitOutcome {
    Source source;
    SampleReport report;
    FitSummary summary;
    std::shared_ptr<const Material> material;  ///< with name, notes and errors
    ErrorMap heldOut, all;                     ///< on samples
    Scene scene;                               ///< on pictures, and physics
    FitTimes times;
};

/// Reads, fits and measures. Throws what openSource and fitMaterial throw.
FitOutcome runFitJob(const FitJob& job, Progress& progress);

/// Counts the texels of all tables that are marked as supported by no sample.
size_t unsupportedTexels(const Material& material);

/// Counts the samples that the reader dropped.
uint64_t invalidSamples(const SampleReport& report);

/// What the fit made of its prior, for people.
std::string priorText(const FitSummary& summary);

/// The material's notes "source" and "options" for a job. They name no folder, and nothing that
/// leaves the result as it is, so that equal notes mean the same fit of the same file name.
std::string sourceNote(const std::string& source);
std::string optionsNote(const FitJob& job);
/// The material's note "generator": the program and its version.
std::string generatorNote();

// Keys of Material::errors: errors on samples have a prefix for the set, the others have none.
constexpr char kHeldOutPrefix[] = "held_out.";
constexpr char kAllPrefix[] = "all.";
// Keys of Material::notes.
constexpr char kSourceNote[] = "source", kOptionsNote[] = "options", kGeneratorNote[] = "generator",
               kUsedNote[] = "samples used", kInvalidNote[] = "samples invalid",
               kBelowFloorNote[] = "values below floor", kFloorNote[] = "noise floor",
               kSmoothnessNote[] = "smoothness", kMisfitNote[] = "does not hold",
               kCoverageNote[] = "coverage", kAssumedNote[] = "assumed";

}  // namespace fbrdf::tool
