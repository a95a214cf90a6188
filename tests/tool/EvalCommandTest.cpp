#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::test {
namespace {

// Nine significant digits: half a unit of the last one.
constexpr double kNineDigits = 5.1e-9;

class EvalCommand : public testing::Test {
protected:
    void SetUp() override { writeMaterial(smallMaterial("hdio"), material); }

    std::vector<std::vector<double>> rowsOf(const ToolRun& run)
    {
        EXPECT_EQ(run.code, 0) << run.err;
        const auto lines = linesOf(run.out);
        EXPECT_EQ(lines.empty() ? "nothing" : lines.front(), "r,g,b");
        std::vector<std::vector<double>> rows;
        for (size_t i = 1; i < lines.size(); ++i) rows.push_back(numbersOf(lines[i]));
        return rows;
    }
    ToolRun evalText(const std::string& pairs, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{"eval", material, "--pairs", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        ToolOptions options;
        options.input = pairs;
        return runTool(arguments, options);
    }

    TemporaryDir folder;
    const std::string material = folder.file("small.fbrdf");
};

TEST_F(EvalCommand, IsTheFloatEvaluationOfTheShader)
{
    const Material read = readMaterial(material);
    const auto pairs = spreadPairs(200);
    const auto rows = rowsOf(evalText(pairsCsv(pairs)));
    ASSERT_EQ(rows.size(), pairs.size());
    for (size_t i = 0; i < pairs.size(); ++i) {
        const Vec3d wo = glm::normalize(pairs[i].wo), wi = glm::normalize(pairs[i].wi);
        const Vec3f expected = evaluate<float>(read, Vec3f(wo), Vec3f(wi));
        for (int c = 0; c < 3; ++c)  // nine digits give a float back exactly
            EXPECT_EQ(static_cast<float>(rows[i][static_cast<size_t>(c)]), expected[c]) << i;
    }
}

TEST_F(EvalCommand, PairsMayBeWrittenAsSpreadsheetsDo)
{
    const auto expected = rowsOf(evalText("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0.6,0.8,0.6,0,0.8\n"));
    ASSERT_EQ(expected.size(), 1u);
    std::string utf16 = "\xFF\xFE";
    for (const char c : std::string("wo_x;wo_y;wo_z;wi_x;wi_y;wi_z\r\n0;0,6;0,8;0,6;0;0,8\r\n"))
        utf16 += {c, '\0'};
    for (const std::string& text :
         {std::string(
              "\"wo_x\",\"wo_y\",\"wo_z\",\"wi_x\",\"wi_y\",\"wi_z\"\n0,\"0.6\",0.8,0.6,0,0.8\n"),
          std::string("\xEF\xBB\xBFwo_x\two_y\two_z\twi_x\twi_y\twi_z\r0\t0.6\t0.8\t0.6\t0\t0.8\r"),
          utf16})
        EXPECT_EQ(rowsOf(evalText(text)), expected) << text;
    expectError(evalText("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,,0.8,0.6,0,0.8\n"), 3,
                ":2: found '' as wo_y");
}

TEST_F(EvalCommand, ExactIsDouble)
{
    const Material read = readMaterial(material);
    const auto pairs = spreadPairs(200);
    const auto rows = rowsOf(evalText(pairsCsv(pairs), {"--exact"}));
    ASSERT_EQ(rows.size(), pairs.size());
    size_t notFloat = 0;
    for (size_t i = 0; i < pairs.size(); ++i) {
        const Vec3d expected = evaluate<double>(read, pairs[i].wo, pairs[i].wi);
        for (int c = 0; c < 3; ++c) {
            const double found = rows[i][static_cast<size_t>(c)];
            EXPECT_NEAR(found, expected[c], expected[c] * kNineDigits) << i;
            notFloat += std::abs(found - static_cast<double>(static_cast<float>(found))) >
                        found * kNineDigits;
        }
    }
    EXPECT_GT(notFloat, pairs.size());
}

TEST_F(EvalCommand, ModelsAreTheirOwnFunction)
{
    ToolOptions options;
    options.input = pairsCsv(spreadPairs(3));
    const auto rows =
        rowsOf(runTool({"eval", "lambert:albedo=0.5/0.25/1", "--pairs", "-"}, options));
    ASSERT_EQ(rows.size(), 3u);
    for (const auto& row : rows) {
        EXPECT_NEAR(row[0], 0.5 / kPi, kNineDigits);
        EXPECT_NEAR(row[1], 0.25 / kPi, kNineDigits);
        EXPECT_NEAR(row[2], 1.0 / kPi, kNineDigits);
    }
}

TEST_F(EvalCommand, BelowTheHorizonIsZero)
{
    const ToolRun run = evalText(std::string(kPairHeader) +
                                 "\n0,0,1,0,0,-1\n0,0,-1,0,0,1\n1,0,0,0,0,1\n0,0,1,0,0,1\n");
    const auto lines = linesOf(run.out);
    ASSERT_EQ(lines.size(), 5u) << run.err;
    for (size_t i : {1u, 2u, 3u}) EXPECT_EQ(lines[i], "0,0,0");
    EXPECT_NE(lines[4], "0,0,0");
}

TEST_F(EvalCommand, DirectionsNeedNotBeUnit)
{
    const std::string header = std::string(kPairHeader) + "\n";
    const ToolRun unit = evalText(header + "0.6,0,0.8,0,-0.28,0.96\n");
    ASSERT_EQ(unit.code, 0) << unit.err;
    EXPECT_EQ(evalText(header + "3,0,4,0,-7e-3,24e-3\n").out, unit.out);
    EXPECT_EQ(evalText(header + "3e300,0,4e300,0,-7e-300,24e-300\n").out, unit.out);
}

TEST_F(EvalCommand, ColumnsGoByName)
{
    const ToolRun plain = evalText(std::string(kPairHeader) + "\n0.6,0,0.8,0,-0.28,0.96\n");
    ASSERT_EQ(plain.code, 0) << plain.err;
    const std::string shuffled =
        "\xef\xbb\xbf# a comment, and a byte-order mark\r\n\r\n"
        "weight,WI_x, wi_y ,wi_z,name,wo_z,wo_y,wo_x\r\n"
        "# another\r\n"
        "nan,0,-0.28,0.96,some text,0.8,+0, 0.6 \r\n\r\n";
    EXPECT_EQ(evalText(shuffled).out, plain.out);
}

TEST_F(EvalCommand, AFileAndStandardInputAreTheSame)
{
    const std::string path = folder.file("pairs.csv"), csv = pairsCsv(spreadPairs(20));
    writeText(path, csv);
    const ToolRun fromFile = runTool({"eval", material, "--pairs", path});
    EXPECT_EQ(fromFile.code, 0);
    EXPECT_EQ(fromFile.out, evalText(csv).out);
    EXPECT_EQ(evalText(csv.substr(0, csv.size() - 1)).out, fromFile.out);  // no last newline
}

TEST_F(EvalCommand, JsonIsAnArrayOfRows)
{
    const std::string csv = pairsCsv(spreadPairs(30));
    const auto rows = rowsOf(evalText(csv));
    const auto json = jsonFrom(evalText(csv, {"--json"}));
    ASSERT_EQ(json.size(), rows.size());
    for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(json[i].get<std::vector<double>>(), rows[i]);
}

TEST_F(EvalCommand, NoPairsGiveNoRows)
{
    EXPECT_EQ(evalText(std::string(kPairHeader) + "\n").out, "r,g,b\n");
    EXPECT_EQ(jsonFrom(evalText(kPairHeader, {"--json"})), nlohmann::json::array());
}

TEST_F(EvalCommand, WrongPairsNameTheirLine)
{
    const std::string header = std::string(kPairHeader) + "\n";
    expectError(evalText(""), 3, "standard input: found no line");
    expectError(evalText("# only\n\n"), 3, "found no line");
    expectError(evalText("a,b,c\n1,2,3\n"), 3, "standard input:1: found the header 'a,b,c'");
    expectError(evalText("wo_x," + header), 3, ":1: found the header");
    expectError(evalText(header + "\n0,0,1,0,0\n"), 3, ":3: found 5 fields, expected 6");
    expectError(evalText(header + "0,0,1,0,0,1,7\n"), 3, ":2: found 7 fields");
    expectError(evalText(header + "0,0,x,0,0,1\n"), 3, ":2: found 'x' as wo_z");
    expectError(evalText(header + "0,0,1,0,nan,1\n"), 3, ":2: found 'nan' as wi_y");
    expectError(evalText(header + "0,0,1,,0,1\n"), 3, ":2: found '' as wi_x");
    expectError(evalText(header + "0,0,0,0,0,1\n"), 3, ":2: found a direction of length 0");
}

TEST_F(EvalCommand, ScatteredSamplesHaveNoValuesInBetween)
{
    const std::string csv = folder.file("samples.csv");
    writeText(csv, samplesCsv(20));
    ToolOptions options;
    options.input = pairsCsv(spreadPairs(2));
    expectError(runTool({"eval", csv, "--pairs", "-"}, options), 3, "found scattered samples");
}

}  // namespace
}  // namespace fbrdf::test
