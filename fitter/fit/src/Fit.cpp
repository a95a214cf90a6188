#include "Conserve.h"
#include "data/Symmetry.h"
#include "FitContext.h"
#include "Flatten.h"
#include "forms/DirectForms.h"
#include "forms/NamedForms.h"
#include "prior/PriorUse.h"
#include "search/Restrained.h"
#include "search/Search.h"
#include "Tilt.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

namespace fbrdf {
namespace {

Form formFor(const FitContext& context)
{
    const FitOptions& options = context.options;
    if (options.formData) return *options.formData;
    if (options.resolution > 0) return makeForm(options.form, options.resolution);
    return makeFormFor(options.form, decidingSamples(context),
                       options.maxBytes * (options.sharedShape ? 3 : 1), options.storage);
}

void checkLookups(const FitOptions& options, const Form& form)
{
    const int lookups = lookupsPerPass(form);
    if (lookups > options.lookups)
        throw Error(ErrorKind::usage, "lookups",
                    Found(std::to_string(options.lookups))
                        .expected("at least " + std::to_string(lookups) + " for " + form.name));
}

void checkLimits(const FitContext& context, const Form& form)
{
    const FitOptions& options = context.options;
    const size_t bytes = bytesOf(context, form);
    if (options.maxBytes > 0 && bytes > options.maxBytes)
        throw Error(
            ErrorKind::usage, "max-bytes",
            Found(std::to_string(options.maxBytes))
                .expected("at least " + std::to_string(bytes) + " for this form and resolution"));
    checkLookups(options, form);
}

// Few scattered samples leave room for inventions.
Fitted fitNamed(const Source& source, const FitContext& context)
{
    constexpr size_t kMostRestrained = 32768;
    const Form form = formFor(context);
    checkLimits(context, form);
    const Dataset& dataset = context.dataset;
    if (dataset.exact || !dataset.inMemory || dataset.rows > kMostRestrained ||
        context.options.ranks.count > 1)
        return fitForm(context, form);
    const Stray stray(probeOf(context), context.statistics.floor, isIsotropicSource(source),
                      context.options.threads);
    return fitRestrained(context, form, stray).fitted;
}

bool isDirect(const FitOptions& options)
{
    return !options.formData && isDirectForm(options.form);
}

Fitted fitDirect(const Source& source, const FitContext& context)
{
    Fitted fitted = fitDirectForm(source, context);
    checkLookups(context.options, fitted.material.form);
    return fitted;
}

Fitted fitAny(const Source& source, const FitContext& context, FitSummary& summary)
{
    if (isDirect(context.options)) return fitDirect(source, context);
    return isSearched(context.options) || priorFor(context)
               ? searchForm(source, context, summary.trials, summary.reason)
               : fitNamed(source, context);
}

// Samples that show an isotropic surface tilted, in the frame of its own normal.
void straighten(const Source& source, const FitOptions& options, Dataset& dataset,
                FitSummary& summary)
{
    constexpr size_t kMostRows = 1000000, kEnough = 16384;
    const bool isScattered = dataset.inMemory && !dataset.exact && !source.evaluate;
    if (!options.straightens || !isScattered || dataset.rows < kFewestSamples ||
        dataset.rows > kMostRows || options.ranks.count > 1 || !isIsotropicSource(source))
        return;
    const auto some =
        someSamples(dataset, FoldChoice::all(), kEnough, options.seed, options.threads);
    summary.tilt = tiltOf(some, statisticsOf(some, false, source.name), options);
    if (!summary.tilt) return;
    const auto all =
        someSamples(dataset, FoldChoice::all(), dataset.rows, options.seed, options.threads);
    dataset = datasetInMemory(straightened(all, *summary.tilt));
}

// A function has samples everywhere, and a fit that leans on the prior has followed it where it has
// none.
bool mayHaveGaps(const FitContext& context, const Fitted& fitted)
{
    return !context.dataset.exact && !fitted.prior && !fitted.solution.x.empty();
}

void measure(const Source& source, const FitContext& context, const Fitted& fitted,
             FitSummary& summary)
{
    const auto probe = probeOf(context);
    const auto values = evaluateAt(fitted.material, probe, context.options.threads);
    summary.all = sampleErrors(probe, values, context.statistics.floor);
    summary.misfits = misfitRegions(probe, values, context.statistics.floor, context.dataset.exact,
                                    context.options.threads);
    if (!context.dataset.exact) summary.coverage = coverageOf(probe);
    summary.used = context.dataset.rows;
    for (const Sample& s : probe)
        for (int c = 0; c < 3; ++c)
            if (!(s.f[c] > context.statistics.floor[c])) ++summary.belowFloor;
    if (!context.options.heldOut) return;
    const bool direct = isDirect(context.options);
    summary.folds = context.dataset.exact || (direct && source.evaluate) ? 0 : context.folds;
    summary.heldOut = direct ? directHeldOutErrors(source, context, fitted)
                             : heldOutErrors(source, context, fitted);
}

void requireAbove(double value, double least, const std::string& option)
{
    if (!(value > least))
        throw Error(ErrorKind::usage, option,
                    Found(numberText(value)).expected("above " + numberText(least)));
}

void checkSolver(const SolverOptions& solver)
{
    requireAbove(solver.costTolerance, 0.0, "cost tolerance");
    requireAbove(solver.maxDamping, 0.0, "largest damping");
    requireAbove(solver.systemTolerance, 0.0, "system tolerance");
    requireAbove(solver.maxSteps, 0, "limit of steps");
    requireAbove(solver.maxSystemIterations, 0, "limit of system iterations");
}

}  // namespace

void checkOptions(const FitOptions& options)
{
    if (options.lookups < 1)
        throw Error(ErrorKind::usage, "lookups",
                    Found(std::to_string(options.lookups)).expected("at least 1"));
    if (options.terms < 1)
        throw Error(ErrorKind::usage, "terms",
                    Found(std::to_string(options.terms)).expected("at least 1"));
    if (options.measured < 1)
        throw Error(ErrorKind::usage, "measured", Found("0 samples").expected("at least 1"));
    if (!(options.seconds >= 0.0))
        throw Error(ErrorKind::usage, "seconds",
                    Found(numberText(options.seconds)).expected("at least 0"));
    if (options.smoothness && !(*options.smoothness > 0.0))
        throw Error(ErrorKind::usage, "smoothness",
                    Found(numberText(*options.smoothness)).expected("above 0"));
    checkSolver(options.solver);
    if (options.formData) {
        validate(*options.formData, "form");
        if (options.resolution > 0)
            throw Error(ErrorKind::usage, "resolution",
                        Found("it beside a form as data").expected("the sizes of the form alone"));
    } else if (isDirect(options)) {
        checkDirectOptions(options);
    } else {
        makeForm(isSearched(options) ? "hdio" : options.form, options.resolution);
    }
}

void FitWatch::check() const
{
    if (isStopped && isStopped()) throw FitStopped();
}

FitResult fitMaterial(const Source& source, const FitOptions& options)
{
    checkOptions(options);
    options.watch.say("reading " + source.name);
    const Clock readClock;
    Dataset dataset = readDataset(source, options);
    FitResult result;
    FitSummary& summary = result.summary;
    summary.readSeconds = readClock.seconds();
    const Clock clock;
    const ProcessorClock processors;
    if (!isDirect(options)) straighten(source, options, dataset, summary);
    options.watch.say("fitting " + source.name);
    const FitContext context = makeFitContext(std::move(dataset), options, source.name);
    Fitted fitted = fitAny(source, context, summary);
    if (mayHaveGaps(context, fitted)) flattenGaps(context, fitted);
    if (options.conserve) summary.conserved = conserveEnergy(fitted.material, options.threads);
    fitted.material.name = source.name;
    summary.seconds = clock.seconds();
    summary.processorSeconds = processors.seconds();
    summary.noiseFloor = context.statistics.floor;
    summary.smoothness = fitted.smoothness;
    summary.prior = fitted.prior;
    summary.solver = fitted.solver;
    options.watch.say("measuring " + source.name);
    measure(source, context, fitted, summary);
    result.material = std::move(fitted.material);
    return result;
}

}  // namespace fbrdf
