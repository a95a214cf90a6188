// What can go wrong with environments is an error or a count with one line that says why, the next
// call works, and the host's state stays.
#include <gtest/gtest.h>

#include "StateTest.h"
#include "support/ExpectError.h"
#include "support/gl/EnvironmentReference.h"
#include "support/gl/Hooks.h"

#include <limits>

namespace fbrdf::test {
namespace {

constexpr int kPixels = 32, kFace = 16;
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

class EnvironmentFault : public StateTest {
protected:
    static std::shared_ptr<gl::GpuEnvironment> made(gl::Renderer& renderer)
    {
        return renderer.createEnvironment(testPanorama(16), {kFace, false});
    }
    static std::shared_ptr<gl::GpuMaterial> material(gl::Renderer& renderer)
    {
        return renderer.createMaterial(
            withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)));
    }
    gl::DrawStats draw(gl::Renderer& renderer, const gl::GpuMaterial& material,
                       const gl::GpuMesh& mesh, const gl::EnvironmentLight& light,
                       const std::vector<Light>& lights = {})
    {
        Offscreen offscreen = makeOffscreen(kPixels);
        gl::DrawOptions options;
        options.environment = light;
        const auto stats = renderer.draw({offscreen.framebuffer(), kPixels, kPixels},
                                         perspectiveView(), {{&material, &mesh}}, lights, options);
        pixels = offscreen.readPixels();
        return stats;
    }
    std::vector<float> pixels;
};

TEST_P(EnvironmentFault, MakingPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    std::vector<Vec3f> expected;
    for (unsigned seed = 0; seed < 8; ++seed) {
        std::shared_ptr<gl::GpuEnvironment> environment;
        scrambler_->scramble(seed);
        const StateSnapshot before = now();
        environment = made(*renderer_);
        EXPECT_EQ(difference(before, now()), "") << "seed " << seed;
        scrambler_->setDefaults();
        EXPECT_EQ(environment->whyNotOnGpu(), "");
        const auto texels = readCube(gl(), *environment).levels[0];
        if (seed == 0) expected = texels;
        ASSERT_EQ(texels, expected) << "seed " << seed;
    }
}

TEST_P(EnvironmentFault, RefiningPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    constexpr int kFine = 64;
    gl::EnvironmentOptions options{kFine, false};
    const auto expected =
        readCube(gl(), *renderer_->createEnvironment(testPanorama(16), options)).levels[0];
    options.gradual = true;
    for (unsigned seed = 0; seed < 4; ++seed) {
        const auto environment = renderer_->createEnvironment(testPanorama(16), options);
        bool isFinished = false;
        while (!isFinished) {
            scrambler_->scramble(seed);
            const StateSnapshot before = now();
            isFinished = renderer_->refine(*environment, 10000);
            EXPECT_EQ(difference(before, now()), "") << "seed " << seed;
            scrambler_->setDefaults();
        }
        ASSERT_EQ(readCube(gl(), *environment).levels[0], expected) << "seed " << seed;
    }
}

TEST_P(EnvironmentFault, DrawingPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto gpu = material(*renderer_);
    const auto environment = made(*renderer_);
    Offscreen offscreen = makeOffscreen(kPixels);
    for (const Technique technique : {Technique::single, Technique::twoLookup}) {
        gl::DrawOptions options{technique};
        options.environment.map = environment.get();
        std::vector<float> expected;
        for (unsigned seed = 0; seed < 8; ++seed) {
            offscreen.clear();
            scrambler_->scramble(seed);
            const StateSnapshot before = now();
            renderer_->draw({offscreen.framebuffer(), kPixels, kPixels}, perspectiveView(),
                            {{gpu.get(), mesh.get()}}, testLights(2), options);
            EXPECT_EQ(difference(before, now()), "") << "seed " << seed;
            scrambler_->setDefaults();
            if (seed == 0) expected = offscreen.readPixels();
            ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
        }
    }
}

TEST_P(EnvironmentFault, SizesThatAreNoneAreRefused)
{
    for (const int size : {-8, 1, 4, 12, 100})
        expectError(ErrorKind::usage, "power of two", [&] {
            renderer_->createEnvironment(testPanorama(16), {size, false});
        });
    const int beyond = 1 << 20;
    expectError(ErrorKind::gl, "at most", [&] {
        renderer_->createEnvironment(testPanorama(16), {beyond, false});
    });
    EXPECT_EQ(made(*renderer_)->size(), kFace);
}

TEST_P(EnvironmentFault, InvalidPanoramasAreRefused)
{
    Panorama panorama = testPanorama(16);
    panorama.texels.pop_back();
    expectError(ErrorKind::input, "texels", [&] { renderer_->createEnvironment(panorama); });
    for (const float value : {kNoNumber, -1.0f, std::numeric_limits<float>::infinity()}) {
        panorama = testPanorama(16);
        panorama.texels[3].y = value;
        expectError(ErrorKind::input, "texel", [&] { renderer_->createEnvironment(panorama); });
    }
    expectError(ErrorKind::input, "texels", [&] { renderer_->createEnvironment(Panorama{}); });
    made(*renderer_);
}

