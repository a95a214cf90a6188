#include "ErrorBins.h"
#include "ErrorFigures.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// Directions and values travel as float.
constexpr double kFloat = 1e-6;

// A sample at half/difference angles in degrees: f = 1, g as given.
void add(ComparisonSet& set, double theta_h, double theta_d, float g)
{
    const auto pair =
        pairFromHalfDifference({theta_h * kPi / 180.0, 0.0, theta_d * kPi / 180.0, kPi / 2.0});
    set.samples.push_back({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(1.0f), 1.0f});
    set.fitted.push_back(Vec3f(g));
}

TEST(ErrorBins, EdgesSpanTheQuadrant)
{
    EXPECT_EQ(edgeOfThetaH(0), 0.0);
    EXPECT_EQ(edgeOfThetaH(kErrorBins), 90.0);
    EXPECT_EQ(edgeOfThetaH(kErrorBins / 2), 22.5);  // half way in the square root
    EXPECT_EQ(edgeOfThetaD(1), 5.0);
    EXPECT_EQ(edgeOfThetaD(kErrorBins), 90.0);
}

TEST(ErrorBins, ASampleFallsBetweenTheEdgesOfItsBin)
{
    ComparisonSet set;
    add(set, 30.0, 12.0, 2.0f);
    const ErrorBins bins = errorBins(set, Vec3f(0.0f));
    size_t filled = 0;
    for (int d = 0; d < kErrorBins; ++d)
        for (int h = 0; h < kErrorBins; ++h) {
            if (bins.at(h, d).samples == 0) continue;
            ++filled;
            EXPECT_LE(edgeOfThetaH(h), 30.0);
            EXPECT_GT(edgeOfThetaH(h + 1), 30.0);
            EXPECT_EQ(edgeOfThetaD(d), 10.0);
            EXPECT_NEAR(bins.at(h, d).median, std::log(2.0), kFloat);
            EXPECT_NEAR(bins.at(h, d).share, 1.0, kFloat);
        }
    EXPECT_EQ(filled, 1u);
}

TEST(ErrorBins, SharesSumToOneAndFollowTheError)
{
    ComparisonSet set;
    add(set, 0.1, 2.0, 3.0f);
    add(set, 30.0, 12.0, 1.5f);
    add(set, 50.0, 12.0, 1.0f);
    const ErrorBins bins = errorBins(set, Vec3f(0.0f));
    double sum = 0.0;
    for (const ErrorBin& bin : bins.bins) sum += bin.share;
    EXPECT_NEAR(sum, 1.0, kFloat);
    EXPECT_GT(bins.at(0, 0).share, 0.9);
}

TEST(ErrorBins, NoiseHasNoRelativeError)
{
    ComparisonSet set;
    add(set, 0.1, 2.0, 3.0f);
    const ErrorBins bins = errorBins(set, Vec3f(1.0f));
    EXPECT_EQ(bins.at(0, 0).samples, 1u);
    EXPECT_TRUE(std::isnan(bins.at(0, 0).median));
}

TEST(WeakestPlaces, NamesThePlantedError)
{
    ComparisonSet set;
    for (int i = 0; i < 8; ++i) {
        add(set, 0.1, 2.0, 1.1f);
        add(set, 30.0, 12.0, 4.0f);
    }
    const std::string text = weakestPlaces(errorBins(set, Vec3f(0.0f)));
    EXPECT_NE(text.find("28\xE2\x80\x93"
                        "34\xC2\xB0"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("10\xE2\x80\x93"
                        "15\xC2\xB0"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("1.39 (samples: 8)"), std::string::npos) << text;  // ln 4
}

TEST(WeakestPlaces, AreEmptyForAPerfectFit)
{
    ComparisonSet set;
    for (int i = 0; i < 8; ++i) add(set, 0.1, 2.0, 1.0f);
    EXPECT_EQ(weakestPlaces(errorBins(set, Vec3f(0.0f))), "");
}

TEST(WeakestPlaces, TheMedianOfOneAmongManyIsNotNamed)
{
    ComparisonSet set;
    add(set, 30.0, 12.0, 4.0f);
    EXPECT_NE(weakestPlaces(errorBins(set, Vec3f(0.0f))).find("1.39 (samples: 1)"),
              std::string::npos);
    for (int i = 0; i < 5000; ++i) add(set, 0.1, 2.0, 1.1f);
    EXPECT_EQ(weakestPlaces(errorBins(set, Vec3f(0.0f))).find("1.39"), std::string::npos);
}

}  // namespace
}  // namespace fbrdf
