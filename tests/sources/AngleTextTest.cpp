// Formats whose files do not name the unit of their angles: ASTM E1392 and headerless text.
#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr float kFloat = 1e-6f;

Source read(const std::string& text, const std::string& name)
{
    const TempFolder folder;
    return openSource(folder.write(name, text));
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("paint.astm", text), part);
}

std::string astm(const std::string& vars, const std::string& rows, int points)
{
    return "ASTM E1392\nTITLE \"a paint, blue\"\nNUM_POINTS " + std::to_string(points) + "\nVARS " +
           vars + "\n" + rows;
}

const std::string kRgb = astm("theta_i,phi_i,theta_s,phi_s,R,G,B",
                              "0.5,0.0,0.25,3.1415927,1,2,3\n0.5,0,1.7,0,1,1,1\n"
                              "0.5,0,0.3,0,nan,1,1\n",
                              3);

}  // namespace

TEST(Astm, ReadsRadiansAndColours)
{
    const Source source = read(kRgb, "paint.astm");
    EXPECT_EQ(source.format, "astm");
    ASSERT_EQ(source.samples.size(), 1u);
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wi) - directionFromAngles(0.5, 0)), 1e-6);
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wo) - directionFromAngles(0.25, kPi)), 1e-6);
    EXPECT_EQ(source.samples[0].f, Vec3f(1, 2, 3));
    EXPECT_EQ(source.report.belowHorizon, 1u);
    EXPECT_EQ(source.report.nonFinite, 1u);
}

TEST(Astm, AnglesAbovePiAreDegrees)
{
    const Source source = read(
        astm("theta_i,phi_i,theta_s,phi_s,Integrated[300..700]", "2,0,3,0,1\n30,90,60,0,0.5\n", 2),
        "paint.astm");
    ASSERT_EQ(source.samples.size(), 2u);
    EXPECT_NEAR(source.samples[1].wi.y, 0.5f, kFloat);
    EXPECT_NEAR(source.samples[1].wo.x, std::sqrt(0.75f), kFloat);
    EXPECT_NE(source.description.find("degrees"), std::string::npos);
}

TEST(Astm, SpectraAndTristimulusBecomeColours)
{
    const Source flat = read(astm("theta_i,theta_s,phi_s,450nm,550nm,650nm",
                                  "0.5,0.25,3,0.5,0.5,0.5\n0.5,0.25,3,0,1,0\n", 2),
                             "paint.astm");
    EXPECT_EQ(flat.samples.at(0).f, Vec3f(0.5f));
    EXPECT_TRUE(flat.isotropic);
    const Source white = read(astm("theta_i,phi_i,theta_s,phi_s,X,Y,Z",
                                   "0.5,0,0.25,3,0.95047,1,1.08883\n0.5,0,0.25,3,0,1,0\n", 2),
                              "paint.astm");
    EXPECT_LT(glm::length(white.samples.at(0).f - Vec3f(1.0f)), 1e-4f);
    EXPECT_EQ(white.report.outOfGamut, 1u);
}

TEST(Astm, RowsAndNamesAreSeparatedEachInTheirOwnWay)
{
    const Vec3f expected = read(kRgb, "paint.astm").samples.at(0).wo;
    for (const char* names :
         {"theta_i phi_i theta_s phi_s R G B", "theta_i;phi_i;theta_s;phi_s;R;G;B",
          "THETA_I\tPHI_I\tTHETA_R\tPHI_R\tr\tg\tb", "theta_i,phi_i,theta_s,phi_s,R,G,B,"})
        for (const char* row : {"0.5 0.0 0.25 3.1415927 1 2 3", "0.5\t0\t0.25\t3.1415927\t1\t2\t3",
                                "0,5 0 0,25 3,1415927 1 2 3", "0,5;0;0,25;3,1415927;1;2;3",
                                "\"0.5\",\"0\",\"0.25\",\"3.1415927\",\"1\",\"2\",\"3\""}) {
            const Source source = read(astm(names, std::string(row) + "\n", 1), "paint.astm");
            ASSERT_EQ(source.samples.size(), 1u) << names << row;
            EXPECT_LT(glm::length(source.samples[0].wo - expected), kFloat) << names << row;
            EXPECT_EQ(source.samples[0].f, Vec3f(1, 2, 3)) << names << row;
        }
}

TEST(Astm, KeysAndNamesMayCarryPunctuationAndUnits)
{
    const Source source =
        read("num_points: 1\nvars = theta_i [deg], theta_s(deg), phi_s_deg, B, G, R\n1,2,0,3,2,1\n",
             "paint.astm");
    EXPECT_EQ(source.samples.at(0).f, Vec3f(1, 2, 3));
    EXPECT_NEAR(source.samples.at(0).wi.x, std::sin(kDegree), kFloat);
}

TEST(Astm, AWavelengthIsAChoice)
{
    const TempFolder folder;
    const std::string path = folder.write(
        "paint.astm", astm("theta_i,theta_s,phi_s,0.65um,450nm,550nm", "0.5,0.25,3,1,2,3\n", 1));
    EXPECT_EQ(openSource(path + "@550").samples.at(0).f, Vec3f(3.0f));
    EXPECT_EQ(openSource(path + "@0.65").samples.at(0).f, Vec3f(1.0f));
    const Outcome outcome = outcomeOf(path + "@500");
    EXPECT_EQ(outcome.kind, int(ErrorKind::usage));
    EXPECT_NE(outcome.message.find("450, 550, 650 nm"), std::string::npos) << outcome.message;
}

