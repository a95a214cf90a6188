// models, forms, --help, --version.
#include "Tool.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace fbrdf::test {
namespace {

const char* const kCommands[] = {"fit",     "eval",  "compare", "info",
                                 "convert", "batch", "models",  "forms"};

std::set<std::string> namesIn(const nlohmann::json& list)
{
    std::set<std::string> names;
    for (const auto& entry : list) names.insert(entry["name"].get<std::string>());
    return names;
}

TEST(Catalogue, ModelsHaveTheNamesThatAreFixed)
{
    const std::map<std::string, std::vector<std::string>> fixed{
        {"lambert", {"albedo"}},
        {"phong", {"kd", "ks", "n"}},
        {"blinn-phong", {"kd", "ks", "n"}},
        {"lafortune", {"kd", "cx", "cy", "cz", "n"}},
        {"ward", {"rho_d", "rho_s", "alpha_x", "alpha_y"}},
        {"ashikhmin-shirley", {"kd", "ks", "nu", "nv"}},
        {"ggx", {"alpha", "alpha_x", "alpha_y", "f0", "kd"}},
        {"beckmann", {"alpha", "alpha_x", "alpha_y", "f0", "kd"}},
        {"oren-nayar", {"albedo", "sigma"}},
        {"poulin-fournier", {}}};
    const auto json = jsonFrom(runTool({"models", "--json"}));
    std::map<std::string, nlohmann::json> found;
    for (const auto& model : json["models"]) found[model["name"]] = model;
    for (const auto& [name, parameters] : fixed) {
        ASSERT_EQ(found.count(name), 1u) << name;
        EXPECT_FALSE(found[name]["paper"].get<std::string>().empty());
        for (const std::string& parameter : parameters)
            EXPECT_EQ(namesIn(found[name]["parameters"]).count(parameter), 1u)
                << name << " " << parameter;
    }
    EXPECT_EQ(namesIn(json["presets"]).count("ward-rolled-brass"), 1u);
}

TEST(Catalogue, TheTextListsTheSameModels)
{
    const auto json = jsonFrom(runTool({"models", "--json"}));
    const ToolRun run = runTool({"models"});
    EXPECT_EQ(run.code, 0);
    for (const auto& model : json["models"]) {
        EXPECT_NE(run.out.find(model["name"].get<std::string>() + " - "), std::string::npos);
        for (const auto& parameter : model["parameters"])
            EXPECT_NE(run.out.find("\n    " + parameter["name"].get<std::string>() + " "),
                      std::string::npos)
                << parameter["name"];
    }
}

TEST(Catalogue, EveryListedDefaultIsAccepted)
{
    const auto json = jsonFrom(runTool({"models", "--json"}));
    for (const auto& parameter : json["models"][0]["parameters"])
        EXPECT_TRUE(parameter.contains("default") && parameter.contains("range"));
    ToolOptions options;
    options.input = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0.6,0,0.8\n";
    for (const auto& model : json["models"]) {
        std::string spec = model["name"].get<std::string>() + ":";
        for (const auto& parameter : model["parameters"])
            if (parameter.contains("default"))
                spec += (spec.back() == ':' ? "" : ",") + parameter["name"].get<std::string>() +
                        "=" + parameter["default"].dump();
        const ToolRun run = runTool({"eval", spec, "--pairs", "-"}, options);
        EXPECT_EQ(run.code, 0) << spec << "\n" << run.err;
    }
}

TEST(Catalogue, FormsPrintWhatTheyCost)
{
    const auto json = jsonFrom(runTool({"forms", "--json"}));
    const std::set<std::string> names = namesIn(json["forms"]);
    for (const char* name : {"pqp", "pqpr", "hdio"}) EXPECT_EQ(names.count(name), 1u) << name;
    for (const auto& form : json["forms"]) {
        EXPECT_GT(form["bytes"].get<int>(), 0);
        if (form["name"] == "hdio") {
            EXPECT_EQ(form["bytes"], 3 * (64 * 16 + 16 * 16));
            EXPECT_EQ(form["lookups_per_light"], 2);
            EXPECT_EQ(form["isotropic"], true);
        }
    }
    const ToolRun run = runTool({"forms"});
    for (const std::string& name : names)
        EXPECT_NE(run.out.find("\n  " + name + " "), std::string::npos) << name;
}

TEST(Catalogue, HelpAndVersionAreResults)
{
    const ToolRun version = runTool({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out, "fbrdf " FBRDF_VERSION "\n");
    const ToolRun help = runTool({"--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* command : kCommands) {
        EXPECT_NE(help.out.find(std::string("\n  ") + command + " "), std::string::npos) << command;
        const ToolRun own = runTool({command, "--help"});
        EXPECT_EQ(own.code, 0) << command;
        EXPECT_EQ(own.err, "");
        EXPECT_NE(own.out.find(std::string("Usage: fbrdf ") + command), std::string::npos)
            << own.out;
    }
}

TEST(Catalogue, AFullDiskIsAnOutputError)
{
    ToolOptions full;
    full.stdoutPath = "/dev/full";
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"models"}, {"forms", "--json"}, {"--help"}, {"info", "lambert"}})
        expectError(runTool(arguments, full), 5, "standard output: cannot be written");
    full.input = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0.6,0,0.8\n";
    expectError(runTool({"eval", "lambert", "--pairs", "-"}, full), 5, "standard output");
}

}  // namespace
}  // namespace fbrdf::test
