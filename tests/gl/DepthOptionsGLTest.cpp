// The same picture comes from every convention of depth that a host may follow, in one pass, in
// several, through surfaces with depth buffers of their own, in batches and with lists of lights.
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "support/ExpectError.h"
#include "support/gl/GlTest.h"
#include "support/gl/Scenes.h"

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;
constexpr float kNear = 0.5f, kFar = 50.0f, kAngle = 0.8f;
// Conventions round depths differently: where surfaces cross, a pixel may show the other one.
constexpr size_t kCrossingPixels = 6;

/// Depths of clip space from the high end to the low end instead.
glm::mat4 mirrored(glm::mat4 projection)
{
    for (int column = 0; column < 4; ++column) projection[column][2] = -projection[column][2];
    return projection;
}

/// 1 at the near plane, 0 infinitely far.
glm::mat4 reversedProjection(float nearest)
{
    glm::mat4 projection = glm::infinitePerspective(kAngle, 1.0f, nearest);
    projection[2][2] = 0.0f;
    projection[3][2] = nearest;
    return projection;
}

struct Convention {
    std::string name;
    glm::mat4 projection;
    gl::DepthOptions depth;
    float nearest;  ///< the depth that nothing is in front of
};

std::vector<Convention> conventions()
{
    using gl::ClipDepth;
    using gl::DepthTest;
    const glm::mat4 usual = glm::perspective(kAngle, 1.0f, kNear, kFar);
    const ClipDepth both = ClipDepth::negativeOneToOne, positive = ClipDepth::zeroToOne;
    return {
        {"OpenGL's own", usual, {}, 0.0f},
        {"less or equal", usual, {DepthTest::lessEqual, both, 0.0f, 1.0f, 1.0f}, 0.0f},
        {"half of the range", usual, {DepthTest::less, both, 0.25f, 0.75f, 0.75f}, 0.25f},
        {"a swapped range", usual, {DepthTest::greater, both, 1.0f, 0.0f, 0.0f}, 1.0f},
        {"a mirrored projection",
         mirrored(usual),
         {DepthTest::greaterEqual, both, 0.0f, 1.0f, 0.0f},
         1.0f},
        {"depths in [0, 1]",
         glm::perspectiveRH_ZO(kAngle, 1.0f, kNear, kFar),
         {DepthTest::less, positive, 0.0f, 1.0f, 1.0f},
         0.0f},
        {"reversed depth, infinitely far", reversedProjection(kNear), gl::reversedDepth(), 1.0f},
    };
}

class DepthConventions : public RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        if (!isReady()) return;
        const Material shiny = testMaterials()[4];
        material_ = renderer_->createMaterial(shiny);
        library_ = renderer_->createLibrary({shiny, testMaterials()[0]});
        knot_ = renderer_->createMesh(knotMesh(64, 10));
        sphere_ = renderer_->createMesh(sphereMesh(16));
    }
    void TearDown() override
    {
        material_.reset();
        library_.reset();
        knot_.reset();
        sphere_.reset();
        RendererTest::TearDown();
    }

    bool isPossible(const Convention& convention) const
    {
        return convention.depth.clip == gl::ClipDepth::negativeOneToOne ||
               renderer_->capabilities().clipControl;
    }
    void clearDepth(const Offscreen& offscreen, float depth, int width) const
    {
        gl().BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
        gl().Enable(GL_SCISSOR_TEST);
        gl().Scissor(0, 0, width, kSize);
        gl().ClearDepth(static_cast<double>(depth));
        gl().Clear(GL_DEPTH_BUFFER_BIT);
        gl().Disable(GL_SCISSOR_TEST);
        gl().ClearDepth(1.0);
        gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    static gl::View viewOf(const Convention& convention)
    {
        gl::View view;
        view.view = glm::translate(glm::mat4(1.0f), Vec3f(0.0f, 0.0f, -4.0f));
        view.projection = convention.projection;
        view.depth = convention.depth;
        return view;
    }
    /// Two items that overlap, in front of a buffer that has the convention's clear value.
    std::vector<float> draw(const Convention& convention, OffscreenFormat format,
                            const gl::DrawOptions& options, int hidden = 0)
    {
        const Offscreen offscreen = makeOffscreen(kSize, format);
        clearDepth(offscreen, convention.depth.clear, kSize);
        if (hidden > 0) clearDepth(offscreen, convention.nearest, hidden);
        const glm::mat4 away = glm::translate(glm::mat4(1.0f), Vec3f(0.2f, 0.1f, -0.4f));
        const auto stats = renderer_->draw(
            {offscreen.framebuffer(), kSize, kSize}, viewOf(convention),
            {{material_.get(), sphere_.get(), away}, {material_.get(), knot_.get()}}, lights(),
            options);
        EXPECT_EQ(stats.itemsFailed, 0);
        return offscreen.readPixels();
    }
    std::vector<float> drawBatch(const Convention& convention)
    {
        const Offscreen offscreen = makeOffscreen(kSize);
        clearDepth(offscreen, convention.depth.clear, kSize);
        const glm::mat4 away = glm::translate(glm::mat4(1.0f), Vec3f(0.4f, 0.1f, -0.6f));
        renderer_->drawBatch({offscreen.framebuffer(), kSize, kSize}, viewOf(convention),
                             {library_.get(), knot_.get(), {{away, 0}, {glm::mat4(1.0f), 1}}},
                             lights());
        return offscreen.readPixels();
    }
    static std::vector<Light> lights()
    {
        auto result = testLights(5);
        for (Light& light : result) light.intensity *= 0.02f;
        return result;
    }
    static size_t differing(const std::vector<float>& a, const std::vector<float>& b)
    {
        size_t count = 0;
        for (size_t i = 0; i < a.size(); i += 4)
            count += std::equal(a.begin() + std::ptrdiff_t(i), a.begin() + std::ptrdiff_t(i + 4),
                                b.begin() + std::ptrdiff_t(i))
                         ? 0
                         : 1;
        return count;
    }

    std::shared_ptr<gl::GpuMaterial> material_;
    std::shared_ptr<gl::GpuLibrary> library_;
    std::shared_ptr<gl::GpuMesh> knot_, sphere_;
};

