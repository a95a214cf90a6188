#include <fbrdf/fit/AnalyticFactors.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Median relative error over the uniform set; what is lost is lost between texels.
double medianError(const std::string& spec, int size)
{
    const auto material = analyticFactors(spec, size, Storage::float32);
    const Source source = makeModelSource(spec);
    std::vector<double> errors;
    for (const auto& pair : uniformPairs(2000)) {
        const Vec3d f = source.evaluate(pair.wo, pair.wi);
        errors.push_back(std::abs(std::log(evaluate(*material, pair.wo, pair.wi).x / f.x)));
    }
    std::nth_element(errors.begin(), errors.begin() + 1000, errors.end());
    return errors[1000];
}

TEST(AnalyticFactors, RepresentWardsModel)
{
    EXPECT_LT(medianError("ward:rho_d=0.1,rho_s=0.2,alpha_x=0.2,alpha_y=0.4", 128), 0.01);
    EXPECT_LT(medianError("ward-rolled-brass", 128), 0.01);
}

TEST(AnalyticFactors, RepresentAshikhminAndShirleysModel)
{
    EXPECT_LT(medianError("ashikhmin-shirley:kd=0.2,ks=0.3,nu=20,nv=80", 128), 0.01);
}

TEST(AnalyticFactors, GetBetterWithTexels)
{
    const std::string spec = "ashikhmin-shirley:kd=0,ks=0.3,nu=20,nv=80";
    EXPECT_LT(medianError(spec, 128), 0.6 * medianError(spec, 32));
}

TEST(AnalyticFactors, AreValidReciprocalMaterials)
{
    for (const char* spec : {"ward", "ashikhmin-shirley"}) {
        const auto material = analyticFactors(spec, 16, Storage::float32);
        ASSERT_TRUE(material);
        EXPECT_NO_THROW(validate(*material, spec));
        for (const auto& pair : uniformPairs(200)) {
            const Vec3d a = evaluate(*material, pair.wo, pair.wi);
            EXPECT_NEAR(evaluate(*material, pair.wi, pair.wo).x, a.x, 1e-12 + 1e-9 * a.x);
        }
    }
}

TEST(AnalyticFactors, AreOfNoOtherModel)
{
    EXPECT_FALSE(analyticFactors("ggx", 16, Storage::log8));
}

FitOptions analytic()
{
    FitOptions options;
    options.form = "analytic";
    options.threads = 1;
    options.heldOut = false;
    return options;
}

TEST(AnalyticFactors, AreAForm)
{
    FitOptions options = analytic();
    options.storage = Storage::half;
    const Source source = makeModelSource("ward-rolled-brass");
    const FitResult result = fitMaterial(source, options);
    EXPECT_EQ(result.material.form.name, "analytic");
    EXPECT_EQ(lookupsPerLight(result.material.form), 1);
    EXPECT_EQ(result.summary.smoothness, 0.0);
    options.maxBytes = 5000;
    EXPECT_LE(materialBytes(fitMaterial(source, options).material), 5000u);
    options.maxBytes = 100;
    EXPECT_THROW(fitMaterial(source, options), Error);
}

TEST(AnalyticFactors, NameTheModelsThatHaveThem)
{
    try {
        fitMaterial(makeModelSource("ggx"), analytic());
        FAIL() << "ggx was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("ward, ashikhmin-shirley"), std::string::npos);
    }
    FitOptions linear = analytic();
    linear.storage = Storage::linear8;
    EXPECT_THROW(checkOptions(linear), Error);
}

}  // namespace
}  // namespace fbrdf
