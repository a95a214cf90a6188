// Every program that the test materials can need, in every version, through glslangValidator.
#include <fbrdf/base/Error.h>
#include <fbrdf/shaders/PrefilterSource.h>
#include <fbrdf/shaders/ShaderSource.h>
#include <fbrdf/shaders/TextureImage.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "support/DataDir.h"
#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

namespace fbrdf {
namespace {

Capabilities capable()
{
    Capabilities c;
    c.maxUniformVectors = 4096;
    c.framebufferObjects = c.floatTargets = c.floatTextures = true;
    return c;
}

std::vector<TableEncoding> encodingsOf(const Material& material)
{
    std::vector<TableEncoding> encodings;
    for (const Table& table : material.tables)
        encodings.push_back(textureImage(table, capable()).encoding);
    return encodings;
}

/// Encodings in which every disc is a cube map.
std::vector<TableEncoding> cubeEncodings(const Material& material)
{
    std::vector<TableEncoding> encodings = encodingsOf(material);
    for (size_t i = 0; i < encodings.size(); ++i)
        if (isDisc(material.tables[i].domain)) encodings[i].lookUp = LookUp::cube;
    return encodings;
}

/// Encodings in which the shader filters.
std::vector<TableEncoding> preciseEncodings(const Material& material)
{
    std::vector<TableEncoding> encodings = encodingsOf(material);
    for (size_t i = 0; i < encodings.size(); ++i)
        encodings[i].precise = !material.form.tables[i].uniform;
    return encodings;
}

/// Fragment shaders of all passes that any technique, limit and target leads to.
void addSources(const Material& material, const std::vector<TableEncoding>& encodings, int glsl,
                std::map<std::string, std::string>& sources)
{
    for (const Technique technique : allTechniques())
        for (const int lights : {0, 1, 20})
            for (const int lookups : {0, 1, 3})
                for (const ColourFormat target : {ColourFormat::rgba32f, ColourFormat::rgba8}) {
                    PlanRequest request;
                    request.technique = technique;
                    request.lights = lights;
                    request.maxLookups = lookups;
                    request.target = target;
                    const Plan plan = planPasses(material.form, request, capable());
                    for (const Pass& pass : plan.passes) {
                        const auto text =
                            fragmentSource(material.form, encodings, programSpec(pass, 2000), glsl);
                        sources.emplace(text, std::to_string(sources.size()) + ".frag");
                    }
                }
}

int validate(const std::string& arguments)
{
    return std::system(("'" FBRDF_GLSLANG "' " + arguments + " > /dev/null 2>&1").c_str());
}

class ShaderValidation : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (std::string(FBRDF_GLSLANG).find("NOTFOUND") == std::string::npos) return;
        if (test::dataIsMandatory()) FAIL() << "CI=true, but no glslangValidator";
        GTEST_SKIP() << "needs glslangValidator (glslang-tools)";
    }

    std::string write(const std::string& name, const std::string& text)
    {
        const std::string path = directory_.file(name);
        std::ofstream(path) << text;
        return path;
    }

    test::TemporaryDir directory_;
};

TEST_F(ShaderValidation, AcceptsEveryGeneratedProgram)
{
    size_t count = 0;
    for (const int glsl : {120, 140, 150, 330, 450, 300}) {
        std::map<std::string, std::string> sources;
        for (const Material& material : test::testMaterials())
            addSources(material, encodingsOf(material), glsl, sources);
        const Material pqp = test::testMaterials().front();
        addSources(pqp, cubeEncodings(pqp), glsl, sources);
        for (const Material& material : test::testMaterials())
            addSources(material, preciseEncodings(material), glsl, sources);
        std::string files = write("surface.vert", vertexSource(glsl));
        for (const auto& [text, name] : sources) files += " " + write(name, text);
        count += sources.size();
        if (validate(files) == 0) continue;
        for (const auto& [text, name] : sources)
            if (validate(write(name, text)) != 0) ADD_FAILURE() << glsl << "\n" << text;
        ADD_FAILURE() << "GLSL " << glsl;
    }
    EXPECT_GT(count, 200u);
}

