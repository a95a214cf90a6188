// Tables of ASAM OpenMATERIAL 3D.
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/brdf/HalfDifference.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

std::string xompt(const std::string& rows)
{
    return "{\"$schema\": \"https://x/OpenMATERIAL-3D/material_brdf_schema.json\",\n"
           " \"metadata\": {\"name\": \"own\", \"authors\": [\"a\", \"b\"]},\n"
           " \"brdf\": {\"wavelengths\": [4.5e-7, 5.5e-7], \"lookupTable\": [" +
           rows + "]}}\n";
}

const std::string kTwoBands =
    "[4.5e-7, 0.5, 0.25, 3.1415927, 0.1], [4.5e-7, 0.5, 0.75, 0, 0.3],\n"
    "[5.5e-7, 0.5, 0.25, 3.1415927, 0.1], [5.5e-7, 0.5, 0.75, 0, null], [5.5e-7, 1, 0, 0, 5]";

Source read(const std::string& text, const std::string& choice = "")
{
    const TempFolder folder;
    return openSource(folder.write("a.xompt", text) + choice);
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("a.xompt", text), part);
}

}  // namespace

TEST(Xompt, RowsOfOnePairAreBandsOfOneSample)
{
    const Source source = read(xompt(kTwoBands));
    EXPECT_EQ(source.format, "xompt");
    EXPECT_TRUE(source.isotropic);
    ASSERT_EQ(source.samples.size(), 1u);
    EXPECT_EQ(source.report.given, 3u);
    EXPECT_EQ(source.report.nonFinite, 2u);  // a null, and a pair with one band of two
    EXPECT_LT(glm::length(source.samples[0].f - Vec3f(0.1f)), 1e-6f);
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wi) - directionFromAngles(0.5, 0)), 1e-6);
    EXPECT_LT(glm::length(Vec3d(source.samples[0].wo) - directionFromAngles(0.25, kPi)), 1e-6);
}

TEST(Xompt, AWavelengthIsAChoice)
{
    for (const char* choice : {"@450", "@0.45", "@4.5e-7"}) {
        const Source source = read(xompt(kTwoBands), choice);
        ASSERT_EQ(source.samples.size(), 2u);
        EXPECT_FLOAT_EQ(source.samples[1].f.x, 0.3f);
    }
    EXPECT_EQ(read(xompt("[9.05e-7, 0.5, 0.25, 0, 0.1]")).samples.size(), 1u);
    expectRefused(xompt("[9.05e-7, 0.5, 0.25, 0, 0.1], [8e-7, 0.5, 0.25, 0, 0.1]"),
                  "no visible wavelength among 800, 905 nm");
}

TEST(Xompt, RefusesWhatDoesNotAddUp)
{
    expectRefused(xompt(""), "found no row");
    expectRefused(xompt("[4.5e-7, 1, 2, 3]"), "found a row of 4 numbers");
    expectRefused(xompt("[4.5e-7, 1, 2, 3, 4, 5]"), "found a row of 6 numbers");
    expectRefused(xompt("[null, 1, 2, 3, 4]"), "without its wavelength");
    expectRefused(xompt("[4.5e-7, 1, 1, 3, 4]").substr(0, 200), "found no JSON");
    expectRefused(xompt(std::string(100000, '[')), "more than 64 levels");
    expectRefused(xompt("{\"lookupTable\": [[1, 2]]}, []"), "found");
    const std::string whole = xompt(kTwoBands);
    EXPECT_GE(refusedPrefixes("a.xompt", whole), whole.size() - 1);
    expectSurvivesDamage("a.xompt", whole, 3);
}

TEST(Xompt, TheExamplesOfTheStandardAreRead)
{
    FBRDF_NEEDS_DATA("openmaterial/example_material_camera_brdf.xompt");
    const Source camera = openSource(dataPath("openmaterial/example_material_camera_brdf.xompt"));
    EXPECT_EQ(camera.report.given, 59u);  // 1888 rows of 32 bands
    expectSound(camera);
    const Source lidar = openSource(dataPath("openmaterial/example_material_lidar_brdf.xompt"));
    EXPECT_EQ(lidar.report.given, 905u);
    expectSound(lidar);
}
