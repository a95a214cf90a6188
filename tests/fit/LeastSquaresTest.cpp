#include "solve/LeastSquares.h"

#include "Known.h"
#include "Quantize.h"
#include "RankPair.h"
#include "solve/Solve.h"
#include "TexelWeights.h"

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <thread>

namespace fbrdf {
namespace {

struct Problem {
    Source source;
    Dataset dataset;
    DataStatistics statistics;

    Problem(Source from, size_t count)
        : source(std::move(from)),
          dataset(makeDataset(source, count, 1, 2)),
          statistics(statisticsOf(someSamples(dataset, FoldChoice::all(), 20000, 1), dataset.exact,
                                  "data"))
    {
    }
};

double largestError(const Material& fitted, const Material& truth)
{
    double largest = 0.0;
    for (const auto& pair : uniformPairs(2000, 77)) {
        const Vec3d f = evaluate(truth, pair.wo, pair.wi), g = evaluate(fitted, pair.wo, pair.wi);
        for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(g[c] / f[c] - 1.0));
    }
    return largest;
}

const Vec3f kUnscaled(1.0f);  // of residuals that are not weighted robustly

// A product that the form can represent comes back to 1e-4: floats of the rows give 1e-6,
// smoothness the rest.
constexpr double kRecovered = 1e-4;

// Two ways to one solution: double sums in another order, materials in floats.
constexpr double kSolversAgree = 1e-6;

class Recovery : public testing::TestWithParam<Form> {};

TEST_P(Recovery, OfAProductThatTheFormCanRepresent)
{
    const Material truth = test::waveMaterial(GetParam());
    Problem problem(test::sourceOf(truth), 30000);
    const LeastSquares squares(truth.form, problem.dataset, problem.statistics, 1, 2);
    SolveOptions options;
    options.smoothness = 1e-14;
    const Material fitted =
        quantize(truth.form, squares.layout(), solve(squares, options).x, Storage::float32);
    EXPECT_LT(largestError(fitted, truth), kRecovered);
}

INSTANTIATE_TEST_SUITE_P(Forms, Recovery,
                         testing::Values(formPqp(10, 0.5), formPqp(10, 1.0), formPqpr(10, 0.5, 8),
                                         formHdio({16, 6, 6})),
                         [](const auto& form) {
                             return form.param.name + std::to_string(form.index);
                         });

TEST(Recovery, FailsWhenTheFormCannotRepresentTheProduct)
{
    const Material truth = test::waveMaterial(formPqp(10, 0.5));
    Problem problem(test::sourceOf(truth), 20000);
    const Form form = formHdio({16, 6, 6});
    const LeastSquares squares(form, problem.dataset, problem.statistics, 1, 2);
    const Material fitted =
        quantize(form, squares.layout(), solve(squares, {}).x, Storage::float32);
    EXPECT_GT(largestError(fitted, truth), 0.1);
}

TEST(Sums, OfTwoProductsComeBack)
{
    const Material truth = test::waveMaterial(makeForm("io+hdio", 16));
    Problem problem(test::sourceOf(truth), 30000);
    const LeastSquares squares(truth.form, problem.dataset, problem.statistics, 1, 2);
    SolveOptions options;
    options.smoothness = 1e-9;
    const Material fitted =
        quantize(truth.form, squares.layout(), solve(squares, options).x, Storage::float32);
    const auto pairs = uniformPairs(2000, 77);
    double sum = 0.0;
    for (const auto& pair : pairs) {
        const Vec3d ratio =
            evaluate(fitted, pair.wo, pair.wi) / evaluate(truth, pair.wo, pair.wi) - 1.0;
        sum += glm::dot(ratio, ratio) / 3.0;
    }
    // Gauss-Newton stops when the cost falls by less than 1e-4 a step: not at the bottom, but near.
    EXPECT_LT(std::sqrt(sum / double(pairs.size())), 5e-3);
}

TEST(Robust, OutliersMoveAPlainFitAndNotARobustOne)
{
    const Material truth = test::waveMaterial(formHdio({16, 6, 6}));
    Source source = test::scattered(test::sourceOf(truth), 20000, 5);
    std::mt19937 random(3);
    for (Sample& s : source.samples)
        if (random() % 100 < 3) s.f *= 30.0f;
    Problem problem(source, 0);
    const LeastSquares squares(truth.form, problem.dataset, problem.statistics, 1, 2);
    SolveOptions options;
    options.smoothness = 1e-9;
    const auto errorOf = [&] {
        return largestError(
            quantize(truth.form, squares.layout(), solve(squares, options).x, Storage::float32),
            truth);
    };
    EXPECT_GT(errorOf(), 0.1);
    options.robust = true;
    EXPECT_LT(errorOf(), 0.01);
}

TEST(Censored, ZerosPullOnlyPredictionsThatLieAbove)
{
    // The darkest fifth is cut to zero: the fit must stay near or below the cut there, and right
    // elsewhere.
    const Material truth = test::waveMaterial(formHdio({16, 6, 6}));
    Source source = test::scattered(test::sourceOf(truth), 20000, 5);
    std::vector<float> reds;
    for (const Sample& s : source.samples) reds.push_back(s.f.x);
    std::sort(reds.begin(), reds.end());
    const float cut = reds[reds.size() / 5];
    for (Sample& s : source.samples)
        if (s.f.x < cut) s.f.x = 0.0f;
    Problem problem(source, 0);
    ASSERT_GT(problem.statistics.floor.x, cut);
    const LeastSquares squares(truth.form, problem.dataset, problem.statistics, 1, 2);
    SolveOptions options;
    options.robust = true;
    const Material fitted =
        quantize(truth.form, squares.layout(), solve(squares, options).x, Storage::float32);
    double darkest = 0.0, bright = 0.0;
    size_t brightCount = 0;
    for (const Sample& s : source.samples) {
        const float g = evaluate(fitted, s.wo, s.wi).x;
        if (s.f.x == 0.0f) {
            darkest = std::max(darkest, double(g));
        } else if (s.f.x > 1.5f * problem.statistics.floor.x) {
            bright += std::abs(std::log(double(g / s.f.x)));
            ++brightCount;
        }
    }
    EXPECT_LT(darkest, 2.0 * double(problem.statistics.floor.x));
    ASSERT_GT(brightCount, 100u);
    EXPECT_LT(bright / double(brightCount), 0.02);
}

TEST(LeastSquares, DoesNotDependOnTheNumberOfThreads)
{
    Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 40000);
    const Form form = formHdio({16, 6, 6});
    const LeastSquares one(form, problem.dataset, problem.statistics, 1, 1),
        four(form, problem.dataset, problem.statistics, 1, 4);
    EXPECT_EQ(step(one, one.flatState(), {}).x, step(four, four.flatState(), {}).x);
}

