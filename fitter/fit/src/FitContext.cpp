#include "FitContext.h"

#include <fbrdf/base/Assert.h>

#include "data/Symmetry.h"
#include "forms/NamedForms.h"
#include "prior/PriorUse.h"
#include "Quantize.h"
#include "TexelWeights.h"
#include "Unsampled.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kFunctionSamples = 131072;  // drawn from a source that is only a function

// The cost of the solution with the options of the context's last steps; of a stream on a part of
// it.
double costOf(const LeastSquares& problem, const FitContext& context, const Solution& solution)
{
    constexpr size_t kStreamRows = 262144;
    StepOptions options;
    options.metric = context.options.metric;
    options.robust = context.robust;
    const auto at = [&](const LeastSquares& of) {
        return cost(of, solution.x, options, residualScale(of, solution.x, options));
    };
    return problem.isInMemory() ? at(problem) : at(problem.thinned(kStreamRows, kNoFold));
}

LeastSquares problemOf(const FitContext& context, const Form& form)
{
    return LeastSquares(form, context.dataset, context.statistics, context.options.seed,
                        context.options.threads, problemOptions(context));
}

PriorSummary summaryOf(const PriorFit& fit)
{
    const auto relative = [](double octaves) { return std::expm1(octaves * std::log(2.0)); };
    return {relative(fit.weights.tau), relative(fit.weights.noise), fit.distance};
}

Fitted fitFormWithPrior(const FitContext& context, const LeastSquares& problem)
{
    const PriorFit fit = fitWithPrior(problem, *context.prior, kNoFold, {});
    Fitted fitted;
    fitted.material = quantize(problem.form(), problem.layout(), fit.x, context.options.storage);
    fitted.prior = summaryOf(fit);
    fitted.solver.termination = Termination::solved;
    fitted.solver.iterations = 1;
    fitted.solver.cost = costOf(problem, context, {fit.x, 0.0, {}});
    markUnsupported(fitted.material, problem.layout(), texelWeights(problem));
    return fitted;
}

// A fit without the samples of a fold.
State stateWithout(const FitContext& context, const LeastSquares& problem, int fold,
                   double smoothness, HeldOut& held, const Solution* start)
{
    if (context.prior) {
        PriorFit fit = fitWithPrior(problem, *context.prior, fold, held.weights);
        held.weights = fit.weights;
        return std::move(fit.x);
    }
    SolveOptions options = solveOptions(context);
    options.smoothness = smoothness;
    options.excludedFold = fold;
    options.start = start;
    held.solution = solve(problem, options);
    return held.solution.x;
}

}  // namespace

Dataset readDataset(const Source& source, const FitOptions& options)
{
    Dataset dataset = makeDataset(source, kFunctionSamples, options.seed, options.threads);
    if (dataset.rows == 0)
        throw Error(ErrorKind::fit, source.name, Found("no samples").expected("at least one"));
    return dataset;
}

FitContext makeFitContext(Dataset dataset, const FitOptions& options, const std::string& source)
{
    FitContext context{options, std::move(dataset), {}, false, 1, false, nullptr};
    const size_t fewest = mayUsePrior(context.dataset, options) ? kFewestWithPrior : kFewestSamples;
    context.statistics = statisticsOf(
        context.dataset, {options.seed, options.threads, options.ranks, fewest}, source);
    context.robust = options.robust && !context.dataset.exact;
    context.folds = context.dataset.rows < kSmallSet ? kFolds : 1;
    return context;
}

size_t decidingSamples(const FitContext& context)
{
    return context.statistics.floor == Vec3f(0.0f) ? 2 * context.dataset.rows
                                                   : context.dataset.rows;
}

FitContext partOf(const FitContext& context, std::vector<Sample> part)
{
    FitContext result = context;
    if (part.empty()) return result;
    result.dataset = datasetInMemory(std::move(part));
    result.dataset.exact = context.dataset.exact;
    return result;
}

size_t bytesOf(const FitContext& context, const Form& form)
{
    return formBytes(form, context.options.storage) / (context.options.sharedShape ? 3 : 1);
}

