// Multisampled targets: sums add up in surfaces of as many samples, whose mean over what an object
// covers is read, so that edges are as smooth as those of objects drawn in one pass.
#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"
#include "support/gl/ShaderRewriter.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;

/// A framebuffer of several samples a pixel, and one of one sample with their mean.
class SampledTarget {
public:
    SampledTarget(const GladGLContext& gl, Offscreen resolved, GLenum internal, GLint samples)
        : gl_(gl), resolved_(std::move(resolved))
    {
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.GenRenderbuffers(2, buffers_);
        for (int i = 0; i < 2; ++i) {
            gl_.BindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
            gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples,
                                               i == 0 ? internal : GLenum(GL_DEPTH_COMPONENT24),
                                               kSize, kSize);
            gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER,
                                        i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT,
                                        GL_RENDERBUFFER, buffers_[i]);
        }
        EXPECT_EQ(gl_.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
        gl_.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    ~SampledTarget()
    {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(2, buffers_);
    }
    SampledTarget(const SampledTarget&) = delete;
    SampledTarget& operator=(const SampledTarget&) = delete;

    GLuint framebuffer() const { return framebuffer_; }
    std::vector<float> pixels() const
    {
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer());
        gl_.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT,
                            GL_NEAREST);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        return resolved_.readPixels();
    }

private:
    const GladGLContext& gl_;
    Offscreen resolved_;
    GLuint framebuffer_ = 0, buffers_[2] = {};
};

class MultisampledTarget : public GlTest {
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        gl().GetIntegerv(GL_MAX_SAMPLES, &samples_);
        samples_ = std::min(samples_, 8);
        if (samples_ < 2) GTEST_SKIP() << "one sample a pixel";
    }

    /// Two objects, one before the other, and their messages.
    Drawn draw(gl::Renderer& renderer, const Material& material, OffscreenFormat format,
               Technique technique, bool nearFirst = true)
    {
        const auto gpu = renderer.createMaterial(material);
        const auto knot = renderer.createMesh(knotMesh(48, 12)),
                   sphere = renderer.createMesh(sphereMesh(12));
        glm::mat4 behind(1.0f);
        behind[3] = glm::vec4(0.3f, 0.2f, -1.5f, 1.0f);
        std::vector<gl::Item> items{{gpu.get(), knot.get()}, {gpu.get(), sphere.get(), behind}};
        if (!nearFirst) std::swap(items[0], items[1]);
        auto lights = testLights(3);
        for (Light& light : lights) light.intensity *= 0.5f;
        const GLenum internal = format == OffscreenFormat::rgba8     ? GL_RGBA8
                                : format == OffscreenFormat::rgba16f ? GL_RGBA16F
                                                                     : GL_RGBA32F;
        const SampledTarget target(gl(), makeOffscreen(kSize, format), internal, samples_);
        Drawn drawn;
        drawn.stats = renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(), items,
                                    lights, {technique, 8, 0});
        drawn.pixels = target.pixels();
        return drawn;
    }

    GLint samples_ = 0;
};

class Multisampled : public MultisampledTarget {
protected:
    void SetUp() override
    {
        MultisampledTarget::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        if (!gl().VERSION_3_0) GTEST_SKIP() << "surfaces of several samples need OpenGL 3.0";
    }
};

double largestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    double largest = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
    return largest;
}

double meanDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double(a[i]) - double(b[i]));
    return sum / static_cast<double>(a.size());
}

// Samples round to codes before their mean is rounded again; where an object overlaps itself within
// a pixel its parts share one mean, which the last factor multiplies.
constexpr double kSteps = 3.0 / 255.0, kMeanSteps = 0.1 / 255.0, kOverlaps = 0.06;

TEST_P(Multisampled, SumsAreThoseOfOnePass)
{
    gl::Renderer renderer = makeRenderer();
    for (const Form& form : {formHdio({8, 6, 6}), formPqp(16, 0.5)})
        for (const bool nearFirst : {true, false}) {
            const Material material = calmMaterial(form);
            const OffscreenFormat format = OffscreenFormat::rgba8;
            const Drawn direct = draw(renderer, material, format, Technique::single, nearFirst),
                        summed = draw(renderer, material, format, Technique::twoLookup, nearFirst);
            EXPECT_EQ(direct.stats.passes, 1);
            EXPECT_GE(summed.stats.passes, 4);
            EXPECT_EQ(summed.stats.technique, Technique::twoLookup) << summed.stats.whyReplaced;
            EXPECT_EQ(summed.stats.accumulation, "RGBA32F");
            EXPECT_LE(largestDifference(direct.pixels, summed.pixels),
                      form.name == "hdio" ? kSteps : kOverlaps)
                << form.name;
            EXPECT_LE(meanDifference(direct.pixels, summed.pixels), kMeanSteps) << form.name;
        }
}

