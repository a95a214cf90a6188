// Everything that can go wrong gives an error of the right kind with words that help, and the next
// good call works.
#include <gtest/gtest.h>

#include "support/ExpectError.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <cstdlib>
#include <limits>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Fault : public GlTest {
protected:
    gl::DrawStats draw(gl::Renderer& renderer, const gl::Item& item,
                       const std::vector<Light>& lights, const gl::DrawOptions& options = {})
    {
        Offscreen offscreen = makeOffscreen(kSize);
        return renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(), {item},
                             lights, options);
    }
};

TEST_P(Fault, NoLoaderIsRefused)
{
    expectError(ErrorKind::gl, "loader", [] { gl::Renderer renderer({}); });
}

TEST_P(Fault, ALoaderThatYieldsNothingIsRefused)
{
    gl::RendererOptions options;
    options.load = [](void*, const char*) -> void* { return nullptr; };
    expectError(ErrorKind::gl, "loader", [&] { gl::Renderer renderer(options); });
}

// Whichever function is missing, there is a refusal or a picture, never a crash.
TEST_P(Fault, AnyMissingFunctionIsRefusedOrNotNeeded)
{
    Hooks hooks(context().loader());
    const gl::RendererOptions options = hooked(hooks);
    {
        gl::Renderer renderer(options);
    }
    const Material material = testMaterials()[2];
    int refused = 0;
    const auto names = hooks.asked;
    for (const std::string& name : names) {
        hooks.hidden = {name};
        try {
            gl::Renderer renderer(options);
            const auto gpu = renderer.createMaterial(material);
            const auto mesh = renderer.createMesh(sphereMesh(2));
            const auto stats =
                draw(renderer, {gpu.get(), mesh.get()}, testLights(2), {Technique::twoLookup});
            EXPECT_EQ(stats.itemsFailed, 0) << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::gl) << name;
            ++refused;
        }
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(names.size(), 500u);
}

TEST_P(Fault, AnOldVersionIsRefused)
{
    gl::RendererOptions options = rendererOptions();
    Capabilities old = makeRenderer().capabilities();
    old.glMajor = 2;
    old.glMinor = 0;
    options.capabilities = old;
    expectError(ErrorKind::gl, "2.0", [&] { gl::Renderer renderer(options); });
    old = makeRenderer().capabilities();
    old.glsl = 110;
    options.capabilities = old;
    expectError(ErrorKind::gl, "110", [&] { gl::Renderer renderer(options); });
}

TEST_P(Fault, TextureUnitsOutOfRangeAreRefused)
{
    gl::RendererOptions options = rendererOptions();
    options.firstTextureUnit = -1;
    expectError(ErrorKind::usage, "unit", [&] { gl::Renderer renderer(options); });
    options.firstTextureUnit = 1000;
    expectError(ErrorKind::usage, "unit", [&] { gl::Renderer renderer(options); });
}

TEST_P(Fault, MoreTexturesThanUnitsAreRefused)
{
    gl::RendererOptions options = rendererOptions();
    Capabilities few = makeRenderer().capabilities();
    few.maxTextureUnits = 1;
    options.capabilities = few;
    gl::Renderer renderer(options);
    expectError(ErrorKind::gl, "textures", [&] { renderer.createMaterial(testMaterials()[0]); });
    renderer.createMaterial(noiseMaterial(formIo(), Storage::log8));
}

TEST_P(Fault, TablesTooLargeAreRefused)
{
    gl::RendererOptions options = rendererOptions();
    Capabilities small = makeRenderer().capabilities();
    small.maxTextureSize = 8;
    options.capabilities = small;
    gl::Renderer renderer(options);
    expectError(ErrorKind::gl, "16 texels", [&] { renderer.createMaterial(testMaterials()[0]); });
}

TEST_P(Fault, BrokenMaterialsAreRefused)
{
    gl::Renderer renderer = makeRenderer();
    Material material = testMaterials()[0];
    material.tables[0].texels[3] = kNan;
    expectError(ErrorKind::input, "finite", [&] { renderer.createMaterial(material); });
    material = testMaterials()[0];
    material.tables.pop_back();
    expectError(ErrorKind::input, "tables", [&] { renderer.createMaterial(material); });
    material = testMaterials()[0];
    material.scales.clear();
    expectError(ErrorKind::input, "scales", [&] { renderer.createMaterial(material); });
    renderer.createMaterial(testMaterials()[0]);
}

