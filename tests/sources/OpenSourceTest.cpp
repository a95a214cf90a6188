// What openSource does before a reader is chosen: files against models, and files that are none.
#include "ReaderTest.h"

#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/OpenSource.h>
#include "support/DataDir.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <random>
#include <thread>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

const std::string kCsv = "theta_i,phi_i,theta_o,phi_o,value\n0,0,0,0,1\n";

}  // namespace

TEST(OpenSource, MissingFilesAreInputErrors)
{
    expectInputError("/nowhere/at/all.csv", "no such file");
    expectInputError("missing.csv", "no such file");
    expectInputError("./missing", "no such file");
}

TEST(OpenSource, EmptyFilesAreInputErrors)
{
    const TempFolder folder;
    expectInputError(folder.write("a.csv", ""), "empty file");
    expectInputError(folder.write("a.binary", ""), "empty file");
}

TEST(OpenSource, DirectoriesAndDevicesAreInputErrors)
{
    const TempFolder folder;
    expectInputError(folder.path(""), "directory");
    expectInputError("/dev/zero", "device");
}

TEST(OpenSource, BinaryGarbageIsAnInputError)
{
    const TempFolder folder;
    std::mt19937 random(1);
    for (const char* name : {"a", "a.csv", "a.brdf", "a.binary", "a.bsdf", "a.txt", "a.bin",
                             "a.xml", "a.exr", "a.f32", "a.fbrdf", "a.dat", "a.astm"}) {
        std::string bytes(4096, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        const Outcome outcome = outcomeOf(folder.write(name, bytes));
        EXPECT_EQ(outcome.kind, int(ErrorKind::input)) << name << ' ' << outcome.message;
        EXPECT_NE(outcome.message.find(name), std::string::npos) << outcome.message;
    }
}

TEST(OpenSource, TextOfNoFormatIsAnInputError)
{
    const TempFolder folder;
    expectInputError(folder.write("letter.txt", "Dear reader,\nthis is not a BRDF.\n"), "letter");
}

TEST(OpenSource, AFileOfNoFormatIsDescribed)
{
    const TempFolder folder;
    const std::string lightTools =
        "# own\nSymmetry Isotropic\nAOI 0 30\nPOI 0\nSide Front\n0.1 0.1\n";
    const std::string path = folder.write("a.bsdf", lightTools);
    expectInputError(path, "text, 59 bytes that start with '# own'");
    expectInputError(path, "resembles LightTools' BSDF");
    expectInputError(path,
                     "as .bsdf it could be rgl (binary that starts with tensor_file) or fourier");
    expectInputError(folder.write("a.brdf", "Dear reader\n"),
                     "as .brdf it could be speos (text with the title");
    expectInputError(folder.write("a.dat", "a letter\n"), "as .dat it could be mit-aniso");
    expectInputError(folder.write("a.csv", std::string("PK\x03\x04\0\0", 6)),
                     "a spreadsheet (.xlsx)");
    expectInputError(folder.write("a", "<html></html>"), "resembles a web page");
}

TEST(OpenSource, UnreadableFilesAreInputErrors)
{
    const TempFolder folder;
    const std::string path = folder.write("secret.csv", kCsv);
    ::chmod(path.c_str(), 0);
    if (::access(path.c_str(), R_OK) == 0) GTEST_SKIP() << "needs a user who is not root";
    expectInputError(path, "Permission denied");
}

TEST(OpenSource, AChoiceNeedsAFormatThatHasSeveral)
{
    const TempFolder folder;
    const std::string path = folder.write("one.csv", kCsv);
    const Outcome outcome = outcomeOf(path + "@0.5");
    EXPECT_EQ(outcome.kind, int(ErrorKind::usage));
    EXPECT_NE(outcome.message.find("one data set"), std::string::npos) << outcome.message;
}

TEST(OpenSource, FileNamesMayHoldTheMarksOfAChoice)
{
    const TempFolder folder;
    EXPECT_EQ(openSource(folder.write("a@b#c.csv", kCsv)).samples.size(), 1u);
}

TEST(OpenSource, ContentGoesBeforeExtension)
{
    const TempFolder folder;
    EXPECT_EQ(openSource(folder.write("a.brdf", kCsv)).format, "csv");
    EXPECT_EQ(openSource(folder.write("a", kCsv)).format, "csv");
}

TEST(OpenSource, ReadsFromAPipe)
{
    const TempFolder folder;
    const std::string path = folder.path("pipe");
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::thread writer([&] {
        const int descriptor = ::open(path.c_str(), O_WRONLY);
        EXPECT_EQ(::write(descriptor, kCsv.data(), kCsv.size()), ssize_t(kCsv.size()));
        ::close(descriptor);
    });
    const Source source = openSource(path);
    writer.join();
    EXPECT_EQ(source.samples.size(), 1u);
}

TEST(OpenSource, UnknownModelsAreUsageErrors)
{
    EXPECT_EQ(outcomeOf("no-such-model:alpha=1").kind, int(ErrorKind::usage));
    EXPECT_EQ(outcomeOf("").kind, int(ErrorKind::usage));
}

TEST(OpenSource, MaterialsAreSourcesThatEvaluate)
{
    Material material;
    material.form = formHdio({8, 6, 4});
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        for (int i = 0; i < 3 * texelCount(spec.domain); ++i)
            table.texels.push_back(0.25f * float(i % 7));
        material.tables.push_back(table);
    }
    material.scales = {Vec3f(0.5f, 1.0f, 2.0f)};
    const TempFolder folder;
    writeMaterial(material, folder.path("paint.fbrdf"));
    const Source source = openSource(folder.path("paint.fbrdf"));
    EXPECT_EQ(source.format, "material");
    EXPECT_TRUE(source.isotropic);
    EXPECT_FALSE(hasSamples(source));
    const Vec3d wo(0.0, 0.6, 0.8), wi(0.6, 0.0, 0.8);
    EXPECT_LT(glm::length(source.evaluate(wo, wi) - evaluate<double>(material, wo, wi)), 1e-12);
}

TEST(OpenSource, ReadsThe2001MapsFromTheirTextOrTheirFolder)
{
    FBRDF_NEEDS_DATA("waterloo_hf/garnetred/garnetred64.txt");
    const Source maps = openSource(dataPath("waterloo_hf/garnetred/garnetred64.txt"));
    EXPECT_EQ(maps.format, "material");
    EXPECT_GT(maps.evaluate({0, 0, 1}, {0, 0, 1}).x, 0.0);
    expectSound(openSource(dataPath("waterloo_hf/satin")));
}

TEST(OpenSource, ModelsAreSourcesThatEvaluate)
{
    const Source model = openSource("lambert:albedo=0.5");
    EXPECT_NEAR(model.evaluate({0, 0, 1}, {0.6, 0, 0.8}).x, 0.5 / kPi, 1e-12);
    EXPECT_TRUE(model.isotropic);
}
