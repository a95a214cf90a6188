// Targets other than RGBA32F, items in front of each other, targets that cannot be drawn to.
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;
// The target rounds once: by half a step of 1/255, or half an ulp of 11 bits, which llvmpipe rounds
// towards 0. A sum of two terms is blended once more.
constexpr float kByteStep = 1.01f / 255.0f;
constexpr float kHalfUlp = 1.01f / 1024.0f;

class Targets : public GlTest {
protected:
    struct Drawn {
        std::vector<float> pixels;
        gl::DrawStats stats;
    };
    Drawn draw(gl::Renderer& renderer, const Material& material, OffscreenFormat format,
               Technique technique, int lights)
    {
        const auto gpu = renderer.createMaterial(material);
        const auto mesh = renderer.createMesh(sphereMesh(16));
        auto dim = testLights(lights);
        for (Light& light : dim) light.intensity /= static_cast<float>(4 * lights);
        Offscreen offscreen = makeOffscreen(kSize, format);
        Drawn drawn;
        drawn.stats = renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                    {{gpu.get(), mesh.get()}}, dim, {technique, 8, 0});
        drawn.pixels = offscreen.readPixels();
        return drawn;
    }
};

TEST_P(Targets, CoarseTargetsGetTheirSumFromAFloatSurface)
{
    gl::Renderer renderer = makeRenderer();
    for (const Material& material : testMaterials()) {
        const auto exact =
            draw(renderer, material, OffscreenFormat::rgba32f, Technique::single, 64).pixels;
        for (const OffscreenFormat format : {OffscreenFormat::rgba8, OffscreenFormat::rgba16f}) {
            const auto [pixels, stats] = draw(renderer, material, format, Technique::twoLookup, 64);
            EXPECT_EQ(stats.accumulation, "RGBA32F") << material.name;
            EXPECT_LE(stats.maxLookups, 2);
            const bool bytes = format == OffscreenFormat::rgba8;
            const float terms = static_cast<float>(material.form.terms.size());
            for (size_t i = 0; i < exact.size(); ++i) {
                const float expected = bytes ? std::min(exact[i], 1.0f) : exact[i];
                const float tolerance = terms * (bytes ? kByteStep : kHalfUlp * exact[i] + 1e-6f);
                ASSERT_NEAR(pixels[i], expected, tolerance) << material.name << " number " << i;
            }
        }
    }
}

TEST_P(Targets, OnePassNeedsNoOtherSurface)
{
    gl::Renderer renderer = makeRenderer();
    const auto stats =
        draw(renderer, testMaterials()[0], OffscreenFormat::rgba8, Technique::single, 64).stats;
    EXPECT_EQ(stats.accumulation, "RGBA8");
    EXPECT_EQ(stats.passes, 1);
}

TEST_P(Targets, AreDrawnOverWhatIsBehindOnly)
{
    gl::Renderer renderer = makeRenderer();
    const auto gpu = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(16));
    for (const Technique technique : {Technique::single, Technique::twoLookup}) {
        Offscreen offscreen = makeOffscreen(kSize);
        offscreen.clear(0.25f, 0.5f, 0.75f, 0.0f);
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{gpu.get(), mesh.get()}}, testLights(3), {technique, 8, 0});
        const auto pixels = offscreen.readPixels();
        EXPECT_EQ(pixels[0], 0.25f);
        EXPECT_EQ(pixels[3], 0.0f);
        const size_t middle = 4 * (kSize / 2 * kSize + kSize / 2);
        EXPECT_EQ(pixels[middle + 3], 1.0f);
        // The object drawn again behind itself changes nothing.
        glm::mat4 behind(1.0f);
        behind[3][2] = -3.0f;
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{gpu.get(), mesh.get(), behind}}, testLights(5), {technique, 8, 0});
        EXPECT_EQ(offscreen.readPixels()[middle], pixels[middle]);
    }
}

TEST_P(Targets, WithoutLightsAreBlackWhereTheMeshIs)
{
    gl::Renderer renderer = makeRenderer();
    const auto gpu = renderer.createMaterial(testMaterials()[3]);
    const auto mesh = renderer.createMesh(sphereMesh(16));
    Offscreen offscreen = makeOffscreen(kSize);
    offscreen.clear(0.25f, 0.5f, 0.75f, 0.0f);
    const auto stats = renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                     {{gpu.get(), mesh.get()}}, {}, {Technique::twoLookup, 8, 0});
    EXPECT_EQ(stats.passes, 1);
    EXPECT_EQ(stats.maxLookups, 0);
    const auto pixels = offscreen.readPixels();
    const size_t middle = 4 * (kSize / 2 * kSize + kSize / 2);
    EXPECT_EQ(pixels[middle], 0.0f);
    EXPECT_EQ(pixels[middle + 3], 1.0f);
    EXPECT_EQ(pixels[0], 0.25f);
}

TEST_P(Targets, ThatCannotBeDrawnToAreRefused)
{
    gl::Renderer renderer = makeRenderer();
    Offscreen offscreen = makeOffscreen(kSize);
    Offscreen flat(context().loader(), {8, 8, OffscreenFormat::rgba32f, false});
    const auto expectRefused = [&](const gl::Target& target, const char* words) {
        try {
            renderer.draw(target, perspectiveView(), {}, {});
            ADD_FAILURE() << "no error, expected " << words;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::gl);
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
    };
    expectRefused({flat.framebuffer(), 8, 8}, "depth");
    expectRefused({offscreen.framebuffer(), 0, 8}, "0x8");
    expectRefused({offscreen.framebuffer(), 8, -1}, "8x-1");
    const auto stats =
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(), {}, {});
    EXPECT_EQ(stats.drawCalls, 0);  // and the next good call works
}

TEST_P(Targets, IncompleteFramebuffersAreRefused)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    GLuint framebuffer = 0, texture = 0;
    gl().GenTextures(1, &texture);
    gl().BindTexture(GL_TEXTURE_2D, texture);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl().GenFramebuffers(1, &framebuffer);
    gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    hooks.refuseFramebuffers = true;
    try {
        renderer.draw({framebuffer, 8, 8}, perspectiveView(), {}, {});
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("complete"), std::string::npos) << error.what();
    }
    gl().DeleteFramebuffers(1, &framebuffer);
    gl().DeleteTextures(1, &texture);
}

TEST_P(Targets, WithoutAFloatSurfaceAnotherTechniqueIsTaken)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const Material pqp = testMaterials()[0];
    const auto exact = draw(renderer, pqp, OffscreenFormat::rgba8, Technique::single, 8).pixels;
    hooks.refuseFramebuffers = true;
    const auto [pixels, stats] =
        draw(renderer, pqp, OffscreenFormat::rgba8, Technique::twoLookup, 8);
    EXPECT_EQ(pixels, exact);
    EXPECT_EQ(stats.passes, 1);
    ASSERT_EQ(log.size(), 2u);
    EXPECT_NE(log[0].find("RGBA32F"), std::string::npos);
    EXPECT_NE(log[1].find("replaced by single"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Backends, Targets, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
