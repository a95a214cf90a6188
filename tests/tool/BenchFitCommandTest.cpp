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

TEST(BenchFitCommand, ComparesLobesWithTheSplitSum)
{
    const TemporaryDir folder;
    writeText(folder.file("sky.hdr"), smallSky());
    writeText(folder.file("notes.txt"), "no environment");
    const std::vector<std::string> command{
        "bench-fit", "--environment",       folder.file("."), "--environment-size",
        "8",         "ggx:alpha=0.4,kd=0.2"};
    auto asJson = command;
    asJson.push_back("--json");
    const auto json = jsonFrom(runTool(asJson));
    EXPECT_EQ(json["environments"], std::vector<std::string>{"sky"});
    const auto ways = json["materials"][0]["ways"];
    ASSERT_EQ(ways.size(), 5u);
    EXPECT_EQ(ways[4]["name"], "64 directions");
    EXPECT_GT(ways[4]["mean"].get<double>(), 35.0);
    EXPECT_EQ(ways[0]["name"], "split sum");
    for (size_t k = 1; k < 4; ++k) {
        EXPECT_EQ(ways[k]["name"], "K = " + std::to_string(k));
        EXPECT_GT(ways[k]["mean"].get<double>(), 35.0);
        EXPECT_GE(ways[k]["mean"].get<double>(), ways[k]["worst"].get<double>());
    }
    const ToolRun text = runTool(command);
    EXPECT_EQ(text.code, 0);
    EXPECT_NE(text.out.find("smallest lead over the split sum"), std::string::npos) << text.out;
}

TEST(BenchFitCommand, ComparesTheVarianceOfDirectionsWithThatOfGgx)
{
    const std::vector<std::string> command{"ward:alpha=0.3", "nothing-there", "--sampling"};
    auto asJson = command;
    asJson.push_back("--json");
    const ToolRun run = bench(asJson);
    EXPECT_EQ(run.code, 1);  // one cannot be read
    const auto json = nlohmann::json::parse(run.out);
    const auto ward = json["materials"][0];
    EXPECT_GT(ward["deviation"].get<double>(), 0.01);
    EXPECT_GE(ward["ggx_deviation"].get<double>(), ward["ggx_deviation_free_shares"].get<double>());
    EXPECT_EQ(json["lower"].get<int>(), ward["deviation"] < ward["ggx_deviation"] ? 1 : 0);
    EXPECT_NE(json["materials"][1]["error"].get<std::string>().find("nothing-there"),
              std::string::npos);
    const ToolRun text = bench(command);
    EXPECT_NE(text.out.find("of 2\n"), std::string::npos) << text.out;
}

TEST(BenchFitCommand, EnvironmentsHaveToBeThere)
{
    const TemporaryDir folder;
    expectError(runTool({"bench-fit", "--environment", folder.file("."), "lambert"}), 3,
                "expected a folder of .exr or .hdr files");
    expectError(runTool({"bench-fit", "--environment", folder.file("none"), "lambert"}), 3,
                "no such folder");
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
    // A row for every contender: header, 2 x 3.
    EXPECT_EQ(linesOf(readText(folder.file("t.csv"))).size(), 7u);
}

TEST(BenchFitCommand, ComparesSingularValuesAndWrittenFactorsAsForms)
{
    const auto json =
        jsonFrom(runTool({"bench-fit", "ward:alpha=0.4", "ggx:alpha=0.4", "--json", "--forms",
                          "svd2,svd:2600,analytic", "--peers", "none", "--threads", "1"}));
    const auto ward = json["materials"][0]["scores"], ggx = json["materials"][1]["scores"];
    ASSERT_EQ(ward.size(), 3u);
    EXPECT_EQ(ward[0]["bytes"], 2496);
    EXPECT_EQ(ward[1]["bytes"], 2496);  // as many terms as the budget allows
    EXPECT_EQ(ward[0]["lookups"], 4);
    EXPECT_EQ(ward[2]["lookups"], 1);
    EXPECT_GT(ward[2]["errors"]["psnr_linear"].get<double>(), 55.0);
    EXPECT_EQ(ggx.size(), 2u);  // it has no row, because its factors are not known
    expectError(runTool({"bench-fit", "lambert", "--forms", "svd77"}), 2, "svd77");
}

TEST(BenchFitCommand, PrintsWhatWorseDataCost)
{
    const auto run = runTool(
        {"bench-fit", "--robustness", "ggx:alpha=0.4,kd=0.2", "--forms", "hdio:1400", "--json"});
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(json["materials"].size(), 1u);
    EXPECT_GT(json["materials"][0]["clean"].get<double>(), 45.0);
    const auto lost = json["means"][0]["lost"];
    EXPECT_EQ(lost["noise"]["may_lose"], 4.0);
    bool holds = true;
    for (const auto& [name, loss] : lost.items())
        holds = holds && loss["mean"].get<double>() <= loss["may_lose"].get<double>();
    EXPECT_EQ(json["holds"].get<bool>(), holds);
    EXPECT_EQ(run.code, holds ? 0 : 1);  // a check that was asked for
    expectError(runTool({"bench-fit", "--robustness", "lambert", "--forms", "analytic"}), 2,
                "analytic");
}

TEST(BenchFitCommand, GoesOnFromTheTableOfAnEarlierRun)
{
    const TemporaryDir folder;
    const std::string csv = folder.file("t.csv");
    const std::string ward = "ward:alpha=0.3,rho_s=0.2";  // a comma inside a field
    const auto first = jsonFrom(bench({ward, "--json", "--csv", csv}))["materials"][0]["scores"];
    // A number that no fit gives shows that the row was kept and not made again.
    std::string table = readText(csv);
    const std::string bytes = "," + first[0]["bytes"].dump() + ",";
    ASSERT_NE(table.find(bytes), std::string::npos);
    table.replace(table.find(bytes), bytes.size(), ",12345,");
    writeText(csv, table);
    const auto both = jsonFrom(bench({ward, "lambert", "--json", "--csv", csv, "--resume"}));
    ASSERT_EQ(both["materials"].size(), 2u);
    const auto kept = both["materials"][0]["scores"];
    ASSERT_EQ(kept.size(), first.size());
    EXPECT_EQ(kept[0]["bytes"], 12345);
    for (size_t i = 0; i < kept.size(); ++i)
        for (const auto& [name, value] : first[i]["errors"].items()) {
            if (!value.is_number()) continue;
            const double before = value.get<double>();
            EXPECT_NEAR(kept[i]["errors"][name].get<double>(), before, 1e-5 * std::abs(before));
        }
    // Another contender: nothing of the table answers for it.
    const auto again =
        jsonFrom(runTool({"bench-fit", ward, "--json", "--csv", csv, "--resume", "--forms",
                          "hdio:600", "--peers", "npf", "--plain", "--smoothness", "1e-4"}));
    EXPECT_NE(again["materials"][0]["scores"][0]["bytes"], 12345);
    expectError(bench({ward, "--resume"}), 2, "--resume");
    writeText(csv, "something,else\n");
    expectError(bench({ward, "--csv", csv, "--resume"}), 3, "t.csv");
}

TEST(BenchFitCommand, LeavesSamplesOutWhereThereIsNoFunction)
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
