// KnownStartTest.cpp - fits that begin at the solution for other samples end where those that begin
// at nothing do. No GL.
#include "forms/NamedForms.h"
#include "Known.h"
#include "Quantize.h"
#include "solve/Solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr int kFold = 2;
constexpr uint64_t kSeed = 1;

struct Data {
    Material truth;
    Dataset dataset;
    DataStatistics statistics;

    // The samples of a fold are twice as bright as the truth.
    explicit Data(const char* form) : truth(test::waveMaterial(makeForm(form, 16)))
    {
        std::vector<Sample> samples =
            samplesAt(test::sourceOf(truth), uniformPairs(12000, kSeed), 2);
        for (size_t i = 0; i < samples.size(); ++i)
            if (foldOf(i, kSeed) == kFold) samples[i].f *= 2.0f;
        statistics = statisticsOf(samples, false, "data");
        dataset = datasetInMemory(std::move(samples));
    }
    // Root of the mean squared log2 of fit over truth.
    double octavesOff(const LeastSquares& problem, const Solution& solution) const
    {
        const Material fitted =
            quantize(truth.form, problem.layout(), solution.x, Storage::float32);
        double sum = 0.0;
        const auto pairs = uniformPairs(2000, 77);
        for (const auto& pair : pairs)
            sum += std::pow(std::log2(evaluate(fitted, pair.wo, pair.wi).y /
                                      evaluate(truth, pair.wo, pair.wi).y),
                            2.0);
        return std::sqrt(sum / double(pairs.size()));
    }
};

class KnownStart : public testing::TestWithParam<const char*> {};

TEST_P(KnownStart, OfAllSamplesIsForgottenWhereAFoldIsLeftOut)
{
    // A fifth of the samples is an octave off. The descent stops when the cost hardly falls.
    constexpr double kSeen = 0.1, kForgotten = 0.01;
    const Data data(GetParam());
    const LeastSquares problem(data.truth.form, data.dataset, data.statistics, kSeed, 2);
    SolveOptions options;
    options.smoothness = 1e-9;
    const Solution whole = solve(problem, options);
    EXPECT_GT(data.octavesOff(problem, whole), kSeen);
    options.excludedFold = kFold;
    options.start = &whole;
    EXPECT_LT(data.octavesOff(problem, solve(problem, options)), kForgotten);
}

TEST_P(KnownStart, OfAPartReachesWhatTheWholeDoes)
{
    constexpr double kNoWorse = 1e-3;  // octaves: what a descent that stops early leaves
    const Data data(GetParam());
    const LeastSquares problem(data.truth.form, data.dataset, data.statistics, kSeed, 2);
    const LeastSquares part = problem.thinned(4000, kNoFold);
    SolveOptions options;
    options.robust = true;
    const Solution start = solve(part, options);
    const double cold = data.octavesOff(problem, solve(problem, options));
    options.start = &start;
    EXPECT_LT(data.octavesOff(problem, solve(problem, options)), cold + kNoWorse);
}

INSTANTIATE_TEST_SUITE_P(Forms, KnownStart, testing::Values("hdio", "io+hdio", "pqpr"));

}  // namespace
}  // namespace fbrdf