TEST_P(DepthConventions, DrawTheSamePicture)
{
    const auto all = conventions();
    for (const OffscreenFormat format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8})
        for (const gl::DrawOptions& options :
             {gl::DrawOptions{}, gl::DrawOptions{Technique::twoLookup}}) {
            const auto expected = draw(all[0], format, options);
            ASSERT_GT(differing(expected, std::vector<float>(expected.size(), 0.0f)), 500u);
            for (const Convention& convention : all) {
                if (!isPossible(convention)) continue;
                EXPECT_LE(differing(draw(convention, format, options), expected), kCrossingPixels)
                    << convention.name;
            }
        }
}

TEST_P(DepthConventions, DrawTheSameBatchAndTheSameListsOfLights)
{
    gl::DrawOptions clustered;
    clustered.clustered = !GetParam().legacy;
    const auto all = conventions();
    const auto batch = drawBatch(all[0]),
               listed = draw(all[0], OffscreenFormat::rgba32f, clustered);
    for (const Convention& convention : all) {
        if (!isPossible(convention)) continue;
        EXPECT_LE(differing(drawBatch(convention), batch), kCrossingPixels) << convention.name;
        EXPECT_LE(differing(draw(convention, OffscreenFormat::rgba32f, clustered), listed),
                  kCrossingPixels)
            << convention.name;
    }
}

TEST_P(DepthConventions, LeaveWhatTheHostHasInFront)
{
    constexpr int kHidden = kSize / 2;
    for (const Convention& convention : conventions()) {
        if (!isPossible(convention)) continue;
        const gl::DrawOptions passes{Technique::twoLookup};
        for (const OffscreenFormat format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8}) {
            const auto whole = draw(convention, format, passes),
                       half = draw(convention, format, passes, kHidden);
            for (size_t i = 0; i < whole.size(); ++i) {
                const bool isHidden = (i / 4) % kSize < kHidden;
                ASSERT_EQ(half[i], isHidden ? 0.0f : whole[i]) << convention.name << " at " << i;
            }
        }
    }
}

TEST_P(DepthConventions, AnotherConventionThanTheProjectionsIsSeen)
{
    auto all = conventions();
    const auto expected = draw(all[0], OffscreenFormat::rgba32f, {});
    Convention mixed = all[4];
    mixed.depth = all[0].depth;
    EXPECT_GT(differing(draw(mixed, OffscreenFormat::rgba32f, {}), expected), 100u);
}

