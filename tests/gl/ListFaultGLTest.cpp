// ListFaultGLTest.cpp - what keeps the GPU from making lists of lights: the CPU makes them, the
// picture is the same, and the reason is told. What keeps anybody from it is an error, and the next
// call works.
#include <gtest/gtest.h>

#include "support/ExpectError.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

class ListFault : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        capabilities_ = makeRenderer().capabilities();
        if (capabilities_.computeBuffers == 0) GTEST_SKIP() << "needs compute shaders";
    }

    /// Draws 60 lights with lists of whom the options ask.
    Drawn drawLists(gl::Renderer& renderer, const gl::DrawOptions& options)
    {
        const auto material = renderer.createMaterial(testMaterials()[0]);
        const auto mesh = renderer.createMesh(sphereMesh(12));
        return drawItems(renderer, kSize, perspectiveView(), {{material.get(), mesh.get()}},
                         lights_, options);
    }
    static gl::DrawOptions listsBy(gl::ListsBy who)
    {
        gl::DrawOptions options;
        options.clustered = true;
        options.listsBy = who;
        return options;
    }

    /// Expects a renderer to draw with lists of the CPU, for this reason, and to tell so once.
    void expectCpuLists(gl::Renderer& renderer, const std::string& reason,
                        bool isToldAlready = false)
    {
        const Drawn cpu = drawLists(renderer, listsBy(gl::ListsBy::cpu));
        log.clear();
        const Drawn fallen = drawLists(renderer, listsBy(gl::ListsBy::gpu));
        EXPECT_EQ(fallen.stats.listsBy, gl::ListsBy::cpu);
        EXPECT_NE(fallen.stats.whyListsByCpu.find(reason), std::string::npos)
            << fallen.stats.whyListsByCpu;
        EXPECT_EQ(fallen.stats.itemsFailed, 0);
        EXPECT_EQ(fallen.pixels, cpu.pixels);
        // Told once, in a line; then again in the statistics of each draw.
        EXPECT_EQ(drawLists(renderer, listsBy(gl::ListsBy::gpu)).stats.whyListsByCpu,
                  fallen.stats.whyListsByCpu);
        ASSERT_EQ(log.size(), isToldAlready ? 0u : 1u);
        EXPECT_TRUE(isToldAlready || log[0].find("made by the CPU") != std::string::npos);
    }
    void expectCpuListsWith(const Capabilities& capabilities, const std::string& reason)
    {
        gl::RendererOptions options = rendererOptions();
        options.capabilities = capabilities;
        gl::Renderer renderer(options);
        expectCpuLists(renderer, reason);
    }

    Capabilities capabilities_;
    std::vector<Light> lights_ = [] {
        auto lights = testLights(60);
        for (size_t i = 0; i < lights.size(); ++i) lights[i].radius = i % 9 == 0 ? 0.0f : 5.0f;
        return lights;
    }();
};

TEST_P(ListFault, AShaderThatDoesNotCompile)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    drawLists(renderer, listsBy(gl::ListsBy::cpu));  // builds the other programs
    expectMessages();
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(12));
    hooks.corruptShaders = true;
    const Drawn fallen =
        drawItems(renderer, kSize, perspectiveView(), {{material.get(), mesh.get()}}, lights_,
                  listsBy(gl::ListsBy::gpu));
    hooks.corruptShaders = false;
    EXPECT_NE(fallen.stats.whyListsByCpu.find("does not compile"), std::string::npos);
    EXPECT_EQ(fallen.stats.itemsFailed, 0);
    expectCpuLists(renderer, "does not compile", true);  // the driver is not asked again
}

TEST_P(ListFault, AProgramThatDoesNotLink)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    drawLists(renderer, listsBy(gl::ListsBy::cpu));
    expectMessages();
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(12));
    hooks.spoilPrograms = true;
    drawItems(renderer, kSize, perspectiveView(), {{material.get(), mesh.get()}}, lights_,
              listsBy(gl::ListsBy::gpu));
    hooks.spoilPrograms = false;
    expectCpuLists(renderer, "does not link", true);
}

TEST_P(ListFault, AnOlderContext)
{
    Capabilities old = capabilities_;
    old.glMajor = 3;
    old.glMinor = 3;
    old.computeBuffers = 0;
    expectCpuListsWith(old, "OpenGL 3.3 without compute shaders");
}

