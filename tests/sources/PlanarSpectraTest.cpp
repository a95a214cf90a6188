// Spectra in the plane of incidence.
#include "ReaderTest.h"
#include "support/DataDir.h"

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

const std::string kHeader = " Incident_angle,Measure_angle, 450nm , 550nm , 650nm \n";

Source read(const std::string& text, const std::string& choice = "")
{
    const TempFolder folder;
    return openSource(folder.write("paint.csv", text) + choice);
}

}  // namespace

TEST(PlanarSpectra, TheMirrorIsAtThePositiveAngle)
{
    const Source source = read(kHeader + "30,30,0.2,0.2,0.2\n30,-60,0.1,0.1,0.1\n30,-30,0,0,0\n");
    EXPECT_EQ(source.format, "planar-spectra");
    ASSERT_EQ(source.samples.size(), 2u);
    EXPECT_EQ(source.report.invalid, 1u);
    EXPECT_NEAR(source.samples[0].wi.x, -0.5f, 1e-6f);
    EXPECT_NEAR(source.samples[0].wo.x, 0.5f, 1e-6f);
    EXPECT_NEAR(source.samples[1].wo.x, -std::sqrt(0.75f), 1e-6f);
    EXPECT_LT(glm::length(source.samples[0].f - Vec3f(0.2f)), 1e-6f);
    expectSound(source);
}

TEST(PlanarSpectra, ValuesAboveThoseOfAPerfectDiffuserAreFactors)
{
    const Source source = read(
        "Incident_angle;Measure_angle;450nm;550nm\n30;10;0,8;0,8\n30;30;90;90\n"
        "30;20;0,8;0,8\n");
    ASSERT_EQ(source.samples.size(), 3u);
    EXPECT_NEAR(source.samples[0].f.x, 0.8 / kPi, 1e-6);
    EXPECT_NE(source.assumptions.at(0).find("reflectance factors"), std::string::npos);
}

TEST(PlanarSpectra, AWavelengthIsAChoice)
{
    EXPECT_FLOAT_EQ(read(kHeader + "30,30,0.1,0.2,0.3\n", "@650").samples.at(0).f.x, 0.3f);
    EXPECT_FLOAT_EQ(read(kHeader + "30,30,0.1,0.2,0.3\n", "@0.45").samples.at(0).f.x, 0.1f);
}

TEST(PlanarSpectra, EveryPrefixIsSoundOrRefused)
{
    const std::string text = kHeader + "30,30,0.2,0.2,0.2\n30,-60,0.1,NA,0.1\n";
    EXPECT_GT(refusedPrefixes("a.csv", text), kHeader.size());
    expectSurvivesDamage("a.csv", text);
}

TEST(PlanarSpectra, TheRealFileHasItsPeakAtTheMirror)
{
    FBRDF_NEEDS_DATA("speos/test_brdf_viewer_2D_data.csv");
    const Source source = openSource(dataPath("speos/test_brdf_viewer_2D_data.csv"));
    EXPECT_EQ(source.report.given, 329u);
    expectSound(source);
    const Sample* most = source.samples.data();
    for (const Sample& s : source.samples)
        if (s.f.y > most->f.y) most = &s;
    EXPECT_LT(glm::length(most->wo - Vec3f(-most->wi.x, 0, most->wi.z)), 1e-5f);
}
