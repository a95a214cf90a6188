// Whatever it is given, the tool answers with the exit code, one clear line, and no output file.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <filesystem>

namespace fbrdf::test {
namespace {

std::string rows(const std::string& row, int count)
{
    std::string text = std::string(kSampleHeader) + "\n";
    for (int i = 0; i < count; ++i) text += row + "\n";
    return text;
}

// Bytes of every value in no order that means anything (a linear congruential generator).
std::string garbage(size_t count)
{
    std::string bytes;
    uint32_t state = 12345;
    for (size_t i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        bytes += static_cast<char>(state >> 24);
    }
    return bytes;
}

struct BadFile {
    const char* name;  ///< of the file, and of the test with '_' for '.'
    std::string content;
    int code;
    const char* words;
};

std::vector<BadFile> badFiles()
{
    return {{"empty.csv", "", 3, "empty"},
            {"empty.fbrdf", "", 3, "empty"},
            {"header.csv", rows("", 0), 3, "no usable sample"},
            {"garbage.csv", garbage(4096), 3, "garbage.csv"},
            {"garbage.fbrdf", garbage(4096), 3, "garbage.fbrdf"},
            {"garbage.binary", garbage(4096), 3, "garbage.binary"},
            {"garbage.bsdf", garbage(4096), 3, "garbage.bsdf"},
            {"unknown.xyz", garbage(4096), 3, "unknown format"},
            {"zeros.binary", std::string(64, '\0'), 3, "zeros.binary"},
            {"truncated.csv", samplesCsv(20).substr(0, 900), 3, "truncated.csv:"},
            {"text.csv", "this is not a table\n", 3, "text.csv:1"},
            {"nan.csv", rows("0,0,1,0.6,0,0.8,nan,nan,nan", 20), 3, "20 not finite"},
            {"zero.csv", rows("0,0,1,0.6,0,0.8,0,0,0", 20), 4, "20, of which 0 have a value above"},
            {"negative.csv", rows("0,0,1,0.6,0,0.8,-1,-1,-1", 20), 4,
             "20, of which 0 have a value above"},
            {"one.csv", rows("0,0,1,0.6,0,0.8,1,1,1", 1), 4, "found 1, of which 1"},
            {"below.csv", rows("0,0,-1,0.6,0,0.8,1,1,1", 20), 3, "20 below the horizon"}};
}

class BadFileTest : public testing::TestWithParam<BadFile> {};

TEST_P(BadFileTest, IsRefusedInOneLineAndLeavesNothing)
{
    const TemporaryDir folder;
    const std::string path = folder.file(GetParam().name);
    writeText(path, GetParam().content);
    expectError(runTool({"fit", path, "-o", folder.file("out.fbrdf")}), GetParam().code,
                GetParam().words);
    EXPECT_EQ(folder.names(), std::vector<std::string>{GetParam().name});
}

std::string testName(const testing::TestParamInfo<BadFile>& file)
{
    std::string name = file.param.name;
    for (char& c : name)
        if (c == '.') c = '_';
    return name;
}
INSTANTIATE_TEST_SUITE_P(Fit, BadFileTest, testing::ValuesIn(badFiles()), testName);

class BadArguments : public testing::Test {
protected:
    void refused(std::vector<std::string> arguments, int code, const std::string& words)
    {
        expectError(runTool(arguments), code, words);
        EXPECT_EQ(folder.names(), std::vector<std::string>());
    }
    void refusedOption(const std::string& option, const std::string& value, const char* words)
    {
        refused({"fit", "lambert", "-o", output, option, value}, 2, words);
    }

