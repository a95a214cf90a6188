// Reference figures of the real files: the data set's parse.py (numpy).
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

std::string ring(double theta, int phis, double lower, double upper)
{
    const auto text = [](double v) { return std::to_string(v); };
    return "<AngleBasisBlock><Theta>" + text(theta) + "</Theta><nPhis>" + std::to_string(phis) +
           "</nPhis><ThetaBounds><LowerTheta>" + text(lower) + "</LowerTheta><UpperTheta>" +
           text(upper) + "</UpperTheta></ThetaBounds></AngleBasisBlock>\n";
}

const std::string kRings = ring(0, 1, 0, 20) + ring(45, 4, 20, 90);

std::string block(const std::string& direction, const std::string& numbers,
                  const std::string& wavelength = "Visible")
{
    return "<WavelengthData><Wavelength unit=\"Integral\">" + wavelength +
           "</Wavelength><WavelengthDataBlock><WavelengthDataDirection>" + direction +
           "</WavelengthDataDirection><ColumnAngleBasis>B</ColumnAngleBasis><RowAngleBasis>B"
           "</RowAngleBasis><ScatteringData>\n" +
           numbers + "</ScatteringData></WavelengthDataBlock></WavelengthData>\n";
}

/// A 5 x 5 matrix, entry (row, column) = scale x (10 row + column + 1).
std::string matrix(double scale = 1.0)
{
    std::string text;
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            text += std::to_string(scale * (10 * row + column + 1)) + (column == 4 ? ",\n" : ", ");
    return text;
}

std::string klems(const std::string& blocks, const std::string& rings = kRings,
                  const std::string& structure = "Columns")
{
    return "<?xml version=\"1.0\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\"><Optical>"
           "<Layer><DataDefinition><IncidentDataStructure>" +
           structure + "</IncidentDataStructure><AngleBasis><AngleBasisName>B</AngleBasisName>" +
           rings + "</AngleBasis></DataDefinition>" + blocks +
           "</Layer></Optical></WindowElement>\n";
}

const std::string kShade = klems(block("Reflection Front", matrix()));

Source read(const std::string& text, const std::string& choice = "")
{
    const TempFolder folder;
    return openSource(folder.write("shade.xml", text) + choice);
}

void expectRefused(const std::string& text, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("shade.xml", text), part);
}

Vec3d at(double theta, double phi)
{
    return directionFromAngles(theta * kDegree, phi * kDegree);
}

}  // namespace

TEST(Klems, RowsAreOutgoingAndColumnsPropagation)
{
    const Source source = read(kShade);
    EXPECT_EQ(source.format, "klems");
    // Outgoing patch 2 (azimuth 90), light from azimuth 180: propagation 0, column 1.
    EXPECT_NEAR(source.evaluate(at(50, 80), at(45, 190)).x, 22.0, 1e-5);
    // The mirror of a patch is its own column.
    for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(source.evaluate(at(45, 90 * k), at(45, 90 * k + 180)).y,
                    10 * (k + 1) + (k + 1) + 1, 1e-5);
    EXPECT_NEAR(source.evaluate(at(5, 0), at(19, 77)).x, 1.0, 1e-6);
    EXPECT_EQ(source.evaluate({0, 0, -1}, {0, 0, 1}), Vec3d(0.0));
}

TEST(Klems, IncidentRowsAreTransposed)
{
    const Source source = read(klems(block("Reflection Front", matrix()), kRings, "Rows"));
    EXPECT_NEAR(source.evaluate(at(50, 80), at(45, 190)).x, 13.0, 1e-5);
}

TEST(Klems, SamplesAreTheCentresOfThePatches)
{
    const Source source = read(kShade);
    EXPECT_EQ(source.stream.rows, 25u);
    expectSound(source);
    for (const Sample& s : allSamples(source))
        EXPECT_LT(glm::length(source.evaluate(Vec3d(s.wo), Vec3d(s.wi)) - Vec3d(s.f)), 1e-5);
}

