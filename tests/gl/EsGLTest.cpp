// The renderer in contexts of OpenGL ES 3.0 and 2.0, compared with the reference in double, whose
// geometry a desktop context of the same driver interpolates.
#include <gtest/gtest.h>

#include "support/DataDir.h"
#include "support/ExpectError.h"
#include "support/gl/EnvironmentReference.h"
#include "support/gl/Reference.h"

#include <algorithm>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;
constexpr int kLights = 9;

class Es : public ::testing::Test {
protected:
    void SetUp() override
    try {
        using Profile = HeadlessOptions::Profile;
        desktop_ =
            std::make_unique<HeadlessContext>(HeadlessOptions{Backend::egl, Profile::core, 3, 3});
        // A driver gives the newest version that is compatible; MESA_GLES_VERSION_OVERRIDE makes
        // that 2.0.
        es_ = std::make_unique<HeadlessContext>(HeadlessOptions{Backend::egl, Profile::es, 2, 0});
    } catch (const Error& error) {
        if (dataIsMandatory()) FAIL() << error.what();
        GTEST_SKIP() << error.what();
    }
    void TearDown() override
    {
        if (!es_) return;
        es_->makeCurrent();
        EXPECT_EQ(loadGl(es_->loader()).GetError(), GLenum(GL_NO_ERROR));
    }

    gl::RendererOptions options()
    {
        es_->makeCurrent();
        gl::RendererOptions options;
        options.load = es_->loader();
        options.log = [this](gl::Severity, const std::string& text) { log.push_back(text); };
        return options;
    }

    /// Radiance at most about 1, from lights of which some have a radius.
    static std::vector<Light> lights()
    {
        auto lights = testLights(kLights);
        for (Light& light : lights) light.intensity /= static_cast<float>(2 * kLights);
        return lights;
    }

    std::vector<double> reference(const Material& material, const gl::MeshData& mesh,
                                  const SurfaceReference& surface = {},
                                  const std::vector<Light>& lit = lights())
    {
        desktop_->makeCurrent();
        Offscreen offscreen(desktop_->loader(), {kSize, kSize});
        const auto geometry = geometryBuffer(loadGl(desktop_->loader()), offscreen, mesh,
                                             glm::mat4(1.0f), perspectiveView());
        return referenceImage(material, geometry, lit, perspectiveView(), surface);
    }

    /// The largest deviation of any technique, as a share of its bound.
    double worstShare(gl::Renderer& renderer, const Material& material, OffscreenFormat format,
                      const gl::MaterialOptions& materialOptions = {})
    {
        const gl::MeshData mesh = sphereMesh(16);
        const auto radiance = reference(material, mesh);
        const auto exact =
            storedImage(radiance, Transfer::linear, format == OffscreenFormat::rgba8);
        es_->makeCurrent();
        const auto gpu = renderer.createMaterial(material, materialOptions);
        const auto gpuMesh = renderer.createMesh(mesh);
        double worst = 0.0;
        for (const auto technique : allTechniques()) {
            Offscreen offscreen(es_->loader(), {kSize, kSize, format});
            offscreen.clear();
            const auto stats =
                renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                              {{gpu.get(), gpuMesh.get()}}, lights(), {technique, 4});
            EXPECT_EQ(stats.itemsFailed, 0) << material.name << (log.empty() ? "" : log.back());
            if (!stats.whyReplaced.empty()) {
                EXPECT_FALSE(renderer.capabilities().floatTargets) << stats.whyReplaced;
                replaced_ = stats.whyReplaced;
            }
            const auto deviation = deviationOf(offscreen.readPixels(), exact, stats.error);
            EXPECT_LE(deviation.share, 1.0)
                << material.name << " " << techniqueName(technique) << " " << deviation.relative;
            worst = std::max(worst, deviation.share);
        }
        return worst;
    }

    std::vector<std::string> log;
    std::string replaced_;
    std::unique_ptr<HeadlessContext> desktop_, es_;
};

