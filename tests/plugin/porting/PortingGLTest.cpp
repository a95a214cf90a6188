// docs/porting.md: the code of the page draws what the runtime draws, and is the code that is
// compiled here.
#include "MinimalEngine.h"

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Scenes.h"

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace fbrdf::test {
namespace {

using porting::MinimalEngine;

constexpr int kSize = 64;
// The same programs on the same numbers, but texels of 16 bits where the runtime has floats.
constexpr double kAgainstRuntime = 1e-4;

class Porting : public GlTest {
protected:
    porting::Frame frame(const Offscreen& target, int lightCount)
    {
        const gl::View view = perspectiveView();
        porting::Frame frame;
        frame.framebuffer = target.framebuffer();
        frame.width = frame.height = kSize;
        frame.modelView = view.view;
        frame.projection = view.projection;
        frame.lights = inEye(testLights(lightCount), view.view);
        return frame;
    }

    static std::vector<Light> inEye(std::vector<Light> lights, const glm::mat4& view)
    {
        const glm::mat3 turn(view);
        for (Light& light : lights) {
            const bool isDirection = light.type == Light::Type::directional;
            light.position =
                isDirection ? turn * light.position : Vec3f(view * glm::vec4(light.position, 1.0f));
            light.axis = turn * light.axis;
        }
        return lights;
    }

    std::vector<float> picture(MinimalEngine& engine, porting::Frame frame, Offscreen& target,
                               Plan& plan)
    {
        target.clear();
        plan = engine.draw(frame);
        return target.readPixels();
    }

    std::vector<float> runtimePicture(const Material& material, const gl::MeshData& mesh,
                                      int lightCount, Transfer transfer)
    {
        gl::Renderer renderer = makeRenderer();
        const auto gpuMaterial = renderer.createMaterial(material);
        const auto gpuMesh = renderer.createMesh(mesh);
        Offscreen offscreen = makeOffscreen(kSize);
        offscreen.clear();
        gl::Target target;
        target.framebuffer = offscreen.framebuffer();
        target.width = target.height = kSize;
        target.transfer = transfer;
        gl::Item item;
        item.material = gpuMaterial.get();
        item.mesh = gpuMesh.get();
        renderer.draw(target, perspectiveView(), {item}, testLights(lightCount));
        return offscreen.readPixels();
    }

    void compareWithRuntime(const Material& material, const gl::MeshData& mesh, Transfer transfer)
    {
        MinimalEngine engine(gl(), material,
                             {mesh.positions, mesh.normals, mesh.tangents, mesh.indices});
        Offscreen target = makeOffscreen(kSize);
        for (const int count : {1, 9}) {
            const auto expected = runtimePicture(material, mesh, count, transfer);
            for (const auto technique : allTechniques()) {
                porting::Frame request = frame(target, count);
                request.technique = technique;
                request.transfer = transfer;
                Plan plan;
                const auto d = compareImages(picture(engine, request, target, plan), expected);
                EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime)
                    << material.name << ", " << count << " lights, " << techniqueName(technique)
                    << ": " << describe(d) << plan.reason;
                passes_.insert(plan.passes.size());
            }
        }
    }

    std::set<size_t> passes_;  ///< how many the plans had
};
INSTANTIATE_TEST_SUITE_P(Backends, Porting, ::testing::Values(GlVariant{Backend::egl, false}),
                         variantName);

TEST_P(Porting, TheMinimalEngineDrawsWhatTheRuntimeDraws)
{
    for (const Material& material : testMaterials())
        compareWithRuntime(material, sphereMesh(24), Transfer::linear);
    EXPECT_GT(passes_.size(), 3u);  // one pass, sums, products before sums
}

TEST_P(Porting, ACurveComesAfterTheSum)
{
    compareWithRuntime(testMaterials()[0], knotMesh(96, 16), Transfer::srgb);
}

TEST_P(Porting, ALostLightIsNoticed)
{
    const Material material = testMaterials()[0];
    const gl::MeshData mesh = sphereMesh(24);
    MinimalEngine engine(gl(), material,
                         {mesh.positions, mesh.normals, mesh.tangents, mesh.indices});
    Offscreen target = makeOffscreen(kSize);
    porting::Frame request = frame(target, 9);
    request.lights.pop_back();
    Plan plan;
    const auto found = picture(engine, request, target, plan);
    EXPECT_GT(compareImages(found, runtimePicture(material, mesh, 9, Transfer::linear)).maxRelative,
              10.0 * kAgainstRuntime);
}

std::string textOf(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Blocks of the page between ```cpp and ```.
std::vector<std::string> codeOf(const std::string& page)
{
    std::vector<std::string> blocks;
    for (size_t at = 0; (at = page.find("```cpp\n", at)) != std::string::npos;) {
        const size_t begin = at + 7, end = page.find("```", begin);
        blocks.push_back(page.substr(begin, end - begin));
        at = end + 3;
    }
    return blocks;
}

/// Without the space that begins a line, as code that is cut from a function stands farther left.
std::string unindented(const std::string& code)
{
    return std::regex_replace(code, std::regex("(^|\n) +"), "$1");
}

/// What lies between the lines "// [name]" and "// [end]".
std::vector<std::string> markedParts(const std::string& source)
{
    std::vector<std::string> parts;
    const std::regex mark("// \\[[a-z]+\\]\n([^]*?)\n *// \\[end\\]");
    for (std::sregex_iterator i(source.begin(), source.end(), mark), end; i != end; ++i)
        parts.push_back((*i)[1].str() + "\n");
    return parts;
}

TEST(PortingPage, ShowsTheCodeThatIsTested)
{
    const auto blocks = codeOf(textOf("docs/porting.md"));
    const auto parts = markedParts(textOf("tests/plugin/porting/MinimalEngine.cpp"));
    ASSERT_FALSE(parts.empty());
    ASSERT_EQ(blocks.size(), parts.size());
    for (size_t i = 0; i < parts.size(); ++i)
        EXPECT_EQ(unindented(blocks[i]), unindented(parts[i])) << "block " << i + 1;
}

// A uniform or an attribute that the shaders no longer have would send a reader astray.
TEST(PortingPage, NamesOnlyWhatTheShadersHave)
{
    const std::string page = textOf("docs/porting.md");
    std::string shaders;
    for (const char* file :
         {"runtime/shaders/glsl/surface.vert", "runtime/shaders/src/FragmentWriter.cpp",
          "runtime/shaders/src/FactorWriter.cpp", "runtime/shaders/src/ShaderSource.cpp",
          "runtime/shaders/include/fbrdf/shaders/ShaderSource.h"})
        shaders += textOf(file);
    const std::regex name("`(fbrdf[A-Z][A-Za-z]*)");
    size_t count = 0;
    for (std::sregex_iterator i(page.begin(), page.end(), name), end; i != end; ++i, ++count)
        EXPECT_NE(shaders.find((*i)[1].str()), std::string::npos) << (*i)[1].str();
    EXPECT_GT(count, 10u);
}

}  // namespace
}  // namespace fbrdf::test
