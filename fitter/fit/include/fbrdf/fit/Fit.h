// Fit.h - from reflectance to a material.
//
// log f is a sum of log texels, so one term is a sparse linear least-squares problem
// (docs/method.md, Eq. 5); sums of terms and other metrics are solved by Gauss-Newton on the same
// rows. Minimised, per channel:
//   sum_n w_n (log2 f_n - log2 g(x)_n)^2 + smoothness |L x|^2
#pragma once
#include <fbrdf/fit/SolverSummary.h>
#include <fbrdf/fit/TablePrior.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/Misfit.h>
#include <fbrdf/sources/Source.h>

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

/// The function of f and g whose difference is the residual.
enum class Metric { log, cubeRoot, log1p };
const char* metricName(Metric metric);           ///< "log", "cuberoot", "log1p"
Metric metricFromName(const std::string& name);  ///< throws Error(usage)

/// The processes that fit one data set together: each reads its share of the rows, sums are added
/// up over all of them, and every process gets the same material.
struct RankSum {
    size_t rank = 0, count = 1;
    /// Adds arrays of equal length up, element by element; every process gets the sums. Called in
    /// the same order by all.
    std::function<void(double* values, size_t count)> add;

    template <class Allocator>
    void sum(std::vector<double, Allocator>& values) const
    {
        if (count > 1) add(values.data(), values.size());
    }
};

/// Rows and factorizations that fits to data on the same grid of directions share: the second fit
/// of a MERL file in the same form takes a fraction of the time of the first. Safe to use from
/// threads.
class FitCache;
std::shared_ptr<FitCache> makeFitCache();

/// Whoever waits for a fit sees what it does, and may end it. Both are called between steps, by
/// several threads at once; either may be empty.
struct FitWatch {
    std::function<void(const std::string& doing)> tell;  ///< for people: "trying hdio"
    std::function<bool()> isStopped;                     ///< true: fitMaterial throws FitStopped

    void say(const std::string& doing) const
    {
        check();
        if (tell) tell(doing);
    }
    void check() const;  ///< throws FitStopped where it is stopped
};

/// Not an Error: nothing is wrong with the data.
class FitStopped : public std::exception {
public:
    const char* what() const noexcept override { return "the fit was stopped"; }
};

struct FitOptions {
    /// A name of namedForms(), a sum such as "io+hdio", a name of directForms(), "auto", or
    /// "best-of": auto that goes on to other sizes and warps of the best form, for as long as it
    /// finds better ones.
    std::string form = "auto";
    std::optional<Form> formData;  ///< a form as data, fitted as it is; `form` is ignored then
    int resolution = 0;   ///< texels along the main axis of the form; 0: the form's own default
    size_t maxBytes = 0;  ///< > 0: no material larger than this
    int lookups = 2;      ///< at least lookupsPerPass() of the form, >= 1
    int terms = 2;        ///< the most terms of a sum that auto tries, >= 1
    /// > 0: auto begins no trial after half of these seconds; the other half is for the last fit.
    /// What it finds then depends on the machine. 0: it tries all that it would.
    double seconds = 0;
    Storage storage = Storage::log8;  ///< svd always stores signed half floats
    Metric metric = Metric::log;
    bool robust = true;  ///< Tukey biweight reweighting of scattered samples
    SolverOptions solver;
    /// Strength relative to the data, > 0; unset: the one with the least held-out error.
    std::optional<double> smoothness;
    bool heldOut = true;  ///< measure held-out errors too: a fit of its own
    /// Errors are computed on at most so many samples, > 0.
    size_t measured = 200000;
    uint64_t seed = 1;  ///< decides the held-out folds and the samples drawn from functions
    int threads = 0;    ///< 0: one for each core
    /// R, G and B share the shape of every map and differ by a scale: a third of the bytes.
    bool sharedShape = false;
    /// Scale the stored material down, all channels alike, so that no directional albedo exceeds 1.
    /// The albedo is computed every 2 degrees from 0 to 88; for an anisotropic form in 4 azimuths.
    bool conserve = false;
    /// Scattered samples of an isotropic surface that was tilted when it was measured are fitted
    /// about the surface's own normal (FitSummary::tilt).
    bool straightens = true;
    /// Fits of hdio to few scattered samples may lean on a prior (TablePrior.h); auto, and hdio
    /// without a resolution, do where that has the least error on samples held out.
    bool usePrior = true;
    std::shared_ptr<const TablePrior> prior;  ///< null: the one that comes with the library
    std::shared_ptr<FitCache> cache;          ///< may be null
    RankSum ranks;
    FitWatch watch;
};

/// The names that stand for a search of the form.
constexpr const char* kAuto = "auto";
constexpr const char* kBestOf = "best-of";
inline bool isSearched(const FitOptions& options)
{
    return !options.formData && (options.form == kAuto || options.form == kBestOf);
}

