#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/base/Number.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

std::string zemax(const std::string& blocks, const std::string& content = "Monochrome",
                  const std::string& type = "BRDF")
{
    return "# a comment\nSource\tMeasured\nSymmetry PlaneSymmetrical\nSpectralContent " + content +
           "\nScatterType " + type +
           "\nSampleRotation 1\n0\nAngleOfIncidence 1\n30\nScatterAzimuth 2\n0 90\n"
           "ScatterRadial 2\n0 20\n\n" +
           blocks;
}

const std::string kBlock = "Monochrome\nDataBegin\nTIS 0.1\n1.5 2.5\n1.5 0\nDataEnd\n";

Source read(const std::string& text)
{
    const TempFolder folder;
    return openSource(folder.write("dash.bsdf", text));
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("dash.bsdf", text), part);
}

}  // namespace

TEST(Zemax, ScatterAnglesAreCentredOnTheMirrorDirection)
{
    const Source source = read(zemax(kBlock));
    EXPECT_EQ(source.format, "zemax");
    EXPECT_TRUE(source.isotropic);
    const std::vector<Sample> samples = allSamples(source);
    ASSERT_EQ(samples.size(), 3u);
    const Vec3f mirror(float(std::sin(30 * kDegree)), 0.0f, float(std::cos(30 * kDegree)));
    EXPECT_LT(glm::length(samples[0].wi - Vec3f(-mirror.x, 0, mirror.z)), 1e-6f);
    EXPECT_LT(glm::length(samples[0].wo - mirror), 1e-6f);
    // Azimuth 0 leads from the mirror direction to the normal: 30 - 20 degrees.
    EXPECT_NEAR(samples[1].wo.x, std::sin(10 * kDegree), 1e-6);
    EXPECT_NEAR(samples[1].wo.z, std::cos(10 * kDegree), 1e-6);
    EXPECT_FLOAT_EQ(samples[1].f.x, 2.5f);
    EXPECT_FLOAT_EQ(samples[0].weight, 0.5f);  // one direction, given for two azimuths
    EXPECT_EQ(reportOf(source).invalid, 1u);   // 0 means not measured
}

TEST(Zemax, TristimulusBlocksBecomeColours)
{
    std::string blocks;
    // The white point of D65 times 2: grey.
    for (const auto& [name, value] :
         {std::pair<const char*, double>{"X", 2 * 0.950470}, {"Y", 2 * 1.0}, {"Z", 2 * 1.088830}}) {
        const std::string v = numberText(value, 9) + " ";
        blocks += std::string("Tristimulus") + name + "\nDataBegin\nTIS 1\n" + v + v + v + v +
                  "\nDataEnd\n";
    }
    const Source source = read(zemax(blocks, "XYZ"));
    const std::vector<Sample> samples = allSamples(source);
    ASSERT_EQ(samples.size(), 4u);
    EXPECT_LT(glm::length(samples[3].f - Vec3f(2.0f)), 1e-4f);
}

TEST(Zemax, TheNamesOfBlocksDecideAndCaseDoesNot)
{
    const auto component = [](const char* name, double value) {
        const std::string v = numberText(value, 9) + " ";
        return std::string(name) + "\nDATABEGIN\ntis 1\n" + v + v + v + v + "\ndataend\n";
    };
    const Source source =
        read(zemax(component("tristimulusY", 2.0) + component("TRISTIMULUS Z", 2 * 1.08883) +
                       component("TristimulusX", 2 * 0.95047),
                   "xyz", "brdf"));
    EXPECT_LT(glm::length(allSamples(source).at(3).f - Vec3f(2.0f)), 1e-4f);
    const std::string x = component("TristimulusX", 1.0), y = component("TristimulusY", 1.0);
    expectRefused(zemax(x + x + y, "XYZ"), "found a block of data twice");
    expectRefused(zemax(x + y + component("TristimulusW", 1.0), "XYZ"), "found Tristimulus 'w'");
    expectRefused(zemax(x + y + x.substr(x.find('\n') + 1), "XYZ"), "found data without a name");
}

TEST(Zemax, RefusesTransmissionAndWhatDoesNotAddUp)
{
    expectRefused(zemax(kBlock, "Monochrome", "BTDF"), "found a BTDF");
    expectRefused(zemax(kBlock, "Spectral"), "found 'Spectral', expected Monochrome or XYZ");
    expectRefused(zemax(kBlock, "XYZ"), "found 1 blocks of data, expected 3");
    expectRefused(zemax(""), "found 0 blocks");
    expectRefused(zemax(kBlock + kBlock), "found a block of data twice");
    expectRefused(zemax("Monochrome\nDataBegin\nTIS 0.1\n1 2 3\nDataEnd\n"),
                  "found 3 values, expected 4");
    expectRefused(zemax("Monochrome\nDataBegin\nTIS 0.1\n1 2 3 4\n"), "end of the file");
    expectRefused(zemax("Monochrome\nDataBegin\nTIS 0.1\n1 2 x 4\nDataEnd\n"), "found 'x'");
    expectRefused("ScatterType BRDF\nDataBegin\n1\nDataEnd\n", "all four lists");
    expectRefused("ScatterType BRDF\nSampleRotation 999999999\n", "expected a count");
    expectRefused("ScatterType BRDF\nSampleRotation -1\n0\n", "expected a count");
    expectRefused("ScatterType BRDF\nNonsense\n", "found 'nonsense'");
}

TEST(Zemax, NotFiniteAndBelowTheHorizonIsCounted)
{
    std::string text = zemax("Monochrome\nDataBegin\nTIS 0.1\n1 nan\n1 2\nDataEnd\n");
    text.replace(text.find("0 20\n\n"), 4, "0 70");
    const Source source = read(text);
    EXPECT_EQ(reportOf(source).nonFinite, 1u);
    EXPECT_EQ(allSamples(source).size(), 3u);
    text.replace(text.find("30\nScatter"), 2, "80");
    EXPECT_EQ(reportOf(read(text)).given, 4u);
    expectSound(read(text));
}

TEST(Zemax, EveryPrefixIsRefused)
{
    const std::string text = zemax(kBlock);
    EXPECT_EQ(refusedPrefixes("a.bsdf", text), text.find("DataEnd") + 7);
    expectSurvivesDamage("a.bsdf", text, 2);
}

TEST(Zemax, RealFilesAgreeWithTheReferenceReader)
{
    const RealFile files[] = {
        {"ua_rt300s/AnoBlackEC1onAlum.bsdf",
         912,
         719,
         {{0.98480773f, 0, 0.173648179f}, {-0.93969262f, 0, 0.34202015f}, Vec3f(1.868f)}},
        {"ua_rt300s/AnoBlackNiTEonSteel.bsdf",
         912,
         719,
         {{0.98480773f, 0, 0.173648179f}, {-0.93969262f, 0, 0.34202015f}, Vec3f(2.976f)}},
    };
    for (const RealFile& file : files) {
        FBRDF_NEEDS_DATA(file.path);
        expectRealFile(openSource(dataPath(file.path)), file);
    }
}
