// Reference figures of the real files: the data set's parse.py (numpy).
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

#include <algorithm>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr double kFloat = 1e-6;  // directions are stored as float

std::string alta(const std::string& dim, const std::string& in, const std::string& out,
                 const std::string& rows)
{
    return "#SAMPLE \"a tape\"\n#DIM " + dim + "\n#VS 0\n#PARAM_IN " + in + "\n#PARAM_OUT " + out +
           "\n" + rows;
}

Source read(const std::string& text)
{
    const TempFolder folder;
    return openSource(folder.write("tape.dat", text));
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("tape.dat", text), part);
}

void expectPair(const std::string& dim, const std::string& in, const std::string& row,
                const Vec3d& wo, const Vec3d& wi)
{
    const Source source = read(alta(dim, in, "INV_STERADIAN", row + " 0.5\n"));
    ASSERT_EQ(source.samples.size(), 1u) << in;
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wo) - wo), kFloat) << in;
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wi) - wi), kFloat) << in;
    EXPECT_FLOAT_EQ(source.samples[0].f.y, 0.5f);
}

const std::string kTape = alta("3 1", "ISOTROPIC_TL_TV_PROJ_DPHI", "INV_STERADIAN_COSINE_FACTOR",
                               "0.5 0.3 0.4 0.25\n0.5 -0.3 0.4 nan\n0.5 1.6 0 1\n");

}  // namespace

TEST(Alta, KnowsTheDirectionsOfEachParameterisation)
{
    const auto at = [](double theta, double phi) { return directionFromAngles(theta, phi); };
    expectPair("4 1", "SPHERICAL_TL_PL_TV_PV", "0.3 0.1 0.6 2", at(0.6, 2), at(0.3, 0.1));
    expectPair("3 1", "ISOTROPIC_TV_TL_DPHI", "0.3 0.6 2", at(0.3, 0), at(0.6, 2));
    expectPair("3 1", "ISOTROPIC_TL_TV_PROJ_DPHI", "0.5 0.3 0.4", at(0.5, std::atan2(4, 3)),
               at(0.5, 0));
    expectPair("3 1", "ISOTROPIC_TL_TV_PROJ_DPHI", "0.5 0 0", at(0, 0), at(0.5, 0));
    expectPair("2 1", "ISOTROPIC_TV_PROJ_DPHI", "0 -0.7", at(0.7, -kPi / 2), at(0, 0));
    expectPair("6 1", "CARTESIAN", "0 0 2 0.6 0 0.8", at(0, 0), {0.6, 0, 0.8});
    expectPair("1 1", "COS_TH", "0.8", {0.6, 0, 0.8}, {0.6, 0, 0.8});
    // theta_h = 0 and theta_d = 0.4: the view is at 0.4 in the azimuth of phi_d.
    expectPair("3 1", "RUSIN_TH_TD_PD", "0 0.4 0.9", at(0.4, 0.9), at(0.4, 0.9 + kPi));
    expectPair("4 1", "RUSIN_TH_PH_TD_PD", "0 0 0.4 0.9", at(0.4, 0.9), at(0.4, 0.9 + kPi));
    expectPair("2 1", "RUSIN_TH_TD", "0 0.4", at(0.4, kPi / 2), at(0.4, -kPi / 2));
    expectPair("2 1", "COS_TH_TD", "1 0.8", {0.6, 0, 0.8}, {-0.6, 0, 0.8});
}

TEST(Alta, HalfVectorsAreAtTheirAngles)
{
    const Source source =
        read(alta("4 1", "RUSIN_TH_PH_TD_PD", "INV_STERADIAN", "0.3 0.7 0.5 1.1 1\n"));
    const Sample& s = source.samples.at(0);
    const HalfDifference a = halfDifferenceFromPair({Vec3d(s.wo), Vec3d(s.wi)});
    EXPECT_NEAR(a.theta_h, 0.3, kFloat);
    EXPECT_NEAR(a.phi_h, 0.7, 1e-5);
    EXPECT_NEAR(a.theta_d, 0.5, kFloat);
    EXPECT_NEAR(std::cos(a.phi_d - 1.1), -1.0, 1e-5);  // the light's d is opposite to the view's
}

TEST(Alta, TakesTheDeclaredCosineOut)
{
    const Source source = read(kTape);
    EXPECT_EQ(source.format, "alta");
    EXPECT_TRUE(source.isotropic);
    ASSERT_EQ(source.samples.size(), 1u);
    EXPECT_NEAR(source.samples[0].f.x, 0.25 / std::cos(0.5), kFloat);
    EXPECT_EQ(source.report.nonFinite, 1u);
    EXPECT_EQ(source.report.belowHorizon, 1u);
}

TEST(Alta, ReadsColoursAndSkipsConfidence)
{
    const std::string row = "0.3 0.1 0.6 2 0.95047 1 1.08883 0.1 0.1 0.1\n";
    const Source rgb = read(alta("4 3", "SPHERICAL_TL_PL_TV_PV", "RGB_COLOR", row));
    EXPECT_EQ(rgb.samples.at(0).f, Vec3f(0.95047f, 1.0f, 1.08883f));
    EXPECT_FALSE(rgb.isotropic);
    const Source xyz = read(alta("4 3", "SPHERICAL_TL_PL_TV_PV", "XYZ_COLOR", row));
    EXPECT_LT(glm::length(xyz.samples.at(0).f - Vec3f(1.0f)), 1e-4f);
}

