// PabTest.cpp - measurements of pab's gonio-photometer: one file, several in one, and folders.
#include "ReaderTest.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr float kFloat = 1e-6f;

// As the manual page of pabopto2bsdf has it.
const std::string kMinimal =
    "#incident_angle 82.5 180\n#format: theta phi DSF\n"
    "60 125.5 0.01\n30 10 0.02\n";
const std::string kWhole =
    "#Mountain 5.1\n# a remark: with a colon\n#sample_name \"saw tooth\"\n#format: theta phi BRDF\n"
    "#intheta 30\n#inphi 10\n#upphi 90\n#colorimetry: CIE-Y\n#datapoints_in_file: 2\n"
    "40 20 0.5\n95 20 0.25\n";
const std::string kXyz =
    "#incident_angle\t30\t0\r\n#colorimetry: CIE-XYZ\r\n#format: theta\tphi\tBSDF\r\n"
    "10\t0\t0.3\t0.3\t0.3\r\n20\t0\t0.2\t0.2\t0.2\r\n";

std::string block(double theta, double phi, double value)
{
    return "#incident_angle " + numberText(theta) + " " + numberText(phi) +
           "\n#format: theta phi BRDF\n20 " + numberText(phi + 180.0) + " " + numberText(value) +
           "\n";
}

Source read(const std::string& text, const std::string& choice = "")
{
    const TempFolder folder;
    return openSource(folder.write("a.bme", text) + choice);
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("a.bme", text), part);
}

Vec3d towards(double theta, double phi)
{
    return directionFromAngles(theta * kPi / 180.0, phi * kPi / 180.0);
}

void expectNear(const Vec3f& a, const Vec3d& b)
{
    EXPECT_LT(glm::length(Vec3d(a) - b), double(kFloat)) << a.x << ' ' << a.y << ' ' << a.z;
}