TEST_F(ShaderValidation, AcceptsTheProbesOfFilters)
{
    for (const int glsl : kGlslVersions)
        for (const ProbedTexture texture : {ProbedTexture::plane, ProbedTexture::cube,
                                            ProbedTexture::volume, ProbedTexture::array}) {
            const bool old = glsl == 100 || glsl == 120;
            // Arrays are probed where there are libraries, volumes where there are any.
            if (texture == ProbedTexture::array && (old || glsl == 300)) continue;
            if (texture == ProbedTexture::volume && glsl == 100) continue;
            EXPECT_EQ(validate(write("probe.vert", filterProbeVertexSource(glsl)) + " " +
                               write("probe.frag", filterProbeFragmentSource(glsl, texture))),
                      0)
                << glsl << " " << static_cast<int>(texture);
        }
}

bool fitsEs100(const Form& form)
{
    for (const TableSpec& table : form.tables)
        if (table.uniform || dimensionCount(table.domain) == 3) return false;
    return true;
}

TEST_F(ShaderValidation, Es100TakesWhatItCanAndNamesWhatItCannot)
{
    int taken = 0, refused = 0;
    for (const Material& material : test::testMaterials()) {
        std::map<std::string, std::string> sources;
        if (!fitsEs100(material.form)) {
            ++refused;
            try {
                materialFunctions(material.form, encodingsOf(material), 100, 4);
                ADD_FAILURE() << material.name << " was taken";
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()).find("GLSL ES 1.00 has no"), std::string::npos)
                    << error.what();
            }
            continue;
        }
        ++taken;
        addSources(material, encodingsOf(material), 100, sources);
        addSources(material, cubeEncodings(material), 100, sources);
        std::string files = write("surface.vert", vertexSource(100));
        for (const auto& [text, name] : sources) files += " " + write(name, text);
        EXPECT_EQ(validate(files), 0) << material.name;
    }
    EXPECT_GT(taken, 3);
    EXPECT_GT(refused, 1);
}

TEST_F(ShaderValidation, FunctionsAndListsOfEs)
{
    const Material material = test::testMaterials().front();
    for (const auto& [glsl, head] :
         {std::pair{100, "#version 100\n"}, std::pair{300, "#version 300 es\n"}}) {
        const std::string output = glsl == 300 ? "out vec4 colour;\n" : "",
                          name = glsl == 300 ? "colour" : "gl_FragColor";
        EXPECT_EQ(
            validate(write("host.frag",
                           head + materialFunctions(material.form, encodingsOf(material), glsl, 4) +
                               output + "void main() { " + name +
                               " = vec4(fbrdfRadiance(vec3(0.0), vec3(0.0, 0.0, 1.0), vec3(1.0, "
                               "0.0, 0.0), vec3(0.0, 0.0, 1.0)), 1.0); }\n")),
            0)
            << glsl;
        ProgramSpec lists{{{0, {0, 1, 2}, true}}, 1, true, false};
        lists.clustered = true;
        EXPECT_THROW(fragmentSource(material.form, encodingsOf(material), lists, glsl), Error);
    }
}

TEST_F(ShaderValidation, FunctionsWithLightsOfTheHost)
{
    const std::string
        host =
            "uniform vec4 hostLights[64];\n"
            "vec3 fbrdfHostLight(int light, vec3 position, out vec3 wi)\n"
            "{ wi = normalize(hostLights[light].xyz - position); return hostLights[light].www; }\n",
        use =
            "void main() { gl_FragColor = vec4(fbrdfRadiance(vec3(0.0), vec3(0.0, "
            "0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0)), 1.0); }\n";
    HostLights lights{host};
    for (const LobeShare& lobes : {LobeShare{}, wholeShare({LobeAxes::tilted, 2, 8})}) {
        lights.lobes = lobes;
        for (const Material& material : test::testMaterials()) {
            const std::string head =
                lobes.isEmpty() ? "#version 120\n"
                                : "#version 120\n#extension GL_ARB_shader_texture_lod : require\n";
            const std::string text =
                materialFunctions(material.form, encodingsOf(material), 120, lights);
            EXPECT_EQ(text.find("fbrdfLights"), std::string::npos);
            EXPECT_EQ(validate(write("host.frag", head + text + use)), 0) << material.name;
            // The host may define its function behind the text.
            EXPECT_EQ(validate(write("behind.frag",
                                     head +
                                         materialFunctions(material.form, encodingsOf(material),
                                                           120, HostLights{"", lobes}) +
                                         host + use)),
                      0)
                << material.name;
            EXPECT_THROW(materialFunctions(material.form, encodingsOf(material), 100, lights),
                         Error);
        }
    }
}