TEST_F(Es, DrawsEveryFormAndTechnique)
{
    gl::Renderer renderer(options());
    const Capabilities& c = renderer.capabilities();
    RecordProperty("version", renderer.glVersion());
    EXPECT_EQ(c.glsl, c.glMajor >= 3 ? 300 : 100);
    double worst = 0.0;
    int drawn = 0;
    for (const Material& material : testMaterials()) {
        const bool hasVolume = material.name.find("everything") != std::string::npos;
        if (hasSigns(material)) continue;
        if (hasVolume && c.glMajor < 3) {
            es_->makeCurrent();
            expectError(ErrorKind::gl, "three dimensions",
                        [&] { renderer.createMaterial(material); });
            continue;
        }
        for (const auto format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8}) {
            if (format == OffscreenFormat::rgba32f && !c.floatTargets) continue;
            worst = std::max(worst, worstShare(renderer, material, format));
            ++drawn;
        }
    }
    EXPECT_GT(worst, 0.1);
    EXPECT_GE(drawn, c.glMajor >= 3 ? 14 : 6);
}

TEST_F(Es, DrawsRecombinedMapsWithinTheirBound)
{
    for (const bool isFloat : {true, false}) {
        gl::RendererOptions wanted = options();
        wanted.capabilities = gl::Renderer(wanted).capabilities();
        wanted.capabilities->softwareSampling &= isFloat;
        gl::Renderer renderer(wanted);
        for (const LookUp lookUp : {LookUp::parabolic, LookUp::cube})
            for (const auto format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8})
                if (format == OffscreenFormat::rgba8 || renderer.capabilities().floatTargets)
                    worstShare(renderer, noiseMaterial(formPqpr(8, 0.5, 6), Storage::log8), format,
                               {lookUp, 64});
    }
}

TEST_F(Es, TakesHooksAndNormalMaps)
{
    gl::Renderer renderer(options());
    const gl::MeshData plain = sphereMesh(16);
    gl::MeshData mesh = plain;
    mesh.extra.emplace_back(mesh.positions.size(), glm::vec4(0.0f, 0.0f, 0.25f, 0.0f));
    mesh.textureCoordinates.resize(mesh.positions.size());
    for (Vec3f& position : mesh.positions) position.z -= 0.25f;  // the hook takes it back
    gl::Hooks hooks;
    hooks.vertex =
        "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position += fbrdfExtra0.xyz; }\n";
    hooks.shadow =
        "float fbrdfShadow(int light, vec3 position, vec3 toLight)\n"
        "{ return light == 1 ? 0.25 : 1.0; }\n";
    const auto gpuHooks = renderer.createHooks(hooks);
    const Material material = testMaterials()[0];
    const auto gpu = renderer.createMaterial(material);
    const auto gpuMesh = renderer.createMesh(mesh);
    const GladGLContext gl = loadGl(es_->loader());
    const unsigned char straight[] = {128, 128, 255, 255};  // nearly: 128 is 0.004
    GLuint map = 0;
    gl.GenTextures(1, &map);
    gl.BindTexture(GL_TEXTURE_2D, map);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, straight);
    Offscreen offscreen(es_->loader(), {kSize, kSize, OffscreenFormat::rgba8});
    offscreen.clear();
    const auto stats =
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{gpu.get(), gpuMesh.get(), glm::mat4(1.0f), gpuHooks.get(), map}}, lights());
    EXPECT_EQ(stats.itemsFailed, 0) << (log.empty() ? "" : log[0]);
    const auto found = offscreen.readPixels();
    gl.DeleteTextures(1, &map);
    SurfaceReference surface;
    surface.shadow = [](size_t light, const Vec3d&) { return light == 1 ? 0.25 : 1.0; };
    surface.normal = [](size_t) { return Vec3d(256.0 / 255.0 - 1.0, 256.0 / 255.0 - 1.0, 1.0); };
    const auto exact = storedImage(reference(material, plain, surface), Transfer::linear, true);
    es_->makeCurrent();
    EXPECT_LE(deviationOf(found, exact, {1e-3, 1.0 / 255.0}).share, 1.0);
}