TEST(Astm, RefusesWhatDoesNotAddUp)
{
    const std::string row = "0.5,0,0.25,3,1\n";
    expectRefused(astm("theta_i,phi_i,theta_s,phi_s,I", row, 2),
                  "found 1 rows, expected NUM_POINTS 2");
    expectRefused(astm("theta_i,phi_i,theta_s,phi_s,I", row + row, 1), "found 2 rows");
    expectRefused(astm("theta_i,phi_i,theta_s,phi_s,I", "0.5,0,0.25,3\n", 1), ":5: found 4 fields");
    expectRefused(astm("theta_i,phi_i,theta_s,phi_s,I", "0.5,0,x,3,1\n", 1), ":5: found 'x'");
    expectRefused(astm("theta_i,phi_i,theta_s,phi_s,A,B", "0,0,0,0,1,1\n", 1), "2 value columns");
    expectRefused(astm("theta_i,phi_i,phi_s,A", "0,0,0,1\n", 1), "found no theta_i, theta_s");
    expectRefused(astm("theta_i,theta_s,phi_s,600nm,600nm", "0,0,0,1,1\n", 1), "twice");
    expectRefused("KEY value\n", "found no VARS");
}

TEST(Astm, EveryPrefixIsRefused)
{
    // Without its last digit or line end the last row is still whole.
    EXPECT_GE(refusedPrefixes("a.astm", kRgb), kRgb.size() - 2);
    expectSurvivesDamage("a.astm", kRgb, 2);
}

TEST(Scattered, SevenColumnsAreAngles)
{
    const Source source =
        read("# Ngan et al. 2005\n0.5 0.1 0.25 3 1 2 3\n0.2 0 0.1 0 0 0 1\n", "satin.txt");
    EXPECT_EQ(source.format, "scattered");
    ASSERT_EQ(source.samples.size(), 2u);
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wi) - directionFromAngles(0.5, 0.1)), 1e-6);
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wo) - directionFromAngles(0.25, 3)), 1e-6);
    EXPECT_EQ(source.samples[0].f, Vec3f(1, 2, 3));
    const Source degrees = read("30 90 60 0 1 2 3\n0 0 1 0 1 1 1\n", "satin.txt");
    EXPECT_NEAR(degrees.samples.at(0).wi.y, 0.5f, kFloat);
}

TEST(Scattered, NineColumnsAreDirectionsLightFirst)
{
    const Source source = read("0.6,0,0.8,0,0,3,1,2,3\n0,0,-1,0,0,1,1,1,1\n", "velvet.txt");
    ASSERT_EQ(source.samples.size(), 1u);
    EXPECT_LT(glm::length(source.samples[0].wi - Vec3f(0.6f, 0, 0.8f)), kFloat);
    EXPECT_LT(glm::length(source.samples[0].wo - Vec3f(0, 0, 1)), kFloat);
    EXPECT_EQ(source.report.belowHorizon, 1u);
}

TEST(Scattered, CommasAreDecimalSignsBetweenBlanks)
{
    for (const char* text : {"0,5 0,1 0,25 3 1 2,5 3\n", "0,5;0,1;0,25;3;1;2,5;3\n",
                             "0.5, 0.1, 0.25, 3, 1, 2.5, 3\n", "0.5,0.1,0.25,3,1,2.5,3\n"}) {
        const Source source = read(text, "satin.txt");
        ASSERT_EQ(source.samples.size(), 1u) << text;
        EXPECT_EQ(source.samples[0].f, Vec3f(1, 2.5f, 3)) << text;
        EXPECT_LT(glm::length(Vec3d(source.samples[0].wi) - directionFromAngles(0.5, 0.1)), 1e-6);
        EXPECT_FALSE(source.assumptions.empty());
    }
}

TEST(Scattered, RefusesRowsOfAnotherLength)
{
    const TempFolder folder;
    const auto refuse = [&](const std::string& text, const std::string& part) {
        expectInputError(folder.write("a.txt", text), part);
    };
    refuse("1 2 3 4 5 6 7\n1 2 3 4 5 6\n", ":2: found 6 numbers");
    refuse("1 2 3 4 5 6 7\n1 2 3 4 5 6 7 8 9\n", ":2: found 9 numbers");
    refuse("1 2 3 4 5 6 7\n1 2 3 4 5 6 seven\n", ":2: found 'seven'");
    refuse("nan 2 3 4 5 6 7\n", "no usable sample");
    refuse("1 2 3 4 5 6\n", "unknown format");
}

TEST(Scattered, EveryPrefixIsSoundOrRefused)
{
    const std::string text = "0.5 0.1 0.25 3 1 2 3\n0.2 0 0.1 0 0 -1 1\n1.7 0 0 0 nan 1 1\n";
    EXPECT_GT(refusedPrefixes("a.txt", text), 10u);
    expectSurvivesDamage("a.txt", text);
}
