#include "Inputs.h"
#include "support/DataDir.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fbrdf::test {
namespace {

TEST(InfoCommand, ListsWhatAMaterialHas)
{
    const TemporaryDir folder;
    Material material = smallMaterial("pqp");
    material.tables[0] = quantized(material.tables[0], Storage::log8);
    material.notes["source"] = "nowhere";
    material.errors["held_out.log_rms"] = 0.25;
    material.errors["psnr_linear"] = 50.0;
    writeMaterial(material, folder.file("m.fbrdf"));
    const auto json = jsonFrom(runTool({"info", folder.file("m.fbrdf"), "--json"}));
    EXPECT_EQ(json["kind"], "material");
    EXPECT_EQ(json["name"], "small");
    EXPECT_EQ(json["form"], "pqp");
    EXPECT_EQ(json["isotropic"], false);
    EXPECT_EQ(json["lookups_per_light"], 2);
    EXPECT_EQ(json["bytes"], 16 * 16 * 3 * (1 + 4));
    ASSERT_EQ(json["tables"].size(), 2u);
    EXPECT_EQ(json["tables"][0]["storage"], "log8");
    EXPECT_EQ(json["tables"][1]["storage"], "float");
    EXPECT_EQ(json["tables"][1]["bytes"], 16 * 16 * 3 * 4);
    EXPECT_EQ(json["tables"][1]["size"], (std::vector<int>{16, 16, 1}));
    EXPECT_NEAR(json["tables"][1]["log2_range"][0][0].get<double>(), -1.5, 1e-3);
    EXPECT_EQ(json["scales"][0], (std::vector<double>{1.0, 0.5, 0.25}));
    EXPECT_EQ(json["units"], "1/sr");
    EXPECT_EQ(json["notes"]["source"], "nowhere");
    EXPECT_EQ(json["errors"]["held_out"]["log_rms"], 0.25);
    EXPECT_EQ(json["errors"]["psnr_linear"], 50.0);
    EXPECT_LT(json["reciprocity"].get<double>(),
              1e-5);  // p(wo) q(h) p(wi) by construction, in float
    EXPECT_EQ(json["directional_albedo"].size(), 7u);
}

TEST(InfoCommand, CountsTheRowsOfAFile)
{
    const TemporaryDir folder;
    const std::string csv = folder.file("mixed.csv");
    writeText(csv, std::string(kSampleHeader) +
                       "\n0,0,1,0.6,0,0.8,1,2,3\n0,0,1,0,0.6,0.8,-0.5,0,1\n"
                       "0,0,1,0,0,1,inf,0,0\n0,0,1,0,0,-1,1,1,1\n0,0,1,0.28,0,0.96,4,5,0.25\n");
    const auto json = jsonFrom(runTool({"info", csv, "--json"}));
    EXPECT_EQ(json["kind"], "data");
    EXPECT_EQ(json["format"], "csv");
    EXPECT_EQ(json["has_function"], false);
    const auto samples = json["samples"];
    EXPECT_EQ(samples["given"], 5);
    EXPECT_EQ(samples["usable"], 3);
    EXPECT_EQ(samples["invalid"], 2);
    EXPECT_EQ(samples["non_finite"], 1);
    EXPECT_EQ(samples["below_horizon"], 1);
    EXPECT_EQ(samples["negative"], 1);
    EXPECT_EQ(samples["least"], (std::vector<double>{-0.5, 0.0, 0.25}));
    EXPECT_EQ(samples["most"], (std::vector<double>{4.0, 5.0, 3.0}));
    EXPECT_FALSE(json.contains("directional_albedo"));
}

// Pairs and their exchanges, the second twice as bright.
TEST(InfoCommand, FindsTheReciprocityErrorOfSamples)
{
    const TemporaryDir folder;
    const std::string csv = folder.file("both.csv");
    std::string rows = std::string(kSampleHeader) + "\n";
    for (const auto& pair : spreadPairs(60))
        rows += pairText(pair) + ",0.1,0.1,0.1\n" + pairText({pair.wi, pair.wo}) + ",0.2,0.2,0.2\n";
    writeText(csv, rows);
    const auto json = jsonFrom(runTool({"info", csv, "--json"}));
    EXPECT_NEAR(json["reciprocity"].get<double>(), std::log(2.0), 1e-6);
    writeText(csv, std::string(kSampleHeader) + "\n0,0,1,0.6,0,0.8,1,1,1\n0,0,1,0,0.6,0.8,1,1,1\n");
    const auto none = jsonFrom(runTool({"info", csv, "--json"}));
    EXPECT_TRUE(none["reciprocity"].is_null());
    EXPECT_EQ(none["reciprocity_note"], "no pair was measured both ways");
}

// Exchanged pairs that differ by up to 1.7 degrees: the finer the cells, the more of them lie on
// both sides of a border.
TEST(InfoCommand, FindsExchangedPairsAtAnyDistance)
{
    const TemporaryDir folder;
    const std::string csv = folder.file("near.csv");
    std::string rows = "theta_i,phi_i,theta_o,phi_o,value\n";
    constexpr int kPairs = 240;
    for (int i = 0; i < kPairs; ++i) {
        const double apart = std::array<double, 4>{0.01, 0.1, 0.5, 1.7}[size_t(i) % 4];
        const auto angles = [&](double thetaI, double phiI, double thetaO, double phiO, int value) {
            rows += fmt::format("{},{},{},{},{}\n", thetaI, phiI, thetaO, phiO, value);
        };
        const double thetaI = 5.0 + i * 7 % 31, phiI = i * 37 % 360, thetaO = 40.0 + i * 11 % 37,
                     phiO = i * 101 % 360;
        angles(thetaI, phiI, thetaO, phiO, 1);
        angles(thetaO, phiO, thetaI + apart, phiI, 2);
    }
    writeText(csv, rows);
    const auto json = jsonFrom(runTool({"info", csv, "--json"}));
    EXPECT_NEAR(json["reciprocity"].get<double>(), std::log(2.0), 1e-6);
    EXPECT_EQ(json["reciprocity_note"].get<std::string>(),
              "over 480 of 480 samples, those measured both ways within 2 degrees");
}

// Every pair of a scan lies in a few degrees, each sample near thousands of others.
TEST(InfoCommand, FindsTheReciprocityErrorOfAScanOfAFewDegrees)
{
    const TemporaryDir folder;
    const std::string csv = folder.file("scan.csv");
    std::string rows = "theta_i,phi_i,theta_o,phi_o,value\n";
    for (int i = 0; i < 20000; ++i) {
        const double a = 30.0 + 0.0001 * (i * 7919 % 20000),
                     b = 30.0 + 0.0001 * (i * 104729 % 20000);
        // ln f(a, b) / f(b, a) = 0.2 (b - a), known for every pair.
        rows += fmt::format("{},0,{},180,{}\n", a, b, std::exp(0.1 * (b - a)));
    }
    writeText(csv, rows);
    const auto json = jsonFrom(runTool({"info", csv, "--json"}));
    // The median of |b - a| of two even numbers in [0, 2] is 2 - sqrt 2.
    EXPECT_NEAR(json["reciprocity"].get<double>(), 0.2 * (2.0 - std::sqrt(2.0)), 0.01);
    EXPECT_EQ(json["assumptions"],
              (std::vector<std::string>{"angles in degrees", "one channel as grey"}));
}

TEST(InfoCommand, KnowsTheAlbedoOfAModel)
{
    const auto json = jsonFrom(runTool({"info", "lambert:albedo=0.5/0.25/1", "--json"}));
    EXPECT_EQ(json["format"], "model");
    EXPECT_EQ(json["has_function"], true);
    EXPECT_EQ(json["isotropic"], true);
    EXPECT_FALSE(json.contains("samples"));
    for (const auto& row : json["directional_albedo"]) {
        EXPECT_NEAR(row["rgb"][0].get<double>(), 0.5, 1e-3) << row["theta_i_degrees"];
        EXPECT_NEAR(row["rgb"][1].get<double>(), 0.25, 1e-3);
        EXPECT_NEAR(row["rgb"][2].get<double>(), 1.0, 2e-3);
    }
}

TEST(InfoCommand, PrintsWhatAReciprocalFormCanReach)
{
    FBRDF_NEEDS_DATA("rgl_iso_rgb/paper_white_rgb.bsdf");
    const std::string file = test::dataPath("rgl_iso_rgb/paper_white_rgb.bsdf");
    const auto json = jsonFrom(runTool({"info", file, "--json"}));
    EXPECT_GT(json["reciprocity"].get<double>(), 0.01);
    EXPECT_NEAR(json["reciprocal_psnr"].get<double>(), 35.9, 0.1);
    EXPECT_TRUE(jsonFrom(runTool({"info", "lambert", "--json"}))["reciprocal_psnr"].is_null());
}

TEST(InfoCommand, PrintsWhatAFormThatIsItsOwnMirrorImageCanReach)
{
    FBRDF_NEEDS_DATA("nbrdf/nbrdf_weights.f32");
    const std::string grease = test::dataPath("nbrdf/nbrdf_weights.f32") + "#grease-covered-steel";
    const auto json = jsonFrom(runTool({"info", grease, "--json"}));
    EXPECT_GT(json["mirror"].get<double>(), 0.1);
    EXPECT_GT(json["mirror_psnr"].get<double>(), 34.0);
    EXPECT_LT(json["mirror_psnr"].get<double>(), 38.0);
    const auto lambert = jsonFrom(runTool({"info", "lambert", "--json"}));
    EXPECT_EQ(lambert["mirror"], 0.0);
    EXPECT_TRUE(lambert["mirror_psnr"].is_null());
    const auto brushed = jsonFrom(runTool({"info", "ward-rolled-brass", "--json"}));
    EXPECT_TRUE(brushed["mirror"].is_null()) << "an anisotropic one has no such plane";
}

TEST(InfoCommand, TheTextIsForPeople)
{
    const TemporaryDir folder;
    writeMaterial(smallMaterial("hdio"), folder.file("m.fbrdf"));
    const ToolRun run = runTool({"info", folder.file("m.fbrdf")});
    EXPECT_EQ(run.code, 0);
    for (const char* words :
         {"material small", "hdio", "T1", "T2", "12x6", "symmetric", "directional albedo", "1/sr"})
        EXPECT_NE(run.out.find(words), std::string::npos) << words;
    for (const std::string& line : linesOf(run.out))
        EXPECT_TRUE(line.empty() || line.back() != ' ') << "'" << line << "'";
}

TEST(InfoCommand, ReportsColoursOutOfGamut)
{
    FBRDF_NEEDS_DATA("cornell_pbrt2/mystique.brdf");
    const auto json =
        jsonFrom(runTool({"info", dataPath("cornell_pbrt2/mystique.brdf"), "--json"}));
    EXPECT_EQ(json["samples"]["given"], 1439);
    EXPECT_GT(json["samples"]["out_of_gamut"].get<int>(), 0);
    EXPECT_GT(json["reciprocity"].get<double>(), 0.05);  // a measurement, not a formula
}

}  // namespace
}  // namespace fbrdf::test
