#include "ReaderTest.h"

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr float kFloat = 1e-6f;  // a few units in the last place of a unit vector's component

Source read(const std::string& text, bool cosine = false)
{
    const TempFolder folder;
    return openSource(folder.write("samples.csv", text), {cosine});
}

void expectNear(const Vec3f& a, const Vec3f& b, float tolerance = kFloat)
{
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("samples.csv", text), part);
}

const char* const kDirections = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b\n";

}  // namespace

TEST(Csv, ReadsDirectionsAndColours)
{
    const Source source = read(std::string("# a comment\n\n") + kDirections +
                               "0,0,1,0.6,0,0.8,0.1,0.2,0.3\n# another\n0,3,4,0,0,2,1e-3,+2,3\r\n");
    ASSERT_EQ(source.samples.size(), 2u);
    expectNear(source.samples[0].wi, {0.6f, 0.0f, 0.8f});
    expectNear(source.samples[0].f, {0.1f, 0.2f, 0.3f});
    expectNear(source.samples[1].wo, {0.0f, 0.6f, 0.8f});  // normalised
    expectNear(source.samples[1].wi, {0.0f, 0.0f, 1.0f});
    EXPECT_EQ(source.samples[1].weight, 1.0f);
    EXPECT_EQ(source.format, "csv");
    EXPECT_EQ(source.name, "samples");
    EXPECT_FALSE(source.isotropic);
}

TEST(Csv, ReadsAnglesInDegreesOneValueAndWeights)
{
    const Source source = read("theta_i,phi_i,theta_o,phi_o,value,weight\n30,90,60,180,0.5,2\n");
    ASSERT_EQ(source.samples.size(), 1u);
    expectNear(source.samples[0].wi, {0.0f, 0.5f, std::sqrt(0.75f)});
    expectNear(source.samples[0].wo, {-std::sqrt(0.75f), 0.0f, 0.5f});
    expectNear(source.samples[0].f, Vec3f(0.5f));
    EXPECT_EQ(source.samples[0].weight, 2.0f);
}

TEST(Csv, ColumnsMayComeInAnyOrderAndCaseWithOthersBetween)
{
    const Source source = read(
        "\xEF\xBB\xBF R , note,g,b,theta_o,phi_o,THETA_I,phi_i\n"
        "1,anything at all,2,3,0,0,45,0\n");
    ASSERT_EQ(source.samples.size(), 1u);
    expectNear(source.samples[0].f, {1.0f, 2.0f, 3.0f});
    expectNear(source.samples[0].wi, {std::sqrt(0.5f), 0.0f, std::sqrt(0.5f)});
}

TEST(Csv, DividesTheCosineOut)
{
    const std::string text = "theta_i,phi_i,theta_o,phi_o,value\n0,0,60,0,0.5\n";
    expectNear(read(text).samples[0].f, Vec3f(0.5f));
    expectNear(read(text, true).samples[0].f, Vec3f(1.0f));
    const std::string long_wo = std::string(kDirections) + "0,3,4,0,0,1,8,8,8\n";
    expectNear(read(long_wo, true).samples[0].f, Vec3f(10.0f), 1e-5f);
}

TEST(Csv, CountsWhatCannotBeUsed)
{
    const Source source = read(std::string(kDirections) +
                               "0,0,1,0,0,1,1,1,1\n"
                               "0,0,1,0,0,1,nan,1,1\n"
                               "0,0,1,0,0,1,1,inf,1\n"
                               "0,0,1,0,0,1,1,1e999,1\n"
                               "0,0,1,0,0,1,1,1e200,1\n"
                               "0,0,0,0,0,1,1,1,1\n"
                               "0,0,-1,0,0,1,1,1,1\n"
                               "0,0,1,1,0,0,1,1,1\n"
                               "0,0,1,0,0,1,-1,1,1\n"
                               "0,0,1,0,0,1,0,1,1\n");
    EXPECT_EQ(source.report.given, 10u);
    EXPECT_EQ(source.report.nonFinite, 5u);
    EXPECT_EQ(source.report.belowHorizon, 2u);
    EXPECT_EQ(source.report.negative, 1u);
    EXPECT_EQ(source.report.zero, 1u);
    EXPECT_EQ(source.samples.size(), 3u);
    expectSound(source);
}

TEST(Csv, NinetyDegreesIsTheHorizon)
{
    const Source source = read(
        "theta_i,phi_i,theta_o,phi_o,value\n"
        "90,0,0,0,1\n-90,0,0,0,1\n0,0,89.99,0,1\n");
    EXPECT_EQ(source.report.belowHorizon, 2u);
    EXPECT_EQ(source.samples.size(), 1u);
}

TEST(Csv, NegativeWeightsAreNotUsed)
{
    const Source source = read(
        "theta_i,phi_i,theta_o,phi_o,value,weight\n"
        "0,0,0,0,1,-1\n0,0,0,0,1,nan\n0,0,0,0,1,0\n");
    EXPECT_EQ(source.report.nonFinite, 2u);
    EXPECT_EQ(source.samples.size(), 1u);
}

TEST(Csv, AllZeroStillReads)
{
    const Source source = read("theta_i,phi_i,theta_o,phi_o,value\n0,0,0,0,0\n10,0,0,0,0\n");
    EXPECT_EQ(source.report.zero, 2u);
    EXPECT_EQ(source.samples.size(), 2u);
}

TEST(Csv, NothingUsableIsAnError)
{
    const std::string header = "theta_i,phi_i,theta_o,phi_o,value\n";
    expectRefused(header, "no usable sample (0 rows)");
    expectRefused(header + "0,0,0,0,nan\nnan,0,0,0,1\n", "2 rows, 2 not finite");
    expectRefused(header + "95,0,0,0,1\n", "1 rows, 1 below the horizon");
}

