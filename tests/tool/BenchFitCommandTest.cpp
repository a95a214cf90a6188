#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fbrdf::test {
namespace {

const std::vector<std::string> kQuick{"--forms",      "hdio:700",  "--peers",
                                      "npf,analytic", "--plain",   "--smoothness",
                                      "1e-4",         "--threads", "1"};

ToolRun bench(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "bench-fit");
    arguments.insert(arguments.end(), kQuick.begin(), kQuick.end());
    return runTool(arguments);
}

TEST(BenchFitCommand, ComparesFormsAndPeersOnAFunction)
{
    const TemporaryDir folder;
    const auto run = bench({"ward:alpha=0.3", "lambert", "--json", "--csv", folder.file("t.csv")});
    const auto json = jsonFrom(run);
    ASSERT_EQ(json["materials"].size(), 2u);
    const auto ward = json["materials"][0]["scores"];
    ASSERT_EQ(ward.size(), 2u);  // nothing was published for it, so no npf
    EXPECT_EQ(ward[0]["name"], "hdio:700");
    EXPECT_LE(ward[0]["bytes"].get<int>(), 700);
    EXPECT_EQ(ward[0]["lookups"], 2);
    EXPECT_EQ(ward[1]["name"], "analytic");
    EXPECT_TRUE(ward[1]["peer"].get<bool>());
    for (const auto& score : ward) EXPECT_GT(score["errors"]["psnr_linear"].get<double>(), 30.0);
    EXPECT_EQ(json["materials"][1]["scores"].size(), 1u);
    EXPECT_EQ(json["ahead_of_every_peer"]["of"], 1);  // the Lambertian has no peer here
    const auto summary = json["summary"][0];
    EXPECT_EQ(summary["materials"], 2);
    const double a = ward[0]["errors"]["psnr_linear"].get<double>();
    const double b = json["materials"][1]["scores"][0]["errors"]["psnr_linear"].get<double>();
    EXPECT_NEAR(summary["errors"]["psnr_linear"]["mean"].get<double>(), 0.5 * (a + b), 1e-9);
    EXPECT_EQ(summary["errors"]["psnr_linear"]["worst"].get<double>(), std::min(a, b));
    EXPECT_EQ(linesOf(readText(folder.file("t.csv"))).size(), 4u);
}

TEST(BenchFitCommand, HoldsSamplesOutWhereThereIsNoFunction)
{
    const TemporaryDir folder;
    writeText(folder.file("s.csv"), samplesCsv(400));
    const auto scores = jsonFrom(bench({folder.file("s.csv"), "--json"}))["materials"][0]["scores"];
    ASSERT_EQ(scores.size(), 1u);
    EXPECT_FALSE(scores[0]["errors"].contains("psnr_linear"));
    EXPECT_GT(scores[0]["errors"]["log_median"].get<double>(), 0.0);
    EXPECT_LT(scores[0]["errors"]["log_median"].get<double>(), 0.2);
}

TEST(BenchFitCommand, OneBadSourceDoesNotLoseTheOthers)
{
    const auto run = bench({"lambert", "no-such-model"});
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.out.find("hdio:700"), std::string::npos);
    EXPECT_NE(run.out.find("no-such-model"), std::string::npos);
}

TEST(BenchFitCommand, NamesWhatItDoesNotKnow)
{
    expectError(runTool({"bench-fit", "lambert", "--forms", "nothing"}), 2, "nothing");
    expectError(runTool({"bench-fit", "lambert", "--peers", "nobody"}), 2, "nobody");
    expectError(runTool({"bench-fit", "lambert", "--forms", "hdio:0"}), 2, "hdio");
    expectError(runTool({"bench-fit", "lambert", "--forms", "", "--peers", "none"}), 2, "--forms");
}

}  // namespace
}  // namespace fbrdf::test