TEST_F(ShaderValidation, FunctionsThatSample)
{
    const Material material = test::testMaterials().front();
    for (const int glsl : {120, 140, 330, 450, 300}) {
        const std::string head =
            "#version " + std::to_string(glsl) + (glsl == 300 ? " es\n" : "\n");
        const std::string output = glsl == 120 ? "" : "out vec4 colour;\n",
                          name = glsl == 120 ? "gl_FragColor" : "colour";
        for (const LobeLayout& table :
             {LobeLayout{LobeAxes::tilted, 1, 24}, LobeLayout{LobeAxes::tilted, 3, 24},
              LobeLayout{LobeAxes::bent, 3, 12, 7}})
            EXPECT_EQ(validate(write(
                          "sampling.frag",
                          head + materialFunctions(material.form, encodingsOf(material), glsl, 4) +
                              samplingFunctions(table, glsl) + output +
                              "void main() { vec3 wo = vec3(0.0, 0.6, 0.8); vec4 drawn = "
                              "fbrdfSampleLobes(wo, vec2(0.3, 0.7)); " +
                              name +
                              " = vec4(fbrdfEvaluate(wo, drawn.xyz), fbrdfLobePdf(wo, drawn.xyz)); "
                              "}\n")),
                      0)
                << glsl;
    }
}

TEST_F(ShaderValidation, AcceptsBuiltInInputs)
{
    const Material material = test::testMaterials().front();
    const std::vector<TableEncoding> encodings(material.form.tables.size());
    for (const SurfaceInputs& inputs : {SurfaceInputs{true, false}, SurfaceInputs{true, true}}) {
        const std::string fragment =
            fragmentSource(material.form, encodings,
                           ProgramSpec{{{0, {0, 1, 2}, true}}, 1, true, false}, 120, inputs);
        EXPECT_EQ(validate(write("surface.vert", vertexSource(120, inputs)) + " " +
                           write("surface.frag", fragment)),
                  0);
    }
}

TEST_F(ShaderValidation, AcceptsInstancesAndArrays)
{
    SurfaceInputs inputs;
    inputs.instanced = true;
    for (const int glsl : {140, 330, 450})
        for (const bool ranged : {false, true})
            for (const Form& form : {formPqpr(8, 0.5, 6), formHdio({8, 8, 8})}) {
                const std::vector<TableEncoding> encodings(form.tables.size(), {true, ranged});
                ProgramSpec spec{{{0, {0, 1}, true}}, 4, true, false};
                if (form.terms[0].factors.size() > 3) spec.parts[0].factors.push_back(3);
                if (ranged)
                    spec.lobes = {{LobeAxes::bent, 5, 12, 7}, 1, 3, false};
                else
                    spec.lobes = {{LobeAxes::tilted, 3, 24, 1}, 1, 2, false};
                const std::string fragment = fragmentSource(form, encodings, spec, glsl, inputs);
                EXPECT_EQ(validate("-l " + write("surface.vert", vertexSource(glsl, inputs)) + " " +
                                   write("surface.frag", fragment)),
                          0)
                    << fragment;
            }
    for (const int glsl : {120, 100, 300}) EXPECT_THROW(vertexSource(glsl, inputs), Error);
}