/// Sets state that a host may have and the renderer must change.
void setHostState(const GladGLContext& gl)
{
    gl.Enable(GL_CULL_FACE);
    gl.Enable(GL_BLEND);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Enable(GL_STENCIL_TEST);
    gl.Disable(GL_DITHER);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthFunc(GL_GEQUAL);
    gl.DepthMask(GL_FALSE);
    gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    gl.Viewport(3, 4, 50, 60);
    gl.Scissor(1, 2, 3, 4);
    gl.ActiveTexture(GL_TEXTURE3);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 2);
    gl.EnableVertexAttribArray(1);
}

std::vector<GLint> hostState(const GladGLContext& gl)
{
    std::vector<GLint> state;
    for (const GLenum name : std::initializer_list<GLenum>{GL_CULL_FACE,
                                                           GL_BLEND,
                                                           GL_SCISSOR_TEST,
                                                           GL_STENCIL_TEST,
                                                           GL_DITHER,
                                                           GL_DEPTH_TEST,
                                                           GL_BLEND_SRC_RGB,
                                                           GL_BLEND_DST_RGB,
                                                           GL_BLEND_SRC_ALPHA,
                                                           GL_BLEND_DST_ALPHA,
                                                           GL_BLEND_EQUATION_RGB,
                                                           GL_DEPTH_FUNC,
                                                           GL_DEPTH_WRITEMASK,
                                                           GL_COLOR_WRITEMASK,
                                                           GL_VIEWPORT,
                                                           GL_SCISSOR_BOX,
                                                           GL_ACTIVE_TEXTURE,
                                                           GL_UNPACK_ALIGNMENT,
                                                           GL_CURRENT_PROGRAM,
                                                           GL_ARRAY_BUFFER_BINDING,
                                                           GL_ELEMENT_ARRAY_BUFFER_BINDING,
                                                           GL_FRAMEBUFFER_BINDING,
                                                           GL_RENDERBUFFER_BINDING,
                                                           GL_TEXTURE_BINDING_2D}) {
        GLint value[4] = {};
        gl.GetIntegerv(name, value);
        state.insert(state.end(), value, value + 4);
    }
    for (GLuint i = 0; i < 8; ++i) {
        GLint enabled = 0;
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
        state.push_back(enabled);
    }
    return state;
}

TEST_F(Es, PutsStateBack)
{
    gl::Renderer renderer(options());
    const auto gpu = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    Offscreen offscreen(es_->loader(), {kSize, kSize, OffscreenFormat::rgba8});
    offscreen.clear();
    const GladGLContext gl = loadGl(es_->loader());
    setHostState(gl);
    const auto before = hostState(gl);
    const auto stats = renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                     {{gpu.get(), mesh.get()}}, lights(), {Technique::batched, 4});
    renderer.createMesh(sphereMesh(8));
    EXPECT_EQ(hostState(gl), before);
    EXPECT_EQ(stats.itemsFailed, 0);
    const auto pixels = offscreen.readPixels();
    EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 0.1f);
}

TEST_F(Es, WithoutFloatTargetsSaysWhatItDoesInstead)
{
    gl::RendererOptions old = options();
    old.capabilities = gl::Renderer(old).capabilities();
    old.capabilities->floatTargets = old.capabilities->halfTargets = false;
    gl::Renderer renderer(old);
    worstShare(renderer, testMaterials()[0], OffscreenFormat::rgba8);
    EXPECT_NE(replaced_, "");
}

TEST_F(Es, AddsUpInRgba8WhereNoFloatCanBeDrawnTo)
{
    gl::RendererOptions old = options();
    old.capabilities = gl::Renderer(old).capabilities();
    old.capabilities->floatTargets = old.capabilities->halfTargets = false;
    gl::Renderer renderer(old);
    const Material material = calmMaterial(formPqp(8, 0.5));
    const gl::MeshData mesh = sphereMesh(16);
    auto few = lights();
    few.resize(2);
    const auto exact = storedImage(reference(material, mesh, {}, few), Transfer::linear, true);
    es_->makeCurrent();
    const auto gpu = renderer.createMaterial(material);
    const auto gpuMesh = renderer.createMesh(mesh);
    Offscreen offscreen(es_->loader(), {kSize, kSize, OffscreenFormat::rgba8});
    offscreen.clear();
    const auto stats = renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                     {{gpu.get(), gpuMesh.get()}}, few, {Technique::twoLookup});
    EXPECT_EQ(stats.whyReplaced, "");
    EXPECT_EQ(stats.accumulation, "RGBA8");
    EXPECT_EQ(stats.passes, 3);
    const double share = deviationOf(offscreen.readPixels(), exact, stats.error).share;
    EXPECT_LE(share, 1.0);
    EXPECT_GT(share, 0.05);
}

