// The contexts and offscreen framebuffers of fbrdf::headless.
#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"

namespace fbrdf::test {
namespace {

using Profile = HeadlessOptions::Profile;

TEST(BackendNames, RoundTrip)
{
    for (const Backend backend : {Backend::egl, Backend::osmesa})
        EXPECT_EQ(backendFromName(backendName(backend)), backend);
    EXPECT_THROW(backendFromName("glx"), Error);
}

TEST(Headless, SaysWhichVersionItCannotMake)
{
    for (const Backend backend : {Backend::egl, Backend::osmesa}) {
        try {
            HeadlessContext context({backend, Profile::core, 9, 9, true});
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::gl);
            EXPECT_NE(std::string(error.what()).find("9.9"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(HeadlessContext({Backend::osmesa, Profile::es, 3, 0, true}), Error);
}

TEST(Headless, MakesOpenGlEsOnEgl)
{
    const HeadlessContext context({Backend::egl, Profile::es, 3, 0, true});
    const auto getString =
        reinterpret_cast<const GLubyte* (*)(GLenum)>(context.loader()(nullptr, "glGetString"));
    const std::string version = reinterpret_cast<const char*>(getString(GL_VERSION));
    EXPECT_EQ(version.rfind("OpenGL ES", 0), 0u) << version;
    gl::RendererOptions options;
    options.load = context.loader();
    EXPECT_EQ(gl::Renderer(options).capabilities().glsl, 300);
}

class OffscreenTest : public GlTest {};

TEST_P(OffscreenTest, ReadsBackWhatItWasClearedTo)
{
    for (const OffscreenFormat format :
         {OffscreenFormat::rgba8, OffscreenFormat::rgba16f, OffscreenFormat::rgba32f}) {
        Offscreen offscreen(context().loader(), {5, 3, format, true});
        EXPECT_EQ(offscreen.width(), 5);
        EXPECT_EQ(offscreen.height(), 3);
        offscreen.clear(1.0f, 0.0f, 0.2f, 1.0f);  // 0.2 is 51 / 255
        const auto pixels = offscreen.readPixels();
        ASSERT_EQ(pixels.size(), 4u * 5u * 3u);
        for (size_t i = 0; i < pixels.size(); i += 4) {
            EXPECT_EQ(pixels[i], 1.0f);
            EXPECT_EQ(pixels[i + 1], 0.0f);
            EXPECT_NEAR(pixels[i + 2], 0.2f, 2e-4f);  // half an ulp of a half float
        }
    }
}

TEST_P(OffscreenTest, FloatTargetsHoldMoreThanOne)
{
    Offscreen offscreen(context().loader(), {1, 1, OffscreenFormat::rgba32f, false});
    offscreen.clear(1234.5f, -2.0f, 0.0f, 0.0f);
    EXPECT_EQ(offscreen.readPixels()[0], 1234.5f);
    EXPECT_EQ(offscreen.readPixels()[1], -2.0f);
}

TEST_P(OffscreenTest, LeavesBindingsAlone)
{
    const Offscreen bound(context().loader(), {4, 4, OffscreenFormat::rgba8, true});
    const GLuint framebuffer = bound.framebuffer();
    gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    Offscreen offscreen(context().loader(), {4, 4, OffscreenFormat::rgba8, true});
    offscreen.clear();
    offscreen.readPixels();
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING}) {
        GLint now = 0;
        gl().GetIntegerv(name, &now);
        EXPECT_EQ(static_cast<GLuint>(now), framebuffer);
    }
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, OffscreenTest, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
