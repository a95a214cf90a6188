// Golden files: after an intended change of the shaders, write them anew with
//     FBRDF_UPDATE_GOLDEN=1 build-debug/bin/tool_test --gtest_filter='GlslCommand.*'
// from the root of the tree, and look at what git diff shows.
#include "Inputs.h"
#include "support/DataDir.h"
#include "support/TemporaryDir.h"
#include "Tool.h"

#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace fbrdf::test {
namespace {

constexpr char kBreak[] = "// ---- ";

Form formIoPqpr()
{
    Form form = formPqpr(8, 0.5, 6);
    form.name = "io+pqpr";
    form.tables.push_back(formHdio({2, 2, 6}).tables[1]);
    form.terms.insert(form.terms.begin(),
                      Term{{{3, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}}});
    return form;
}

/// Tables as a fit writes them: log8, whose shaders apply a range.
Material storedMaterial(const Form& form)
{
    Material material;
    material.form = form;
    material.name = form.name;
    for (const TableSpec& spec : form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.channels = 3;
        for (int i = 0; i < 3 * texelCount(spec.domain); ++i)
            table.texels.push_back(std::sin(0.1f * static_cast<float>(i)));
        material.tables.push_back(quantized(table, Storage::log8));
    }
    material.scales.assign(form.terms.size(), Vec3f(1.0f, 0.5f, 0.25f));
    return material;
}

struct Golden {
    Form form;
    std::vector<std::string> options;
};

std::vector<Golden> goldens()
{
    return {{formHdio({12, 6, 6}), {}},
            {formPqpr(8, 0.5, 6), {"--technique", "two-lookup", "--version", "120"}},
            {formIoPqpr(), {"--technique", "batched", "--version", "300", "--lights", "20"}}};
}

ToolRun runGlsl(const Form& form, const std::vector<std::string>& options)
{
    const TemporaryDir folder;
    writeMaterial(storedMaterial(form), folder.file("m.fbrdf"));
    std::vector<std::string> arguments{"glsl", folder.file("m.fbrdf")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runTool(arguments);
}

struct Shader {
    std::string heading, text;
};

std::vector<Shader> split(const std::string& output)
{
    std::vector<Shader> shaders;
    for (const std::string& line : linesOf(output))
        if (line.rfind(kBreak, 0) == 0)
            shaders.push_back({line, ""});
        else if (!shaders.empty())
            shaders.back().text += line + "\n";
    return shaders;
}

bool validates(const Shader& shader)
{
    const TemporaryDir folder;
    const bool isVertex = shader.heading.find("vertex") != std::string::npos;
    const std::string path = folder.file(isVertex ? "s.vert" : "s.frag");
    writeText(path, shader.text);
    return std::system(("'" FBRDF_GLSLANG "' " + path + " > /dev/null 2>&1").c_str()) == 0;
}

TEST(GlslCommand, PrintsTheGoldenFiles)
{
    for (const Golden& golden : goldens()) {
        const ToolRun run = runGlsl(golden.form, golden.options);
        ASSERT_EQ(run.code, 0) << run.err;
        const std::string path = "tests/tool/golden/" + golden.form.name + ".glsl";
        if (std::getenv("FBRDF_UPDATE_GOLDEN")) writeText(path, run.out);
        EXPECT_EQ(run.out, readText(path)) << path;
    }
}

TEST(GlslCommand, NamesEveryPassOnce)
{
    const Form pqpr = formPqpr(8, 0.5, 6);
    const auto shaders = split(runGlsl(pqpr, {"--technique", "two-lookup"}).out);
    ASSERT_EQ(shaders.size(), 3u);  // q(h) p(wi) r for each of 8 lights, then p(wo)
    EXPECT_EQ(shaders[0].heading, "// ---- vertex shader, pass 1 to 9");
    EXPECT_EQ(shaders[1].heading, "// ---- fragment shader, pass 1 to 8");
    EXPECT_EQ(shaders[2].heading, "// ---- fragment shader, pass 9");
    for (const Shader& shader : shaders) EXPECT_EQ(shader.text.rfind("#version 330\n", 0), 0u);
}

TEST(GlslCommand, PrintsShadersThatCompile)
{
    if (std::string(FBRDF_GLSLANG).find("NOTFOUND") != std::string::npos) {
        if (dataIsMandatory()) FAIL() << "CI=true, but no glslangValidator";
        GTEST_SKIP() << "needs glslangValidator (glslang-tools)";
    }
    for (const Golden& golden : goldens())
        for (const char* technique : {"single", "batched", "two-lookup"})
            for (const char* version : {"120", "330", "450", "300"})
                for (const Shader& shader :
                     split(runGlsl(golden.form, {"--technique", technique, "--version", version,
                                                 "--lights", "3"})
                               .out))
                    EXPECT_TRUE(validates(shader)) << golden.form.name << shader.heading << "\n"
                                                   << shader.text;
    EXPECT_FALSE(validates({"// ---- vertex shader", "#version 330\nvoid main() { oops }\n"}));
}

TEST(GlslCommand, PrintsFunctionsThatSampleWhereThereAreLobes)
{
    const Form form = formPqpr(8, 0.5, 6);
    const std::string plain = runGlsl(form, {"--functions"}).out;
    EXPECT_NE(plain.find("vec3 fbrdfEvaluate(vec3 wo, vec3 wi)"), std::string::npos);
    EXPECT_EQ(plain.find("fbrdfSampleLobes"), std::string::npos);
    Material material = storedMaterial(form);
    material.lobes.lobes = 1;
    material.lobes.thetas = 2;
    material.lobes.knots.resize(2);
    const TemporaryDir folder;
    writeMaterial(material, folder.file("m.fbrdf"));
    for (const char* const version : {"120", "300"})
        EXPECT_NE(runTool({"glsl", folder.file("m.fbrdf"), "--functions", "--version", version})
                      .out.find("vec4 fbrdfSampleLobes(vec3 wo, vec2 u)"),
                  std::string::npos);
}

TEST(GlslCommand, RefusesBadInput)
{
    expectError(runTool({"glsl", "missing.fbrdf"}), 3, "missing.fbrdf");
    expectError(runTool({"glsl", "missing.fbrdf", "--technique", "deferred"}), 2,
                "found 'deferred', expected one of single, batched, two-lookup");
    expectError(runTool({"glsl", "missing.fbrdf", "--version", "310"}), 2,
                "found 310, expected one of 120");
    expectError(runTool({"glsl", "missing.fbrdf", "--lights", "-1"}), 2, "--lights");
    expectError(runTool({"glsl"}), 2, "MATERIAL");
    expectError(runGlsl(formPqpr(8, 0.5, 6), {"--version", "100"}), 6, "GLSL ES 1.00");
}

}  // namespace
}  // namespace fbrdf::test
