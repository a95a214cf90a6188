#include <fbrdf/fit/Fit.h>
#include <fbrdf/sources/OpenSource.h>

#include "Known.h"

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

FitOptions small(const std::string& form)
{
    FitOptions options;
    options.form = form;
    options.resolution = 16;
    return options;
}

// The kind of error of a fit; gl, which no fit has, where there is none.
ErrorKind kindOf(const Source& source, const FitOptions& options)
{
    try {
        fitMaterial(source, options);
    } catch (const Error& error) {
        return error.kind();
    }
    return ErrorKind::gl;
}

TEST(Fit, FewerMeasuredSamplesChangeNoTableAndErrorsALittle)
{
    FitOptions options;
    options.form = "io";
    options.heldOut = false;
    options.smoothness = 1e-3;
    const Source source = openSource("ggx:alpha=0.3,f0=0.9,kd=0.1");
    const FitResult all = fitMaterial(source, options);
    options.measured = 4000;
    const FitResult few = fitMaterial(source, options);
    EXPECT_EQ(few.material.tables[0].texels, all.material.tables[0].texels);
    EXPECT_NE(few.summary.all.logMedian, all.summary.all.logMedian);
    EXPECT_NEAR(few.summary.all.logMedian, all.summary.all.logMedian,
                0.1 * all.summary.all.logMedian);
    options.measured = 0;
    EXPECT_THROW(fitMaterial(source, options), Error);
}

TEST(Fit, IsTheSameForTheSameSeedWhateverTheThreads)
{
    const Source source = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3}), 3000, 2);
    FitOptions options = small("hdio");
    options.threads = 1;
    const FitResult a = fitMaterial(source, options);
    options.threads = 3;
    const FitResult b = fitMaterial(source, options);
    for (size_t t = 0; t < a.material.tables.size(); ++t)
        EXPECT_EQ(a.material.tables[t].texels, b.material.tables[t].texels);
    EXPECT_EQ(a.material.scales, b.material.scales);
    EXPECT_EQ(a.summary.heldOut.logRms, b.summary.heldOut.logRms);
}

TEST(Fit, ReportsWhatItUsed)
{
    Source source = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3}), 2000, 2);
    for (size_t i = 0; i < 50; ++i) source.samples[i].f = Vec3f(-0.001f);
    const FitResult result = fitMaterial(source, small("hdio"));
    EXPECT_EQ(result.summary.used, 2000u);
    EXPECT_GE(result.summary.belowFloor, 150u);
    EXPECT_EQ(result.summary.folds, 5);
    EXPECT_GT(result.summary.noiseFloor.x, 0.0f);
    EXPECT_GT(result.summary.smoothness, 0.0);
    EXPECT_NO_THROW(validate(result.material, "fit"));
}

TEST(Fit, StaysWithinTheByteBudget)
{
    const Source source = test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
    FitOptions options;
    options.form = "hdio";
    options.maxBytes = 1400;
    EXPECT_LE(materialBytes(fitMaterial(source, options).material), 1400u);
    options.maxBytes = 20;
    EXPECT_EQ(kindOf(source, options), ErrorKind::usage);
    options.maxBytes = 1400;
    options.resolution = 64;
    EXPECT_EQ(kindOf(source, options), ErrorKind::usage);
}

TEST(Fit, SharperIncludedMetricsLowerTheErrorTheyMeasure)
{
    // A form too weak for its data: p q p on a plastic.
    const Source source = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3}), 20000, 3);
    FitOptions options = small("pqp");
    options.storage = Storage::float32;
    const SampleErrors log = fitMaterial(source, options).summary.all;
    options.metric = Metric::cubeRoot;
    const SampleErrors cube = fitMaterial(source, options).summary.all;
    EXPECT_LT(cube.cubeRootRms, 0.98 * log.cubeRootRms);
}

TEST(Fit, OnePairMeasuredFiveTimesGivesItsValueAndFewerTimesNone)
{
    const Sample sample{Vec3f(0, 0, 1), glm::normalize(Vec3f(0.3f, 0, 1)), Vec3f(0.25f), 1.0f};
    Source source;
    source.name = "one pair";
    source.samples.assign(4, sample);
    EXPECT_THROW(fitMaterial(source, small("hdio")), Error);
    source.samples.push_back(sample);
    const FitResult result = fitMaterial(source, small("hdio"));
    EXPECT_NEAR(evaluate(result.material, sample.wo, sample.wi).x, 0.25f, 0.01f);
}

TEST(Fit, BadInputIsRefused)
{
    const Source source = test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3});
    FitOptions options = small("nonsense");
    EXPECT_EQ(kindOf(source, options), ErrorKind::usage);
    options = small("hdio");
    options.smoothness = -1.0;
    EXPECT_EQ(kindOf(source, options), ErrorKind::usage);
    options = small("hdio");
    options.lookups = 0;
    EXPECT_EQ(kindOf(source, options), ErrorKind::usage);
    EXPECT_EQ(kindOf(Source{}, small("hdio")), ErrorKind::fit);
    Source dark;
    dark.samples.assign(9, Sample{Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0.0f), 1.0f});
    EXPECT_EQ(kindOf(dark, small("hdio")), ErrorKind::fit);
}

}  // namespace
}  // namespace fbrdf
