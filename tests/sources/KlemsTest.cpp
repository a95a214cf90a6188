// Reference figures of the real files: the data set's parse.py (numpy).
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

std::string ring(double theta, int phis, double lower, double upper)
{
    const auto text = [](double v) { return fixedText(v); };
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
            text += fixedText(scale * (10 * row + column + 1)) + (column == 4 ? ",\n" : ", ");
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

TEST(Klems, GreyOfEqualEnergyIsGrey)
{
    const std::string text = klems(block("Reflection Back", matrix(0.3), "CIE-X") +
                                   block("Reflection Back", matrix(0.3)) +
                                   block("Reflection Back", matrix(0.3), "CIE-Z"));
    const Vec3d grey = read(text).evaluate({0, 0, 1}, {0, 0, 1});
    EXPECT_LT(glm::length(grey - Vec3d(0.3)), 1e-4) << grey.x << ' ' << grey.y << ' ' << grey.z;
    const Vec3d pink = read(text, "@back/d65").evaluate({0, 0, 1}, {0, 0, 1});
    EXPECT_NEAR(pink.x, 0.3 * (3.2404542 - 1.5371385 - 0.4985314), 1e-4);
    EXPECT_NE(read(text).assumptions.back().find("equal energy"), std::string::npos);
}

TEST(Klems, TheSideThatIsThereIsTakenAndNamed)
{
    const Source source = read(klems(block("Reflection Back", matrix(2))));
    EXPECT_NEAR(source.evaluate({0, 0, 1}, {0, 0, 1}).x, 2.0, 1e-6);
    EXPECT_EQ(source.assumptions.at(0), "the back side, which alone is there");
}

TEST(Klems, BandsAreChoicesAndErrorsListThem)
{
    const TempFolder folder;
    const std::string path =
        folder.write("solar.xml", klems(block("Reflection Front", matrix(3), "Solar") +
                                        block("Reflection Back", matrix(4), "Solar") +
                                        block("Reflection Back", matrix(5), "NIR")));
    const auto atNormal = [&](const std::string& choice) {
        return openSource(path + choice).evaluate({0, 0, 1}, {0, 0, 1}).x;
    };
    EXPECT_NEAR(atNormal("@solar"), 3.0, 1e-6);
    EXPECT_NEAR(atNormal("@SOLAR/back"), 4.0, 1e-6);
    EXPECT_NEAR(atNormal("@back/solar"), 4.0, 1e-6);
    EXPECT_NEAR(atNormal("@nir"), 5.0, 1e-6);
    expectInputError(path, "FILE@solar/front, FILE@solar/back, FILE@nir/back");
    for (const char* choice : {"@visible", "@550", "@nir/front", "@front/back"})
        EXPECT_EQ(outcomeOf(path + choice).kind, int(ErrorKind::usage)) << choice;
}

TEST(Klems, OtherBandsAndTransmissionAreNamed)
{
    const Source source = read(klems(block("Reflection Front", matrix(3), "Visible") +
                                     block("Reflection Front", matrix(4), "Solar") +
                                     block("Reflection Front", matrix(5), "NIR") +
                                     block("Transmission Front", matrix(6), "Solar")));
    const auto assumes = [&](const std::string& text) {
        return std::count(source.assumptions.begin(), source.assumptions.end(), text);
    };
    EXPECT_EQ(assumes("the visible band; others are FILE@solar, FILE@nir"), 1);
    EXPECT_EQ(assumes("the reflection; transmission is not read"), 1);
    for (const std::string& text : read(klems(block("Reflection Front", matrix(3)))).assumptions)
        EXPECT_TRUE(text.find("others") == std::string::npos &&
                    text.find("transm") == std::string::npos)
            << text;
}

TEST(Klems, WordsAreComparedWithoutCase)
{
    std::string text = klems(block("REFLECTION  front", matrix(), "visible"), kRings, " rows\n");
    for (const char* tag : {"ColumnAngleBasis", "AngleBasisName"})
        for (size_t at = text.find(tag); at != std::string::npos; at = text.find(tag, at + 1))
            text[at] = static_cast<char>(std::tolower(text[at]));
    EXPECT_NEAR(read(text).evaluate(at(50, 80), at(45, 190)).x, 13.0, 1e-5);
    expectRefused(klems(block("Reflection Front", matrix()), kRings, "Sideways"),
                  "found the IncidentDataStructure 'Sideways'");
}

TEST(Klems, CommentsSplitNoData)
{
    std::string numbers = matrix();
    for (size_t at = numbers.find(",\n"); at != std::string::npos;
         at = numbers.find(",\n", at + 20))
        numbers.insert(at + 1, "<!-- row, 1 2 3 -->");
    EXPECT_NEAR(read(klems(block("Reflection Front", numbers))).evaluate(at(50, 80), at(45, 190)).x,
                22.0, 1e-5);
}

TEST(Klems, KnownBasesNeedNoDefinition)
{
    for (const auto& [name, patches] : {std::pair<std::string, size_t>{"LBNL/Klems Full", 145},
                                        {"lbnl/klems half", 73},
                                        {"LBNL/Klems Quarter", 41}}) {
        std::string numbers;
        for (size_t i = 0; i < patches * patches; ++i)
            numbers += std::to_string(i % patches == i / patches ? i % patches + 1 : 0) + ' ';
        std::string text = klems(block("Reflection Front", numbers), "");
        for (size_t at = text.find(">B<"); at != std::string::npos; at = text.find(">B<", at + 1))
            text.replace(at + 1, 1, name);
        const Source source = read(text);
        EXPECT_EQ(source.stream.rows, patches * patches);
        // The diagonal is the mirror: every patch sees itself.
        for (const Sample& s : allSamples(source)) {
            const bool mirror = glm::length(Vec3f(-s.wi.x, -s.wi.y, s.wi.z) - s.wo) < 1e-5f;
            EXPECT_EQ(s.f.x > 0.0f, mirror) << name;
        }
    }
}

TEST(Klems, OutgoingAndIncidentBasesMayDiffer)
{
    // Two outgoing patches, five incident: entry (row, column) = 10 row + column.
    std::string text =
        klems(block("Reflection Front", "0 1 2 3 4\n10 11 12 13 14"),
              kRings + "</AngleBasis><AngleBasis><AngleBasisName>C</AngleBasisName>" +
                  ring(0, 1, 0, 30) + ring(60, 1, 30, 90));
    text.replace(text.find("<RowAngleBasis>B"), 16, "<RowAngleBasis>C");
    const Source source = read(text);
    EXPECT_EQ(source.stream.rows, 10u);
    EXPECT_NEAR(source.evaluate(at(50, 80), at(45, 190)).x, 11.0, 1e-5);
    EXPECT_NEAR(source.evaluate(at(20, 80), at(45, 270)).x, 2.0, 1e-5);
    expectSound(source);
}

namespace {

std::string tree(int rank, const std::string& data, const std::string& bands = "")
{
    std::string text =
        klems(block("Reflection Back", data) + bands, "", "TensorTree" + std::to_string(rank));
    return text;
}

/// Values 0, 1, 2.. in a leaf of 2^(rank log2) values.
std::string countedLeaf(int rank, int log2)
{
    std::string text = "{";
    for (int i = 0; i < 1 << (rank * log2); ++i) text += " " + std::to_string(i);
    return text + " }";
}

}  // namespace

TEST(TensorTree, OneValueAppliesEverywhere)
{
    for (const int rank : {3, 4}) {
        const Source source = read(tree(rank, "\n{ 0.318309886 }\n"));
        EXPECT_EQ(source.isotropic, rank == 3);
        EXPECT_NEAR(source.evaluate(at(50, 80), at(45, 190)).x, 0.318309886, 1e-7);
        EXPECT_EQ(source.evaluate({0, 0, -1}, {0, 0, 1}), Vec3d(0.0));
        expectSound(source);
    }
}

TEST(TensorTree, CoordinatesAreThoseOfTheSquare)
{
    // Rank 4, two cells along each coordinate, the first slowest: 8 -x(wi), 4 -y(wi), 2 x(wo),
    // y(wo).
    const Source four = read(tree(4, countedLeaf(4, 1)));
    EXPECT_NEAR(four.evaluate(at(60, 10), at(60, 10)).x, 0 + 0 + 2 + 1, 1e-6);
    EXPECT_NEAR(four.evaluate(at(60, 190), at(60, 190)).x, 8 + 4, 1e-6);
    EXPECT_NEAR(four.evaluate(at(60, 100), at(60, -80)).x, 4 + 1, 1e-6);
    // Rank 3, four cells: |wi| from grazing (0) to normal (2), then wo about the azimuth of -wi.
    const Source three = read(tree(3, countedLeaf(3, 2)));
    for (const double turn : {0.0, 77.0, 200.0}) {
        const Vec3d mirror = three.evaluate(at(80, turn + 190), at(80, turn));
        EXPECT_NEAR(mirror.x, 0 * 16 + 3 * 4 + 2, 1e-6) << turn;
        EXPECT_NEAR(three.evaluate(at(80, turn - 10), at(10, turn)).x, 1 * 16 + 0 * 4 + 2, 1e-6);
    }
}

TEST(TensorTree, BranchesHalveTheCube)
{
    std::string branches = "{";
    for (int i = 0; i < 8; ++i) branches += "{" + std::to_string(i) + "}";
    const Source source = read(tree(3, branches + "}"));
    // Bit 0: |wi|, always in the lower half; bit 1: along the mirror; bit 2: across it.
    EXPECT_NEAR(source.evaluate(at(60, 190), at(60, 0)).x, 2.0 + 4.0, 1e-6);
    EXPECT_NEAR(source.evaluate(at(60, 170), at(60, 0)).x, 2.0, 1e-6);
    EXPECT_NEAR(source.evaluate(at(60, -10), at(60, 0)).x, 4.0, 1e-6);
    EXPECT_NEAR(source.evaluate(at(60, 10), at(60, 0)).x, 0.0, 1e-6);
}

TEST(TensorTree, ColourComesFromThreeTrees)
{
    const Source source = read(tree(
        3, "{0.3}",
        block("Reflection Back", "{0.3}", "CIE-X") + block("Reflection Back", "{0.3}", "CIE-Z")));
    const Vec3d f = source.evaluate(at(50, 80), at(45, 190));
    EXPECT_LT(glm::length(f - Vec3d(0.3)), 1e-4);
}

TEST(TensorTree, RefusesWhatIsNoTree)
{
    for (const char* data :
         {"", "{", "{}", "{1 2}", "{1} 2", "{1}{1}", "{{1}{2}}", "{one}", "{nan}", "{1e60}", "1",
          "{1", "{1 2 3 4 5 6 7 8", "{{{{{{{{{{{{{{{{{{{{{{{{{{{{{{"})
        expectRefused(tree(3, data), "ScatteringData");
    const std::string text = tree(3, countedLeaf(3, 1));
    EXPECT_GT(refusedPrefixes("t.xml", text, 3), text.size() / 4);
    expectSurvivesDamage("t.xml", text, 3);
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
    expectRefused(klems(block("Transmission Front", matrix())),
                  "found no visible reflection, expected a choice of what the file has: "
                  "Transmission Front of Visible (not read)");
    expectRefused(klems(block("Reflection Front", "1, 2, 3")), "found 3 numbers");
    expectRefused(klems(block("Reflection Front", matrix() + "7")), "found 26 numbers");
    expectRefused(klems(block("Reflection Front", "1, two, 3")), "found 'two'");
    expectRefused(klems(front, ring(0, 0, 0, 20)), "a ring of 0");
    expectRefused(klems(front, ring(0, -4, 0, 20)), "a ring of -4");
    expectRefused(klems(front, ring(0, 999999999, 0, 20)), "a ring of 999999999");
    expectRefused(klems(front, ring(0, 1, 30, 20)), "a ring of 1");
    expectRefused(klems(front, ring(45, 4, 20, 90) + ring(0, 1, 0, 20)), "rings that overlap");
    expectRefused(klems(front, ""), "found the ColumnAngleBasis 'B'");
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
