// Text tables of measurement groups: NIST, RT-300S, FRED and lumos.
#include "ReaderTest.h"
#include "support/DataDir.h"

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

// kFloat: unit vectors and values are stored as float.
constexpr float kFloat = 1e-6f;

Source read(const std::string& text, const std::string& name = "a.txt")
{
    const TempFolder folder;
    return openSource(folder.write(name, text));
}

void expectRefused(const std::string& text, const std::string& part,
                   const std::string& name = "a.txt")
{
    const TempFolder folder;
    expectInputError(folder.write(name, text), part);
}

void expectNear(const Vec3f& a, const Vec3d& b)
{
    EXPECT_LT(glm::length(Vec3d(a) - b), double(kFloat)) << a.x << ' ' << a.y << ' ' << a.z;
}

Vec3d towards(double theta, double phi)
{
    return {std::sin(theta * kDegree) * std::cos(phi * kDegree),
            std::sin(theta * kDegree) * std::sin(phi * kDegree), std::cos(theta * kDegree)};
}

const std::string kNist =
    "lambda,thetai,phi,thetar,phir,f_r11,f_r12/f_r11\n"
    "0.351,-30,0,20,90,2.5E-01,0.1\n0.532,-30,0,20,90,0.3,nan\n0.532,-30,0,95,90,0.3,0\n";

const std::string kRt300s =
    "# a machine\nstage_deg,theta_i_deg,A_deg,R_deg,rt_minus_blank,brdf\n"
    "0,30,-90,40,0.1,0.5\n90,30,-90,40,0.1,-0.25\n0,30,-90,-30,0.1,0.0001\n0,30,0,0,0.1,nan\n";

const std::string kFred =
    "type bsdf_data\nformat angles=deg bsdf=value scale=2\n"
    "30\t0\n0\t0\t0.5\n40\t90\t0.25\n60 10\n100 0 1\n40 0 nan\n";

const std::string kLumos =
    "# words\n# phi_i     theta_i     phi_o     theta_o     brdf\n"
    "30.0  180.0  -40.0 0.0  1.5e-01\n30 180 90 0 1\n30 180 10 0 inf\n";

}  // namespace

TEST(Nist, ReadsRowsOfAllWavelengthsOrOne)
{
    const TempFolder folder;
    const std::string path = folder.write("ptfe.csv", kNist);
    const Source all = openSource(path);
    EXPECT_EQ(all.format, "nist");
    ASSERT_EQ(all.samples.size(), 2u);
    EXPECT_EQ(all.report.belowHorizon, 1u);
    expectNear(all.samples[0].wi, towards(30, 180));  // a negative zenith angle
    expectNear(all.samples[0].wo, towards(20, 90));
    EXPECT_FLOAT_EQ(all.samples[0].f.y, 0.25f);
    const Source green = openSource(path + "@0.532");
    ASSERT_EQ(green.samples.size(), 1u);
    EXPECT_EQ(openSource(path + "@532").samples.size(), 1u);
    EXPECT_FLOAT_EQ(green.samples[0].f.y, 0.3f);
    EXPECT_EQ(green.report.given, 2u);
}

TEST(Nist, WavelengthsThatAreNotThereAreUsageErrors)
{
    const TempFolder folder;
    const std::string path = folder.write("ptfe.csv", kNist);
    for (const char* choice : {"@0.6", "@600", "@green", "@-1", "@nan"})
        EXPECT_EQ(outcomeOf(path + choice).kind, int(ErrorKind::usage)) << choice;
    EXPECT_NE(outcomeOf(path + "@0.6").message.find("0.351, 0.532"), std::string::npos);
}

TEST(Nist, RefusesRaggedRows)
{
    expectRefused(kNist + "0.532,1,2\n", ":5: found 3 fields between commas, expected 7");
    expectRefused(kNist + "0.532,x,0,20,90,0.3,0\n", ":5: found 'x' as thetai");
}

TEST(Rt300s, TurnsTheMachinesAnglesIntoTheSamplesFrame)
{
    const Source source = read(kRt300s);
    EXPECT_EQ(source.format, "rt300s");
    ASSERT_EQ(source.samples.size(), 2u);
    expectNear(source.samples[0].wi, towards(30, 180));
    expectNear(source.samples[0].wo, towards(40, 0));   // A = -90: in the plane, past the normal
    expectNear(source.samples[1].wi, towards(30, 90));  // the stage turned by +90
    expectNear(source.samples[1].wo, towards(40, -90));
    EXPECT_EQ(source.report.negative, 1u);
    EXPECT_EQ(source.report.invalid, 1u);  // the detector in the beam
    EXPECT_EQ(source.report.nonFinite, 1u);
}

