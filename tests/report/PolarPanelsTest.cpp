#include "PolarFigures.h"
#include "PolarPanels.h"
#include "TestMaterials.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kDegrees = 1e-3;  // float directions

std::vector<PolarPanel> panelsOf(const Source& source)
{
    const Material material = test::constantMaterial(Vec3f(0.5f));
    return polarPanels(source, material, comparisonSet(source, material));
}

// Reflects towards the mirror direction only.
Source mirrorSource()
{
    Source source = test::lambertianSource(0.0);
    source.evaluate = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(glm::dot(wo, Vec3d(-wi.x, -wi.y, wi.z)) > std::cos(0.5 * kPi / 180.0) ? 1.0
                                                                                           : 0.0);
    };
    return source;
}

TEST(PolarPanels, TheMirrorDirectionIsAtPlusThetaI)
{
    Source source = mirrorSource();
    source.isotropic = false;
    const auto panels = panelsOf(source);
    ASSERT_EQ(panels.size(), 8u);
    for (const PolarPanel& panel : panels) {
        size_t lit = 0;
        for (const PolarPoint& p : panel.data) {
            if (p.f.x == 0.0) continue;
            ++lit;
            EXPECT_NEAR(p.theta_o, panel.theta_i, 0.51);
        }
        EXPECT_GT(lit, 0u);
    }
}

TEST(PolarPanels, AFunctionIsDrawnAsCurvesOfDataAndFit)
{
    const auto panels = panelsOf(test::lambertianSource(0.25));
    ASSERT_EQ(panels.size(), 4u);
    for (const PolarPanel& panel : panels) {
        EXPECT_FALSE(panel.scattered);
        ASSERT_EQ(panel.data.size(), panel.fit.size());
        for (size_t i = 0; i < panel.data.size(); ++i) {
            EXPECT_EQ(panel.data[i].f.x, 0.25);
            EXPECT_NEAR(panel.fit[i].f.x, 0.5, 1e-6);
        }
    }
}

TEST(PolarPanels, ScatteredSamplesAppearAtTheirAngles)
{
    const auto panels = panelsOf(test::scatteredSource(0.5f));
    ASSERT_EQ(panels.size(), 2u);
    EXPECT_NEAR(panels[0].theta_i, 30.0, kDegrees);
    EXPECT_NEAR(panels[1].theta_i, 60.0, kDegrees);
    for (const PolarPanel& panel : panels) {
        EXPECT_TRUE(panel.scattered);
        ASSERT_EQ(panel.data.size(), 17u);
        for (size_t i = 0; i < panel.data.size(); ++i)
            EXPECT_NEAR(panel.data[i].theta_o, -80.0 + 10.0 * static_cast<double>(i), kDegrees);
    }
}

TEST(PolarPanels, SamplesOutsideThePlaneAreLeftOut)
{
    Source source = test::scatteredSource(0.5f);
    for (Sample& s : source.samples) s.wo = Vec3f(directionFromAngles(0.5, 1.3));
    EXPECT_TRUE(panelsOf(source).empty());
}

TEST(PolarPanels, AnIsotropicPlaneMayHaveAnyAzimuth)
{
    Source source = test::scatteredSource(0.5f);
    const auto turned = [](const Vec3f& w) {
        const double c = std::cos(0.7), s = std::sin(0.7);
        const Vec3d v(w);
        return Vec3f(Vec3d(c * v.x - s * v.y, s * v.x + c * v.y, v.z));
    };
    for (Sample& s : source.samples) {
        s.wo = turned(s.wo);
        s.wi = turned(s.wi);
    }
    EXPECT_EQ(panelsOf(source).size(), 2u);
    source.isotropic = false;
    EXPECT_TRUE(panelsOf(source).empty());  // neither along the tangent nor across it
}

TEST(PolarPanels, AcrossTheTangentIsAPlaneOfItsOwn)
{
    Source source = test::scatteredSource(0.5f);
    source.isotropic = false;
    for (Sample& s : source.samples) {
        s.wo = {-s.wo.y, s.wo.x, s.wo.z};
        s.wi = {-s.wi.y, s.wi.x, s.wi.z};
    }
    const auto panels = panelsOf(source);
    ASSERT_EQ(panels.size(), 2u);
    EXPECT_EQ(panels[0].azimuth, 90.0);
}

TEST(PolarPanels, ManySamplesAreThinnedAndCounted)
{
    Source source = test::scatteredSource(0.5f);
    const std::vector<Sample> once = source.samples;
    for (int i = 0; i < 99; ++i)
        source.samples.insert(source.samples.end(), once.begin(), once.end());
    const auto panels = panelsOf(source);
    EXPECT_EQ(panels[0].samples, 1700u);
    EXPECT_EQ(panels[0].data.size(), kDotsShown);
}

size_t occurrences(const std::string& text, const std::string& part)
{
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(PolarFigures, GreyIsOneLineAndColourThree)
{
    EXPECT_EQ(
        occurrences(polarFigures(panelsOf(test::lambertianSource(0.25))), "class=\"data grey\""),
        4u + 1u);
    Source red = test::lambertianSource(0.0);
    red.evaluate = [](const Vec3d&, const Vec3d&) { return Vec3d(0.5, 0.1, 0.1); };
    const std::string figures = polarFigures(panelsOf(red));
    for (const char* name : {"data red", "data green", "data blue"})
        EXPECT_EQ(occurrences(figures, std::string("class=\"") + name + "\""), 4u) << name;
}

TEST(PolarFigures, ScatteredDataAreDots)
{
    const std::string figures = polarFigures(panelsOf(test::scatteredSource(0.5f)));
    EXPECT_EQ(occurrences(figures, "class=\"dot grey\""), 34u + 1u);
    EXPECT_EQ(polarFigures({}), "");
}

TEST(PolarFigures, BlackDataCanBeDrawn)
{
    EXPECT_NE(polarFigures(panelsOf(test::lambertianSource(0.0))), "");
}

}  // namespace
}  // namespace fbrdf