TEST(Alta, RefusesWhatIsNotDeclared)
{
    expectRefused("#DIM 1 1\n#PARAM_OUT INV_STERADIAN\n1 2\n", "found no #PARAM_IN");
    expectRefused("#DIM 1 1\n#PARAM_IN COS_TH\n1 2\n", "found no #PARAM_OUT");
    expectRefused(alta("1 1", "ISOTROPIC_TV_TL", "INV_STERADIAN", "1 2\n"),
                  "found #PARAM_IN 'ISOTROPIC_TV_TL'");
    expectRefused(alta("1 1", "COS_TH", "ENERGY", "1 2\n"), "found #PARAM_OUT 'ENERGY'");
    expectRefused(alta("2 1", "COS_TH", "INV_STERADIAN", "1 2\n"), "found #DIM '2'");
    expectRefused(alta("1 1", "COS_TH", "RGB_COLOR", "1 2\n"), "1 for COS_TH and 3");
    expectRefused(alta("1 -3", "COS_TH", "RGB_COLOR", "1 2\n"), "found #DIM");
    expectRefused(alta("1 999999999999", "COS_TH", "RGB_COLOR", "1 2\n"), "found #DIM");
    expectRefused(alta("1 3", "COS_TH", "RGB_COLOR", "1 2 3\n"), ":6: found 3 numbers");
    expectRefused(alta("1 3", "COS_TH", "RGB_COLOR", "1 2 3 x\n"), ":6: found 'x'");
    expectRefused(alta("1 3", "COS_TH", "RGB_COLOR", "7 1 1 1\n"), "1 not finite");
}

TEST(Alta, RareParameterisationsFollowTheirDefinitions)
{
    const auto pairOf = [](const char* name, const char* dim, const std::string& row) {
        const Source source = read(alta(dim, name, "INV_STERADIAN", row + " 1\n"));
        EXPECT_EQ(source.samples.size(), 1u) << name;
        return source.samples.empty() ? DirectionPair<double>{{0, 0, 1}, {0, 0, 1}}
                                      : DirectionPair<double>{Vec3d(source.samples[0].wo),
                                                              Vec3d(source.samples[0].wi)};
    };
    const auto flat = [](const Vec3d& v) { return std::hypot(v.x, v.y); };
    constexpr double kTolerance = 1e-6;
    const auto stark = pairOf("STARK_2D", "2 1", "0.3 0.4");
    EXPECT_NEAR(flat(0.5 * (stark.wi + stark.wo)), 0.3, kTolerance);
    EXPECT_NEAR(glm::length(0.5 * (stark.wi - stark.wo)), 0.4, kTolerance);
    const auto stark3 = pairOf("STARK_3D", "3 1", "0.3 0.4 0.7");
    const Vec3d back = 0.5 * (stark3.wi - stark3.wo);
    EXPECT_NEAR(flat(0.5 * (stark3.wi + stark3.wo)), 0.3, kTolerance);
    EXPECT_NEAR(glm::length(back), 0.4, kTolerance);
    EXPECT_NEAR(std::atan2(back.y, back.x), 0.7, kTolerance);
    const auto neumann = pairOf("NEUMANN_3D", "3 1", "0.3 0.4 0.7");
    EXPECT_NEAR(flat(0.5 * (neumann.wi + neumann.wo)), 0.3, kTolerance);
    EXPECT_NEAR(flat(0.5 * (neumann.wi - neumann.wo)), 0.4, kTolerance);
    EXPECT_NEAR(flat(pairOf("NEUMANN_2D", "2 1", "0.3 0.4").wo), 0.5, kTolerance);
    EXPECT_NEAR(glm::dot(pairOf("COS_TLV", "1 1", "0.8").wo, Vec3d(0, 0, 1)), 0.8, kTolerance);
    EXPECT_NEAR(pairOf("COS_TLR", "1 1", "0.8").wo.x, -0.6, kTolerance);
    // k is the half vector of the view and the mirrored light.
    const auto k = [](const DirectionPair<double>& p) {
        return glm::normalize(p.wo + Vec3d(-p.wi.x, -p.wi.y, p.wi.z));
    };
    EXPECT_NEAR(k(pairOf("COS_TK", "1 1", "0.8")).z, 0.8, kTolerance);
    EXPECT_LT(glm::length(k(pairOf("SCHLICK_VK", "3 1", "0.6 0 0.8")) - Vec3d(0.6, 0, 0.8)),
              kTolerance);
    const auto schlick = pairOf("SCHLICK_TL_TK_PROJ_DPHI", "3 1", "0.5 -0.3 0.1");
    EXPECT_LT(
        glm::length(k(schlick) - directionFromAngles(std::hypot(0.3, 0.1), std::atan2(0.1, -0.3))),
        kTolerance);
    EXPECT_NEAR(schlick.wi.z, std::cos(0.5), kTolerance);
    const auto retro = pairOf("RETRO_TL_TVL_PROJ_DPHI", "3 1", "0.5 0.3 0");
    EXPECT_LT(glm::length(retro.wo - directionFromAngles(0.2, 0)),
              kTolerance);  // towards the normal
    EXPECT_LT(glm::length(pairOf("RETRO_TL_TVL_PROJ_DPHI", "3 1", "0.5 0.8 0").wo -
                          directionFromAngles(-0.3, 0)),
              kTolerance);
    EXPECT_NEAR(pairOf("STEREOGRAPHIC", "4 1", "0.5 0 0 0.2").wo.x, 0.8, kTolerance);
    EXPECT_NEAR(pairOf("RUSIN_VH", "3 1", "0.6 0 0.8").wi.x, 0.6, kTolerance);
    EXPECT_NEAR(
        glm::dot(pairOf("RUSIN_TH_PH_TD", "3 1", "0.3 1 0.2").wi, directionFromAngles(0.3, 1)),
        std::cos(0.2), kTolerance);
}