TEST(Csv, ErrorsNameTheLine)
{
    const std::string row = "0,0,1,0,0,1,1,1,1\n";
    expectRefused(kDirections + row + "0,0,1,0,0,1,1,abc,1\n", ":3: found 'abc' as g");
    expectRefused(kDirections + row + "\n#\n0,0,1,0,0,1,1,1\n", ":5: found 8 fields");
    expectRefused(kDirections + row + "0,0,1,0,0,1,1,1,1,1\n", ":3: found 10 fields");
    expectRefused(kDirections + std::string("0,0,1,0,0,1,1,0x10,1\n"), "found '0x10'");
    expectRefused("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g\n", ":1: found the header");
    expectRefused("wo_x,wo_y,wo_z,wi_x,wi_y,r,g,b\n1,2,3,4,5,6,7,8\n", "expected columns wo_x");
    expectRefused("theta_i,theta_i,phi_i,theta_o,phi_o,value\n", "'theta_i' twice");
}

TEST(Csv, ReadsWhatSpreadsheetsWrite)
{
    const char* const texts[] = {
        "theta_i;phi_i;theta_o;phi_o;value\n30;90;60;180;0,5\n",
        "theta_i\tphi_i\ttheta_o\tphi_o\tvalue\n30\t90\t60\t180\t0.5\n",
        "theta_i phi_i theta_o phi_o value\n30 90 60 180 0,5\n",
        "\"theta_i\",\"phi_i\",\"theta_o\",\"phi_o\",\"value\"\n\"30\",\"90\",\"60\",\"180\",\"0,"
        "5\"\n",
        "sep=;\r\n\"theta_i\";\"phi_i\";\"theta_o\";\"phi_o\";\"value\"\r\n30;90;60;180;0.5\r\n",
        "\"theta_i\" \"phi_i\" \"theta_o\" \"phi_o\" \"value\"\n\"1\" 30 90 60 180 0.5\n",
        "\"\",theta_i,phi_i,theta_o,phi_o,value,note\r0,30,90,60,180,0.5,\"a, b\"\r",
        "theta_i,phi_i,theta_o,phi_o,value,\n30,90,60,180,0.5,\n",
        "theta_i,phi_i,theta_o,phi_o,value\n30,90,60,180,0.5,,\n",
        "theta_i [deg],phi_i (rad),theta_o_deg,phi_o,value "
        "[1/sr]\n30,1.5707963267948966,60,180,0.5\n",
        "theta_i,phi_i,theta_o,phi_o,value,\"two\nlines\"\n30,90,60,180,0.5,\"x\ny\"\n",
    };
    for (const char* text : texts) {
        const Source source = read(text);
        ASSERT_EQ(source.samples.size(), 1u) << text;
        expectNear(source.samples[0].wi, {0.0f, 0.5f, std::sqrt(0.75f)});
        expectNear(source.samples[0].wo, {-std::sqrt(0.75f), 0.0f, 0.5f});
        expectNear(source.samples[0].f, Vec3f(0.5f));
        EXPECT_EQ(source.format, "csv");
    }
}

TEST(Csv, ReadsUtf16WithEitherByteOrder)
{
    const std::string text = "theta_i,phi_i,theta_o,phi_o,value\r\n30,90,60,180,0.5\r\n";
    for (const bool little : {true, false}) {
        std::string bytes = little ? "\xFF\xFE" : "\xFE\xFF";
        for (const char c : text) bytes += little ? std::string({c, '\0'}) : std::string({'\0', c});
        EXPECT_EQ(read(bytes).samples.size(), 1u);
        EXPECT_GT(refusedPrefixes("s.csv", bytes), 40u);
    }
}

TEST(Csv, MissingValuesAreCountedAsNotFinite)
{
    const Source source = read(
        "theta_i,phi_i,theta_o,phi_o,value\n30,0,30,180,0.3\n30,0,45,180,\n30,0,45,180,NA\n"
        "30,,45,180,1\n30,0,45,180,#N/A\n");
    EXPECT_EQ(source.report.given, 5u);
    EXPECT_EQ(source.report.nonFinite, 4u);
    EXPECT_EQ(source.samples.size(), 1u);
}

TEST(Csv, UnitsThatAreNoneOfAnglesAreRefused)
{
    expectRefused("theta_i [mm],phi_i,theta_o,phi_o,value\n1,2,3,4,5\n", "found the unit 'mm'");
}

TEST(Csv, EveryPrefixIsSoundOrRefused)
{
    const std::string text = std::string("# c\n") + kDirections +
                             "0,0,1,0.6,0,0.8,0.125,0.2,0.3\n0,0,1,-0.6,0,0.8,1e-2,nan,3\n";
    EXPECT_GT(refusedPrefixes("s.csv", text), 40u);
    expectSurvivesDamage("s.csv", text);
}

TEST(Csv, ManyRowsKeepTheirOrderInBlocks)
{
    std::string text = "theta_i,phi_i,theta_o,phi_o,value\n";
    constexpr size_t kRows = 100000;
    for (size_t i = 0; i < kRows; ++i) text += "10,0,20,0," + std::to_string(i) + "\n";
    const Source source = read(text);
    size_t next = 0;
    forEachBlock(source, [&](const Sample* block, size_t count) {
        EXPECT_LE(count, kSampleBlock);
        for (size_t i = 0; i < count; ++i) EXPECT_EQ(block[i].f.x, float(next++));
    });
    EXPECT_EQ(next, kRows);
}