TEST_P(Multisampled, EdgesAreThoseOfManyPictures)
{
    gl::Renderer renderer = makeRenderer();
    const Material material = calmMaterial(formPqp(16, 0.5));
    const auto direct =
        draw(renderer, material, OffscreenFormat::rgba32f, Technique::single).pixels;
    // An RGBA32F target adds up in place; RGBA16F needs surfaces.
    const auto summed =
        draw(renderer, material, OffscreenFormat::rgba16f, Technique::twoLookup).pixels;
    constexpr int kMore = 8;
    const auto gpu = renderer.createMaterial(material);
    const auto knot = renderer.createMesh(knotMesh(48, 12)),
               sphere = renderer.createMesh(sphereMesh(12));
    glm::mat4 behind(1.0f);
    behind[3] = glm::vec4(0.3f, 0.2f, -1.5f, 1.0f);
    auto lights = testLights(3);
    for (Light& light : lights) light.intensity *= 0.5f;
    Offscreen large = makeOffscreen(kMore * kSize);
    large.clear();
    renderer.draw({large.framebuffer(), kMore * kSize, kMore * kSize}, perspectiveView(),
                  {{gpu.get(), knot.get()}, {gpu.get(), sphere.get(), behind}}, lights);
    const auto fine = large.readPixels();
    std::vector<float> reference(static_cast<size_t>(4 * kSize * kSize));
    for (int y = 0; y < kMore * kSize; ++y)
        for (int x = 0; x < kMore * kSize; ++x)
            for (int c = 0; c < 4; ++c)
                reference[static_cast<size_t>(4 * (y / kMore * kSize + x / kMore) + c)] +=
                    fine[static_cast<size_t>(4 * (y * kMore * kSize + x) + c)] / (kMore * kMore);
    const double ofDirect = meanDifference(direct, reference),
                 ofSummed = meanDifference(summed, reference);
    EXPECT_LE(ofSummed, 1.05 * ofDirect);
    EXPECT_GT(ofDirect, 0.0);
}

// The tester: a mean that is not divided by the share that was drawn to darkens edges.
TEST_P(Multisampled, EdgesOfUndividedMeansAreSeen)
{
    gl::RendererOptions options = rendererOptions();
    options.load = rewritingShaders(context().options().backend, [](std::string text) {
        const std::string share = "max(read.a, 0.001)";
        const size_t at = text.find(share);
        return at == std::string::npos ? text : text.replace(at, share.size(), "1.0");
    });
    gl::Renderer renderer(options);
    const Material material = calmMaterial(formHdio({8, 6, 6}));
    const auto direct = draw(renderer, material, OffscreenFormat::rgba8, Technique::single),
               summed = draw(renderer, material, OffscreenFormat::rgba8, Technique::twoLookup);
    EXPECT_GT(largestDifference(direct.pixels, summed.pixels), 3.0 * kSteps);
}

TEST_P(Multisampled, SurfacesThatAreRefusedLeaveOnePass)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    hooks.refuseFramebuffers = true;
    const Material material = calmMaterial(formPqp(16, 0.5));
    const Drawn drawn = draw(renderer, material, OffscreenFormat::rgba8, Technique::twoLookup);
    EXPECT_EQ(drawn.stats.technique, Technique::single);
    EXPECT_NE(drawn.stats.whyReplaced, "");
    EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const std::string& line) {
        return line.find(" samples can be drawn to") != std::string::npos;
    }));
}

TEST_P(Multisampled, TheFramebufferToReadFromStaysBound)
{
    gl::Renderer renderer = makeRenderer();
    const Offscreen host = makeOffscreen(8);
    const Material material = calmMaterial(formHdio({8, 6, 6}));
    const auto gpu = renderer.createMaterial(material);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    const SampledTarget target(gl(), makeOffscreen(kSize, OffscreenFormat::rgba8), GL_RGBA8,
                               samples_);
    gl().BindFramebuffer(GL_READ_FRAMEBUFFER, host.framebuffer());
    const auto stats =
        renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{gpu.get(), mesh.get()}}, testLights(3), {Technique::twoLookup, 8, 0});
    EXPECT_EQ(stats.accumulation, "RGBA32F");
    GLint bound = 0;
    gl().GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
    EXPECT_EQ(static_cast<GLuint>(bound), host.framebuffer());
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST_P(MultisampledTarget, BeforeOpenGL30OnePassDrawsThatSaysWhy)
{
    if (gl().VERSION_3_0) GTEST_SKIP() << "surfaces may have several samples";
    gl::Renderer renderer = makeRenderer();
    const Material material = calmMaterial(formPqp(16, 0.5));
    const Drawn drawn = draw(renderer, material, OffscreenFormat::rgba8, Technique::twoLookup);
    EXPECT_EQ(drawn.stats.technique, Technique::single);
    EXPECT_NE(drawn.stats.whyReplaced.find("does not fit into RGBA8"), std::string::npos)
        << drawn.stats.whyReplaced;
}

INSTANTIATE_TEST_SUITE_P(Backends, MultisampledTarget, ::testing::ValuesIn(allVariants()),
                         variantName);
INSTANTIATE_TEST_SUITE_P(Backends, Multisampled, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
