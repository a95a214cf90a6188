// batch under mpirun: the same files as one process, and what a killed rank leaves behind.
#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

namespace fbrdf::test {
namespace {

namespace fs = std::filesystem;

class BatchRanks : public testing::Test {
protected:
    void SetUp() override
    {
        if (std::string(FBRDF_MPIRUN).empty())
            GTEST_SKIP() << "needs MPI: install libopenmpi-dev and configure again";
        std::string lines;
        for (int i = 0; i < 5; ++i) {
            const std::string name = "m" + std::to_string(i), csv = folder.file(name + ".csv");
            writeText(csv, samplesCsv(100, i + 1.0));
            lines += name + "\t" + csv + "\n";
        }
        writeText(list, lines + "missing\tnothing.csv\n");
    }

    std::vector<std::string> arguments(const std::string& output)
    {
        return {"batch",        list,    "-o",           folder.file(output),
                "--form",       "hdio",  "--resolution", "16",
                "--smoothness", "0.001", "--plain"};
    }
    // Root may run a test, and a machine may have fewer cores than ranks.
    ToolOptions ranks(const char* count)
    {
        ToolOptions options;
        options.launcher = {FBRDF_MPIRUN, "--oversubscribe", "-n", count};
        options.environment = {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"};
        return options;
    }
    std::map<std::string, std::string> filesIn(const std::string& output)
    {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::directory_iterator(folder.file(output)))
            files[entry.path().filename().string()] = readText(entry.path().string());
        return files;
    }

    TemporaryDir folder;
    const std::string list = folder.file("list.txt");
};

TEST_F(BatchRanks, GiveTheSameFilesAsOneProcess)
{
    ASSERT_EQ(runTool(arguments("alone")).code, 1);  // one source is missing
    const ToolRun run = runTool(arguments("ranks"), ranks("3"));
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.out.find("5 fitted, 0 kept, 1 failed"), std::string::npos) << run.out;
    EXPECT_NE(run.err.find("fbrdf: missing: "), std::string::npos) << run.err;
    EXPECT_EQ(filesIn("alone").size(), 6u);
    EXPECT_EQ(filesIn("ranks"), filesIn("alone"));
}

TEST_F(BatchRanks, MoreRanksThanMaterialsIsFine)
{
    writeText(list, "only\t" + folder.file("m0.csv") + "\n");
    const ToolRun run = runTool(arguments("out"), ranks("3"));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(filesIn("out").size(), 2u);
}

TEST_F(BatchRanks, AWrongListIsReportedOnce)
{
    writeText(list, "no tab\n");
    const ToolRun run = runTool(arguments("out"), ranks("2"));
    EXPECT_EQ(run.code, 3);
    const size_t first = run.err.find("fbrdf: ");
    ASSERT_NE(first, std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("fbrdf: ", first + 1), std::string::npos) << run.err;
}

TEST_F(BatchRanks, ShareOneDataSetAndComeToTheFitOfOne)
{
    writeText(list, samplesCsv(30000));  // four blocks of rows
    const auto fit = [this](const std::string& output) {
        return std::vector<std::string>{"fit",       list,    "-o",           folder.file(output),
                                        "--form",    "hdio",  "--resolution", "16",
                                        "--storage", "float", "--json"};
    };
    ASSERT_EQ(runTool(fit("alone.fbrdf")).code, 0);
    const ToolRun run = runTool(fit("ranks.fbrdf"), ranks("2"));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(jsonFrom(run)["samples"]["used"], 30000);  // rank 0 alone prints
    const Material a = readMaterial(folder.file("alone.fbrdf")),
                   b = readMaterial(folder.file("ranks.fbrdf"));
    for (size_t k = 0; k < a.tables.size(); ++k)
        for (size_t i = 0; i < a.tables[k].texels.size(); ++i)
            EXPECT_NEAR(a.tables[k].texels[i], b.tables[k].texels[i], 1e-5) << k << " " << i;
    const Vec3d wo(0.28, 0.0, 0.96), wi(0.0, 0.6, 0.8);
    EXPECT_NEAR(evaluate(a, wo, wi).x / evaluate(b, wo, wi).x, 1.0, 1e-6);
}

// A rank that dies after its first material: mpirun ends the run, --resume does the rest.
TEST_F(BatchRanks, ResumeFinishesWhatAKilledRankLeft)
{
    ToolOptions killed = ranks("2");
    const std::string script = folder.file("kill-second-rank.sh");
    writeText(script, "#!/bin/sh\n[ \"$OMPI_COMM_WORLD_RANK\" = 1 ] && kill -9 $$\nexec \"$@\"\n");
    killed.launcher.insert(killed.launcher.end(), {"sh", script});
    EXPECT_NE(runTool(arguments("out"), killed).code, 0);
    const ToolRun resumed = runTool([&] {
        auto all = arguments("out");
        all.push_back("--resume");
        return all;
    }());
    EXPECT_EQ(resumed.code, 1);  // the missing source
    ASSERT_EQ(runTool(arguments("alone")).code, 1);
    EXPECT_EQ(filesIn("out"), filesIn("alone"));
}

}  // namespace
}  // namespace fbrdf::test
