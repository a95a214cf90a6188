// SampleCommandTest.cpp - fbrdf sample and fbrdf pdf: they agree with each other, and estimates
// from them with what the tool says elsewhere.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::test {
namespace {

const std::string kModel = "ggx:alpha=0.3,kd=0.2";

std::vector<std::vector<double>> samplesOf(const std::string& source, const std::string& wo,
                                           const std::string& count, const std::string& seed = "1")
{
    const ToolRun run = runTool({"sample", source, "--wo", wo, "--count", count, "--seed", seed});
    EXPECT_EQ(run.code, 0) << run.err;
    const auto lines = linesOf(run.out);
    EXPECT_EQ(lines.at(0), "wi_x,wi_y,wi_z,pdf,r,g,b");
    std::vector<std::vector<double>> rows;
    for (size_t i = 1; i < lines.size(); ++i) rows.push_back(numbersOf(lines[i]));
    return rows;
}

TEST(SampleCommand, PdfSaysTheDensityOfWhatItDraws)
{
    const TemporaryDir folder;
    const auto rows = samplesOf(kModel, "0.5,0.2,1", "50");
    ASSERT_EQ(rows.size(), 50u);
    std::string pairs = std::string(kPairHeader) + "\n";
    for (const auto& row : rows)
        pairs += "0.5,0.2,1," + fixedText(row[0]) + "," + fixedText(row[1]) + "," +
                 fixedText(row[2]) + "\n";
    writeText(folder.file("p.csv"), pairs);
    const ToolRun run = runTool({"pdf", kModel, "--pairs", folder.file("p.csv")});
    const auto lines = linesOf(run.out);
    ASSERT_EQ(lines.size(), 51u);
    EXPECT_EQ(lines[0], "pdf");
    for (size_t i = 0; i < rows.size(); ++i)  // directions have six digits in the file
        EXPECT_NEAR(numbersOf(lines[i + 1]).at(0) / rows[i][3], 1.0, 1e-3) << i;
}

TEST(SampleCommand, EstimatesTheAlbedo)
{
    double sum = 0.0;
    const auto rows = samplesOf(kModel, "0,0,1", "4000");
    for (const auto& row : rows) sum += row[4] * std::max(0.0, row[2]) / row[3];
    const auto info = jsonFrom(runTool({"info", kModel, "--json"}));
    const double albedo = info["directional_albedo"][0]["rgb"][0].get<double>();
    EXPECT_NEAR(sum / static_cast<double>(rows.size()), albedo, 0.01 * albedo);
}

TEST(SampleCommand, SeedsDiffer)
{
    EXPECT_EQ(samplesOf(kModel, "0,0,1", "5"), samplesOf(kModel, "0,0,1", "5"));
    EXPECT_NE(samplesOf(kModel, "0,0,1", "5"), samplesOf(kModel, "0,0,1", "5", "2"));
}

TEST(SampleCommand, TakesTheLobesOfAFile)
{
    const TemporaryDir folder;
    Material material = smallMaterial("hdio");
    LobeTable& lobes = material.lobes;
    lobes.lobes = 1;
    lobes.thetas = 2;
    lobes.knots.resize(2);
    for (LobeKnot& knot : lobes.knots) knot.cosine = Vec3f(0.5f);
    writeMaterial(material, folder.file("m.fbrdf"));
    for (const auto& row : samplesOf(folder.file("m.fbrdf"), "0.1,0,1", "20"))
        EXPECT_NEAR(row[3], row[2] / 3.14159265358979, 1e-6);  // a cosine alone
}

TEST(SampleCommand, RefusesWhatIsNoView)
{
    for (const char* wo : {"0,0,-1", "0,0,0", "1,2", "a,b,c", "0,0,1,0", "nan,0,1", ""})
        expectError(runTool({"sample", "lambert:albedo=0.5", "--wo", wo, "--count", "5"}), 2,
                    "expected x,y,z of a direction with z > 0");
    expectError(runTool({"sample", "lambert", "--wo", "0,0,1", "--count", "0"}), 2, "--count");
}

TEST(SampleCommand, RefusesScatteredSamples)
{
    const TemporaryDir folder;
    writeText(folder.file("s.csv"), samplesCsv(50));
    expectError(runTool({"sample", folder.file("s.csv"), "--wo", "0,0,1", "--count", "5"}), 3,
                "s.csv");
}

}  // namespace
}  // namespace fbrdf::test