TEST_P(Fault, BrokenMeshesAreRefused)
{
    gl::Renderer renderer = makeRenderer();
    const gl::MeshData good = sphereMesh(4);
    gl::MeshData mesh = good;
    mesh.normals.pop_back();
    expectError(ErrorKind::input, "normals", [&] { renderer.createMesh(mesh); });
    mesh = good;
    mesh.tangents.resize(1);
    expectError(ErrorKind::input, "tangents", [&] { renderer.createMesh(mesh); });
    mesh = good;
    mesh.indices.pop_back();
    expectError(ErrorKind::input, "indices", [&] { renderer.createMesh(mesh); });
    mesh = good;
    mesh.indices[5] = static_cast<uint32_t>(mesh.positions.size());
    expectError(ErrorKind::input, "index", [&] { renderer.createMesh(mesh); });
    expectError(ErrorKind::input, "indices", [&] { renderer.createMesh(gl::MeshData{}); });
    renderer.createMesh(good);
}

TEST_P(Fault, OutOfMemoryIsReported)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    renderer.createMaterial(testMaterials()[0]);  // measures how finely the context filters
    // The error comes where the upload asks for one, after those of the host were looked for.
    hooks.errorAfter = 1;
    hooks.nextError = GL_OUT_OF_MEMORY;
    expectError(ErrorKind::gl, "out of memory", [&] { renderer.createMesh(sphereMesh(4)); });
    hooks.errorAfter = 1;
    hooks.nextError = GL_OUT_OF_MEMORY;
    expectError(ErrorKind::gl, "out of memory",
                [&] { renderer.createMaterial(testMaterials()[0]); });
    renderer.createMesh(sphereMesh(4));
}

TEST_P(Fault, ErrorsOfTheHostAreNotTakenForOurs)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    hooks.nextError = GL_INVALID_OPERATION;
    renderer.createMesh(sphereMesh(4));
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("host"), std::string::npos);
}

TEST_P(Fault, AShaderThatDoesNotCompileIsRefusedWithItsLog)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    hooks.corruptShaders = true;
    expectMessages();
    expectError(ErrorKind::gl, "compile", [&] { renderer.createMaterial(testMaterials()[0]); });
}

TEST_P(Fault, ADrawSurvivesAShaderThatDoesNotCompile)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    const gl::Item item{material.get(), mesh.get()};
    expectMessages();
    hooks.corruptShaders = true;  // two-lookup needs programs that do not exist yet
    for (int frame = 0; frame < 3; ++frame)
        EXPECT_EQ(draw(renderer, item, testLights(3), {Technique::twoLookup}).itemsFailed, 1);
    EXPECT_EQ(log.size(), 1u);  // reported once, not every frame
    EXPECT_EQ(draw(renderer, item, testLights(1)).itemsFailed, 0);
    expectError(ErrorKind::gl, "compile",
                [&] { renderer.prepare(*material, {Technique::twoLookup}, 3); });
}

TEST_P(Fault, LightsThatAreNotNumbersAreDroppedAndCounted)
{
    gl::Renderer renderer = makeRenderer();
    const auto material = renderer.createMaterial(testMaterials()[2]);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    auto lights = testLights(4);
    Offscreen offscreen = makeOffscreen(kSize);
    const gl::Target target{offscreen.framebuffer(), kSize, kSize};
    renderer.draw(target, perspectiveView(), {{material.get(), mesh.get()}}, lights);
    const auto expected = offscreen.readPixels();
    lights.insert(lights.begin() + 1, Light{Light::Type::point, Vec3f(kNan), Vec3f(1.0f), 0.0f});
    lights.push_back({Light::Type::directional, Vec3f(0.0f), Vec3f(1.0f), 0.0f});
    lights.push_back({Light::Type::point, Vec3f(1.0f), Vec3f(1.0f), -2.0f});
    offscreen.clear();
    const auto stats =
        renderer.draw(target, perspectiveView(), {{material.get(), mesh.get()}}, lights);
    EXPECT_EQ(stats.lightsGiven, 7);
    EXPECT_EQ(stats.lightsUsed, 4);
    EXPECT_EQ(stats.lightsDropped, 3);
    EXPECT_EQ(offscreen.readPixels(), expected);
}

