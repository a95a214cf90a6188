// How finely this driver filters, on which the tolerances of the image tests rest: a ramp between
// two texels is magnified 4096 times.
#include <gtest/gtest.h>

#include "support/gl/GlTest.h"

#include <set>

namespace fbrdf::test {
namespace {

constexpr GLsizei kSteps = 4096;

class Filter : public GlTest {
protected:
    /// Counts the values between a black and a white texel, and reads the one in the middle.
    std::pair<size_t, float> ramp(GLint internalFormat)
    {
        const auto& g = gl();
        const float texels[] = {0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f};
        GLuint texture = 0, array = 0;
        g.GenTextures(1, &texture);
        g.BindTexture(GL_TEXTURE_2D, texture);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        g.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        g.TexImage2D(GL_TEXTURE_2D, 0, internalFormat, 2, 1, 0, GL_RGB, GL_FLOAT, texels);
        g.GenVertexArrays(1, &array);
        g.BindVertexArray(array);
        Offscreen offscreen(context().loader(), {kSteps, 1, OffscreenFormat::rgba32f, false});
        g.BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
        g.Viewport(0, 0, kSteps, 1);
        const GLuint program = linkProgram(
            g,
            "#version 140\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
            "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n",
            "#version 140\nuniform sampler2D map;\nout vec4 result;\nvoid main() { result = "
            "textureLod(map, vec2(0.25 + 0.5 * gl_FragCoord.x / 4096.0, 0.5), 0.0); }\n");
        g.UseProgram(program);
        g.DrawArrays(GL_TRIANGLES, 0, 3);
        const auto pixels = offscreen.readPixels();
        std::set<float> distinct;
        for (size_t i = 0; i < static_cast<size_t>(kSteps); ++i) distinct.insert(pixels[4 * i]);
        g.UseProgram(0);
        g.DeleteProgram(program);
        g.DeleteTextures(1, &texture);
        g.BindVertexArray(0);
        g.DeleteVertexArrays(1, &array);
        g.BindFramebuffer(GL_FRAMEBUFFER, 0);
        return {distinct.size(), pixels[4 * static_cast<size_t>(3 * kSteps / 4)]};
    }
};

// The formats in which the runtime uploads tables. Hardware may filter in 256 steps; the image
// tests would then need larger tolerances.
TEST_P(Filter, IsFineForTheFormatsThatTheRuntimeUses)
{
    for (const GLint format : {GL_RGB16, GL_RGB16F, GL_RGB32F}) {
        const auto [distinct, threeQuarters] = ramp(format);
        EXPECT_GE(distinct, 2048u) << "format " << format;
        EXPECT_NEAR(threeQuarters, 0.75f, 1e-3f) << "format " << format;
    }
}

TEST_P(Filter, RampSeesCoarseFiltering)  // the tester: 8-bit texels cannot have more than 256 steps
{
    const size_t distinct = ramp(GL_RGB8).first;
    RecordProperty("steps_of_rgb8", static_cast<int>(distinct));
    EXPECT_GT(distinct, 2u);
    const std::string name = reinterpret_cast<const char*>(gl().GetString(GL_RENDERER));
    const bool known = name.find("llvmpipe") != std::string::npos;
    EXPECT_TRUE(!known || distinct <= 257u) << distinct;
}

INSTANTIATE_TEST_SUITE_P(Backends, Filter, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