TEST(Klems, TheBackIsAChoice)
{
    const std::string text =
        klems(block("Reflection Back", matrix(2)) + block("Reflection Front", matrix()));
    EXPECT_NEAR(read(text, "@back").evaluate({0, 0, 1}, {0, 0, 1}).x, 2.0, 1e-6);
    EXPECT_NEAR(read(text, "@front").evaluate({0, 0, 1}, {0, 0, 1}).x, 1.0, 1e-6);
    const TempFolder folder;
    EXPECT_EQ(outcomeOf(folder.write("shade.xml", text) + "@side").kind, int(ErrorKind::usage));
}

TEST(Klems, TristimulusBlocksBecomeColours)
{
    const Source source = read(klems(block("Reflection Front", matrix(0.95047), "CIE-X") +
                                     block("Reflection Front", matrix()) +
                                     block("Reflection Front", matrix(1.08883), "CIE-Z")));
    EXPECT_LT(glm::length(source.evaluate({0, 0, 1}, {0, 0, 1}) - Vec3d(1.0)), 1e-4);
}

TEST(Klems, NegativeAndNotFiniteEntriesAreCounted)
{
    std::string numbers = matrix();
    numbers.replace(0, 8, "-1.00000");
    numbers.replace(numbers.find("2.000000"), 8, "nan     ");
    const Source source = read(klems(block("Reflection Front", numbers)));
    const SampleReport report = reportOf(source);
    EXPECT_EQ(report.negative, 1u);
    EXPECT_EQ(report.nonFinite, 1u);
    EXPECT_EQ(source.evaluate({0, 0, 1}, {0, 0, 1}), Vec3d(0.0));
    expectSound(source);
}

TEST(Klems, RefusesWhatDoesNotAddUp)
{
    const std::string front = block("Reflection Front", matrix());
    expectRefused(klems(block("Transmission Front", matrix())), "no visible 'Reflection front'");
    expectRefused(klems(block("Reflection Front", "1, 2, 3")), "found 3 numbers");
    expectRefused(klems(block("Reflection Front", matrix() + "7")), "found 26 numbers");
    expectRefused(klems(block("Reflection Front", "1, two, 3")), "found 'two'");
    expectRefused(klems(front, ring(0, 0, 0, 20)), "a ring of 0");
    expectRefused(klems(front, ring(0, -4, 0, 20)), "a ring of -4");
    expectRefused(klems(front, ring(0, 999999999, 0, 20)), "a ring of 999999999");
    expectRefused(klems(front, ring(0, 1, 30, 20)), "a ring of 1");
    expectRefused(klems(front, ring(45, 4, 20, 90) + ring(0, 1, 0, 20)), "rings that overlap");
    expectRefused(klems(front, ""), "found bases 'B'");
    expectRefused("<WindowElement><a></b></WindowElement>", "expected XML");
    std::string many;
    for (int i = 0; i < 90; ++i) many += ring(i, 360, i, i + 1);
    expectRefused(klems(front, many), "over 4096 patches");
}

TEST(Klems, EveryPrefixIsRefused)
{
    const size_t whole = kShade.find("</WindowElement>") + 16;
    EXPECT_EQ(refusedPrefixes("s.xml", kShade, 3), (whole + 2) / 3);
    expectSurvivesDamage("s.xml", kShade, 5);
}

TEST(Klems, RealFilesAgreeWithTheReferenceReader)
{
    const RealFile files[] = {
        {"klems_fabric/blinds_20deg_noGlazing_Klems.xml",
         21025,
         21025,
         {{0, 0.991444886f, 0.130526185f}, {0, 0.991444886f, 0.130526185f}, Vec3f(0.826f)}},
        {"klems_fabric/mcs6216_t3_g6_t80_-a_phi00_kl.xml@back",
         21025,
         21025,
         {{-0.49572244f, -0.85861641f, 0.13052618f},
          {0.49572244f, 0.85861641f, 0.13052618f},
          Vec3f(1.601f)}},
    };
    for (const RealFile& file : files) {
        FBRDF_NEEDS_DATA("klems_fabric/parse.py");
        expectRealFile(openSource(dataPath(file.path)), file);
    }
}