    TemporaryDir folder;
    const std::string output = folder.file("out.fbrdf");
};

TEST_F(BadArguments, SourcesThatDoNotExist)
{
    refused({"fit", folder.file("none.csv"), "-o", output}, 3, "found no such file");
    refused({"fit", "nomodel", "-o", output}, 2, "found 'nomodel'");
    refused({"fit", "", "-o", output}, 2, "expected a file");
    refused({"fit", folder.file("").substr(0, folder.file("").size() - 1), "-o", output}, 3,
            "director");
    refused({"info", "no/such/file.csv"}, 3, "found no such file");
    refused({"compare", "lambert", "nomodel"}, 2, "found 'nomodel'");
    refused({"convert", "no/such/file.csv", folder.file("a.csv")}, 3, "found no such file");
    refused({"eval", "lambert", "--pairs", "no/such/file.csv"}, 3, "cannot be read");
    refused({"eval", "lambert", "--pairs", "/"}, 3, "cannot be read");
}

TEST_F(BadArguments, ParametersOutOfRange)
{
    refused({"fit", "ggx:alpha=7", "-o", output}, 2, "found alpha=7");
    refused({"fit", "ggx:alpha=nan", "-o", output}, 2, "alpha");
    refused({"fit", "ggx:alpha=soft", "-o", output}, 2, "alpha='soft'");
    refused({"fit", "ggx:gloss=1", "-o", output}, 2, "'gloss'");
    refused({"fit", "lambert:albedo=0.5/0.5", "-o", output}, 2, "albedo");
    refused({"info", "lambert:albedo=-1"}, 2, "albedo");
}

TEST_F(BadArguments, OptionsOutOfRange)
{
    refusedOption("--form", "nothing", "found 'nothing'");
    refusedOption("--resolution", "0", "--resolution: found '0'");
    refusedOption("--resolution", "many", "--resolution: found 'many'");
    refusedOption("--max-bytes", "-1", "--max-bytes: found '-1'");
    refusedOption("--max-bytes", "2", "max-bytes");
    refusedOption("--lookups", "0", "--lookups: found '0'");
    refusedOption("--storage", "log9", "found 'log9'");
    refusedOption("--metric", "sum", "found 'sum'");
    refusedOption("--smoothness", "0", "--smoothness: found '0'");
    refusedOption("--smoothness", "-2", "--smoothness: found '-2'");
    refusedOption("--smoothness", "inf", "--smoothness: found 'inf'");
    refusedOption("--seed", "1.5", "--seed: found '1.5'");
    refusedOption("--threads", "99999999999999999999", "--threads: found");
}

TEST_F(BadArguments, CommandLinesThatDoNotParse)
{
    refused({}, 2, "command line: found no command, expected one of fit, eval");
    refused({"fix"}, 2, "command line: found 'fix'");
    refused({"--bogus"}, 2, "command line: found '--bogus'");
    refused({"fit"}, 2, "fit: found no SOURCE");
    refused({"fit", "lambert"}, 2, "fit: found no --output");
    refused({"fit", "lambert", "-o"}, 2, "fit: found --output alone");
    refused({"fit", "lambert", "-o", output, "-o", output}, 2, "fit: found --output again");
    refused({"fit", "lambert", "-o", output, "--bogus"}, 2, "fit: found '--bogus'");
    refused({"eval", "lambert"}, 2, "eval: found no --pairs");
    refused({"compare", "lambert"}, 2, "compare: found no B");
    refused({"forms", "extra"}, 2, "forms: found 'extra'");
}

TEST_F(BadArguments, OutputsThatCannotBeWritten)
{
    const auto refusedAt = [&](const std::string& path, int code, const char* words) {
        refused({"fit", "lambert", "-o", path}, code, words);
    };
    refusedAt(folder.file("none/out.fbrdf"), 5, "none/out.fbrdf: cannot be written");
    refusedAt("/dev/full", 5, "/dev/full: found a device");
    refusedAt("/dev/null", 5, "/dev/null: found a device");
    refusedAt(folder.file(""), 5, "found a folder");
    refusedAt("/proc/out.fbrdf", 5, "/proc/out.fbrdf: cannot be written");
    refusedAt(folder.file("out.png"), 2, "found extension '.png'");
    refused({"fit", "lambert", "-o", output, "--report", folder.file("none/r.html")}, 5,
            "none/r.html");
    refused({"fit", "lambert", "-o", output, "--report", "/dev/null"}, 5,
            "/dev/null: found a device");
    refused({"fit", "lambert", "-o", "/dev/stdout"}, 5, "/dev/stdout: found a stream");
    refused({"convert", "lambert", folder.file("none/a.csv")}, 5, "none/a.csv");
    refused({"convert", "lambert", "/dev/full"}, 5, "/dev/full");
}

TEST_F(BadArguments, NoFileIsReplacedByAFailure)
{
    writeText(output, "precious");
    EXPECT_EQ(runTool({"fit", "ggx:alpha=7", "-o", output}).code, 2);
    EXPECT_EQ(runTool({"convert", "lambert", output}).code, 2);
    EXPECT_EQ(readText(output), "precious");
}

TEST_F(BadArguments, MessagesAreOneLineWhateverAFileIsCalled)
{
    expectError(runTool({"info", "two\nlines\x1b[31m.csv"}), 3, "two?lines?[31m.csv");
}

TEST(BadMaterial, TruncatedAnywhereIsRefused)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    writeMaterial(smallMaterial("hdio"), path);
    const std::string whole = readText(path);
    for (const double share : {0.1, 0.5, 0.9, 0.999}) {
        writeText(path, whole.substr(0, static_cast<size_t>(share * double(whole.size()))));
        expectError(runTool({"info", path}), 3, path);
    }
}

}  // namespace
}  // namespace fbrdf::test