TEST(LeastSquares, TheStepMinimisesWhatCostMeasures)
{
    Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 10000);
    const Form form = formHdio({16, 6, 6});
    const LeastSquares squares(form, problem.dataset, problem.statistics, 1, 2);
    StepOptions options;
    options.smoothness = 1e-10;
    const State best = step(squares, squares.flatState(), options).x;
    const double least = cost(squares, best, options, kUnscaled);
    std::mt19937 random(9);
    for (int i = 0; i < 20; ++i) {
        State other = best;
        for (double& v : other) v += 0.01 * (double(random() % 2001) / 1000.0 - 1.0);
        EXPECT_GT(cost(squares, other, options, kUnscaled), least);
    }
}

// Both solvers run to their last digits: rows are floats, and the gauge is fixed by 1e-11.
double largestDifference(const LeastSquares& a, const State& x, const LeastSquares& b,
                         const State& y)
{
    const Material p = quantize(a.form(), a.layout(), x, Storage::float32),
                   q = quantize(b.form(), b.layout(), y, Storage::float32);
    return largestError(p, q);
}

class Solvers : public testing::TestWithParam<bool> {};

TEST_P(Solvers, FactorizationAndConjugateGradientsAgree)
{
    Source source =
        test::scattered(test::sourceOf(test::waveMaterial(formHdio({16, 6, 6}))), 15000, 5);
    std::mt19937 random(3);
    for (Sample& s : source.samples) s.f *= random() % 50 == 0 ? 30.0f : 1.0f;
    Problem problem(source, 0);
    for (const Form& form : {formPqpr(8, 0.5, 8), formHdio({12, 5, 5})}) {
        LeastSquaresOptions factored, iterated;
        factored.solver = SystemSolver::factored;
        iterated.solver = SystemSolver::conjugateGradients;
        iterated.limits.systemTolerance = 1e-12;
        factored.sharedShape = iterated.sharedShape = GetParam();
        const LeastSquares a(form, problem.dataset, problem.statistics, 1, 2, factored),
            b(form, problem.dataset, problem.statistics, 1, 2, iterated);
        StepOptions options;
        options.smoothness = 1e-2;
        options.robust = true;
        const State from = step(a, a.flatState(), {}).x;
        // Both start from one state, so that the robust weights are the same.
        const State x = step(a, from, options).x;
        const State y = step(b, from, options).x;
        EXPECT_LT(largestDifference(a, x, b, y), kSolversAgree) << form.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Solvers, testing::Bool());

TEST(SharedShape, ComesBackWithItsThreeLevels)
{
    Material truth = test::waveMaterial(formHdio({16, 6, 6}));
    for (Table& table : truth.tables)
        for (size_t i = 0; i < table.texels.size(); ++i) table.texels[i] = table.texels[i - i % 3];
    truth.scales = {Vec3f(0.7f, 0.2f, 0.05f)};
    Problem problem(test::sourceOf(truth), 20000);
    LeastSquaresOptions options;
    options.sharedShape = true;
    const LeastSquares squares(truth.form, problem.dataset, problem.statistics, 1, 2, options);
    SolveOptions solveOptions;
    solveOptions.smoothness = 1e-14;
    const Material fitted =
        quantize(truth.form, squares.layout(), solve(squares, solveOptions).x, Storage::float32);
    EXPECT_EQ(fitted.tables[0].channels, 1);
    EXPECT_EQ(materialBytes(fitted), (16u * 6 + 6 * 6) * 4);
    EXPECT_LT(largestError(fitted, truth), kRecovered);
}

TEST(SharedShape, CannotRepresentThreeShapes)
{
    const Material truth = test::waveMaterial(formHdio({16, 6, 6}));
    Problem problem(test::sourceOf(truth), 10000);
    LeastSquaresOptions options;
    options.sharedShape = true;
    const LeastSquares squares(truth.form, problem.dataset, problem.statistics, 1, 2, options);
    EXPECT_GT(
        largestError(quantize(truth.form, squares.layout(), solve(squares, {}).x, Storage::float32),
                     truth),
        0.1);
}

TEST(Cache, ASecondFitOnTheSameGridIsTheFitWithoutACache)
{
    FitCache cache;
    for (const double f0 : {0.5, 0.04}) {
        Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, f0, 0.1}), 20000);
        ASSERT_FALSE(geometryOf(problem.dataset, 1).empty());
        const Form form = formHdio({16, 6, 6});
        LeastSquaresOptions cached;
        cached.cache = &cache;
        const LeastSquares with(form, problem.dataset, problem.statistics, 1, 2, cached),
            without(form, problem.dataset, problem.statistics, 1, 2);
        SolveOptions options;
        options.folds = 2;
        const Solution a = solve(with, options), b = solve(without, options);
        EXPECT_EQ(a.smoothness, b.smoothness);
        EXPECT_EQ(a.x, b.x) << f0;
    }
}

