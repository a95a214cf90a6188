// Files of many materials: the neural nets and the NPF tables. Reference values of the real
// files: the data sets' own parse.py.
#include "ReaderTest.h"
#include "support/DataDir.h"

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

// kReference: the reference is printed with 9 digits; weights are float in both.
constexpr double kReference = 1e-8;
constexpr size_t kNetRow = 675, kNpfRow = 512 * 3;

/// Weights with which f is exp(b3) - 1 = `value` everywhere.
std::string constantNet(float value)
{
    std::string bytes;
    for (size_t i = 0; i < kNetRow; ++i) append(bytes, i < kNetRow - 3 ? 0.0f : std::log1p(value));
    return bytes;
}

std::string emptyNpf()
{
    return std::string(256 * kNpfRow * 4, '\0');
}

void setNpf(std::string& bytes, size_t row, size_t column, float value)
{
    for (size_t c = 0; c < 3; ++c)
        std::memcpy(&bytes[(row * kNpfRow + column * 3 + c) * 4], &value, 4);
}

int kindOf(const std::string& spec)
{
    return outcomeOf(spec).kind;
}

}  // namespace

TEST(Nbrdf, RunsTheNetworkOfTheChosenRow)
{
    const TempFolder folder;
    const std::string path = folder.write("nets.f32", constantNet(0.25f) + constantNet(0.5f));
    const Source source = openSource(path + "#1");
    EXPECT_EQ(source.format, "nbrdf");
    EXPECT_EQ(source.name, "nets#1");
    EXPECT_NEAR(source.evaluate({0, 0, 1}, {0.6, 0, 0.8}).x, 0.5, 1e-6);
    EXPECT_EQ(source.evaluate({0, 0, 1}, {0.6, 0, -0.8}), Vec3d(0.0));
    EXPECT_EQ(source.stream.geometry, "merl 90x90x180 full");
}

TEST(Nbrdf, FindsMaterialsByName)
{
    const TempFolder folder;
    const std::string path =
        folder.write("nets.f32", constantNet(1) + constantNet(2) + constantNet(3));
    folder.write("materials.txt", "merl gold\nrgl gold\nrgl foil\n");
    EXPECT_NEAR(openSource(path + "#foil").evaluate({0, 0, 1}, {0, 0, 1}).y, 3.0, 1e-5);
    EXPECT_NEAR(openSource(path + "#rgl/gold").evaluate({0, 0, 1}, {0, 0, 1}).y, 2.0, 1e-5);
    EXPECT_EQ(openSource(path + "#0").name, "gold");
    const Outcome twice = outcomeOf(path + "#gold");
    EXPECT_EQ(twice.kind, int(ErrorKind::usage));
    EXPECT_NE(twice.message.find("several sets (merl, rgl)"), std::string::npos) << twice.message;
}

TEST(Nbrdf, NamesAreReadAsAnyText)
{
    const TempFolder folder;
    const std::string path = folder.write("nets.f32", constantNet(1) + constantNet(2));
    for (const char* names :
         {"\xEF\xBB\xBFgold\rfoil\r", "gold\r\n\r\nfoil", "merl\tgold\nfoil\n"}) {
        folder.write("materials.txt", names);
        EXPECT_NEAR(openSource(path + "#gold").evaluate({0, 0, 1}, {0, 0, 1}).y, 1.0, 1e-5);
        EXPECT_NEAR(openSource(path + "#foil").evaluate({0, 0, 1}, {0, 0, 1}).y, 2.0, 1e-5);
    }
    folder.write("materials.txt", "");
    EXPECT_EQ(openSource(path + "#1").name, "nets#1");
}

TEST(Nbrdf, ChoicesThatDoNotExistAreUsageErrors)
{
    const TempFolder folder;
    const std::string path = folder.write("nets.f32", constantNet(1) + constantNet(2));
    for (const char* choice : {"", "#2", "#-1", "#gold", "#99999999999999999999"})
        EXPECT_EQ(kindOf(path + choice), int(ErrorKind::usage)) << choice;
}