TEST_P(ListFault, AContextThatHasTooFewStorageBuffers)
{
    Capabilities few = capabilities_;
    few.computeBuffers = 2;
    expectCpuListsWith(few, "2 storage buffers of a compute shader, expected at least 3");
}

TEST_P(ListFault, StorageBuffersThatAreTooSmall)
{
    Capabilities small = capabilities_;
    small.maxStorageBytes = 4096;
    expectCpuListsWith(small, "expected at most");
}

TEST_P(ListFault, AFunctionThatIsMissing)
{
    Hooks hooks(context().loader());
    for (const char* const name :
         {"glDispatchCompute", "glMemoryBarrier", "glBindBufferBase", "glGetInteger64i_v"}) {
        hooks.hidden = {name};
        gl::Renderer renderer(hooked(hooks));
        expectCpuLists(renderer, "without compute shaders");
    }
}

TEST_P(ListFault, NoMemoryForTheLists)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(12));
    const auto draw = [&](gl::ListsBy who) {
        return drawItems(renderer, kSize, perspectiveView(), {{material.get(), mesh.get()}},
                         lights_, listsBy(who));
    };
    const Drawn cpu = draw(gl::ListsBy::cpu);
    for (Light& light : lights_) light.radius *= 1.1f;
    // The buffer of reaches is the first that grows; errors of the host are looked for before.
    hooks.errorAfter = 1;
    hooks.nextError = GL_OUT_OF_MEMORY;
    const Drawn fallen = draw(gl::ListsBy::gpu);
    EXPECT_EQ(fallen.stats.listsBy, gl::ListsBy::cpu);
    EXPECT_NE(fallen.stats.whyListsByCpu.find("out of memory"), std::string::npos);
    const Drawn next = draw(gl::ListsBy::gpu);
    EXPECT_EQ(next.stats.listsBy, gl::ListsBy::gpu) << next.stats.whyListsByCpu;
    EXPECT_EQ(next.pixels, fallen.pixels);
    EXPECT_NE(next.pixels, cpu.pixels);
}

TEST_P(ListFault, MoreLightsThanAnyBufferHasIsAnErrorAndTheNextCallWorks)
{
    gl::RendererOptions options = rendererOptions();
    options.capabilities = capabilities_;
    options.capabilities->maxBufferTexels = 8192;
    gl::Renderer renderer(options);
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(12));
    const std::vector<Light> few(lights_.begin(), lights_.begin() + 10);
    std::vector<Light> many;
    for (int i = 0; i < 60; ++i) many.insert(many.end(), lights_.begin(), lights_.end());
    Offscreen offscreen = makeOffscreen(kSize);
    const auto draw = [&](const std::vector<Light>& lights, gl::ListsBy who) {
        return renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                             {{material.get(), mesh.get()}}, lights, listsBy(who));
    };
    for (const gl::ListsBy who : {gl::ListsBy::cpu, gl::ListsBy::gpu}) {
        // Three texels a light.
        expectError(ErrorKind::gl, "lights: found 10800 texels, expected at most 8192",
                    [&] { draw(many, who); });
        EXPECT_EQ(draw(few, who).itemsFailed, 0);
    }
}

TEST_P(ListFault, AContextThatIsLostWhileListsAreMade)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(12));
    Offscreen offscreen = makeOffscreen(kSize);
    const auto draw = [&](gl::ListsBy who) {
        return renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                             {{material.get(), mesh.get()}}, lights_, listsBy(who));
    };
    // A lost context has no names for new objects: neither a shader nor a buffer can be made.
    hooks.loseContext = true;
    expectError(ErrorKind::gl, "no name for a new object", [&] { draw(gl::ListsBy::gpu); });
    expectError(ErrorKind::gl, "no name for a new object", [&] { draw(gl::ListsBy::cpu); });
    hooks.loseContext = false;
    EXPECT_EQ(draw(gl::ListsBy::cpu).itemsFailed, 0);
    const auto stats = draw(gl::ListsBy::gpu);
    EXPECT_NE(stats.whyListsByCpu.find("no shader object"), std::string::npos);
    renderer.abandonContext();
    expectError(ErrorKind::gl, "abandoned", [&] { draw(gl::ListsBy::gpu); });
}

INSTANTIATE_TEST_SUITE_P(Backends, ListFault, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