TEST(Cache, KnowsTheSupport)
{
    FitCache cache;
    LeastSquaresOptions cached;
    cached.cache = &cache;
    const Form form = formHdio({16, 6, 6});
    for (const double f0 : {0.5, 0.04}) {
        Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, f0, 0.1}), 20000);
        const LeastSquares with(form, problem.dataset, problem.statistics, 1, 2, cached),
            without(form, problem.dataset, problem.statistics, 1, 2);
        EXPECT_EQ(texelWeights(with), texelWeights(without));
    }
}

TEST(Cache, AnotherRadiusOfADiscIsAnotherForm)
{
    FitCache cache;
    LeastSquaresOptions cached;
    cached.cache = &cache;
    Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 10000);
    Form form = formPqp(12, 0.5);
    for (const double radius : {5.5, 4.0}) {
        std::get<DiscDomain>(form.tables[0].domain).radius = radius;
        const LeastSquares with(form, problem.dataset, problem.statistics, 1, 2, cached),
            without(form, problem.dataset, problem.statistics, 1, 2);
        EXPECT_EQ(step(with, with.flatState(), {}).x, step(without, without.flatState(), {}).x);
    }
}

TEST(Cache, AnotherGridIsNotMistakenForIt)
{
    FitCache cache;
    LeastSquaresOptions cached;
    cached.cache = &cache;
    const Form form = formHdio({16, 6, 6});
    for (const size_t count : std::initializer_list<size_t>{20000, 10000}) {
        Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), count);
        const LeastSquares with(form, problem.dataset, problem.statistics, 1, 2, cached),
            without(form, problem.dataset, problem.statistics, 1, 2);
        EXPECT_EQ(step(with, with.flatState(), {}).x, step(without, without.flatState(), {}).x);
    }
}