TEST_P(Fault, ALightOnTheSurfaceStaysFinite)
{
    gl::Renderer renderer = makeRenderer();
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    Offscreen offscreen = makeOffscreen(kSize);
    const std::vector<Light> lights{{Light::Type::point, {0.0f, 0.0f, 1.0f}, Vec3f(1.0f), 0.0f}};
    renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                  {{material.get(), mesh.get()}}, lights, {Technique::twoLookup});
    for (const float value : offscreen.readPixels()) ASSERT_TRUE(std::isfinite(value));
}

TEST_P(Fault, ItemsThatCannotBeDrawnAreLeftOutAndCounted)
{
    gl::Renderer renderer = makeRenderer(), other = makeRenderer();
    const auto material = renderer.createMaterial(testMaterials()[2]);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    const auto foreign = other.createMesh(sphereMesh(8));
    Offscreen offscreen = makeOffscreen(kSize);
    const auto stats = renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                     {{nullptr, mesh.get()},
                                      {material.get(), nullptr},
                                      {material.get(), foreign.get()},
                                      {material.get(), mesh.get(), glm::mat4(0.0f)},
                                      {material.get(), mesh.get(), glm::mat4(kNan)},
                                      {material.get(), mesh.get()}},
                                     testLights(2));
    EXPECT_EQ(stats.itemsFailed, 5);
    EXPECT_EQ(stats.drawCalls, 1);
    EXPECT_EQ(log.size(), 3u);  // the same text is reported once
}

TEST_P(Fault, ViewsAndOptionsOutOfRangeAreRefused)
{
    gl::Renderer renderer = makeRenderer();
    Offscreen offscreen = makeOffscreen(kSize);
    const gl::Target target{offscreen.framebuffer(), kSize, kSize};
    gl::View view = perspectiveView();
    view.projection = glm::mat4(0.0f);
    expectError(ErrorKind::usage, "singular", [&] { renderer.draw(target, view, {}, {}); });
    view = perspectiveView();
    view.view[3][0] = kNan;
    expectError(ErrorKind::usage, "finite", [&] { renderer.draw(target, view, {}, {}); });
    expectError(ErrorKind::usage, "lights a pass", [&] {
        renderer.draw(target, perspectiveView(), {}, {}, {Technique::batched, 0, 0});
    });
    expectError(ErrorKind::usage, "look-ups", [&] {
        renderer.draw(target, perspectiveView(), {}, {}, {Technique::single, 8, -1});
    });
    renderer.draw(target, perspectiveView(), {}, {});
}

TEST_P(Fault, AnAnisotropicMaterialOnAMeshWithoutTangentsIsDrawnWithAWarning)
{
    gl::Renderer renderer = makeRenderer();
    const auto material = renderer.createMaterial(testMaterials()[0]);
    gl::MeshData bare = sphereMesh(8);
    bare.tangents.clear();
    const auto mesh = renderer.createMesh(bare);
    EXPECT_EQ(draw(renderer, {material.get(), mesh.get()}, testLights(2)).itemsFailed, 0);
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("tangents"), std::string::npos);
    draw(renderer, {material.get(), mesh.get()}, testLights(2));
    EXPECT_EQ(log.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Backends, Fault, ::testing::ValuesIn(allVariants()), variantName);

// ctest runs this in a process whose driver reports 2.0 (see CMakeLists.txt); elsewhere it is
// skipped.
TEST(Driver, OfVersion20IsRefused)
{
    const char* version = std::getenv("MESA_GL_VERSION_OVERRIDE");
    if (!version || std::string(version) != "2.0") GTEST_SKIP() << "needs a driver of version 2.0";
    HeadlessContext context({Backend::egl, HeadlessOptions::Profile::compatibility, 2, 0, true});
    gl::RendererOptions options;
    options.load = context.loader();
    expectError(ErrorKind::gl, "2.0", [&] { gl::Renderer renderer(options); });
}

TEST(Driver, WithoutAContextIsRefused)
{
    gl::RendererOptions options;
    options.load = HeadlessContext::loadEgl;
    expectError(ErrorKind::gl, "no current context", [&] { gl::Renderer renderer(options); });
}

}  // namespace
}  // namespace fbrdf::test
