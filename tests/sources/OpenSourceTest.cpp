// What openSource does before a reader is chosen: files against models, and files that are none.
#include "ReaderTest.h"

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
