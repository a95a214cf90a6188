// eval as a stream: order, memory, and answers before the end of the input.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fbrdf::test {
namespace {

// A block is a megabyte, about 8,600 of these pairs. There are several, so that threads overtake.
constexpr size_t kSeveralBlocks = 60000;

class EvalStream : public testing::Test {
protected:
    std::string pairsFile(size_t count)
    {
        const std::string path = folder.file(std::to_string(count) + ".csv");
        writeText(path, pairsCsv(spreadPairs(count)));
        return path;
    }

    /// The same thousand pairs again and again. It is never in memory as a whole: what a process
    /// holds when it starts another counts among that one's memory.
    std::string longFile(int thousands)
    {
        const std::string path = folder.file(std::to_string(thousands) + "k.csv");
        const std::string rows = pairsCsv(spreadPairs(1000)).substr(std::strlen(kPairHeader));
        std::ofstream file(path);
        file << kPairHeader;
        for (int i = 0; i < thousands; ++i) file << rows;
        return path;
    }

    TemporaryDir folder;
};

TEST_F(EvalStream, ThreadsKeepTheOrder)
{
    const std::string pairs = pairsFile(kSeveralBlocks);
    const ToolRun one = runTool({"eval", "ggx:alpha=0.3", "--pairs", pairs, "--threads", "1"});
    const ToolRun four = runTool({"eval", "ggx:alpha=0.3", "--pairs", pairs, "--threads", "4"});
    EXPECT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(linesOf(one.out).size(), kSeveralBlocks + 1);
    EXPECT_TRUE(one.out == four.out);
}

TEST_F(EvalStream, JsonOfSeveralBlocksIsOneArray)
{
    const ToolRun run = runTool(
        {"eval", "lambert", "--pairs", pairsFile(kSeveralBlocks), "--json", "--threads", "3"});
    EXPECT_EQ(jsonFrom(run).size(), kSeveralBlocks);
}

TEST_F(EvalStream, RowsBeforeABadOneAreWritten)
{
    const std::string path = pairsFile(kSeveralBlocks);
    writeText(path, readText(path) + "0,0,1,0,0,oops\n" + "0,0,1,0,0,1\n");
    const ToolRun run = runTool({"eval", "lambert", "--pairs", path, "--threads", "4"});
    EXPECT_EQ(run.code, 3);
    EXPECT_EQ(linesOf(run.out).size(), kSeveralBlocks + 1);
    EXPECT_EQ(run.err, "fbrdf: " + path + ":" + std::to_string(kSeveralBlocks + 2) +
                           ": found 'oops' as wi_z, expected a finite number\n");
}

TEST_F(EvalStream, ALineWithoutAnEndIsRefusedInBoundedMemory)
{
    const std::string path = folder.file("long.csv");
    writeText(path, std::string(kPairHeader) + "\n" + std::string(size_t(40) << 20, '1'));
    const ToolRun run = runTool({"eval", "lambert", "--pairs", path});
    expectError(run, 3, ":2: found a line longer than a megabyte");
    const ToolRun small = runTool({"eval", "lambert", "--pairs", pairsFile(10)});
    EXPECT_LT(run.maxResidentKb, small.maxResidentKb + (20 << 10));
}

TEST_F(EvalStream, MemoryDoesNotGrowWithTheInput)
{
    const auto residentKb = [&](int thousands) {
        ToolOptions options;
        options.stdoutPath = folder.file("rows.csv");
        const ToolRun run =
            runTool({"eval", "ggx", "--pairs", longFile(thousands), "--threads", "1"}, options);
        EXPECT_EQ(run.code, 0) << run.err;
        return run.maxResidentKb;
    };
    // 20 MB of input need no less memory than 80: a thread holds a few blocks of a megabyte. How
    // many of several threads are full at once is a matter of speed.
    const long few = residentKb(170), many = residentKb(680);
    EXPECT_LT(many - few, 8 << 10) << few << " KB, then " << many << " KB";
}

// A program that writes a pair and waits for the answer before it writes the next one.
TEST_F(EvalStream, AnswersBeforeTheEndOfTheInput)
{
    int in[2], out[2];
    ASSERT_EQ(pipe(in), 0);
    ASSERT_EQ(pipe(out), 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(in[0], STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        close(in[1]);
        execl(FBRDF_TOOL, FBRDF_TOOL, "eval", "lambert", "--pairs", "-", nullptr);
        _exit(127);
    }
    close(in[0]);
    close(out[1]);
    const std::string asked = std::string(kPairHeader) + "\n0,0,1,0,0,1\n";
    ASSERT_EQ(write(in[1], asked.data(), asked.size()), static_cast<ssize_t>(asked.size()));
    constexpr int kPatienceMs = 60000;  // it hangs for good when it is wrong
    pollfd answer{out[0], POLLIN, 0};
    EXPECT_EQ(poll(&answer, 1, kPatienceMs), 1) << "no answer while the input is open";
    close(in[1]);
    close(out[0]);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace fbrdf::test
