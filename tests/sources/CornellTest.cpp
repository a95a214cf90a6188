// Reference figures of the real files: the data's own parse.py (numpy), per file.
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <algorithm>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

const char* const kSmall =
    "# title\n# num wls\n4\n# wls\n450 520\n550 650\n"
    "0.5 0.0 0.25 3.14159265 0.1 0.1 0.1 0.1\n"
    "0.5 0.0 1.0 0.0 0.0 0.5 0.0 0.0 # a comment\n"
    "0.5 0.0 1.7 0.0 0.0 0.5 0.0 0.0\n"
    "0.5 0.0 0.1 0.0\n nan 0.5 0.0 0.0\n";

Source read(const std::string& text, const std::string& name = "paint.brdf")
{
    const TempFolder folder;
    return openSource(folder.write(name, text));
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("paint.brdf", text), part);
}

}  // namespace

TEST(Cornell, ReadsAnglesSpectraAndCounts)
{
    const Source source = read(kSmall);
    EXPECT_EQ(source.format, "cornell");
    EXPECT_TRUE(source.isotropic);
    ASSERT_EQ(source.samples.size(), 2u);
    EXPECT_EQ(source.report.belowHorizon, 1u);
    EXPECT_EQ(source.report.nonFinite, 1u);
    const Sample& grey = source.samples[0];
    EXPECT_NEAR(grey.wi.x, std::sin(0.5), 1e-6);
    EXPECT_NEAR(grey.wo.x, -std::sin(0.25), 1e-6);  // phi_o = pi: the mirror's side
    EXPECT_EQ(grey.f, Vec3f(0.1f));
}

TEST(Cornell, ASpectralLineIsOutOfGamut)
{
    const Source source = read(kSmall);
    EXPECT_EQ(source.report.outOfGamut, 1u);
    EXPECT_EQ(source.report.negative, 1u);
    EXPECT_GT(source.samples[1].f.y, 0.0f);
}

TEST(Cornell, IsRecognisedWithoutItsExtension)
{
    EXPECT_EQ(read(kSmall, "paint.txt").format, "cornell");
}

TEST(Cornell, UnitsOfWavelengthsAndAnglesGoByTheirSize)
{
    const std::string rows = "0.5 0 0.5 3.14159 .1 .5 .9\n0.5 0 1.0 3.0 .1 .5 .9\n";
    const Source nm = read("3\n400 550 700\n" + rows);
    for (const char* text : {"3\n0.4 0.55 0.7\n", "3\n0,4 0,55 0,7\n", "3\n4e-7 5.5e-7 7e-7\n"}) {
        const Source other = read(text + rows, "paint.txt");
        ASSERT_EQ(other.samples.size(), nm.samples.size()) << text;
        EXPECT_LT(glm::length(other.samples[0].f - nm.samples[0].f), 1e-6f) << text;
        EXPECT_NE(other.assumptions.at(0).find("by their size"), std::string::npos);
    }
    const Source degrees = read("1\n550\n30 0 60 180 0.5\n");
    EXPECT_NEAR(degrees.samples.at(0).wi.x, 0.5f, 1e-6f);
}

TEST(Cornell, WavelengthsComeInAnyOrderAndOneIsAChoice)
{
    const std::string row = "0.5 0 0.5 3.14159 ";
    const Source up = read("3\n400 550 700\n" + row + ".1 .5 .9\n");
    const Source down = read("3\n700 550 400\n" + row + ".9 .5 .1\n");
    EXPECT_LT(glm::length(up.samples.at(0).f - down.samples.at(0).f), 1e-6f);
    const TempFolder folder;
    const std::string path = folder.write("a.brdf", "2\n900 1000\n" + row + ".1 .5\n");
    EXPECT_EQ(openSource(path + "@1000").samples.at(0).f, Vec3f(0.5f));
    EXPECT_EQ(openSource(path + "@0.9").samples.at(0).f, Vec3f(0.1f));
}

TEST(Cornell, RefusesWhatIsNotWhole)
{
    expectRefused("3\n450 550\n", "found 2 wavelengths, expected 3");
    expectRefused("3\n450 550 650\n0.5 0 0.2 3.1 1 1\n", ":3: found a last record of 6 numbers");
    expectRefused("3\n450 550 650\n0.5 0 0.2 3.1 1 1 x\n", ":3: found 'x'");
    expectRefused("3\n450 650 650\n0.5 0 0.2 3.1 1 1 1\n", "wavelength twice");
    expectRefused("3\n0.45 550 650\n0.5 0 0.2 3.1 1 1 1\n", "wavelengths from 0.45 to 650");
    expectRefused("2\n900 1000\n0.5 0 0.2 3.1 1 1\n", "no visible wavelength among 900, 1000 nm");
    expectRefused("0\n", "number of wavelengths");
    expectRefused("-3\n450 550 650\n", "number of wavelengths");
    expectRefused("999999999999\n450 550 650\n", "number of wavelengths");
    expectRefused("3\n450 550 650\n", "no usable sample");
}

TEST(Cornell, EveryPrefixIsSoundOrRefused)
{
    EXPECT_GT(refusedPrefixes("p.brdf", kSmall), 60u);
    expectSurvivesDamage("p.brdf", kSmall);
}

TEST(Cornell, GarnetRedAgreesWithTheReferenceReader)
{
    FBRDF_NEEDS_DATA("cornell_pbrt2/garnet_red.brdf");
    const Source source = openSource(dataPath("cornell_pbrt2/garnet_red.brdf"));
    expectSound(source);
    EXPECT_EQ(source.name, "garnet_red");
    EXPECT_EQ(source.report.given, 1439u);
    EXPECT_EQ(source.report.nonFinite, 0u);
    const auto brightest =
        std::max_element(source.samples.begin(), source.samples.end(),
                         [](const Sample& a, const Sample& b) { return a.f.y < b.f.y; });
    const Vec3f h = glm::normalize(brightest->wi + brightest->wo);
    EXPECT_LT(std::acos(h.z), 0.05f);  // the highlight is at the mirror, so no sign is wrong
}

TEST(Cornell, EveryPrefixOfARealFileIsSoundOrRefused)
{
    FBRDF_NEEDS_DATA("cornell_pbrt2/mystique.brdf");
    std::ifstream file(dataPath("cornell_pbrt2/mystique.brdf"), std::ios::binary);
    std::string bytes(8000, '\0');
    file.read(bytes.data(), std::streamsize(bytes.size()));
    EXPECT_GT(refusedPrefixes("m.brdf", bytes, 7), 1000u);
}
