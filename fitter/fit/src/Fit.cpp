#include "Bake.h"
#include "LeastSquares.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/fit/NoiseFloor.h>
#include <fbrdf/fit/SampleSets.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kFunctionSamples = 131072;  // taken from a source that is only a function
constexpr size_t kTestSamples = 65536;       // interfaces.md: the uniform test set
constexpr int kRobustSteps = 3;              // after the plain one: four solves
constexpr double kFirstSmoothness = 1e-3;
const std::vector<double> kSmoothnessLadder{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The solution for one form with some fold left out, starting flat.
State solve(const LeastSquares& problem, StepOptions options, bool robust)
{
    State x = problem.step(problem.flatState(), options);
    options.robust = robust;
    for (int i = 0; robust && i < kRobustSteps; ++i) x = problem.step(x, options);
    return x;
}

double chooseSmoothness(const LeastSquares& problem, const State& x, bool robust, int folds)
{
    std::vector<double> error(kSmoothnessLadder.size(), 0.0);
    for (int fold = 0; fold < folds; ++fold) {
        StepOptions options;
        options.excludedFold = fold;
        options.robust = robust;
        const auto states = problem.steps(x, options, kSmoothnessLadder);
        for (size_t s = 0; s < states.size(); ++s) error[s] += problem.foldError(states[s], fold);
    }
    const auto best = std::min_element(error.begin(), error.end());
    return kSmoothnessLadder[static_cast<size_t>(best - error.begin())];
}

}  // namespace

FitResult fitMaterial(const Source& source, const FitOptions& options)
{
    const bool measured = !source.samples.empty();
    const auto start = std::chrono::steady_clock::now();
    std::vector<Sample> samples =
        measured
            ? source.samples
            : samplesAt(source, uniformPairs(kFunctionSamples, options.seed + 1), options.threads);
    const Vec3f floor = measured ? estimateNoiseFloor(samples) : Vec3f(0.0f);
    const Observations observations = observe(std::move(samples), floor, options.seed);
    const Form form = makeForm(options.form == "auto" ? "hdio" : options.form, options.resolution);
    const LeastSquares problem(form, observations, options.threads);
    const bool robust = options.robust && measured;
    StepOptions step;
    step.smoothness = options.smoothness.value_or(kFirstSmoothness);
    State x = solve(problem, step, robust);
    const int folds = observations.samples.size() < 20000 ? kFolds : 1;
    if (!options.smoothness) {
        step.smoothness = chooseSmoothness(problem, x, robust, folds);
        step.robust = robust;
        x = problem.step(x, step);
    }
    FitResult result;
    result.material = bake(form, problem.layout(), x, options.storage);
    FitSummary& summary = result.summary;
    summary.seconds = secondsSince(start);
    summary.used = observations.used;
    summary.belowFloor = observations.belowFloor;
    summary.noiseFloor = floor;
    summary.smoothness = step.smoothness;
    summary.all =
        sampleErrors(observations.samples,
                     evaluateAt(result.material, observations.samples, options.threads), floor);
    if (measured) {
        std::vector<Sample> held;
        std::vector<Vec3f> fitted;
        for (int fold = 0; fold < folds; ++fold) {
            StepOptions foldStep = step;
            foldStep.robust = false;
            foldStep.excludedFold = fold;
            const Material m =
                bake(form, problem.layout(), solve(problem, foldStep, robust), options.storage);
            std::vector<Sample> part;
            for (size_t i = 0; i < observations.samples.size(); ++i)
                if (observations.fold[i] == fold) part.push_back(observations.samples[i]);
            const auto values = evaluateAt(m, part, options.threads);
            held.insert(held.end(), part.begin(), part.end());
            fitted.insert(fitted.end(), values.begin(), values.end());
        }
        summary.folds = folds;
        summary.heldOut = sampleErrors(held, fitted, floor);
    } else {
        const auto test = samplesAt(source, uniformPairs(kTestSamples, 0), options.threads);
        summary.heldOut =
            sampleErrors(test, evaluateAt(result.material, test, options.threads), floor);
    }
    return result;
}

}  // namespace fbrdf
