#include "Conserve.h"
#include "FitContext.h"
#include "forms/DirectForms.h"
#include "forms/NamedForms.h"
#include "search/Search.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

namespace fbrdf {
namespace {

Form formFor(const Job& job)
{
    const FitOptions& options = job.options;
    if (options.formData) return *options.formData;
    if (options.resolution > 0) return makeForm(options.form, options.resolution);
    return makeFormFor(options.form, decidingSamples(job),
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

void checkLimits(const Job& job, const Form& form)
{
    const FitOptions& options = job.options;
    const size_t bytes = bytesOf(job, form);
    if (options.maxBytes > 0 && bytes > options.maxBytes)
        throw Error(
            ErrorKind::usage, "max-bytes",
            Found(std::to_string(options.maxBytes))
                .expected("at least " + std::to_string(bytes) + " for this form and resolution"));
    checkLookups(options, form);
}

Fitted fitNamed(const Job& job)
{
    const Form form = formFor(job);
    checkLimits(job, form);
    return fitForm(job, form);
}

bool isMade(const FitOptions& options)
{
    return !options.formData && isMadeForm(options.form);
}

Fitted fitMade(const Source& source, const Job& job)
{
    Fitted fitted = makeFitted(source, job);
    checkLookups(job.options, fitted.material.form);
    return fitted;
}

Fitted fitAny(const Source& source, const Job& job, FitSummary& summary)
{
    if (isMade(job.options)) return fitMade(source, job);
    return isSearched(job.options) ? searchForm(source, job, summary.trials, summary.reason)
                                   : fitNamed(job);
}

void measure(const Source& source, const Job& job, const Fitted& fitted, FitSummary& summary)
{
    const auto probe = probeOf(job);
    const auto values = evaluateAt(fitted.material, probe, job.options.threads);
    summary.all = sampleErrors(probe, values, job.traits.floor);
    summary.misfits = misfitRegions(probe, values, job.traits.floor, job.feed.exact);
    if (!job.feed.exact) summary.coverage = coverageOf(probe);
    summary.used = job.feed.rows;
    for (const Sample& s : probe)
        for (int c = 0; c < 3; ++c)
            if (!(s.f[c] > job.traits.floor[c])) ++summary.belowFloor;
    if (!job.options.heldOut) return;
    const bool made = isMade(job.options);
    summary.folds = job.feed.exact || (made && source.evaluate) ? 0 : job.folds;
    summary.heldOut =
        made ? madeHeldOutErrors(source, job, fitted) : heldOutErrors(source, job, fitted);
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
    } else if (isMade(options)) {
        checkMadeOptions(options);
    } else {
        makeForm(isSearched(options) ? "hdio" : options.form, options.resolution);
    }
}

FitResult fitMaterial(const Source& source, const FitOptions& options)
{
    checkOptions(options);
    const Clock readClock;
    Feed feed = readFeed(source, options);
    FitResult result;
    FitSummary& summary = result.summary;
    summary.readSeconds = readClock.seconds();
    const Clock clock;
    const ProcessorClock processors;
    const Job job = makeJob(std::move(feed), options, source.name);
    Fitted fitted = fitAny(source, job, summary);
    if (options.conserve) summary.conserved = conserveEnergy(fitted.material, options.threads);
    fitted.material.name = source.name;
    summary.seconds = clock.seconds();
    summary.processorSeconds = processors.seconds();
    summary.noiseFloor = job.traits.floor;
    summary.smoothness = fitted.smoothness;
    summary.solver = fitted.solver;
    measure(source, job, fitted, summary);
    result.material = std::move(fitted.material);
    return result;
}

}  // namespace fbrdf
