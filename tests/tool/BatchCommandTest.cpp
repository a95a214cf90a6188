#include "Inputs.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>

namespace fbrdf::test {
namespace {

namespace fs = std::filesystem;

class BatchCommand : public testing::Test {
protected:
    void SetUp() override
    {
        for (const char* name : {"a", "b", "c"})
            writeText(folder.file(std::string(name) + ".csv"), samplesCsv(120, name[0] - '`'));
        writeText(list, "# three materials\n\nzebra\t" + folder.file("a.csv") + "\nbadger\t" +
                            folder.file("b.csv") + "\r\nape\t" + folder.file("c.csv") + "\n");
    }

    ToolRun batch(const std::vector<std::string>& more = {})
    {
        std::vector<std::string> arguments{"batch",
                                           list,
                                           "-o",
                                           output,
                                           "--form",
                                           "hdio",
                                           "--resolution",
                                           "16",
                                           "--smoothness",
                                           "0.001",
                                           "--plain",
                                           "--environment-lobes",
                                           "0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTool(arguments);
    }
    /// First field of each row of results.csv.
    std::vector<std::string> namesInResults()
    {
        std::vector<std::string> names;
        for (const std::string& line : linesOf(readText(output + "/results.csv")))
            names.push_back(line.substr(0, line.find(',')));
        return names;
    }
    std::map<std::string, std::string> filesIn(const std::string& path)
    {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::directory_iterator(path))
            files[entry.path().filename().string()] = readText(entry.path().string());
        return files;
    }
    /// Moves a file's time of change into the past, or the future.
    void shiftTime(const std::string& path, int seconds)
    {
        fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(seconds));
    }

    TemporaryDir folder;
    const std::string list = folder.file("list.txt"), output = folder.file("new/out");
};

TEST_F(BatchCommand, FitsEachMaterialAndReportsItInOrder)
{
    const ToolRun run = batch();
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "3 fitted, 0 kept, 0 failed: " + output + "/results.csv\n");
    EXPECT_EQ(namesInResults(), (std::vector<std::string>{"name", "zebra", "badger", "ape"}));
    for (const char* name : {"zebra", "badger", "ape"})
        EXPECT_GT(readMaterial(output + "/" + name + ".fbrdf").errors.count("held_out.log_rms"),
                  0u);
    EXPECT_EQ(filesIn(output).size(), 4u);
}

TEST_F(BatchCommand, IsTheSameFitAsTheCommandFit)
{
    ASSERT_EQ(batch().code, 0);
    ASSERT_EQ(runTool(quickFit(folder.file("b.csv"), folder.file("b.fbrdf"))).code, 0);
    EXPECT_EQ(readText(folder.file("b.fbrdf")), readText(output + "/badger.fbrdf"));
}

TEST_F(BatchCommand, ThreadsDoNotChangeTheFiles)
{
    ASSERT_EQ(batch({"--threads", "1"}).code, 0);
    const auto one = filesIn(output);
    ASSERT_EQ(batch({"--threads", "3"}).code, 0);
    EXPECT_EQ(filesIn(output), one);
}

TEST_F(BatchCommand, AFailingMaterialDoesNotStopTheRest)
{
    writeText(list, "bad\t" + folder.file("none.csv") + "\ngood\t" + folder.file("a.csv") +
                        "\nworse\tggx:alpha=99\n");
    const ToolRun run = batch({"--json"});
    EXPECT_EQ(run.code, 1);
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["fitted"], 1);
    EXPECT_EQ(json["failed"], 2);
    const auto errors = linesOf(run.err);
    ASSERT_EQ(errors.size(), 2u) << run.err;
    EXPECT_EQ(errors[0], "fbrdf: bad: " + folder.file("none.csv") +
                             ": found no such file, expected a file or a model");
    EXPECT_EQ(errors[1].rfind("fbrdf: worse: model ggx: found alpha=99", 0), 0u) << errors[1];
    const auto rows = linesOf(readText(output + "/results.csv"));
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0].substr(rows[0].size() - 6), ",error");
    EXPECT_NE(rows[1].find("found no such file"), std::string::npos);
    EXPECT_EQ(rows[2].back(), ',');
    EXPECT_NE(rows[3].find("found alpha=99"), std::string::npos);
    EXPECT_FALSE(fs::exists(output + "/bad.fbrdf"));
}

