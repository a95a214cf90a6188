#include "prior/PriorFit.h"

#include "forms/NamedForms.h"
#include "Known.h"
#include "prior/TableNumbers.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/fit/SamplePlan.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/metrics/StandardSphere.h>
#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/LU>

namespace fbrdf {
namespace {

using Index = Eigen::Index;

constexpr double kOctaves = 1.442695;

TablePrior smallPrior()
{
    TablePrior prior{formHdio({8, 4, 4}), {}, {}};
    const auto count = static_cast<size_t>(Layout(prior.form).unknowns());
    prior.mean.assign(count, -1.0f);
    for (const float k : {0.2f, 0.7f}) {
        std::vector<float>& mode = prior.modes.emplace_back();
        for (size_t i = 0; i < count; ++i) mode.push_back(std::cos(k * static_cast<float>(i)));
    }
    return prior;
}

// A material whose channels are the mean and different amounts of the modes.
Material materialOf(const TablePrior& prior)
{
    const Layout layout(prior.form);
    const std::vector<size_t> order = unknownsInOrder(prior.form, layout);
    std::vector<Vec3f> x(order.size());
    for (size_t i = 0; i < order.size(); ++i)
        x[order[i]] = Vec3f(prior.mean[i]) + prior.modes[0][i] * Vec3f(1.0f, 0.5f, -0.5f) +
                      prior.modes[1][i] * Vec3f(-1.0f, 0.3f, 0.8f);
    Material material;
    material.form = prior.form;
    for (size_t t = 0; t < prior.form.tables.size(); ++t) {
        Table table;
        table.name = prior.form.tables[t].name;
        table.domain = prior.form.tables[t].domain;
        for (int i = 0; i < texelCount(table.domain); ++i)
            for (int c = 0; c < 3; ++c)
                table.texels.push_back(x[static_cast<size_t>(layout.unknownOf(t, i))][c]);
        material.tables.push_back(table);
    }
    material.scales.assign(1, Vec3f(1.0f));
    return material;
}

std::vector<Sample> samplesOf(const Material& material, size_t count)
{
    const Source source = test::sourceOf(material);
    return samplesAt(source, uniformPairs(count, 3), 1);
}

LeastSquares problemOf(const Form& form, const std::vector<Sample>& samples)
{
    DataStatistics statistics;
    return LeastSquares(form, datasetInMemory(samples), statistics, 1, 1);
}

// The minimum of |r|^2 / s^2 + (x - mean)^T C^-1 (x - mean), solved from the side of the unknowns.
PriorMatrix directly(const LeastSquares& problem, const std::vector<Sample>& samples,
                     const TablePrior& prior, const PriorWeights& weights)
{
    const PriorCovariance covariance(prior);
    const PriorMatrix root = smoothnessRoot(prior.form);
    const PriorMatrix c = covariance.modes * covariance.modes.transpose() +
                          weights.tau * weights.tau * root.transpose() * root;
    PriorMatrix system = c.inverse();
    PriorMatrix right = system * covariance.mean.replicate(1, 3);
    std::vector<int> unknown(static_cast<size_t>(problem.maker().width()));
    std::vector<float> weight(unknown.size());
    for (const Sample& s : samples) {
        problem.maker().make(s, unknown.data(), weight.data());
        PriorVector row = PriorVector::Zero(c.rows());
        for (size_t k = 0; k < unknown.size(); ++k)
            row(unknown[k]) += static_cast<double>(weight[k]);
        const double mean = static_cast<double>(s.f.x + s.f.y + s.f.z) / 3.0;
        const double seen = mean / (mean + 1e-3);
        const double w = (seen * seen + 1e-4) / (weights.noise * weights.noise);
        system += w * row * row.transpose();
        for (int k = 0; k < 3; ++k)
            right.col(k) += w * std::log2(static_cast<double>(s.f[k])) * row;
    }
    return system.lu().solve(right);
}

TEST(PriorFit, IsTheMeanOfThePosterior)
{
    const TablePrior prior = smallPrior();
    const Material material = materialOf(prior);
    const PriorWeights weights{0.3, 0.05};
    for (const size_t count : {12u, 200u}) {  // fewer and more than the 42 unknowns
        const auto samples = samplesOf(material, count);
        const LeastSquares problem = problemOf(prior.form, samples);
        const PriorFit fit = fitWithPrior(problem, PriorCovariance(prior), kNoFold, weights);
        const PriorMatrix expected = directly(problem, samples, prior, weights);
        ASSERT_EQ(fit.x.size(), static_cast<size_t>(expected.size()));
        for (Index i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(fit.x[static_cast<size_t>(i)], expected.data()[i], 2e-4)
                << count << " " << i;
    }
}

TEST(PriorFit, AFoldThatIsLeftOutTakesNoPart)
{
    const TablePrior prior = smallPrior();
    auto samples = samplesOf(materialOf(prior), 60);
    const PriorWeights weights{0.3, 0.05};
    const auto fitted = [&](int fold) {
        return fitWithPrior(problemOf(prior.form, samples), PriorCovariance(prior), fold, weights)
            .x;
    };
    const State before = fitted(2), all = fitted(kNoFold);
    for (size_t i = 0; i < samples.size(); ++i)
        if (foldOf(i, 1) == 2) samples[i].f *= 100.0f;
    EXPECT_EQ(fitted(2), before);
    EXPECT_NE(fitted(kNoFold), all);
}

// 12 samples decide 42 unknowns a channel where the material is one that the prior can be.
TEST(PriorFit, FewSamplesFindAMaterialThatThePriorKnows)
{
    const TablePrior prior = smallPrior();
    const Material material = materialOf(prior);
    const auto samples = samplesOf(material, 12);
    const PriorFit fit =
        fitWithPrior(problemOf(prior.form, samples), PriorCovariance(prior), kNoFold, {});
    EXPECT_LE(fit.weights.tau, 0.05 * kOctaves * 1.001);
    EXPECT_LE(fit.weights.noise, 0.02 * kOctaves * 1.001);
    EXPECT_NEAR(fit.distance, (1.0 + 0.25 + 0.25 + 1.0 + 0.09 + 0.64) / 6.0, 0.15);
}

TEST(PriorFit, NoiseIsFoundByEvidence)
{
    const TablePrior prior = smallPrior();
    auto samples = samplesOf(materialOf(prior), 400);
    for (size_t i = 0; i < samples.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            // Uniform with the standard deviation 0.1.
            const auto u =
                static_cast<float>(splitMix64(3 * i + static_cast<size_t>(c)) % 10000) / 10000.0f;
            samples[i].f[c] *= std::exp(0.1f * std::sqrt(12.0f) * (u - 0.5f));
        }
    const PriorFit fit =
        fitWithPrior(problemOf(prior.form, samples), PriorCovariance(prior), kNoFold, {});
    EXPECT_NEAR(fit.weights.noise, 0.1 * kOctaves, 1e-9);  // a step of the ladder
}

double psnrOf(const Source& truth, const FitOptions& options, const Source& samples)
{
    const Material material = fitMaterial(samples, options).material;
    constexpr int kSize = 48;
    const auto reference = renderStandardSphere(truth.evaluate, kSize);
    const auto fitted = [&material](const Vec3d& wo, const Vec3d& wi) {
        return evaluate(material, wo, wi);
    };
    return imageErrors(renderStandardSphere(fitted, kSize), reference).psnrLinear;
}

Source samplesAtPlan(const Source& truth, size_t count)
{
    Source samples;
    samples.name = "few";
    samples.format = "csv";
    samples.isotropic = true;
    samples.samples = samplesAt(truth, shippedPlan(PlanSpace::hemisphere, count), 1);
    return samples;
}

// Analytic materials are none of those that the prior was learned from.
TEST(PriorFit, SixteenSamplesMakeAPictureOfWhatThePriorHasNotSeen)
{
    for (const test::Ggx& ggx : {test::Ggx{0.3, 0.3, 0.04, 0.3}, test::Ggx{0.15, 0.15, 0.8, 0.0}}) {
        const Source truth = test::sourceOf(ggx);
        EXPECT_GT(psnrOf(truth, {}, samplesAtPlan(truth, 16)), 32.0) << ggx.alphaX;
    }
}

// What is seen of one sample is nearly all of the prior's making: grey, bounded, and right where
// the sample is.
TEST(PriorFit, AnyNumberOfSamplesMakesASensiblePicture)
{
    constexpr double kHue = 0.02;  // of the rounding to 8 bits of three channels
    const Source truth = test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
    FitOptions options;
    for (const size_t count : {2u, 4u, 8u, 12u, 24u}) {
        const Source samples = samplesAtPlan(truth, count);
        const FitResult result = fitMaterial(samples, options);
        ASSERT_TRUE(result.summary.prior) << count;
        EXPECT_EQ(result.summary.used, count);
        const Sample& first = samples.samples.front();
        const Vec3f there = evaluate<float>(result.material, first.wo, first.wi);
        EXPECT_NEAR(std::log(there.x / first.f.x), 0.0, 0.1) << count;
        for (const auto& pair : uniformPairs(500)) {
            const Vec3d f = evaluate(result.material, pair.wo, pair.wi);
            ASSERT_TRUE(std::isfinite(f.x) && f.x > 0.0) << count;
            ASSERT_NEAR(std::log(f.y / f.x), 0.0, kHue) << count;
            ASSERT_NEAR(std::log(f.z / f.x), 0.0, kHue) << count;
        }
        EXPECT_LT(physicsErrors([&](const Vec3d& wo,
                                    const Vec3d& wi) { return evaluate(result.material, wo, wi); },
                                0)
                      .albedoMax,
                  1.1)
            << count;
    }
}

TEST(PriorFit, FitsThatLeanOnNothingNeedFiveSamples)
{
    const Source truth = test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
    FitOptions options;
    options.usePrior = false;
    EXPECT_THROW(fitMaterial(samplesAtPlan(truth, 4), options), Error);
    options.usePrior = true;
    options.maxBytes = 3000;  // the tables of the prior have 3,840
    EXPECT_THROW(fitMaterial(samplesAtPlan(truth, 4), options), Error);
    options.maxBytes = 0;
    Source black = samplesAtPlan(truth, 1);
    black.samples.front().f = Vec3f(0.0f);
    EXPECT_THROW(fitMaterial(black, options), Error) << "no value above the noise floor";
}

// A rough plastic, as the prior knows many. A metal of one analytic lobe, which it does not know,
// is drawn worse with it than without: so few samples do not show which is which.
TEST(PriorFit, SmoothnessAloneIsNoBetterOfWhatThePriorKnows)
{
    FitOptions alone;
    alone.usePrior = false;
    alone.form = "hdio";
    const Source truth = test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
    for (const size_t count : {8u, 16u}) {
        const Source samples = samplesAtPlan(truth, count);
        EXPECT_GT(psnrOf(truth, {}, samples), psnrOf(truth, alone, samples) - 1.0) << count;
    }
}

TEST(PriorFit, IsForFewScatteredSamplesAlone)
{
    const Source truth = test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
    FitOptions options;
    options.heldOut = false;
    const auto leans = [&](const Source& source) {
        return fitMaterial(source, options).summary.prior.has_value();
    };
    EXPECT_TRUE(leans(samplesAtPlan(truth, 16)));
    options.form = "hdio";
    EXPECT_TRUE(leans(samplesAtPlan(truth, 16)));
    EXPECT_FALSE(leans(truth));
    options.form = "hdg";
    EXPECT_FALSE(leans(samplesAtPlan(truth, 16)));
    options.form = "auto";
    options.usePrior = false;
    EXPECT_FALSE(leans(samplesAtPlan(truth, 16)));
    options.usePrior = true;
    options.maxBytes = 3000;  // the tables of the prior have 3,840
    EXPECT_FALSE(leans(samplesAtPlan(truth, 40)));
}

}  // namespace
}  // namespace fbrdf
