#include <fbrdf/fit/Svd.h>

#include "support/TemporaryDir.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// Texels are half floats, 2^-11 apart relative to the largest of their table, in both factors.
constexpr double kHalf = 2e-3;
constexpr double kSteep = 0.3;  // cosine above which the grid's own steps are small

double smallestCosine(const DirectionPair<double>& pair)
{
    return std::min(pair.wo.z, pair.wi.z);
}

double squaredError(const Material& material, const BrdfFunction& brdf)
{
    double sum = 0.0;
    for (const auto& pair : uniformPairs(2000, 5)) {
        if (smallestCosine(pair) < kSteep) continue;
        const Vec3d d = evaluate(material, pair.wo, pair.wi) - brdf(pair.wo, pair.wi);
        sum += glm::dot(d, d);
    }
    return sum;
}

// A sum of three products of a function of theta_h and one of theta_d and phi_d, of either sign.
double rankThree(const HalfDifference& a)
{
    const double h = std::sin(a.theta_h), d = std::sin(a.theta_d), p = std::cos(2.0 * a.phi_d);
    return (1.0 + h) * (1.0 + d) + 0.5 * h * h * p * d - 0.7 * std::exp(-4.0 * h) * d * d;
}

double rankThreeOf(const Vec3d& wo, const Vec3d& wi)
{
    return rankThree(halfDifferenceFromPair({wo, wi}));
}

// The largest difference at the knots, where look-ups interpolate nothing.
double largestAtKnots(const Material& material)
{
    const auto angle = [](const Axis& axis, int knot) {
        return angleFromAxisCoordinate(axis.map, static_cast<double>(knot) / (axis.size - 1));
    };
    const auto& u = std::get<GridDomain>(material.tables[0].domain).axes;
    const auto& v = std::get<GridDomain>(material.tables[1].domain).axes;
    double largest = 0.0;
    for (int i = 1; i < u[0].size; ++i)
        for (int j = 1; j < v[0].size; ++j)
            for (int k = 0; k < v[1].size; ++k) {
                const HalfDifference a{angle(u[0], i), 0.0, angle(v[0], j), angle(v[1], k)};
                const auto pair = pairFromHalfDifference(a);
                if (smallestCosine(pair) < 0.05) continue;
                largest = std::max(largest,
                                   std::abs(evaluate(material, pair.wo, pair.wi).x - rankThree(a)));
            }
    return largest;
}

Material svdOf(const BrdfFunction& brdf, int terms, int size = 32, bool isotropic = true)
{
    return svdMaterial(brdf, formSvd(terms, size, isotropic), 1);
}

const BrdfFunction kRankThree = [](const Vec3d& wo, const Vec3d& wi) {
    return Vec3d(rankThreeOf(wo, wi));
};

TEST(Svd, OneTermRepresentsALambertian)
{
    const BrdfFunction lambert = makeModelSource("lambert:albedo=0.2/0.4/0.8").evaluate;
    for (const bool isotropic : {true, false}) {
        const Material material = svdOf(lambert, 1, 16, isotropic);
        for (const auto& pair : uniformPairs(200))
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(evaluate(material, pair.wo, pair.wi)[c], lambert(pair.wo, pair.wi)[c],
                            kHalf * lambert(pair.wo, pair.wi)[c]);
    }
}

TEST(Svd, AsManyTermsAsTheRankAreExactAtTheKnots)
{
    EXPECT_LT(largestAtKnots(svdOf(kRankThree, 3)), 4.0 * kHalf);
    EXPECT_GT(largestAtKnots(svdOf(kRankThree, 2)), 40.0 * kHalf);
}

TEST(Svd, TermsBeyondTheRankDoNoHarm)
{
    EXPECT_LT(largestAtKnots(svdOf(kRankThree, 5)), 4.0 * kHalf);
}

TEST(Svd, EveryTermLowersTheError)
{
    const BrdfFunction ggx = makeModelSource("ggx:alpha=0.4,f0=0.5,kd=0.2").evaluate;
    double last = std::numeric_limits<double>::infinity();
    for (int terms = 1; terms <= 5; ++terms) {
        const double error = squaredError(svdOf(ggx, terms, kSvdSize), ggx);
        EXPECT_LT(error, last) << terms;
        last = error;
    }
}

TEST(Svd, RepresentsAnisotropy)
{
    const BrdfFunction ggx = makeModelSource("ggx:alpha_x=0.2,alpha_y=0.6,f0=0.9").evaluate;
    const double isotropic = squaredError(svdOf(ggx, 4, 32, true), ggx);
    EXPECT_LT(squaredError(svdOf(ggx, 4, 40, false), ggx), 0.25 * isotropic);
}

