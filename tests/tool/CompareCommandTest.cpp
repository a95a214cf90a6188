#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::test {
namespace {

// The metrics take values as float, so that equality ends at 1e-6.
constexpr double kFloat = 1e-6;

TEST(CompareCommand, AFunctionAgainstItselfHasNoError)
{
    const auto json = jsonFrom(runTool({"compare", "ggx:alpha=0.3", "ggx:alpha=0.3", "--json"}));
    const auto errors = json["errors"];
    for (const char* name :
         {"log_rms", "log_median", "cos_rms", "cuberoot_rms", "nbrdf_loss", "delta_e_itp", "flip"})
        EXPECT_LT(errors[name].get<double>(), kFloat) << name;
    EXPECT_EQ(errors["psnr_linear"], 999.0);  // instead of infinity
    EXPECT_EQ(errors["psnr_srgb"], 999.0);
    EXPECT_NEAR(errors["ssim"].get<double>(), 1.0, kFloat);
    EXPECT_LT(errors["reciprocity"].get<double>(), kFloat);
    EXPECT_EQ(json["samples"]["set"], "uniform");
    EXPECT_EQ(json["samples"]["used"], 65536);
}

TEST(CompareCommand, LightsFromAnEnvironment)
{
    const TemporaryDir folder;
    writeText(folder.file("sky.hdr"), smallSky());
    const auto psnr = [&](const std::string& tested) {
        return jsonFrom(runTool({"compare", tested, "lambert:albedo=0.5", "--environment",
                                 folder.file("sky.hdr"), "--environment-size", "8",
                                 "--json"}))["environment"]["psnr"]
            .get<double>();
    };
    // A face of the cosine level has 8 x 8 texels, which are good for about 40 dB.
    EXPECT_GT(psnr("lambert:albedo=0.5"), 36.0);
    EXPECT_LT(psnr("lambert:albedo=0.25"), 20.0);
}

TEST(CompareCommand, TwiceAsBrightIsAKnownError)
{
    const auto errors = jsonFrom(
        runTool({"compare", "lambert:albedo=0.5", "lambert:albedo=0.25", "--json"}))["errors"];
    EXPECT_NEAR(errors["log_rms"].get<double>(), std::log(2.0), kFloat);
    EXPECT_NEAR(errors["log_median"].get<double>(), std::log(2.0), kFloat);
    for (const auto& channel : errors["log_median_rgb"])
        EXPECT_NEAR(channel.get<double>(), std::log(2.0), kFloat);
    EXPECT_NEAR(errors["cos_rms"].get<double>(), 1.0, kFloat);
    EXPECT_NEAR(errors["cuberoot_rms"].get<double>(), std::cbrt(2.0) - 1.0, kFloat);
    EXPECT_NEAR(errors["albedo_max"].get<double>(), 0.5, 1e-3);  // quadrature
    EXPECT_LT(errors["psnr_linear"].get<double>(), 20.0);
}

TEST(CompareCommand, TheReferencesOwnSamplesAreUsed)
{
    const TemporaryDir folder;
    const std::string csv = folder.file("lambert.csv");
    std::string rows = std::string(kSampleHeader) + "\n";
    for (const auto& pair : spreadPairs(100)) rows += pairText(pair) + ",0.1,0.2,0.4\n";
    writeText(csv, rows);
    const auto json =
        jsonFrom(runTool({"compare", "lambert:albedo=0.6283185307", csv, "--json"}));  // f = 0.2
    EXPECT_EQ(json["samples"]["set"], "own");
    EXPECT_EQ(json["samples"]["used"], 100);
    const auto median = json["errors"]["log_median_rgb"];
    EXPECT_NEAR(median[0].get<double>(), std::log(2.0), kFloat);
    EXPECT_NEAR(median[1].get<double>(), 0.0, kFloat);
    EXPECT_NEAR(median[2].get<double>(), std::log(2.0), kFloat);
    EXPECT_FALSE(json["errors"].contains("psnr_linear"));  // samples make no picture
}

TEST(CompareCommand, MaterialsAreEvaluatedAsStored)
{
    const TemporaryDir folder;
    const std::string path = folder.file("small.fbrdf");
    Material material = smallMaterial("hdio");
    writeMaterial(material, path);
    const auto same = jsonFrom(runTool({"compare", path, path, "--json"}))["errors"];
    EXPECT_EQ(same["log_rms"], 0.0);
    for (Table& table : material.tables) table = quantized(table, Storage::log8);
    const std::string coarse = folder.file("coarse.fbrdf");
    writeMaterial(material, coarse);
    const auto rounded = jsonFrom(runTool({"compare", coarse, path, "--json"}))["errors"];
    EXPECT_GT(rounded["log_rms"].get<double>(), 0.0);
    EXPECT_LT(rounded["log_rms"].get<double>(), 0.05);
}

TEST(CompareCommand, TheTextNamesEveryError)
{
    const ToolRun run = runTool({"compare", "lambert", "lambert:albedo=0.4"});
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, "");
    for (const char* name :
         {"log_rms", "log_median", "cos_rms", "cuberoot_rms", "nbrdf_loss", "psnr_linear",
          "psnr_srgb", "ssim", "delta_e_itp", "flip", "reciprocity", "albedo_max", "65,536"})
        EXPECT_NE(run.out.find(name), std::string::npos) << name;
}

TEST(CompareCommand, ScatteredSamplesCannotBeTested)
{
    const TemporaryDir folder;
    writeText(folder.file("a.csv"), samplesCsv(20));
    expectError(runTool({"compare", folder.file("a.csv"), "lambert"}), 3,
                "found scattered samples");
}

}  // namespace
}  // namespace fbrdf::test