TEST(Sums, OfAWideRangeLeaveTheFlatStart)
{
    // Where the weaker term has a share of 1 in 500, a whole step of it overflows a float.
    Problem problem(test::sourceOf(test::Ggx{0.03, 0.03, 0.9, 0.0}), 20000);
    const LeastSquares squares(makeForm("hdpio+hdpio", 24), problem.dataset, problem.statistics, 1,
                               2);
    StepOptions damped;
    damped.damping = 1e-3;
    const State flat = squares.flatState(), x = step(squares, flat, damped).x;
    EXPECT_LT(cost(squares, x, {}, kUnscaled), cost(squares, flat, {}, kUnscaled));
}

TEST(Sums, AWeakStrengthGetsAsFarAsTheChosenOne)
{
    Problem problem(test::sourceOf(test::Ggx{0.1, 0.1, 0.04, 0.3}), 20000);
    const LeastSquares squares(makeForm("io+hdio", 64), problem.dataset, problem.statistics, 1, 2);
    SolveOptions options;
    const Solution chosen = solve(squares, options);
    options.smoothness = 1e-7;
    const State given = solve(squares, options).x;
    // With so little smoothness from the start the descent ended a thousand times higher.
    EXPECT_LT(cost(squares, given, {}, kUnscaled), 10.0 * cost(squares, chosen.x, {}, kUnscaled));
}

// The samples of a source as a stream that drops every fifth row.
SampleStream droppingStream(const std::vector<Sample>& samples)
{
    SampleStream stream;
    stream.rows = samples.size();
    stream.read = [&samples](uint64_t first, size_t count, std::vector<Sample>& out,
                             SampleReport&) {
        for (uint64_t i = first; i < first + count; ++i)
            if (splitMix64(i) % 5 != 0) out.push_back(samples[i]);
    };
    return stream;
}

TEST(Folds, WhatIsHeldOutOfALongStreamTakesNoPartInTheFit)
{
    constexpr uint64_t kSeed = 9;
    std::vector<Sample> samples =
        test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 60000, 1).samples;
    for (size_t i = 0; i < samples.size(); ++i) samples[i].weight = 1.0f + 1e-6f * float(i);
    const SampleStream stream = droppingStream(samples);
    const Dataset dataset = datasetOfStream(stream);
    const DataStatistics statistics =
        statisticsOf(someSamples(dataset, FoldChoice::all(), 20000, kSeed), false, "data");
    const LeastSquares squares(formHdio({8, 4, 4}), dataset, statistics, kSeed, 2);
    StepOptions options;
    options.excludedFold = 2;
    const State before = step(squares, squares.flatState(), options).x;
    const auto heldOut = someSamples(dataset, FoldChoice::onlyOf(2), 500, kSeed);
    ASSERT_GT(heldOut.size(), 300u);
    for (const Sample& s : heldOut)
        for (Sample& of : samples)
            if (of.weight == s.weight && of.wi == s.wi) of.f *= 100.0f;
    EXPECT_EQ(step(squares, squares.flatState(), options).x, before);
}

TEST(Weights, OneBlackSampleThatTheTraitsMissedIsSeen)
{
    Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 20000);
    const Form form = formHdio({16, 6, 6});
    EXPECT_FALSE(dependsOnState(LeastSquares(form, problem.dataset, problem.statistics, 1, 2), {}));
    std::vector<Sample> samples = someSamples(problem.dataset, FoldChoice::all(), 20000, 1);
    samples[777].f.y = 0.0f;
    ASSERT_TRUE(problem.statistics.sameWeights);
    EXPECT_TRUE(dependsOnState(
        LeastSquares(form, datasetInMemory(std::move(samples)), problem.statistics, 1, 2), {}));
}

TEST(Weights, AStepOfALinearProblemDoesNotDependOnWhereItStarts)
{
    Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 20000);
    const LeastSquares squares(formHdio({16, 6, 6}), problem.dataset, problem.statistics, 1, 2);
    const State flat = squares.flatState(), once = step(squares, flat, {}).x;
    StepOptions damped;  // so little that only the start is another
    damped.damping = 1e-15;
    EXPECT_LT(largestDifference(squares, step(squares, once, damped).x, squares, once),
              kSolversAgree);
}