TEST_F(Es, WithoutHalfFloatTexturesRefusesMaterials)
{
    gl::RendererOptions bare = options();
    bare.capabilities = gl::Renderer(bare).capabilities();
    bare.capabilities->floatTextures = bare.capabilities->softwareSampling = false;
    gl::Renderer renderer(bare);
    expectError(ErrorKind::gl, "OES_texture_half_float",
                [&] { renderer.createMaterial(testMaterials()[0]); });
}

TEST_F(Es, HasNoListsNorArraysAndSaysSo)
{
    gl::Renderer renderer(options());
    const Material material = testMaterials()[2];
    const auto library = renderer.createLibrary({material, material});
    EXPECT_NE(library->whyNotPacked(), "");
    const auto mesh = renderer.createMesh(sphereMesh(8));
    Offscreen offscreen(es_->loader(), {kSize, kSize, OffscreenFormat::rgba8});
    gl::DrawOptions clustered;
    clustered.clustered = true;
    const auto stats = renderer.drawBatch(
        {offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
        {library.get(), mesh.get(), {{glm::mat4(1.0f), 0}, {glm::mat4(1.0f), 1}}}, lights(),
        clustered);
    EXPECT_EQ(stats.itemsFailed, 0);
    EXPECT_EQ(stats.drawCalls, 2);
    EXPECT_NE(stats.whyReplaced, "");
}

/// A picture under an environment that the renderer makes itself.
std::vector<float> underEnvironment(gl::Renderer& renderer, HeadlessContext& context,
                                    const Material& material, bool floats)
{
    const auto environment = renderer.createEnvironment(testPanorama(32), {16, floats});
    EXPECT_EQ(environment->whyNotOnGpu(), "");
    const auto gpu = renderer.createMaterial(material);
    const auto mesh = renderer.createMesh(sphereMesh(12));
    Offscreen offscreen(context.loader(), {kSize, kSize, OffscreenFormat::rgba8});
    offscreen.clear();
    gl::DrawOptions options;
    options.environment.map = environment.get();
    options.environment.intensity = Vec3f(0.2f);
    const auto stats = renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                     {{gpu.get(), mesh.get()}}, {}, options);
    EXPECT_EQ(stats.itemsWithoutEnvironment, 0) << stats.whyNoEnvironment;
    return offscreen.readPixels();
}

TEST_F(Es, DrawsEnvironmentsAsTheDesktopDoesOrSaysWhyNot)
{
    gl::Renderer renderer(options());
    if (renderer.capabilities().glMajor < 3) {
        expectError(ErrorKind::gl, "ES 2.0", [&] {
            renderer.createEnvironment(testPanorama(32), {16, false});
        });
        return;
    }
    constexpr double kStep = 1.0 / 255.0 + 1e-6;  // rounding may fall to either side
    for (const LobeAxes axes : {LobeAxes::tilted, LobeAxes::bent})
        for (const bool floats : {false, true}) {
            const Material material = withLobes(testMaterials()[0], testLobes(axes, 3));
            es_->makeCurrent();
            const auto found = underEnvironment(renderer, *es_, material, floats);
            desktop_->makeCurrent();
            gl::RendererOptions full;
            full.load = desktop_->loader();
            gl::Renderer other(full);
            const auto expected = underEnvironment(other, *desktop_, material, floats);
            ASSERT_EQ(found.size(), expected.size());
            float largest = 0.0f;
            for (size_t i = 0; i < found.size(); ++i) {
                ASSERT_NEAR(found[i], expected[i], kStep) << i;
                if (i % 4 != 3) largest = std::max(largest, found[i]);
            }
            EXPECT_GT(largest, 0.2f);
        }
    es_->makeCurrent();
}

}  // namespace
}  // namespace fbrdf::test
