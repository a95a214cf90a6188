// Targets of every colour format that OpenGL can draw to: what is drawn is within the bound, which
// is that of the format's coarsest channel; and those that store no colours are refused.
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"
#include "support/gl/ShaderRewriter.h"

#include <algorithm>
#include <string>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

struct StoredFormat {
    const char* name;
    GLenum internal;
    bool clamps;  ///< to [0, 1]
};

constexpr StoredFormat kFormats[] = {
    {"RGB565", GL_RGB565, true},
    {"RGBA4", GL_RGBA4, true},
    {"RGB5_A1", GL_RGB5_A1, true},
    {"R3_G3_B2", GL_R3_G3_B2, true},
    {"RGB10_A2", GL_RGB10_A2, true},
    {"RGBA12", GL_RGBA12, true},
    {"RGBA16", GL_RGBA16, true},
    {"RGBA8", GL_RGBA8, true},
    {"SRGB8_ALPHA8", GL_SRGB8_ALPHA8, true},
    {"RGBA8_SNORM", GL_RGBA8_SNORM, true},
    {"RGBA16_SNORM", GL_RGBA16_SNORM, true},
    {"R11F_G11F_B10F", GL_R11F_G11F_B10F, false},
    {"RGBA16F", GL_RGBA16F, false},
    {"RGB16F", GL_RGB16F, false},
    {"RGBA32F", GL_RGBA32F, false},
};

/// A framebuffer with a texture of any format, and depth.
class FormatTarget {
public:
    FormatTarget(const GladGLContext& gl, GLenum internal, bool integers = false) : gl_(gl)
    {
        gl_.GenTextures(1, &colour_);
        gl_.BindTexture(GL_TEXTURE_2D, colour_);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), kSize, kSize, 0,
                       integers ? GL_RGBA_INTEGER : GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl_.BindTexture(GL_TEXTURE_2D, 0);
        gl_.GenRenderbuffers(1, &depth_);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
        gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize, kSize);
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
        isComplete_ = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    ~FormatTarget()
    {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(1, &depth_);
        gl_.DeleteTextures(1, &colour_);
    }
    FormatTarget(const FormatTarget&) = delete;
    FormatTarget& operator=(const FormatTarget&) = delete;

    bool isComplete() const { return isComplete_; }
    void clear() const
    {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    GLuint framebuffer() const { return framebuffer_; }
    /// RGBA, alpha 1 where the mesh was drawn, whatever the format stores of it.
    std::vector<float> readPixels(const std::vector<double>& exact) const
    {
        std::vector<float> pixels(static_cast<size_t>(4 * kSize * kSize));
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, pixels.data());
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        for (size_t i = 3; i < pixels.size(); i += 4) pixels[i] = static_cast<float>(exact[i]);
        return pixels;
    }

private:
    const GladGLContext& gl_;
    GLuint colour_ = 0, depth_ = 0, framebuffer_ = 0;
    bool isComplete_ = false;
};

class Formats : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        Offscreen floats = makeOffscreen(kSize);
        geometry_ = geometryBuffer(gl(), floats, sphere_, glm::mat4(1.0f), perspectiveView());
    }

    struct Share {
        double ofBound = 0.0, ofBytes = 0.0;  ///< the latter: of the bound of RGBA8
        gl::DrawStats stats;
    };
    Share draw(gl::Renderer& renderer, const StoredFormat& format, const FormatTarget& target,
               Technique technique, Transfer transfer, float dim)
    {
        const Material material = calmMaterial(formHdio({8, 6, 6}));
        auto lights = testLights(3);
        for (Light& light : lights) light.intensity *= dim;
        const auto gpu = renderer.createMaterial(material);
        const auto mesh = renderer.createMesh(sphere_);
        target.clear();
        Share share;
        share.stats =
            renderer.draw({target.framebuffer(), kSize, kSize, transfer}, perspectiveView(),
                          {{gpu.get(), mesh.get()}}, lights, {technique});
        const auto exact =
            storedImage(referenceImage(material, geometry_, lights, perspectiveView()), transfer,
                        format.clamps);
        const auto pixels = target.readPixels({exact.begin(), exact.end()});
        share.ofBound = deviationOf(pixels, exact, share.stats.error).share;
        ErrorBound bytes = share.stats.error;
        bytes.relative = 1e-5;
        bytes.absolute = 1.0 / 255.0;
        share.ofBytes = deviationOf(pixels, exact, bytes).share;
        return share;
    }

    const gl::MeshData sphere_ = sphereMesh(16);
    GeometryBuffer geometry_;
};

