// GlTest.h - the fixture of tests that need a GL context: on every backend, and once as an old
// context would be used (GLSL 1.20, no vertex arrays). Any error that GL reports fails the test.
#pragma once
#include "Gl.h"

#include <fbrdf/gl/Renderer.h>
#include <fbrdf/headless/Offscreen.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace fbrdf::test {

struct GlVariant {
    Backend backend = Backend::egl;
    bool legacy = false;  ///< compatibility context, GLSL 1.20, no vertex arrays
};
std::string variantName(const ::testing::TestParamInfo<GlVariant>& info);
/// EGL and OSMesa, each modern and legacy.
std::vector<GlVariant> allVariants();
/// EGL and OSMesa, modern.
std::vector<GlVariant> modernVariants();

/// Reports every GL error message of the current context as a test failure.
void failOnGlMessages(const GladGLContext& gl);

/// A picture, RGBA, bottom row first, and the messages about it.
struct Drawn {
    std::vector<float> pixels;
    gl::DrawStats stats;
};

class Hooks;

class GlTest : public ::testing::TestWithParam<GlVariant> {
protected:
    /// Skips where the backend is missing; with CI=true in the environment that fails.
    void SetUp() override;
    void TearDown() override;

    HeadlessContext& context() { return *context_; }
    const GladGLContext& gl() const { return gl_; }
    /// Options of a renderer of this variant; its messages go to `log`.
    gl::RendererOptions rendererOptions();
    /// The same, with the hooks between the renderer and GL.
    gl::RendererOptions hooked(Hooks& hooks);
    gl::Renderer makeRenderer() { return gl::Renderer(rendererOptions()); }
    /// Materials are drawn with these as exactly as floats allow: the shader filters where the
    /// context does so coarsely.
    gl::MaterialOptions exactOptions(gl::Renderer& renderer);
    /// A material of these options.
    std::shared_ptr<gl::GpuMaterial> exactMaterial(gl::Renderer& renderer,
                                                   const Material& material);
    Offscreen makeOffscreen(int size = 64, OffscreenFormat format = OffscreenFormat::rgba32f);

    /// Draws the items to an RGBA32F target of size x size.
    Drawn drawItems(gl::Renderer& renderer, int size, const gl::View& view,
                    const std::vector<gl::Item>& items, const std::vector<Light>& lights,
                    const gl::DrawOptions& options = {});

    /// Called by tests that provoke messages of the driver, such as those about a shader that does
    /// not compile.
    void expectMessages() const { gl_.Disable(GL_DEBUG_OUTPUT); }

    std::vector<std::string> log;

private:
    std::unique_ptr<HeadlessContext> context_;
    GladGLContext gl_{};
};

/// A test with a renderer, which goes before the context does.
class RendererTest : public GlTest {
protected:
    void SetUp() override;
    void TearDown() override;
    bool isReady() const { return !IsSkipped() && !HasFatalFailure(); }

    std::unique_ptr<gl::Renderer> renderer_;
};

}  // namespace fbrdf::test