TEST_F(ShaderValidation, AcceptsLobesAndWhatPrefiltersThem)
{
    const LobeLayout tilted{LobeAxes::tilted, 3, 24, 1}, bent{LobeAxes::bent, 5, 12, 7};
    for (const int glsl : {120, 140, 150, 330, 450, 300}) {
        std::string files = write("surface.vert", vertexSource(glsl));
        int count = 0;
        const auto add = [&](const std::string& text) {
            files += " " + write("lobes" + std::to_string(count++) + ".frag", text);
        };
        // Forms with a local frame and without, lights or none, all lobes or one.
        for (const Form& form : {formPqp(8, 0.5), formHdio({8, 8, 8})})
            for (const int lights : {0, 4})
                for (const LobeShare& share : {LobeShare{tilted, 0, 3, true},
                                               {tilted, 2, 1, false},
                                               {bent, 0, 5, true},
                                               {bent, 1, 2, false},
                                               {tilted, 0, 3, true, true, 0, 0, 0, 8, 4},
                                               {bent, 0, 5, true, true, 0, 0, 0, 8, 4},
                                               {tilted, 0, 3, true, false, 0, 0, 4},
                                               {bent, 1, 2, false, true, 0, 0, 2}}) {
                    ProgramSpec spec;
                    if (lights > 0) spec = {{{0, {0, 1}, true}}, lights, true, false};
                    spec.lobes = share;
                    const std::vector<TableEncoding> encodings(form.tables.size());
                    add(fragmentSource(form, encodings, spec, glsl));
                    spec.areaLists = share.areaSlots > 0;
                    if (spec.areaLists && glsl != 120 && glsl != 300)
                        add(fragmentSource(form, encodings, spec, glsl));
                }
        for (const bool fromCube : {false, true}) add(prefilterSourceFragment(glsl, fromCube));
        add(prefilterLobeFragment(glsl));
        EXPECT_EQ(validate(files), 0) << glsl;
    }
    ProgramSpec spec;
    spec.lobes = {tilted, 0, 3, true};
    const Form form = formPqp(8, 0.5);
    EXPECT_THROW(fragmentSource(form, std::vector<TableEncoding>(2), spec, 100), Error);
}

TEST_F(ShaderValidation, AcceptsHooksNormalMapsAndDerivedTangents)
{
    SurfaceInputs inputs;
    inputs.normalMap = inputs.derivedTangent = true;
    inputs.vertexHook =
        "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position += fbrdfExtra0.xyz; normal.x += 0.5; tangent.w = -tangent.w; }\n";
    inputs.shadowHook =
        "uniform float shade;\nfloat fbrdfShadow(int light, vec3 position, vec3 toLight)\n"
        "{ return light == 1 ? shade : toLight.x; }\n";
    inputs.tintHook =
        "uniform sampler2D tint;\nvec4 fbrdfTint()\n"
        "{ return FBRDF_TEXTURE_MIPMAPPED(tint, fbrdfTextureCoordinate); }\n";
    inputs.tintedTerms = {0};
    const Form form = formPqp(8, 0.5);
    for (const int glsl : {120, 140, 150, 330, 450, 100, 300})
        for (const int lights : {1, 4})
            for (const bool clustered : {false, true}) {
                if (clustered && (glsl == 120 || glsl == 100 || glsl == 300)) continue;
                ProgramSpec spec{{{0, {0, 1, 2}, true}}, lights, true, false};
                spec.clustered = clustered;
                const std::string fragment =
                    fragmentSource(form, std::vector<TableEncoding>(2), spec, glsl, inputs);
                EXPECT_EQ(validate(write("surface.vert", vertexSource(glsl, inputs)) + " " +
                                   write("surface.frag", fragment)),
                          0)
                    << glsl << "\n"
                    << fragment;
            }
}

TEST_F(ShaderValidation, LinksTheStages)
{
    for (const int glsl :
         {140, 330, 450, 100, 300}) {  // glslang links neither GLSL 1.20 varyings nor built-ins
        std::map<std::string, std::string> sources;
        const Material material = test::testMaterials().front();
        addSources(material, encodingsOf(material), glsl, sources);
        const std::string vertex = write("surface.vert", vertexSource(glsl));
        for (const auto& [text, name] : sources)
            EXPECT_EQ(validate("-l " + vertex + " " + write(name, text)), 0) << text;
    }
}

TEST_F(ShaderValidation, TheProgramThatMakesListsIsValid)
{
    EXPECT_EQ(validate(write("lists.comp", clusterListsSource())), 0);
    EXPECT_NE(validate(write("broken.comp", clusterListsSource() + "}")), 0);
}

TEST_F(ShaderValidation, RejectsABrokenProgram)
{
    std::map<std::string, std::string> sources;
    const Material material = test::testMaterials().front();
    addSources(material, encodingsOf(material), 330, sources);
    std::string text = sources.begin()->first;
    text.replace(text.find("vec4(total"), 4, "vec3");
    EXPECT_NE(validate(write("broken.frag", text)), 0);
}

}  // namespace
}  // namespace fbrdf
