#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace fbrdf::test {
namespace {

class ConvertCommand : public testing::Test {
protected:
    std::string material(const std::string& form)
    {
        const std::string path = folder.file(form + ".fbrdf");
        writeMaterial(smallMaterial(form), path);
        return path;
    }
    std::string valuesOf(const std::string& source)
    {
        ToolOptions options;
        options.input = pairsCsv(spreadPairs(50));
        const ToolRun run = runTool({"eval", source, "--pairs", "-"}, options);
        EXPECT_EQ(run.code, 0) << run.err;
        return run.out;
    }
    void convert(const std::string& from, const std::string& to)
    {
        const ToolRun run = runTool({"convert", from, to});
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run.out + run.err, "");
    }

    TemporaryDir folder;
};

TEST_F(ConvertCommand, TheManifestKeepsEveryValue)
{
    const std::string original = material("hdio");
    Material coarse = readMaterial(original);
    for (Table& table : coarse.tables) table = quantized(table, Storage::log8);
    writeMaterial(coarse, original);
    convert(original, folder.file("m.json"));
    convert(folder.file("m.json"), folder.file("back.fbrdf"));
    EXPECT_EQ(valuesOf(folder.file("m.json")), valuesOf(original));
    EXPECT_EQ(valuesOf(folder.file("back.fbrdf")), valuesOf(original));
}

TEST_F(ConvertCommand, TheLayoutOf2001KeepsAProduct)
{
    const std::string original = material("pqp");
    std::filesystem::create_directory(folder.file("w"));
    convert(original, folder.file("w/small.txt"));
    convert(folder.file("w/small.txt"), folder.file("back.fbrdf"));
    const auto before = linesOf(valuesOf(original)),
               after = linesOf(valuesOf(folder.file("back.fbrdf")));
    ASSERT_EQ(before.size(), after.size());
    for (size_t i = 1; i < before.size(); ++i)  // linear 8 bits, and maps resampled to 7/16
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(std::log(numbersOf(after[i])[c] / numbersOf(before[i])[c]), 0.0, 0.25) << i;
}

TEST_F(ConvertCommand, SamplesOfAModelComeBackAsCsv)
{
    const std::string csv = folder.file("lambert.csv");
    convert("lambert:albedo=0.5", csv);
    const auto json = jsonFrom(runTool({"compare", "lambert:albedo=0.5", csv, "--json"}));
    EXPECT_EQ(json["samples"]["set"], "own");
    EXPECT_GT(json["samples"]["used"].get<int>(), 1000);
    EXPECT_LT(json["errors"]["log_rms"].get<double>(), 1e-6);
}

TEST_F(ConvertCommand, AMaterialBecomesAMerlTable)
{
    const std::string merl = folder.file("small.binary");
    convert(material("hdio"), merl);
    EXPECT_EQ(std::filesystem::file_size(merl), 12u + 3u * 8u * 90u * 90u * 180u);
    const auto json = jsonFrom(runTool({"info", merl, "--json"}));
    EXPECT_EQ(json["format"], "merl");
    EXPECT_GT(json["samples"]["below_horizon"].get<int>(), 0);  // cells that are no reflection
}

TEST_F(ConvertCommand, RefusesWhatAFormatCannotHold)
{
    writeText(folder.file("samples.csv"), samplesCsv(20));
    const auto refused = [&](const std::string& from, const std::string& to, const char* words) {
        expectError(runTool({"convert", from, folder.file(to)}), 2, words);
        EXPECT_FALSE(std::filesystem::exists(folder.file(to))) << to;
    };
    refused(material("hdio"), "a.txt", "found form 'hdio'");
    refused("lambert", "b.fbrdf", "found reflectance (model), expected a material");
    refused(folder.file("samples.csv"), "c.json", "found reflectance (csv)");
    refused(folder.file("samples.csv"), "d.binary", "");
    refused("lambert", "e.png", "found extension '.png'");
    refused("lambert", "f", "found extension ''");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"hdio.fbrdf", "samples.csv"}));
}

}  // namespace
}  // namespace fbrdf::test