TEST(Nbrdf, RefusesPartsOfRowsAndBadWeights)
{
    const TempFolder folder;
    expectInputError(folder.write("nets.f32", constantNet(1).substr(4)), "rows of 675");
    for (const float bad : {std::nanf(""), INFINITY, 1e30f}) {
        std::string bytes = constantNet(1);
        std::memcpy(&bytes[400], &bad, 4);
        expectInputError(folder.write("nets.f32", bytes), "at byte 400");
    }
    EXPECT_EQ(refusedPrefixes("nets.f32", constantNet(1), 13), (2700 + 12) / 13u);
}

TEST(Nbrdf, LargeOutputsStayFinite)
{
    std::string bytes;
    for (size_t i = 0; i < kNetRow; ++i) append(bytes, 1e3f);
    const TempFolder folder;
    const Vec3d f = openSource(folder.write("n.f32", bytes)).evaluate({0, 0, 1}, {0, 0, 1});
    EXPECT_TRUE(std::isfinite(f.x) && f.x > 1e30);
}

TEST(Nbrdf, AgreesWithTheReferenceEvaluator)
{
    FBRDF_NEEDS_DATA("nbrdf/nbrdf_weights.f32");
    const std::string nets = dataPath("nbrdf/nbrdf_weights.f32");
    expectReference(openSource(nets + "#merl/alumina-oxide"),
                    {{0.104301902, 0.097576198, 0.085212868},
                     {0.10463941, 0.097578343, 0.083040738},
                     {27.991189855, 23.854872238, 25.118371965}},
                    kReference);
    expectReference(openSource(nets + "#merl/chrome"),
                    {{1.351052330e-03, 1.192355752e-03, 1.260898722e-03},
                     {8.010806428e-04, 6.865328808e-04, 7.471881416e-04},
                     {7.507504626e+02, 7.966918309e+02, 7.860345419e+02}},
                    kReference);
}

TEST(Nbrdf, SamplesAreTheNetworkOnTheMerlGrid)
{
    FBRDF_NEEDS_DATA("nbrdf/nbrdf_weights.f32");
    const Source source = openSource(dataPath("nbrdf/nbrdf_weights.f32") + "#0");
    std::vector<Sample> samples;
    SampleReport report;
    source.stream.read(700000, 1000, samples, report);
    EXPECT_EQ(report.given, 1000u);
    ASSERT_GT(samples.size(), 500u);
    for (const Sample& s : samples) {  // directions are rounded to float: 1e-4 of a smooth net
        const Vec3d f = source.evaluate(Vec3d(s.wo), Vec3d(s.wi));
        EXPECT_NEAR(double(s.f.x), f.x, 1e-4 * f.x);
    }
}

TEST(Npf, EvaluatesTheProductOfFactors)
{
    std::string bytes = emptyNpf();
    setNpf(bytes, 7, 0, 0.5f);
    setNpf(bytes, 7, 1, 2.0f);
    for (size_t bin = 0; bin < 90; ++bin) {
        setNpf(bytes, 7, 2 + bin, 3.0f);
        setNpf(bytes, 7, 92 + bin, bin == 0 ? 1e6f : 0.8f);  // bin 0 of G1 and F is not used
        setNpf(bytes, 7, 182 + bin, bin == 0 ? 1e6f : 0.1f);
    }
    const TempFolder folder;
    const Source source = openSource(folder.write("npf.bin", bytes) + "#7");
    EXPECT_EQ(source.format, "npf");
    const double expected = (0.5 + 2 * 3 * 0.1 * (0.8 / 1.0) * (0.8 / 0.8)) / kPi;
    EXPECT_NEAR(source.evaluate({0, 0, 1}, {0.6, 0, 0.8}).z, expected, 1e-6);
}

TEST(Npf, RefusesEmptyRowsAndBadFactors)
{
    std::string bytes = emptyNpf();
    const TempFolder folder;
    expectInputError(folder.write("npf.bin", bytes) + "#3", "empty row");
    for (const float bad : {-1.0f, std::nanf(""), INFINITY}) {
        setNpf(bytes, 2, 5, bad);
        expectInputError(folder.write("npf.bin", bytes) + "#2", "expected a factor");
    }
    EXPECT_EQ(kindOf(folder.path("npf.bin")), int(ErrorKind::usage));
    EXPECT_EQ(kindOf(folder.path("npf.bin") + "#256"), int(ErrorKind::usage));
    expectInputError(folder.write("short.bin", bytes.substr(1)), "short.bin");
}

