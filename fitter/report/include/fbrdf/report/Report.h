// Report.h - one fit as one HTML page: the maps, data against fit, where it fails, what else was
// tried. The page is self-contained (pictures as data: URIs, plots as inline SVG, no script,
// no address), opens offline, and follows light, dark and print. It does not contain when or where
// it was made, so that equal fits give equal pages.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/Misfit.h>
#include <fbrdf/sources/Source.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

/// One row of the table of forms tried.
struct ReportTrial {
    std::string form;         ///< name
    std::string description;  ///< describe(form)
    size_t bytes = 0;
    int lookups = 0;  ///< texture look-ups per light
    double seconds = 0;
    /// Held-out errors under the names of Metrics.h; the table has a column for each name.
    std::map<std::string, double> errors;
    bool chosen = false;
    std::string stage{};  ///< what the search varied; may be empty
};

struct ReportCounts {
    uint64_t used = 0;  ///< samples that took part in the fit
    /// Samples that could not: not finite, below the horizon, or marked as not measured.
    uint64_t invalid = 0;
    uint64_t belowFloor = 0;  ///< channel values at or below the noise floor
};

struct ReportSeconds {
    double read = 0, fit = 0, write = 0;
};

struct ReportInput {
    /// The material as stored. It must outlive the call, as must the source.
    const Material& material;
    /// Where it has no `evaluate`, plots show its samples, and the sphere shows the fit alone.
    const Source& source;
    int lookups = 0;  ///< texture look-ups per light of the material
    ReportSeconds seconds{};
    ReportCounts counts{};
    /// Counts of the data. Where unset, source.report is used, which a stream does not have.
    std::optional<SampleReport> rows{};
    Vec3f noiseFloor{0.0f};  ///< 1/sr
    SampleErrors heldOut{}, all{};
    std::string heldOutNote{};  ///< what "held out" was: "5 folds", "16,384 fresh pairs"
    PhysicsErrors physics{};
    /// Pictures of the standard sphere; one of size 0 is rendered here where it can be.
    SphereImage sphereOfData{}, sphereOfFit{};
    std::optional<ImageErrors> image{};   ///< unset: computed from the pictures where there are two
    std::vector<ReportTrial> trials{};    ///< empty: the form was asked for by name
    std::vector<MisfitRegion> misfits{};  ///< where the form cannot follow the data
    std::optional<Coverage> coverage{};   ///< of measurements
    std::string command{};                ///< how the fit was made, for people; may be empty
};

/// The page: UTF-8, HTML 5 that is well-formed XML too.
std::string reportHtml(const ReportInput& input);

/// Writes the page; it appears whole or not at all. Throws Error(output).
void writeReport(const ReportInput& input, const std::string& path);

}  // namespace fbrdf