bool assumes(const Source& source, const std::string& part)
{
    for (const std::string& assumption : source.assumptions)
        if (assumption.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST(Pab, DividesTheCosineOutOfDsfAndTurnsUpTowardsY)
{
    const Source source = read(kMinimal);
    EXPECT_EQ(source.format, "pab");
    EXPECT_EQ(source.name, "a");
    ASSERT_EQ(source.samples.size(), 2u);
    expectNear(source.samples[0].wi, towards(82.5, 270.0));
    expectNear(source.samples[0].wo, towards(60.0, 215.5));
    EXPECT_NEAR(source.samples[0].f.x, 0.01 / std::cos(kPi / 3.0), 1e-8);
    EXPECT_TRUE(source.isotropic);
    EXPECT_TRUE(assumes(source, "one azimuth"));
    EXPECT_TRUE(assumes(source, "one channel as grey"));
}

TEST(Pab, KeepsBrdfValuesAndSaysWhatItLeavesOut)
{
    const Source source = read(kWhole);
    EXPECT_EQ(source.name, "saw tooth");
    ASSERT_EQ(source.samples.size(), 1u);
    expectNear(source.samples[0].wi, towards(30.0, 10.0));
    expectNear(source.samples[0].wo, towards(40.0, 20.0));
    EXPECT_FLOAT_EQ(source.samples[0].f.y, 0.5f);
    EXPECT_EQ(source.report.belowHorizon, 1u);
    EXPECT_TRUE(assumes(source, "the reflection of the front; 1 row of transmission"));
}

TEST(Pab, ReadsXyzUnderEitherWhite)
{
    const Source source = read(kXyz);
    ASSERT_EQ(source.samples.size(), 2u);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(source.samples[0].f[c], 0.3, 1e-4) << c;
    EXPECT_TRUE(assumes(source, "equal energy"));
    const Source underD65 = read(kXyz, "@d65");
    EXPECT_GT(underD65.samples[0].f.x, underD65.samples[0].f.z);
}

TEST(Pab, TheBackIsSeenFromTheBack)
{
    // Light from the back, 30 degrees off its normal, up and to the right as seen from the front.
    const std::string text =
        "#incident_angle 150 -45\n#format: theta phi BRDF\n160 90 0.5\n20 0 0.25\n" +
        block(10.0, 0.0, 0.125);
    const Source back = read(text, "@back"), front = read(text);
    ASSERT_EQ(back.samples.size(), 1u);
    expectNear(back.samples[0].wi, towards(30.0, 135.0));
    expectNear(back.samples[0].wo, towards(20.0, 0.0));
    EXPECT_FLOAT_EQ(back.samples[0].f.x, 0.5f);
    ASSERT_EQ(front.samples.size(), 1u);
    EXPECT_FLOAT_EQ(front.samples[0].f.x, 0.125f);
    const Source alone = read("#incident_angle 150 0\n#format: theta phi BRDF\n160 90 0.5\n");
    EXPECT_EQ(alone.samples.size(), 1u) << "the only side there is";
}

TEST(Pab, MirrorsWhatTheAzimuthsOfTheLightLeaveOut)
{
    const Source quarter = read(block(30, 0, 1) + block(30, 45, 1) + block(30, 90, 1));
    EXPECT_EQ(quarter.samples.size(), 12u);
    EXPECT_TRUE(assumes(quarter, "a quarter of a turn"));
    expectSound(quarter);
    const Source half = read(block(30, 45, 1) + block(30, 135, 1));
    EXPECT_EQ(half.samples.size(), 4u);
    EXPECT_TRUE(assumes(half, "half of a turn"));
    expectNear(half.samples[2].wi, towards(30.0, 45.0));  // the first, at 45 + 90 degrees
    const Source whole = read(block(30, 45, 1) + block(30, 135, 1) + block(30, -45, 1) +
                              block(30, 225, 1) + block(0, 0, 1));
    EXPECT_EQ(whole.samples.size(), 5u);
    const Source plane = read(block(30, 0, 1) + block(50, 0, 1) + block(0, 77, 1));
    EXPECT_EQ(plane.samples.size(), 3u);
    EXPECT_TRUE(plane.isotropic);
}

TEST(Pab, AFolderOfFilesIsOneMeasurement)
{
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("steel"));
    folder.write("steel/01.txt", block(10, 0, 0.5));
    folder.write("steel/02.txt", block(40, 0, 0.25));
    folder.write("steel/readme.txt", "# about\nwords\n");
    folder.write("steel/picture.jpg", std::string("\xFF\xD8\xFF", 3));
    const Source source = openSource(folder.path("steel"));
    EXPECT_EQ(source.name, "steel");
    EXPECT_EQ(source.format, "pab");
    ASSERT_EQ(source.samples.size(), 2u);
    EXPECT_FLOAT_EQ(source.samples[1].f.x, 0.25f);
    EXPECT_NE(source.description.find("2 files"), std::string::npos);
    EXPECT_EQ(openSource(folder.path("steel") + "/").name, "steel");
    folder.write("steel/03.txt", kMinimal + "1 2\n");
    expectInputError(folder.path("steel"), "03.txt:5: found 2 numbers");
}

TEST(Pab, AFolderWithoutSuchFilesIsNone)
{
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("empty"));
    expectInputError(folder.path("empty"), "found a directory, expected a file");
}

TEST(Pab, RefusesWhatItCannotTell)
{
    expectRefused("#incident_angle 10 0\n#format: theta phi lux\n1 2 3\n",
                  ":2: found another #format");
    expectRefused("#intheta 10\n#format: theta phi BRDF\n1 2 3\n",
                  ":3: found a row without the dire");
    expectRefused("#intheta ten\n#format: theta phi BRDF\n", ":1: found 'ten', expected a number");
    expectRefused("#intheta\n#format: theta phi BRDF\n", ":1: found nothing");
    expectRefused(kMinimal + "1 2 3 4\n", ":5: found 4 numbers, expected theta, phi, value");
    expectRefused(kMinimal + "1 2 three\n", ":5: found 'three'");
    expectRefused(kMinimal + "#incident_angle 10 0\n1 2 3\n", ":6: found a row without #format");
    expectRefused(kXyz + kMinimal, "one colorimetry");
    expectRefused("#incident_angle 10 0\n#format: theta phi BRDF\n#colorimetry: RGB\n",
                  ":3: found the colorimetry 'RGB'");
    expectRefused("#incident_angle 10 0\n#format: theta phi BRDF\n", "no usable sample");
    const TempFolder folder;
    try {
        openSource(folder.write("a.bme", kMinimal) + "@left");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
}

TEST(Pab, EveryPrefixAndDamageIsSoundOrRefused)
{
    for (const std::string& text : {kMinimal, kWhole, kXyz}) {
        EXPECT_GT(refusedPrefixes("a.bme", text), text.size() / 4);
        expectSurvivesDamage("a.bme", text, 2);
    }
}