// A table is 1.5 MB: every length near the end of a row, and every 997 bytes between. A prefix is
// no table of this size; some are of the size of another format, which is then what is read.
TEST(Npf, EveryPrefixIsRefused)
{
    constexpr size_t kRow = kNpfRow * 4;
    std::string bytes = emptyNpf();
    setNpf(bytes, 7, 0, 0.5f);
    const TempFolder folder(TempFolder::Place::memory);
    const std::string path = folder.write("npf.bin", bytes);
    EXPECT_EQ(openSource(path + "#7").format, "npf");
    for (size_t length = bytes.size(); length > 0;) {
        const size_t inRow = length % kRow;
        const bool edge = inRow < 3 || inRow + 3 > kRow || length < 64;
        length -= edge ? 1 : std::min<size_t>(997, inRow - 2);
        std::filesystem::resize_file(path, length);
        const Outcome outcome = outcomeOf(path);
        EXPECT_TRUE(outcome.kind == int(ErrorKind::input) || outcome.kind == int(ErrorKind::usage))
            << length;
        EXPECT_NE(outcome.message.find("npf.bin"), std::string::npos) << outcome.message;
    }
}

TEST(Npf, AgreesWithTheReferenceEvaluator)
{
    FBRDF_NEEDS_DATA("npf_merl/npf.bin");
    expectReference(openSource(dataPath("npf_merl/npf.bin") + "#alumina-oxide"),
                    {{0.097726672, 0.09111958, 0.079019455},
                     {0.097728481, 0.091117397, 0.078873333},
                     {13.841551862, 19.773637029, 67.360264541}},
                    kReference);
    expectReference(openSource(dataPath("npf_merl/npf.bin") + "#chrome"),
                    {{1.488430381e-03, 1.335883420e-03, 1.440561874e-03},
                     {4.963673342e-04, 5.047926410e-04, 5.067607467e-04},
                     {4.372940361e+02, 5.506815026e+02, 5.994150565e+02}},
                    kReference);
}

TEST(MaterialsOf, ACollectionIsAllItsMaterials)
{
    const TempFolder folder;
    const std::string path =
        folder.write("nets.f32", constantNet(1) + constantNet(2) + constantNet(3));
    EXPECT_EQ(materialsOf(path), (std::vector<std::string>{path + "#0", path + "#1", path + "#2"}));
    folder.write("materials.txt", "merl gold\nrgl gold\nrgl foil\n");
    EXPECT_EQ(materialsOf(path),
              (std::vector<std::string>{path + "#merl/gold", path + "#rgl/gold", path + "#foil"}));
    for (const std::string& spec : materialsOf(path)) EXPECT_NO_THROW(openSource(spec)) << spec;
}

TEST(MaterialsOf, ASetIsItsMaterialsAndAnythingElseIsItself)
{
    const TempFolder folder;
    const std::string path = folder.write("nets.f32", constantNet(1) + constantNet(2));
    folder.write("materials.txt", "merl gold\nrgl foil\n");
    EXPECT_EQ(materialsOf(path + "#rgl"), std::vector<std::string>{path + "#foil"});
    EXPECT_EQ(materialsOf(path + "#gold"), std::vector<std::string>{path + "#gold"});
    EXPECT_EQ(materialsOf(path + "#none"), std::vector<std::string>{path + "#none"});
    EXPECT_EQ(materialsOf("ggx:alpha=0.1"), std::vector<std::string>{"ggx:alpha=0.1"});
    EXPECT_EQ(materialsOf("absent.csv"), std::vector<std::string>{"absent.csv"});
}

TEST(MaterialsOf, EmptyRowsOfNpfTablesAreNoMaterials)
{
    const TempFolder folder;
    std::string bytes = emptyNpf();
    setNpf(bytes, 1, 0, 0.5f);
    const std::string path = folder.write("npf.bin", bytes);
    EXPECT_EQ(materialsOf(path), (std::vector<std::string>{path + "#0", path + "#1"}));
}