TEST_P(DepthConventions, ThatCannotBeAreRefused)
{
    const auto refused = [&](ErrorKind kind, const std::string& words, gl::DepthOptions depth) {
        Convention convention = conventions()[0];
        convention.depth = depth;
        expectError(kind, words, [&] { draw(convention, OffscreenFormat::rgba32f, {}); });
    };
    using gl::DepthTest;
    const auto both = gl::ClipDepth::negativeOneToOne;
    refused(ErrorKind::usage, "found clear depth", {DepthTest::greater, both, 0.0f, 1.0f, 1.0f});
    refused(ErrorKind::usage, "found clear depth", {DepthTest::less, both, 0.5f, 1.0f, 0.5f});
    refused(ErrorKind::usage, "found depth 2", {DepthTest::less, both, 0.0f, 2.0f, 1.0f});
    refused(ErrorKind::usage, "found depth nan",
            {DepthTest::less, both, std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f});
    gl::RendererOptions options = rendererOptions();
    options.capabilities = renderer_->capabilities();
    options.capabilities->clipControl = false;
    gl::Renderer without(options);
    const Offscreen offscreen = makeOffscreen(kSize);
    expectError(ErrorKind::gl, "expected it for depths in [0, 1]", [&] {
        without.draw({offscreen.framebuffer(), kSize, kSize}, viewOf(conventions()[6]), {}, {});
    });
}

/// A framebuffer of RGBA8 with 32-bit float depth.
class FloatDepth {
public:
    explicit FloatDepth(const GladGLContext& gl) : gl_(gl)
    {
        gl.GenFramebuffers(1, &framebuffer_);
        gl.GenRenderbuffers(2, buffers_);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        attach(0, GL_COLOR_ATTACHMENT0, GL_RGBA8);
        attach(1, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
        gl.ClearDepth(0.0);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl.ClearDepth(1.0);
    }
    ~FloatDepth()
    {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteRenderbuffers(2, buffers_);
    }
    FloatDepth(const FloatDepth&) = delete;
    FloatDepth& operator=(const FloatDepth&) = delete;
    GLuint framebuffer() const { return framebuffer_; }
    std::vector<float> readPixels() const
    {
        std::vector<float> pixels(4 * kSize * kSize);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, pixels.data());
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        return pixels;
    }

private:
    void attach(int i, GLenum attachment, GLenum format)
    {
        gl_.BindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
        gl_.RenderbufferStorage(GL_RENDERBUFFER, format, kSize, kSize);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffers_[i]);
    }

    const GladGLContext& gl_;
    GLuint framebuffer_ = 0, buffers_[2] = {};
};

// A near plane at 1 mm and a knot of a kilometre four kilometres away: 24 bits of reversed depth
// resolve a kilometre there, and surfaces of 24 bits would add up the lights of hidden fragments.
TEST_P(DepthConventions, SurfacesResolveWhatAFloatDepthBufferResolves)
{
    if (GetParam().legacy || !renderer_->capabilities().clipControl)
        GTEST_SKIP() << "float depth and clip control need a newer context";
    constexpr float kScale = 1000.0f;
    const auto all = conventions();
    const FloatDepth target(gl());
    gl::View view = viewOf(all[6]);
    view.view = glm::translate(glm::mat4(1.0f), Vec3f(0.0f, 0.0f, -4.0f * kScale));
    view.projection = reversedProjection(0.001f);
    auto far = lights();
    for (Light& light : far) {
        light.position *= kScale;
        light.radius *= kScale;
        if (light.type != Light::Type::directional) light.intensity *= kScale * kScale;
    }
    const glm::mat4 model = glm::scale(glm::mat4(1.0f), Vec3f(kScale));
    renderer_->draw({target.framebuffer(), kSize, kSize}, view,
                    {{material_.get(), knot_.get(), model}}, far, {Technique::twoLookup});
    Offscreen plain = makeOffscreen(kSize, OffscreenFormat::rgba8);
    renderer_->draw({plain.framebuffer(), kSize, kSize}, viewOf(all[0]),
                    {{material_.get(), knot_.get()}}, lights(), {Technique::twoLookup});
    const auto found = target.readPixels(), expected = plain.readPixels();
    size_t off = 0;
    for (size_t i = 0; i < found.size(); ++i)
        off += std::abs(found[i] - expected[i]) > 2.0f / 255.0f ? 1 : 0;
    EXPECT_LE(off, 4 * kCrossingPixels);
}

INSTANTIATE_TEST_SUITE_P(Backends, DepthConventions, ::testing::ValuesIn(allVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