/// One form that was tried.
struct Trial {
    std::string form;   ///< name
    std::string stage;  ///< what the search varied: "form", "prior", "size", "warp" or "final"
    std::string description;  ///< describe(form)
    size_t bytes = 0;
    int lookups = 0;  ///< per light
    double seconds = 0;
    SampleErrors heldOut;
    /// What decides, the less the better: the geometric mean of the errors that are seen
    /// (log_median, cos_rms with the hue of highlights, cuberoot_rms), held out and, of few
    /// samples, on all; with another metric than log its own error. 0: left out, for want of time.
    double score = 0;
    bool chosen = false;  ///< the one that was fitted in the end
};

/// Fewer samples do not show which of two forms is better: a fit that may lean on a prior does.
constexpr size_t kFewestCompared = 32;

/// What a fit made of its prior.
struct PriorSummary {
    /// Standard deviations, relative: of tables about the modes of the prior, and of one sample.
    double tables = 0, samples = 0;
    /// Mean square of the coordinates in the modes: 1 for what the prior was learned from.
    double distance = 0;

    /// The material is unlike all that the prior knows: its tables leave the modes by more than
    /// those of materials of the kind that the prior was learned from (fitter/few.py counts).
    bool isUnlike() const { return tables > kMostTables; }
    static constexpr double kMostTables = 0.9;
};

/// The tangential part of a surface's normal in the frame of its samples, radians for so small a
/// tilt.
struct Tilt {
    double x = 0, y = 0;
};
/// In degrees, with the azimuth, for people.
std::string describe(const Tilt& tilt);

struct FitSummary {
    double readSeconds = 0;       ///< making or reading the samples
    double seconds = 0;           ///< fitting alone: no reading, no reporting
    double processorSeconds = 0;  ///< the same work, summed over the threads of the process
    size_t used = 0;              ///< samples with at least one channel above the floor
    size_t belowFloor = 0;        ///< channel values censored
    Vec3f noiseFloor{0.0f};
    double smoothness = 0;              ///< the strength used
    std::optional<PriorSummary> prior;  ///< where the fit leans on one
    SolverSummary solver;               ///< why it stopped, after how many steps, at which cost
    double conserved = 1;  ///< what the material was multiplied by for the sake of energy
    int folds = 0;         ///< that the held-out errors come from; 0: fresh samples of the function
    SampleErrors heldOut, all;
    std::vector<MisfitRegion> misfits;  ///< where the form does not follow the data; empty: it does
    std::optional<Tilt> tilt;  ///< that was found; errors are those about the surface's own normal
    std::optional<Coverage> coverage;  ///< directions of a measurement; a function has all
    std::vector<Trial> trials;
    std::string reason;  ///< why auto chose its form, a sentence for people; empty: it did not

    /// One line: how the solver stopped and the error held out.
    std::string briefReport() const;
    /// Everything above in lines of text, each ending with a newline.
    std::string fullReport() const;
};

struct FitResult {
    Material material;
    FitSummary summary;
};

/// Throws Error(usage) for an unknown form or an option that no data could make possible.
void checkOptions(const FitOptions& options);

/// Throws what checkOptions does, Error(usage) for limits that the form does not keep, Error(fit)
/// for data from which nothing can be fitted, FitStopped where its watch is. Deterministic for a
/// seed, whatever the number of threads.
FitResult fitMaterial(const Source& source, const FitOptions& options = {});

struct NamedForm {
    std::string name, product, note;
    int defaultResolution;
    bool isReciprocal = false;  ///< f(wo, wi) = f(wi, wo) whatever the tables hold
};
/// The forms that have names: pqp, pqpr, hdio, ...
const std::vector<NamedForm>& namedForms();

/// What a letter in the name of a form stands for.
struct FormLetter {
    std::string letters, meaning;
};
const std::vector<FormLetter>& formLetters();

/// Forms that are not fitted in log space: "svd" (Svd.h), "svdN" of N terms, and
/// "analytic" (AnalyticFactors.h). "svd" takes as many terms as fit maxBytes, 4 without it.
const std::vector<NamedForm>& directForms();
/// False for a direct form that the source does not allow: analytic needs a model whose factors are
/// known, svd a function or samples that are known to be isotropic. Throws Error(usage) as
/// checkOptions.
bool suitsForm(const Source& source, const std::string& form);
/// A named form, or a sum of named forms: "io+hdio". Throws Error(usage) for an unknown name.
/// `resolution` 0: the default.
Form makeForm(const std::string& name, int resolution = 0);

/// Texture look-ups that every light costs.
int lookupsPerLight(const Form& form);
/// The smallest limit of look-ups in a pass within which the form can be drawn one light at a time
/// straight into a float target (fbrdf/plan/Plan.h): pqp 2, hdio 2, qdg 1. With a surface beside
/// the target any form can be drawn with one look-up a pass, at a multiple of the passes; that
/// choice is left to the renderer.
int lookupsPerPass(const Form& form);

}  // namespace fbrdf