TEST(Rt300s, RefusesRaggedRows)
{
    expectRefused(kRt300s + "0,30,-90\n", ":7: found 3 fields");
    expectRefused(kRt300s + "0,30,-90,40,0.1,bright\n", "found 'bright' as brdf");
}

TEST(Fred, IncidentAzimuthIsThatOfPropagation)
{
    const Source source = read(kFred);
    EXPECT_EQ(source.format, "fred");
    ASSERT_EQ(source.samples.size(), 2u);
    expectNear(source.samples[1].wi, towards(30, 180));
    expectNear(source.samples[1].wo, towards(40, 90));
    EXPECT_FLOAT_EQ(source.samples[1].f.x, 0.5f);  // scale=2
    EXPECT_EQ(source.report.belowHorizon, 1u);
    EXPECT_EQ(source.report.nonFinite, 1u);
}

TEST(Fred, RefusesWhatItDoesNotKnow)
{
    expectRefused("type bsdf_data\nformat angles=rad\n", ":2: found 'angles=rad'");
    expectRefused("type bsdf_data\n0 0 1\n", ":2: found a scattered direction");
    expectRefused("type bsdf_data\n1 2 3 4\n", ":2: found 4 numbers");
    expectRefused("type bsdf_data\n30 zero\n", "found 'zero'");
    expectRefused("type bsdf_data\n30 0\n", "no usable sample");
}

TEST(Lumos, PhiIsTheZenithAngle)
{
    const Source source = read(kLumos, "chassis.csv");
    EXPECT_EQ(source.format, "lumos");
    ASSERT_EQ(source.samples.size(), 1u);
    expectNear(source.samples[0].wi, towards(30, 180));
    expectNear(source.samples[0].wo, towards(40, 180));
    EXPECT_EQ(source.report.belowHorizon, 1u);
    EXPECT_EQ(source.report.nonFinite, 1u);
}

TEST(Lumos, RefusesRaggedRows)
{
    expectRefused(kLumos + "1 2 3 4\n", ":6: found 4 numbers, expected 5");
    expectRefused(kLumos + "1 2 3 4 five\n", ":6: found 'five'");
}

TEST(MeasurementText, EveryPrefixAndDamageIsSoundOrRefused)
{
    for (const std::string& text : {kNist, kRt300s, kFred, kLumos}) {
        EXPECT_GT(refusedPrefixes("a.txt", text), text.size() / 4);
        expectSurvivesDamage("a.txt", text, 2);
    }
}

TEST(MeasurementText, RealFilesAgreeWithTheReferenceReader)
{
    const RealFile files[] = {
        {"nist_ptfe/PTFE.data.csv",
         7296,
         7296,
         {{0.899999976f, -0.400000215f, 0.1732047f},
          {-0.965925813f, 0.0f, 0.258819044f},
          Vec3f(0.714f)}},
        {"ua_rt300s/csv/imx455_aniso.csv",
         12540,
         12290,
         {{0.92541659f, 0.16317591f, 0.34202015f},
          {-0.93969262f, 0, 0.34202015f},
          Vec3f(29.0389f)}},
        {"ua_rt300s/csv/nite_steel_3rot.csv",
         7524,
         7374,
         {{0.98480773f, 0, 0.173648179f}, {-0.93969262f, 0, 0.34202015f}, Vec3f(3.11853f)}},
        {"ua_rt300s/fred/AnoBlackEC1onAlum_fullAz.txt",
         2175,
         2175,
         {{0.98480773f, 0, 0.173648179f}, {-0.93969262f, 0, 0.34202015f}, Vec3f(1.823496f)}},
        {"starlink_lab/chassis_brdf.csv",
         724,
         716,
         {{0.965925813f, 0, 0.258819044f}, {-0.965925813f, 0, 0.258819044f}, Vec3f(8038.03f)}},
        {"cars_airborne/vegetation_brdf_cars.csv",
         14500,
         14434,
         {{0.856873572f, 0.514861584f, 0.0261769481f},
          {-0.954656959f, 0, 0.297708124f},
          Vec3f(1.70275f)}},
    };
    for (const RealFile& file : files) {
        FBRDF_NEEDS_DATA(file.path);
        expectRealFile(openSource(dataPath(file.path)), file);
    }
    EXPECT_EQ(openSource(dataPath("nist_ptfe/PTFE.data.csv") + "@0.532").samples.size(), 1824u);
}