TEST_P(Formats, AreDrawnToWithinTheBound)
{
    gl::Renderer renderer = makeRenderer();
    int drawn = 0;
    for (const StoredFormat& format : kFormats) {
        const FormatTarget target(gl(), format.internal);
        if (!target.isComplete()) continue;
        ++drawn;
        double worst = 0.0, worstOfBytes = 0.0;
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb})
            for (const Technique technique : allTechniques()) {
                const Share share = draw(renderer, format, target, technique, transfer,
                                         format.clamps ? 0.05f : 0.5f);
                EXPECT_EQ(share.stats.itemsFailed, 0) << format.name;
                EXPECT_LE(share.ofBound, 1.0)
                    << format.name << " " << techniqueName(technique) << " transfer "
                    << static_cast<int>(transfer) << " bound " << share.stats.error.relative
                    << " + " << share.stats.error.absolute;
                worst = std::max(worst, share.ofBound);
                worstOfBytes = std::max(worstOfBytes, share.ofBytes);
            }
        // That of floats is for steeper tables than these.
        if (format.internal != GL_RGBA32F) {
            EXPECT_GT(worst, 0.2) << format.name
                                  << ": a bound that nothing comes near says nothing";
        }
        // The tester: with 5 bits or 6 the bound of bytes does not hold.
        for (const GLenum coarse : {GL_RGB565, GL_RGBA4, GL_R11F_G11F_B10F})
            if (format.internal == coarse) {
                EXPECT_GT(worstOfBytes, 1.5) << format.name;
            }
    }
    EXPECT_GE(drawn, 6);
}

TEST_P(Formats, OfIntegersAreRefused)
{
    gl::Renderer renderer = makeRenderer();
    const FormatTarget target(gl(), GL_RGBA8UI, true);
    if (!target.isComplete()) GTEST_SKIP() << "RGBA8UI cannot be drawn to";
    try {
        renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(), {}, {});
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::gl);
        EXPECT_NE(std::string(error.what()).find("integers"), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, Formats, ::testing::ValuesIn(modernVariants()), variantName);

/// Halves below the smallest normal one become 0 when they are written, as on many GPUs.
ShaderRewriter flushing()
{
    return afterMain(
        "    fbrdfColour.rgb *= vec3(greaterThanEqual(fbrdfColour.rgb, vec3(6.103515625e-5)));\n");
}

class TinyHalves : public Formats {};

TEST_P(TinyHalves, AreWithinTheBoundWhereverTheyAreTakenForZero)
{
    const StoredFormat halves{"RGBA16F", GL_RGBA16F, false};
    const FormatTarget target(gl(), halves.internal);
    if (!target.isComplete()) GTEST_SKIP() << "RGBA16F cannot be drawn to";
    gl::Renderer renderer = makeRenderer();
    const auto dim = [&](gl::Renderer& with) {
        return draw(with, halves, target, Technique::single, Transfer::linear, 5e-5f);
    };
    const Share kept = dim(renderer);
    EXPECT_LE(kept.ofBound, 1.0);
    EXPECT_LE(kept.stats.error.absolute, 0x1p-23) << "llvmpipe keeps them";
    gl::RendererOptions options = rendererOptions();
    options.load = rewritingShaders(context().options().backend, flushing());
    gl::Renderer flushed(options);
    const Share lost = dim(flushed);
    EXPECT_LE(lost.ofBound, 1.0);
    EXPECT_GT(lost.ofBound, 0.3);
    ErrorBound steps = lost.stats.error;
    EXPECT_GT(steps.absolute, 100.0 * kept.stats.error.absolute);
}

INSTANTIATE_TEST_SUITE_P(Backends, TinyHalves, ::testing::Values(GlVariant{Backend::egl, false}),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