SolveOptions solveOptions(const FitContext& context)
{
    SolveOptions options;
    options.smoothness = context.options.smoothness.value_or(0.0);
    options.metric = context.options.metric;
    options.robust = context.robust;
    options.folds = context.folds;
    return options;
}

LeastSquaresOptions problemOptions(const FitContext& context)
{
    LeastSquaresOptions options;
    options.sharedShape = context.options.sharedShape;
    options.limits = context.options.solver;
    options.cache = context.options.cache.get();
    options.ranks = context.options.ranks;
    options.watch = &context.options.watch;
    return options;
}

std::vector<Sample> probeOf(const FitContext& context, const FoldChoice& choice)
{
    return someSamples(context.dataset, choice, context.options.measured, context.options.seed,
                       context.options.threads);
}

Fitted fitForm(const FitContext& context, const Form& form, const Solution* start)
{
    const LeastSquares problem = problemOf(context, form);
    if (context.prior) return fitFormWithPrior(context, problem);
    SolveOptions options = solveOptions(context);
    options.start = start;
    Solution solution = solve(problem, options);
    const std::vector<double> weights = texelWeights(problem);
    extendHue(problem.form(), problem.layout(), weights, solution.x);
    Fitted fitted{quantize(form, problem.layout(), solution.x, context.options.storage),
                  solution.smoothness,
                  solution.summary,
                  {},
                  {},
                  {}};
    fitted.solver.cost = costOf(problem, context, solution);
    fitted.solution = std::move(solution);
    markUnsupported(fitted.material, problem.layout(), weights);
    return fitted;
}

Fitted fitFormBeside(const FitContext& context, const Form& form, const std::vector<Sample>& more)
{
    const FitOptions& options = context.options;
    std::vector<Sample> samples = someSamples(context.dataset, FoldChoice::all(),
                                              context.dataset.rows, options.seed, options.threads);
    samples.insert(samples.end(), more.begin(), more.end());
    Fitted fitted = fitForm(partOf(context, std::move(samples)), form);
    const LeastSquares problem = problemOf(context, form);
    markUnsupported(fitted.material, problem.layout(), texelWeights(problem));
    return fitted;
}

SampleErrors heldOutErrors(const Source& source, const FitContext& context, const Fitted& fitted)
{
    if (fitted.heldOut) return *fitted.heldOut;
    if (!context.dataset.exact) {
        HeldOut held;
        // Of many samples those of a fold move the solution by so little that a few steps from it
        // without them arrive where those from nothing do.
        const bool isKnown = context.folds == 1 && !fitted.solution.x.empty();
        holdOut(context, fitted.material.form, fitted.smoothness, context.folds, held,
                isKnown ? &fitted.solution : nullptr);
        return held.errors;
    }
    const auto test =
        samplesAt(source, uniformPairs(kUniformTestPairs, 0), context.options.threads);
    return sampleErrors(test, evaluateAt(fitted.material, test, context.options.threads),
                        context.statistics.floor);
}

void holdOut(const FitContext& context, const Form& form, double smoothness, int folds,
             HeldOut& held, const Solution* start)
{
    FBRDF_ASSERT(folds, <=, kFolds);
    if (held.folds >= folds) return;
    const LeastSquares problem = problemOf(context, form);
    const std::vector<double> weights = texelWeights(problem);
    for (; held.folds < folds; ++held.folds) {
        State x = stateWithout(context, problem, held.folds, smoothness, held, start);
        if (!context.prior) extendHue(problem.form(), problem.layout(), weights, x);
        const Material material = quantize(form, problem.layout(), x, context.options.storage);
        const auto part = probeOf(context, FoldChoice::onlyOf(held.folds));
        const auto values = evaluateAt(material, context.turnsHeldOut ? turned(part) : part,
                                       context.options.threads);
        held.samples.insert(held.samples.end(), part.begin(), part.end());
        held.fitted.insert(held.fitted.end(), values.begin(), values.end());
        held.foldEnd.push_back(held.samples.size());
    }
    if (!held.samples.empty())
        held.errors = sampleErrors(held.samples, held.fitted, context.statistics.floor);
}

}  // namespace fbrdf