TEST_P(EnvironmentFault, TexturesThatAreNoneAreRefused)
{
    expectMessages();
    GLuint texture = 0;
    gl().GenTextures(1, &texture);
    for (const uint32_t name : {0u, 12345u, texture})
        expectError(ErrorKind::gl, "texture", [&] {
            renderer_->createEnvironment(gl::HostEnvironment{name, false}, {kFace, false});
        });
    gl().BindTexture(GL_TEXTURE_2D, texture);
    gl().BindTexture(GL_TEXTURE_2D, 0);
    expectError(ErrorKind::gl, "without texels", [&] {
        renderer_->createEnvironment(gl::HostEnvironment{texture, false}, {kFace, false});
    });
    // A 2D texture is no cube map.
    expectError(ErrorKind::gl, "GL error", [&] {
        renderer_->createEnvironment(gl::HostEnvironment{texture, true}, {kFace, false});
    });
    gl().DeleteTextures(1, &texture);
    made(*renderer_);
}

TEST_P(EnvironmentFault, LightOutOfRangeIsRefused)
{
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto gpu = material(*renderer_);
    const auto environment = made(*renderer_);
    gl::EnvironmentLight good;
    good.map = environment.get();
    const auto refused = [&](const std::string& words, const gl::EnvironmentLight& light) {
        expectError(ErrorKind::usage, words, [&] { draw(*renderer_, *gpu, *mesh, light); });
    };
    for (const float value : {kNoNumber, -1.0f, std::numeric_limits<float>::infinity()}) {
        gl::EnvironmentLight light = good;
        light.intensity.y = value;
        refused("intensity", light);
    }
    for (const float scale : {0.0f, 2.0f, kNoNumber}) {
        gl::EnvironmentLight light = good;
        light.rotation[1] *= scale;
        refused("rotation", light);
    }
    gl::EnvironmentLight light = good;
    light.lobes = -1;
    refused("lobes", light);
    EXPECT_EQ(draw(*renderer_, *gpu, *mesh, good).itemsWithoutEnvironment, 0);
}

TEST_P(EnvironmentFault, OfNoIntensityIsNone)
{
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto gpu = material(*renderer_);
    const auto environment = made(*renderer_);
    gl::EnvironmentLight light;
    draw(*renderer_, *gpu, *mesh, light, testLights(2));
    const auto without = pixels;
    light.map = environment.get();
    light.intensity = Vec3f(0.0f);
    const auto stats = draw(*renderer_, *gpu, *mesh, light, testLights(2));
    EXPECT_EQ(stats.itemsWithoutEnvironment, 0);
    EXPECT_EQ(pixels, without);
}

TEST_P(EnvironmentFault, OfAnotherRendererIsRefused)
{
    gl::Renderer other = makeRenderer();
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto gpu = material(*renderer_);
    const auto foreign = made(other), own = made(*renderer_);
    expectError(ErrorKind::usage, "another renderer",
                [&] { draw(*renderer_, *gpu, *mesh, {foreign.get()}); });
    EXPECT_EQ(draw(*renderer_, *gpu, *mesh, {own.get()}).itemsFailed, 0);
}

TEST_P(EnvironmentFault, ReleasedRightAfterADrawIsDrawn)
{
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto gpu = material(*renderer_);
    auto environment = made(*renderer_);
    draw(*renderer_, *gpu, *mesh, {environment.get()});
    const auto expected = pixels;
    Offscreen offscreen = makeOffscreen(kPixels);
    gl::DrawOptions options;
    options.environment.map = environment.get();
    renderer_->draw({offscreen.framebuffer(), kPixels, kPixels}, perspectiveView(),
                    {{gpu.get(), mesh.get()}}, {}, options);
    environment.reset();
    EXPECT_EQ(offscreen.readPixels(), expected);
}

TEST_P(EnvironmentFault, LeavesNoObjectBehind)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto alive = hooks.alive;
    made(renderer);
    for (const auto& [kind, count] : hooks.alive) {
        const auto before = alive.find(kind);
        EXPECT_EQ(count, before == alive.end() ? 0 : before->second) << kind;
    }
}

TEST_P(EnvironmentFault, AfterTheContextIsAnError)
{
    gl::Renderer renderer = makeRenderer();
    const auto environment = made(renderer);
    const GLuint texture = environment->texture();
    renderer.abandonContext();
    expectError(ErrorKind::gl, "abandoned", [&] { made(renderer); });
    gl().DeleteTextures(1, &texture);
}

