// fbrdf-bench as its users run it.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/BuiltFile.h"
#include "support/DataDir.h"
#include "support/TemporaryDir.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace fbrdf::test {
namespace {

struct Result {
    int exitCode = -1;
    std::string out, err;
};

std::string textOf(const std::string& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

Result runBench(const std::string& arguments, const std::string& environment = "")
{
    const TemporaryDir dir;
    const std::string command = environment + " '" + builtFile("FBRDF_BENCH", FBRDF_BENCH_PATH) +
                                "' " + arguments + " >'" + dir.file("out") + "' 2>'" +
                                dir.file("err") + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, textOf(dir.file("out")),
            textOf(dir.file("err"))};
}

#define NEEDS_GL(result) \
    if (result.exitCode == 6 && !dataIsMandatory()) GTEST_SKIP() << result.err

TEST(BenchProgram, TimesLightFromEverywhere)
{
    const Result result = runBench("--environment --size 8x8 --mesh triangle --json");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    ASSERT_EQ(json.size(), 1u);
    std::map<std::string, nlohmann::json> rows;
    for (const auto& row : json[0]["rows"]) rows[row["name"]] = row;
    EXPECT_EQ(rows["ggx, split sum"]["ratio"], 1.0);
    EXPECT_EQ(rows["K = 1, two-lookup"]["passes"], 1);
    EXPECT_EQ(rows["K = 2, two-lookup"]["passes"], 2);
    EXPECT_EQ(rows["K = 2, two-lookup"]["lookups"], 2);
    EXPECT_EQ(rows["K = 3, single"]["lookups"], 4);
    EXPECT_EQ(rows["K = 2, 16 spheres"]["lookups"], 0);
    EXPECT_GT(rows["K = 2, 16 spheres"]["milliseconds"], 0.0);
}

TEST(BenchProgram, TimesEveryVariantOnce)
{
    const Result result = runBench("--lights 2 --size 8x8 --json");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    std::set<std::string> variants;
    for (const auto& row : json["results"]) {
        EXPECT_GT(row["milliseconds"], 0.0);
        EXPECT_GT(row["ratio"], 0.0);
        EXPECT_GT(row["multiply_adds"], 0.0) << row;
        variants.insert(row["mesh"].get<std::string>() + " " + row["variant"].get<std::string>());
    }
    EXPECT_EQ(variants.size(), json["results"].size());
    for (const char* mesh : {"triangle ", "sphere "})
        for (const char* variant : {"ggx",
                                    "merl",
                                    "nbrdf",
                                    "nbrdf-baked",
                                    "poulin-fournier",
                                    "multipass-osgfx",
                                    "hdio single",
                                    "hdio batched",
                                    "hdio two-lookup",
                                    "pqp single",
                                    "pqpr batched",
                                    "io+hdio two-lookup",
                                    "hdpio single",
                                    "hdpu batched",
                                    "hdsu two-lookup",
                                    "hdio precise single",
                                    "hdg two-lookup",
                                    "svd4 single",
                                    "svd8 two-lookup",
                                    "analytic:ward batched",
                                    "qdio single",
                                    "hdpu precise single"})
            EXPECT_EQ(variants.count(std::string(mesh) + variant), 1u) << mesh << variant;
    EXPECT_TRUE(json["left_out"].empty());
    EXPECT_FALSE(json["renderer"].get<std::string>().empty());
}

TEST(BenchProgram, TimesFormsByName)
{
    const Result result = runBench(
        "--lights 2 --size 8x8 --mesh triangle --json --only 'hdg,svd3 single,pqpn precise,"
        "gg+qdg batched,pqpr cube single'");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    std::vector<std::string> variants;
    const auto json = nlohmann::json::parse(result.out);
    for (const auto& row : json["results"]) variants.push_back(row["variant"]);
    EXPECT_EQ(variants, std::vector<std::string>({"hdg single", "hdg batched", "hdg two-lookup",
                                                  "svd3 single", "pqpn precise single",
                                                  "pqpn precise batched", "pqpn precise two-lookup",
                                                  "gg+qdg batched", "pqpr cube single"}));
}

TEST(BenchProgram, IsRightInFormsOfEveryKind)
{
    const Result result =
        runBench("--accuracy --lights 2 --json --only 'hdg,hdpu precise,qdio,svd4,analytic:ward'");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err << result.out;
    std::set<std::string> forms;
    const auto json = nlohmann::json::parse(result.out);
    for (const auto& row : json["rows"]) {
        forms.insert(row["form"]);
        EXPECT_GT(row["multiply_adds"], 0.0) << row;
        // Singular values have no bound, and differ by no more than floats and formats do.
        EXPECT_LT(row["absolute"], 0.01) << row;
    }
    EXPECT_EQ(forms.size(), 5u);
}

TEST(BenchProgram, CountsTheLightsThatReachAPixel)
{
    const Result result = runBench("--reach --lights 16,64 --size 64x64 --json");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["lights"], 4096);
    ASSERT_EQ(json["rows"].size(), 2u);
    for (const auto& row : json["rows"]) {
        const double wanted = row["wanted"], reaching = row["reaching"], listed = row["listed"];
        EXPECT_NEAR(reaching, wanted, 0.2 * wanted);  // less at the border
        EXPECT_GE(listed, reaching);
        for (const char* time : {"clustered", "building", "editing", "spots", "one_list"})
            EXPECT_GT(row[time], 0.0);
        EXPECT_EQ(row.contains("by_gpu"), json["why_not_by_gpu"] == "");
    }
    EXPECT_EQ(json["culled"]["given"], 100000);
    EXPECT_GT(json["culled"]["seen"], 4000);
    EXPECT_LT(json["culled"]["seen"], 12000);
}