TEST(Svd, NegativeValuesSurviveTheFile)
{
    const BrdfFunction negative = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(-1.0, 2.0, 0.5) * rankThreeOf(wo, wi);
    };
    const Material material = svdOf(negative, 2, 16);
    EXPECT_NO_THROW(validate(material, "svd"));
    const auto signs =
        std::minmax_element(material.tables[1].texels.begin(), material.tables[1].texels.end());
    EXPECT_LT(*signs.first, 0.0f);
    EXPECT_GT(*signs.second, 0.0f);
    const test::TemporaryDir folder;
    writeMaterial(material, folder.file("svd.fbrdf"));
    const Material read = readMaterial(folder.file("svd.fbrdf"));
    for (const auto& pair : uniformPairs(100)) {
        const Vec3d f = evaluate(material, pair.wo, pair.wi);
        EXPECT_LT(f.x, 0.0);
        EXPECT_EQ(evaluate(read, pair.wo, pair.wi), f);
    }
}

TEST(Svd, RefusesMoreTermsThanTheMatrixHas)
{
    EXPECT_THROW(svdOf(kRankThree, 5, 4), Error);
    EXPECT_THROW(svdOf(kRankThree, kMaxSvdTerms + 1, 64), Error);
}

FitOptions named(const std::string& form)
{
    FitOptions options;
    options.form = form;
    options.threads = 1;
    options.heldOut = false;
    return options;
}

TEST(SvdForm, TakesTheTermsOfTheNameOrTheBudget)
{
    const Source source = makeModelSource("ggx:alpha=0.4");
    FitOptions options = named("svd2");
    EXPECT_EQ(fitMaterial(source, options).material.form.terms.size(), 2u);
    options.form = "svd";
    EXPECT_EQ(fitMaterial(source, options).material.form.terms.size(), 4u);
    options.maxBytes = 4000;
    const Material material = fitMaterial(source, options).material;
    EXPECT_EQ(material.form.name, "svd3");
    EXPECT_EQ(materialBytes(material), 3u * 1248u);
    EXPECT_EQ(material.tables[0].storage, Storage::signedHalf);
}

TEST(SvdForm, ResamplesScatteredSamples)
{
    Source scattered = makeModelSource("ggx:alpha=0.6,f0=0.3,kd=0.3");
    scattered.samples = samplesAt(scattered, uniformPairs(2000), 1);
    scattered.evaluate = {};
    scattered.exact = false;
    FitOptions options = named("svd4");
    options.heldOut = true;
    const FitResult result = fitMaterial(scattered, options);
    EXPECT_EQ(result.summary.folds, 5);
    EXPECT_LT(result.summary.all.logMedian, 0.05);
    EXPECT_LT(result.summary.heldOut.logMedian, 0.08);
}

TEST(SvdForm, MarksTexelsThatNoSampleSupports)
{
    Source scattered = makeModelSource("ggx:alpha=0.6,f0=0.3,kd=0.3");
    std::vector<Sample> steep;  // half vectors within 25 degrees of the normal
    for (const Sample& s : samplesAt(scattered, uniformPairs(20000), 1))
        if (glm::normalize(s.wo + s.wi).z > 0.906f) steep.push_back(s);
    scattered.samples = steep;
    scattered.evaluate = {};
    scattered.exact = false;
    const Material material = fitMaterial(scattered, named("svd2")).material;
    const Table& u = material.tables[0];
    const auto knots = static_cast<size_t>(texelCount(u.domain));
    ASSERT_EQ(u.unsupported.size(), knots);
    EXPECT_FALSE(u.unsupported[knots / 4]);
    EXPECT_TRUE(u.unsupported[knots - 1]);
    EXPECT_EQ(material.tables[2].unsupported, u.unsupported);
    const Material whole = fitMaterial(makeModelSource("lambert"), named("svd2")).material;
    EXPECT_FALSE(whole.tables[0].unsupported[knots / 4]);
}

TEST(SvdForm, RefusesWhatItCannotDo)
{
    Source scattered = makeModelSource("ggx:alpha_x=0.3,alpha_y=0.6");
    scattered.samples = samplesAt(scattered, uniformPairs(500), 1);
    scattered.evaluate = {};
    EXPECT_THROW(fitMaterial(scattered, named("svd")), Error);
    for (const char* form : {"svd0", "svd33", "svd99999999999"})
        EXPECT_THROW(checkOptions(named(form)), Error) << form;
    EXPECT_THROW(checkOptions(named("svdx")), Error);
    FitOptions options = named("svd");
    options.metric = Metric::cubeRoot;
    EXPECT_THROW(checkOptions(options), Error);
    options = named("svd4");
    options.maxBytes = 1300;
    EXPECT_THROW(fitMaterial(makeModelSource("lambert"), options), Error);
}

}  // namespace
}  // namespace fbrdf