TEST_P(EnvironmentFault, RefusedFramebuffersLeaveItToTheCpu)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    hooks.refuseFramebuffers = true;
    const auto environment = made(renderer);
    EXPECT_NE(environment->whyNotOnGpu(), "");
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("cannot be drawn to"), std::string::npos) << log[0];
    expectError(ErrorKind::gl, "cannot be drawn to", [&] {
        renderer.createEnvironment(gl::HostEnvironment{environment->texture(), true},
                                   {kFace, false});
    });
    hooks.refuseFramebuffers = false;
    EXPECT_EQ(made(renderer)->whyNotOnGpu(), "");
}

TEST_P(EnvironmentFault, ShadersThatDoNotCompileLeaveItToTheCpu)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    expectMessages();
    hooks.corruptShaders = true;
    EXPECT_NE(made(renderer)->whyNotOnGpu().find("compile"), std::string::npos);
    hooks.corruptShaders = false;
    EXPECT_EQ(made(renderer)->whyNotOnGpu(), "");
}

TEST_P(EnvironmentFault, OutOfMemoryIsReported)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    hooks.errorAfter = 1;
    hooks.nextError = GL_OUT_OF_MEMORY;
    EXPECT_NE(made(renderer)->whyNotOnGpu().find("out of memory"), std::string::npos);
    hooks.errorAfter = 1;
    hooks.nextError = GL_OUT_OF_MEMORY;
    const CubeImage cube = readCube(gl(), *made(*renderer_));
    expectError(ErrorKind::gl, "out of memory", [&] { renderer.createEnvironment(cube); });
    EXPECT_EQ(made(renderer)->whyNotOnGpu(), "");
}

TEST_P(EnvironmentFault, AContextThatCannotHaveItDrawsWithout)
{
    Capabilities poor = renderer_->capabilities();
    poor.glsl = 120;
    poor.textureLod = false;
    gl::RendererOptions options = rendererOptions();
    options.capabilities = poor;
    if (!GetParam().legacy) return;  // a core profile has no GLSL 1.20
    gl::Renderer renderer(options);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    const auto gpu = material(renderer);
    const auto environment = made(renderer);  // on the CPU
    log.clear();
    draw(renderer, *gpu, *mesh, {}, testLights(2));
    const auto without = pixels;
    for (int frame = 0; frame < 3; ++frame) {
        const auto stats = draw(renderer, *gpu, *mesh, {environment.get()}, testLights(2));
        EXPECT_EQ(stats.itemsFailed, 0);
        EXPECT_EQ(stats.itemsWithoutEnvironment, 1);
        EXPECT_NE(stats.whyNoEnvironment.find("texture_lod"), std::string::npos);
        EXPECT_EQ(stats.environmentError, 0.0);
        EXPECT_EQ(pixels, without);
    }
    EXPECT_EQ(log.size(), 1u);
}

TEST_P(EnvironmentFault, LobesThatCannotBeFittedAreLoggedOnce)
{
    Material material = noiseMaterial(formIo(), Storage::float32);
    material.tables[0].texels[7] = 4000.0f;  // log2: finite there, infinite as a reflectance
    const auto gpu = renderer_->createMaterial(material);
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto environment = made(*renderer_);
    gl::DrawOptions options;
    options.environment.map = environment.get();
    log.clear();
    renderer_->prepare(*gpu, options, 0);
    for (int frame = 0; frame < 3; ++frame) {
        const auto stats = draw(*renderer_, *gpu, *mesh, {environment.get()});
        EXPECT_EQ(stats.itemsFailed, 0);
        EXPECT_EQ(stats.itemsWithoutEnvironment, 1);
        EXPECT_EQ(stats.whyNoEnvironment.find("being fitted"), std::string::npos);
    }
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("without the environment"), std::string::npos) << log[0];
}

TEST_P(EnvironmentFault, PackedMaterialsWithoutLobesAreDrawnWithoutAndSaySo)
{
    const Material material = noiseMaterial(formPqpr(8, 0.5, 6), Storage::log8);
    const auto library = renderer_->createLibrary({material, material});
    if (!library->whyNotPacked().empty()) GTEST_SKIP() << library->whyNotPacked();
    const auto mesh = renderer_->createMesh(sphereMesh(8));
    const auto environment = made(*renderer_);
    Offscreen offscreen = makeOffscreen(kPixels);
    gl::DrawOptions options;
    options.environment.map = environment.get();
    const auto stats = renderer_->drawBatch(
        {offscreen.framebuffer(), kPixels, kPixels}, perspectiveView(),
        {library.get(), mesh.get(), {{glm::mat4(1.0f), 0}, {glm::mat4(1.0f), 1}}}, {}, options);
    EXPECT_EQ(stats.itemsFailed, 0);
    EXPECT_EQ(stats.itemsWithoutEnvironment, 2);
    EXPECT_NE(stats.whyNoEnvironment.find("packed"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Backends, EnvironmentFault, ::testing::ValuesIn(allVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