TEST(Ranks, TwoProcessesTakeTheStepOfOne)
{
    Problem problem(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), 60000);
    const Form form = formHdio({16, 6, 6});
    const LeastSquares alone(form, problem.dataset, problem.statistics, 1, 1);
    test::RankPair pair;
    std::array<State, 2> states;
    std::array<std::thread, 2> processes;
    for (size_t r = 0; r < 2; ++r)
        processes[r] = std::thread([&, r] {
            LeastSquaresOptions options;
            options.ranks = pair.rank(r);
            const LeastSquares half(form, problem.dataset, problem.statistics, 1, 1, options);
            states[r] = solve(half, {}).x;
        });
    for (std::thread& process : processes) process.join();
    EXPECT_EQ(states[0], states[1]);
    EXPECT_LT(largestDifference(alone, solve(alone, {}).x, alone, states[0]), kSolversAgree);
}

TEST(DataStatistics, NothingAboveTheFloorIsAnError)
{
    std::vector<Sample> samples(5, Sample{Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0.0f), 1.0f});
    EXPECT_THROW(statisticsOf(samples, false, "data"), Error);
    EXPECT_THROW(statisticsOf({}, false, "data"), Error);
}

// White samples of a function but for one, which no part of 65,536 samples is sure to contain.
Dataset whiteButFor(const Sample& one, uint64_t seed)
{
    std::vector<Sample> samples(100000, Sample{Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0.5f), 1.0f});
    Dataset dataset = datasetInMemory(samples);
    const auto isLookedAt = [&](size_t i) {
        samples[i].weight = 2.0f;
        const auto part = someSamples(datasetInMemory(samples), FoldChoice::all(), 65536, seed);
        samples[i].weight = 1.0f;
        return std::any_of(part.begin(), part.end(),
                           [](const Sample& s) { return s.weight == 2.0f; });
    };
    size_t unseen = 0;
    while (isLookedAt(unseen)) ++unseen;
    samples[unseen] = one;
    dataset = datasetInMemory(std::move(samples));
    dataset.exact = true;
    return dataset;
}

TEST(DataStatistics, OneColouredSampleIsSeenWhereverItIs)
{
    const Vec3f up(0, 0, 1);
    const StatisticsOptions options{1, 2, {}};
    EXPECT_TRUE(statisticsOf(whiteButFor({up, up, Vec3f(0.5f), 1.0f}, 1), options, "data").grey);
    EXPECT_FALSE(
        statisticsOf(whiteButFor({up, up, Vec3f(0.5f, 0.1f, 0.5f), 1.0f}, 1), options, "data")
            .grey);
}

TEST(DataStatistics, OneBlackSampleIsSeenWhereverItIs)
{
    const Vec3f up(0, 0, 1);
    const StatisticsOptions options{1, 2, {}};
    EXPECT_TRUE(
        statisticsOf(whiteButFor({up, up, Vec3f(0.5f), 1.0f}, 1), options, "data").sameWeights);
    EXPECT_FALSE(
        statisticsOf(whiteButFor({up, up, Vec3f(0.0f), 1.0f}, 1), options, "data").sameWeights);
}

TEST(DataStatistics, AFunctionHasAFloorOnlyWhereItIsCutOff)
{
    std::vector<Sample> samples;
    for (int i = 0; i < 100; ++i)
        samples.push_back(
            {Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(i < 20 ? 0.0f : 2.0f, 1e-6f, 1.0f), 1.0f});
    const DataStatistics statistics = statisticsOf(samples, true, "function");
    EXPECT_FLOAT_EQ(statistics.floor.x, 0.008f);
    EXPECT_EQ(statistics.floor.y, 0.0f);
    EXPECT_EQ(statistics.floor.z, 0.0f);
    const Observed zero = observe(0.0f, 1.0f, statistics, 0, 1.0f);
    EXPECT_FLOAT_EQ(zero.value, 0.008f);
    EXPECT_FALSE(zero.censored);
    EXPECT_EQ(zero.weight, 1.0f);
    EXPECT_TRUE(
        observe(0.0f, 1.0f, statistics, 1, 1.0f).censored);  // without a floor it takes no part
}

TEST(DataStatistics, OneSampleAFoldIsTheLeast)
{
    std::vector<Sample> samples(4, Sample{Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0.5f), 1.0f});
    EXPECT_THROW(statisticsOf(samples, false, "data"), Error);
    samples.push_back(samples[0]);
    EXPECT_EQ(statisticsOf(samples, false, "data").usable, 5u);
}

}  // namespace
}  // namespace fbrdf
