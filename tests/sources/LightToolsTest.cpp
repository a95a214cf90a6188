#include "ReaderTest.h"

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

const std::string kAngles = "ScatterAzimuth 4\n0 90 180 270\nScatterRadial 3\n0 30\n60\n";

std::string lightTools(const std::string& blocks, const std::string& content = "Monochrome")
{
    return "# own\nSymmetry Asymmetrical\nSpectralContent " + content + "\n" + kAngles +
           "DataBegin\n" + blocks + "DataEnd\n";
}

/// Values of azimuth a and radial angle r are `scale` (1 + 10 a + r).
std::string block(const std::string& head, int scale = 1)
{
    std::string text = head + "\nTIS 0.5\n";
    for (int a = 0; a < 4; ++a) {
        for (int r = 0; r < 3; ++r) text += std::to_string(scale * (1 + 10 * a + r)) + " ";
        text += "\n";
    }
    return text;
}

const std::string kFront = "AOI 30\nPOI 0\nSide Front\nWavelength 550\nScatterType BRDF";
const std::string kBack = "AOI 150\nPOI 0\nSide Back\nWavelength 550\nScatterType BRDF";
const std::string kThrough = "AOI 30\nPOI 0\nSide Front\nWavelength 550\nScatterType BTDF";

Source read(const std::string& text, const std::string& choice = "")
{
    const TempFolder folder;
    return openSource(folder.write("a.bsdf", text) + choice);
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("a.bsdf", text), part);
}

Vec3f onMeridian(double zenith, double azimuth)
{
    const double z = zenith * kDegree, a = azimuth * kDegree;
    return Vec3f(Vec3d(std::sin(z) * std::cos(a), std::sin(z) * std::sin(a), std::cos(z)));
}

}  // namespace

TEST(LightTools, AnglesAreAboutTheNormalAndTheLightComesFromAzimuth90)
{
    const Source source = read(lightTools(block(kFront)));
    EXPECT_EQ(source.format, "lighttools");
    EXPECT_TRUE(source.isotropic);
    const std::vector<Sample> samples = allSamples(source);
    ASSERT_EQ(samples.size(), 12u);
    for (int a = 0; a < 4; ++a)
        for (int r = 0; r < 3; ++r) {
            const Sample& sample = samples[size_t(3 * a + r)];
            EXPECT_LT(glm::length(sample.wi - onMeridian(30.0, 90.0)), 1e-6f);
            EXPECT_LT(glm::length(sample.wo - onMeridian(30.0 * r, 90.0 * a)), 1e-6f);
            EXPECT_EQ(sample.f.x, float(1 + 10 * a + r));
            EXPECT_EQ(sample.weight, r == 0 ? 0.25f : 1.0f);  // the normal is given four times
        }
    EXPECT_EQ(source.assumptions,
              (std::vector<std::string>{"one band as grey",
                                        "isotropic, as there is one plane of incidence"}));
}

TEST(LightTools, SidesAreChoicesAndTransmissionIsNotRead)
{
    const std::string text = lightTools(block(kThrough, 7) + block(kFront) + block(kBack, 3));
    EXPECT_EQ(allSamples(read(text)).at(1).f.x, 2.0f);
    EXPECT_EQ(allSamples(read(text, "@front")).at(1).f.x, 2.0f);
    const Source back = read(text, "@back");
    EXPECT_EQ(allSamples(back).at(1).f.x, 6.0f);
    EXPECT_LT(glm::length(allSamples(back).at(1).wi - onMeridian(30.0, 90.0)), 1e-6f);
    EXPECT_EQ(back.assumptions.back(),
              "the reflection of the back; 2 blocks of transmission or of the other side not read");
    EXPECT_EQ(allSamples(read(lightTools(block(kBack, 3)))).at(1).f.x, 6.0f)
        << "the side that is there";
    const TempFolder folder;
    EXPECT_NE(outcomeOf(folder.write("a.bsdf", text) + "@left").kind, 0);
    expectInputError(folder.write("b.bsdf", lightTools(block(kBack))) + "@front",
                     "found no reflection of the front");
    expectRefused(lightTools(block(kThrough)), "found no reflection");
}

TEST(LightTools, WavelengthsAreChoicesOrBecomeAColour)
{
    const auto at = [](int wavelength) {
        return "AOI 30\nPOI 0\nSide Front\nWavelength " + std::to_string(wavelength) +
               "\nScatterType BRDF";
    };
    const std::string text = lightTools(block(at(450), 1) + block(at(550), 2) + block(at(650), 3));
    EXPECT_EQ(allSamples(read(text, "@550")).at(1).f, Vec3f(4.0f));
    EXPECT_EQ(allSamples(read(text, "@650/front")).at(1).f, Vec3f(6.0f));
    const Vec3f red = allSamples(read(text)).at(1).f;
    EXPECT_GT(red.x, red.y);
    EXPECT_GT(red.y, red.z);
    expectRefused(lightTools(block(at(450)) + block(at(550)) + block("AOI 40\nWavelength 450")),
                  "found 3 blocks, expected 4, 2 for each AOI");
    expectRefused(lightTools(block(at(450)) + block(at(450))), "found AOI 30 twice");
}

TEST(LightTools, TristimulusBlocksBecomeColours)
{
    const auto component = [](const std::string& name) {
        return "AOI 30\nSide Front\nScatterType BRDF\nTristimulusValue Tris" + name;
    };
    const std::string blocks =
        block(component("Z")) + block(component("X")) + block(component("Y"));
    const Source source = read(lightTools(blocks, "XYZ"));
    EXPECT_LT(glm::length(allSamples(source).at(4).f - Vec3f(12.0f)), 1e-3f) << "equal energy";
    expectRefused(lightTools(blocks), "found a TristimulusValue, expected none");
    expectRefused(lightTools(block(kFront), "XYZ"), "found values without TristimulusValue");
}

TEST(LightTools, RefusesWhatDoesNotAddUp)
{
    const std::string ones = "\nTIS 1\n1 1 1 1 1 1 1 1 1 1 1 1\n", head = "Symmetry Asymmetrical\n";
    expectRefused(lightTools(ones + "AOI 1\n"), "found values, expected an AOI above them");
    expectRefused(lightTools("AOI 200" + ones), "found AOI 200, expected 0 to 180 degrees");
    expectRefused(lightTools(block(kFront) + "AOI 40\nWavelength 550\nPOI 90" + ones),
                  "found several planes of incidence (POI)");
    expectRefused(lightTools("AOI 40\nTIS 1\n1 1 x "), "found 'x', expected a value");
    expectRefused(lightTools("AOI 30\nSide Left" + ones), "found 'Left', expected Front or Back");
    expectRefused(head + "ScatterAzimuth 1\n0\nDataBegin\nAOI 1\n",
                  "expected ScatterAzimuth and ScatterRadial above");
    expectRefused(head + "ScatterAzimuth 99999999\n0\nDataBegin\nAOI 1\n",
                  "expected a count from 1 to 100000");
}

TEST(LightTools, EveryPrefixIsRefused)
{
    const std::string text = lightTools(block(kFront) + block(kBack));
    EXPECT_EQ(refusedPrefixes("a.bsdf", text), text.size() - 1);  // the last line may lack its end
}

TEST(LightTools, DamagedFilesAreSoundOrRefused)
{
    expectSurvivesDamage("a.bsdf", lightTools(block(kFront)));
}
