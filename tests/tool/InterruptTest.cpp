// Ctrl-C and what ends a process: the tool dies of the signal, as shells and schedulers expect, and
// leaves whole files or none.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

namespace fbrdf::test {
namespace {

class Interrupt : public testing::TestWithParam<int> {
protected:
    void SetUp() override
    {
        if (!terminalsExist()) GTEST_SKIP() << "no pseudo terminal: is /dev/pts mounted?";
        writeText(csv, samplesCsv(4000));
    }

    /// Runs until the terminal shows `text` and sends the signal then. A machine that was faster
    /// than the signal has finished, which is as well.
    bool wasInterrupted(const std::vector<std::string>& arguments, const std::string& text)
    {
        ToolOptions options;
        options.terminal = true;
        options.environment = {"TERM=xterm"};
        options.signal = GetParam();
        options.signalAt = text;
        const ToolRun run = runTool(arguments, options);
        EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
        EXPECT_TRUE(run.code == 128 + GetParam() || run.code == 0) << run.code << run.err;
        return run.code != 0;
    }

    TemporaryDir folder;
    const std::string csv = folder.file("glossy.csv");
    const std::vector<std::string> nothing{"glossy.csv"};
};

TEST_P(Interrupt, OfAFitLeavesNothing)
{
    const bool interrupted =
        wasInterrupted({"fit", csv, "-o", folder.file("out.fbrdf")}, "fitting glossy");
    EXPECT_EQ(folder.names() == nothing, interrupted);
}

TEST_P(Interrupt, OfReadingLeavesNothing)
{
    wasInterrupted({"info", csv}, "reading ");
    EXPECT_EQ(folder.names(), nothing);
}

TEST_P(Interrupt, OfWritingLeavesNothing)
{
    const bool interrupted =
        wasInterrupted({"convert", "ggx", folder.file("out.binary")}, "writing ");
    EXPECT_EQ(folder.names() == nothing, interrupted);
}

TEST_P(Interrupt, OfABatchLeavesWholeMaterials)
{
    const std::string list = folder.file("list.txt"), out = folder.file("out");
    writeText(list, "one\t" + csv + "\ntwo\t" + csv + "\n");
    if (!wasInterrupted({"batch", list, "-o", out}, "[")) return;
    if (!std::filesystem::exists(out)) return;
    for (const auto& entry : std::filesystem::directory_iterator(out)) {
        EXPECT_EQ(entry.path().extension(), ".fbrdf") << entry.path();
        EXPECT_NO_THROW(readMaterial(entry.path().string()));
    }
}

std::string signalName(const testing::TestParamInfo<int>& signal)
{
    return signal.param == SIGINT ? "CtrlC" : "Termination";
}
INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM), signalName);

}  // namespace
}  // namespace fbrdf::test