TEST_F(BatchCommand, ResumeKeepsWhatIsThere)
{
    ASSERT_EQ(batch().code, 0);
    const auto before = filesIn(output);
    fs::remove(output + "/badger.fbrdf");
    fs::remove(output + "/results.csv");
    const auto written = fs::last_write_time(output + "/ape.fbrdf");
    EXPECT_EQ(batch({"--resume"}).out.substr(0, 26), "1 fitted, 2 kept, 0 failed");
    EXPECT_EQ(fs::last_write_time(output + "/ape.fbrdf"), written);
    EXPECT_EQ(filesIn(output), before);
}

TEST_F(BatchCommand, ResumeFitsAgainWhatIsNotTheSame)
{
    ASSERT_EQ(batch().code, 0);
    writeText(output + "/zebra.fbrdf", "half a fi");  // of a disk that was full
    shiftTime(output + "/badger.fbrdf", -1000);       // older than its source
    EXPECT_EQ(batch({"--resume"}).out.substr(0, 26), "2 fitted, 1 kept, 0 failed");
    EXPECT_EQ(batch({"--resume", "--seed", "7"}).out.substr(0, 26), "3 fitted, 0 kept, 0 failed");
    EXPECT_EQ(batch({"--resume", "--seed", "7"}).out.substr(0, 26), "0 fitted, 3 kept, 0 failed");
    EXPECT_EQ(batch().out.substr(0, 26), "3 fitted, 0 kept, 0 failed");
}

TEST_F(BatchCommand, ResumeSeesThatAFormFileHasChanged)
{
    const std::string form = folder.file("form.json");
    const auto resume = [&](const std::string& radius) {
        writeText(form, R"({"name": "q", "tables": [{"name": "q", "domain": {"disc": {"size": 8,
                            "gamma": 0.5, "radius": )" +
                            radius + R"(}}}], "terms": [[{"table": 0, "argument": "h"}]]})");
        return runTool({"batch", list, "-o", output, "--form", form, "--smoothness", "0.001",
                        "--plain", "--resume"})
            .out.substr(0, 26);
    };
    EXPECT_EQ(resume("3.5"), "3 fitted, 0 kept, 0 failed");
    EXPECT_EQ(resume("3.5"), "0 fitted, 3 kept, 0 failed");
    EXPECT_EQ(resume("3.0"), "3 fitted, 0 kept, 0 failed");
}

TEST_F(BatchCommand, RowsWithCommasAreQuoted)
{
    writeText(list, "model\tlambert:albedo=0.5/0.4/0.3\ntwo\tggx:alpha=0.5,kd=0.2\n");
    ASSERT_EQ(batch().code, 0);
    const auto rows = linesOf(readText(output + "/results.csv"));
    EXPECT_EQ(rows[1].rfind("model,lambert:albedo=0.5/0.4/0.3,hdio,", 0), 0u) << rows[1];
    EXPECT_EQ(rows[2].rfind("two,\"ggx:alpha=0.5,kd=0.2\",hdio,", 0), 0u) << rows[2];
}

TEST_F(BatchCommand, WrongListsAreRefusedBeforeAnyWork)
{
    const std::string good = "good\t" + folder.file("a.csv") + "\n";
    const std::map<std::string, std::string> wrong{
        {"no tab\n", ":1: found 'no tab', expected name<TAB>source"},
        {good + "x\t\n", ":2: found 'x\?', expected name<TAB>source"},
        {good + good, ":2: found the name 'good' again"},
        {good + "../up\tlambert\n", ":2: found the name '../up'"},
        {good + ".hidden\tlambert\n", ":2: found the name '.hidden'"},
        {"# nothing\n\n", "found no material"},
        {"", "found no material"}};
    for (const auto& [text, words] : wrong) {
        writeText(list, text);
        expectError(batch(), 3, words);
        EXPECT_FALSE(fs::exists(output)) << text;
    }
    fs::remove(list);
    expectError(batch(), 3, "cannot be read");
}

TEST_F(BatchCommand, AFolderThatCannotBeMadeIsAnOutputError)
{
    writeText(folder.file("new"), "a file where the folder should be");
    expectError(batch(), 5, "cannot be made");
}

}  // namespace
}  // namespace fbrdf::test
