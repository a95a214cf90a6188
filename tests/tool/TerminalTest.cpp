// Progress belongs on a terminal, and only there.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

constexpr char kClear[] = "\r\x1b[K";

class Terminal : public testing::Test {
protected:
    void SetUp() override
    {
        if (!terminalsExist()) GTEST_SKIP() << "no pseudo terminal: is /dev/pts mounted?";
        writeText(csv, samplesCsv(100));
        onTerminal.terminal = true;
        onTerminal.environment = {"TERM=xterm"};
    }

    TemporaryDir folder;
    const std::string csv = folder.file("glossy.csv"), output = folder.file("out.fbrdf");
    ToolOptions onTerminal;
};

TEST_F(Terminal, PhasesAreShownAndRemoved)
{
    const ToolRun run = runTool(quickFit(csv, output), onTerminal);
    EXPECT_EQ(run.code, 0);
    for (const char* phase :
         {"reading glossy.csv ...", "fitting glossy ...", "measuring glossy ..."})
        EXPECT_NE(run.err.find(std::string(kClear) + phase), std::string::npos) << phase;
    ASSERT_GE(run.err.size(), 4u);
    EXPECT_EQ(run.err.substr(run.err.size() - 4), kClear);
    EXPECT_EQ(run.out.find('\x1b'), std::string::npos);  // the result is plain text
}

TEST_F(Terminal, AnErrorStandsAloneOnItsLine)
{
    const ToolRun run = runTool({"fit", "ggx:alpha=9", "-o", output}, onTerminal);
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find(std::string(kClear) + "fbrdf: model ggx"), std::string::npos) << run.err;
}

TEST_F(Terminal, BatchAndEvalShowABar)
{
    writeText(folder.file("list.txt"), "one\t" + csv + "\n");
    const ToolRun batch = runTool({"batch", folder.file("list.txt"), "-o", folder.file("out"),
                                   "--form", "hdio", "--resolution", "16", "--smoothness", "0.001"},
                                  onTerminal);
    EXPECT_EQ(batch.code, 0);
    EXPECT_NE(batch.err.find("[" + std::string(30, '.') + "]   0 %"), std::string::npos);
    writeText(folder.file("pairs.csv"), pairsCsv(spreadPairs(30000)));
    const ToolRun eval =
        runTool({"eval", "lambert", "--pairs", folder.file("pairs.csv")}, onTerminal);
    EXPECT_EQ(eval.code, 0);
    EXPECT_NE(eval.err.find(" %  evaluating"), std::string::npos) << eval.err;
}

TEST_F(Terminal, LinesFitTheTerminal)
{
    const std::string longName = folder.file(std::string(150, 'x') + ".csv");
    writeText(longName, samplesCsv(100));
    const ToolRun run = runTool(quickFit(longName, output), onTerminal);
    EXPECT_EQ(run.code, 0);
    size_t column = 0;
    for (const char c : run.err) {
        column = c == '\r' ? 0 : column + 1;
        EXPECT_LT(column, 80u + 3u);  // 80 cells, and the three characters that clear the line
    }
}

TEST_F(Terminal, NothingIsShownWithoutOne)
{
    EXPECT_EQ(runTool(quickFit(csv, output)).err, "");
    onTerminal.environment = {"TERM=dumb"};
    EXPECT_EQ(runTool(quickFit(csv, output), onTerminal).err, "");
    onTerminal.environment = {"TERM=xterm"};
    auto quiet = quickFit(csv, output);
    quiet.push_back("--quiet");
    EXPECT_EQ(runTool(quiet, onTerminal).err, "");
}

}  // namespace
}  // namespace fbrdf::test