TEST(BenchProgram, StaysWithinItsBounds)
{
    const Result result = runBench("--accuracy --lights 9 --only pqpr,io+hdio --json");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err << result.out;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["holds"], true);
    std::set<std::string> versions;
    double worst = 0.0;
    for (const auto& row : json["rows"]) {
        versions.insert(row["version"]);
        EXPECT_LE(row["share"], 1.0) << row;
        worst = std::max(worst, row["share"].get<double>());
    }
    EXPECT_GT(worst, 0.2);
    // Two forms, three techniques, three formats, except for the version that has only one format.
    EXPECT_EQ(json["rows"].size(), versions.size() * 2 * 3 * 3 - 2 * 3 * 2);
    EXPECT_GE(versions.size(), 6u);
}

TEST(BenchProgram, TimesByEveryClock)
{
    for (const char* clock : {"wall", "cpu", "gpu"}) {
        const Result result =
            runBench("--lights 4 --size 64x64 --mesh triangle --only ggx --json --clock " +
                     std::string(clock));
        if (result.err.find("timer queries") != std::string::npos) GTEST_SKIP() << result.err;
        NEEDS_GL(result);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        const auto json = nlohmann::json::parse(result.out);
        EXPECT_EQ(json["clock"], clock);
        EXPECT_GT(json["results"][0]["milliseconds"], 0.0) << clock;
    }
}

TEST(BenchProgram, LeavesOutWhatWouldTakeTooLong)
{
    const Result result = runBench(
        "--lights 1,64 --size 8x8 --mesh triangle --only ggx,merl --frame-limit 1e-6 --json");
    NEEDS_GL(result);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["results"].size(), 2u);   // with one light there is no estimate yet
    EXPECT_EQ(json["left_out"].size(), 2u);  // with 64 there is one
}

TEST(BenchProgram, RefusesWhatItDoesNotKnow)
{
    for (const char* arguments :
         {"--lights 0", "--lights many", "--size 8", "--size 0x8", "--mesh cube", "--clock sun",
          "--device gpu", "--only hidio", "--only 'hdio twice'", "--only 'hdio cube single more'",
          "--accuracy --only svd99", "--frame-limit -1", "more"}) {
        const Result result = runBench(arguments);
        if (std::string(arguments).find("--only") != std::string::npos) NEEDS_GL(result);
        EXPECT_EQ(result.exitCode, 2) << arguments << result.err;
        EXPECT_EQ(result.err.rfind("fbrdf-bench: ", 0), 0u) << result.err;
        EXPECT_TRUE(result.out.empty());
    }
}

TEST(BenchProgram, WithoutGlEndsWith6)
{
    const Result result = runBench("--lights 1", "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent");
    EXPECT_EQ(result.exitCode, 6) << result.err;
    EXPECT_EQ(result.err.rfind("fbrdf-bench: ", 0), 0u) << result.err;
}

}  // namespace
}  // namespace fbrdf::test
