#include "GlTest.h"

#include "CoarseFilter.h"
#include "Hooks.h"
#include "Scenes.h"

#include <fbrdf/base/Error.h>

#include "support/DataDir.h"

#include <algorithm>
#include <cstdlib>

namespace fbrdf::test {
namespace {

void GLAD_API_PTR onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
                            const GLchar* text, const void*)
{
    const bool bad = type == GL_DEBUG_TYPE_ERROR || severity != GL_DEBUG_SEVERITY_NOTIFICATION;
    if (bad) ADD_FAILURE() << "GL: " << std::string(text, static_cast<size_t>(length));
}

HeadlessOptions contextOptions(const GlVariant& variant)
{
    using Profile = HeadlessOptions::Profile;
    if (variant.legacy) return {variant.backend, Profile::compatibility, 2, 1, true};
    return {variant.backend, Profile::core, 3, 3, true};
}

}  // namespace

std::string variantName(const ::testing::TestParamInfo<GlVariant>& info)
{
    return std::string(backendName(info.param.backend)) + (info.param.legacy ? "_legacy" : "");
}

std::vector<GlVariant> allVariants()
{
    return {{Backend::egl, false},
            {Backend::osmesa, false},
            {Backend::egl, true},
            {Backend::osmesa, true}};
}

std::vector<GlVariant> modernVariants()
{
    return {{Backend::egl, false}, {Backend::osmesa, false}};
}

void failOnGlMessages(const GladGLContext& gl)
{
    if (!gl.KHR_debug) return;
    gl.Enable(GL_DEBUG_OUTPUT);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl.DebugMessageCallback(onMessage, nullptr);
}

void GlTest::SetUp()
{
    try {
        context_ = std::make_unique<HeadlessContext>(contextOptions(GetParam()));
    } catch (const Error& error) {
        if (dataIsMandatory()) FAIL() << error.what();
        GTEST_SKIP() << error.what();
    }
    gl_ = loadGl(context_->loader());
    failOnGlMessages(gl_);
}

void GlTest::TearDown()
{
    if (!context_) return;
    context_->makeCurrent();
    EXPECT_EQ(gl_.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

gl::RendererOptions GlTest::rendererOptions()
{
    gl::RendererOptions options;
    options.load = context_->loader();
    // FBRDF_TEST_FILTER_BITS=8 plays a GPU: see CoarseFilter.h.
    if (const char* bits = std::getenv("FBRDF_TEST_FILTER_BITS"))
        options.load = coarselyFiltering(context_->options().backend, std::atoi(bits));
    options.log = [this](gl::Severity, const std::string& text) { log.push_back(text); };
    if (!GetParam().legacy && GetParam().backend == Backend::egl) return options;
    Capabilities old = gl::Renderer(options).capabilities();
    options.capabilities = old;
    options.capabilities->glsl = std::min(old.glsl, 330);  // EGL tests what the driver has, 4.50
    if (!GetParam().legacy) return options;
    old.glsl = 120;
    old.vertexArrays = false;
    options.capabilities = old;
    return options;
}

Drawn GlTest::drawItems(gl::Renderer& renderer, int size, const gl::View& view,
                        const std::vector<gl::Item>& items, const std::vector<Light>& lights,
                        const gl::DrawOptions& options)
{
    Offscreen offscreen = makeOffscreen(size);
    Drawn drawn;
    drawn.stats =
        renderer.draw({offscreen.framebuffer(), size, size}, view, items, lights, options);
    drawn.pixels = offscreen.readPixels();
    return drawn;
}

gl::RendererOptions GlTest::hooked(Hooks& hooks)
{
    gl::RendererOptions options = rendererOptions();
    options.load = Hooks::load;
    options.loadUser = &hooks;
    return options;
}

gl::MaterialOptions GlTest::exactOptions(gl::Renderer& renderer)
{
    constexpr double kCoarse = 1e-4;  // octaves: float arithmetic is a hundred times finer
    gl::MaterialOptions options;
    const Material noise = noiseMaterial(formIo(), Storage::half);
    options.precise = renderer.createMaterial(noise)->filterError() > kCoarse;
    return options;
}

std::shared_ptr<gl::GpuMaterial> GlTest::exactMaterial(gl::Renderer& renderer,
                                                       const Material& material)
{
    return renderer.createMaterial(material, exactOptions(renderer));
}

Offscreen GlTest::makeOffscreen(int size, OffscreenFormat format)
{
    Offscreen result(context_->loader(), {size, size, format, true});
    result.clear();
    return result;
}

void RendererTest::SetUp()
{
    GlTest::SetUp();
    if (isReady()) renderer_ = std::make_unique<gl::Renderer>(makeRenderer());
}

void RendererTest::TearDown()
{
    renderer_.reset();
    GlTest::TearDown();
}

}  // namespace fbrdf::test