namespace {

/// The rows of kTape in binary.
template <class Number>
std::string binaryTape(const std::string& endian, const std::string& precision, bool reversed)
{
    std::string bytes =
        "#ALTA_BEGIN_HEADER\n#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n"
        "#PARAM_OUT INV_STERADIAN\n#VERSION 1\n#FORMAT binary\n#ENDIAN " +
        endian + "\n#PRECISION " + precision + "\n#SAMPLE_COUNT 2\n#ALTA_END_HEADER\n";
    for (const double value : {0.1, 0.2, 0.3, 0.25, 0.4, 0.5, 3.0, 0.125}) {
        std::string number;
        append(number, Number(value));
        if (reversed) std::reverse(number.begin(), number.end());
        bytes += number;
    }
    return bytes;
}

}  // namespace

TEST(Alta, ReadsBinaryOfEitherEndAndPrecision)
{
    const std::string files[] = {binaryTape<double>("little", "ieee754-double", false),
                                 binaryTape<double>("big", "ieee754-double", true),
                                 binaryTape<float>("little", "ieee754-single", false)};
    for (const std::string& bytes : files) {
        const Source source = read(bytes);
        ASSERT_EQ(source.samples.size(), 2u);
        EXPECT_LT(glm::length(Vec3d(source.samples[1].wo) - directionFromAngles(0.4, 0)), kFloat);
        EXPECT_LT(glm::length(Vec3d(source.samples[1].wi) - directionFromAngles(0.5, 3.0)), kFloat);
        EXPECT_EQ(source.samples[1].f, Vec3f(0.125f));
        EXPECT_EQ(source.format, "alta");
    }
    EXPECT_EQ(refusedPrefixes("a.alta", files[0]), files[0].size());
    expectSurvivesDamage("a.alta", files[0], 3);
}

TEST(Alta, RefusesBinaryThatDoesNotAddUp)
{
    const std::string whole = binaryTape<double>("little", "ieee754-double", false);
    const auto replaced = [&](const std::string& part, const std::string& by) {
        return std::string(whole).replace(whole.find(part), part.size(), by);
    };
    expectRefused(whole + "x", "bytes of data, expected 2 rows of at least 32 bytes");
    expectRefused(replaced("COUNT 2", "COUNT 3"), "expected 3 rows");
    expectRefused(replaced("COUNT 2", "COUNT 9223372036854775807"), "rows");
    expectRefused(replaced("COUNT 2", "COUNT 0"), "found #SAMPLE_COUNT '0'");
    expectRefused(replaced("little", "middle"), "found #ENDIAN 'middle'");
    expectRefused(replaced("ieee754-double", "decimal"), "found #PRECISION 'decimal'");
    expectRefused(replaced("#ALTA_END_HEADER\n", "#END\n"), "found no line #ALTA_END_HEADER");
}

TEST(Alta, EveryPrefixIsSoundOrRefused)
{
    EXPECT_GT(refusedPrefixes("a.dat", kTape), kTape.size() / 2);
    expectSurvivesDamage("a.dat", kTape, 2);
}

TEST(Alta, RealFilesAgreeWithTheReferenceReader)
{
    FBRDF_NEEDS_DATA("cea_retro/retro-3M-jaune.dat");
    const RealFile tape = {"cea_retro/retro-3M-jaune.dat",
                           7397,
                           7311,
                           {{-0.874487162f, 0.00303058513f, 0.485039234f},
                            {0.866025388f, 0, 0.5f},
                            Vec3f(38.9729309f)}};
    const Source source = openSource(dataPath(tape.path));
    expectRealFile(source, tape);
    EXPECT_EQ(source.report.belowHorizon, 86u);
    const Source felt = openSource(dataPath("cea_retro/pink-felt-1d.alta"));
    EXPECT_EQ(felt.samples.size(), 90u);
    EXPECT_FLOAT_EQ(felt.samples[0].f.x, 0.10970442f);
}
