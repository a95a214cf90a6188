// What is stored of the radiance agrees with the definition in every kind of target.
#include <fbrdf/base/Error.h>
#include <fbrdf/plan/Transfer.h>

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Scenes.h"

#include <algorithm>
#include <limits>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;
constexpr float kExposure = 0.125f;
// The pow of drivers is good to some 1e-5, and sums are added in another order.
constexpr double kCurve = 1e-4;

class Transfers : public RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        if (!isReady()) return;
        mesh_ = renderer_->createMesh(knotMesh(48, 8));
    }
    void TearDown() override
    {
        mesh_.reset();
        RendererTest::TearDown();
    }
    gl::DrawStats draw(const gl::Target& target, const Material& material, Technique technique)
    {
        const auto gpu = renderer_->createMaterial(material);
        return renderer_->draw(target, perspectiveView(), {{gpu.get(), mesh_.get()}}, testLights(5),
                               {technique, 8, 0});
    }
    /// How far one pass is from the exact byte, as its plan says: drivers need not take the
    /// nearest.
    double byteStep(const Material& material)
    {
        Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
        const ErrorBound error =
            draw({offscreen.framebuffer(), kSize, kSize, Transfer::exposure, kExposure}, material,
                 Technique::single)
                .error;
        return error.absolute - error.maps.absolute + kCurve;
    }
    std::vector<float> drawn(const Material& material, OffscreenFormat format, Transfer transfer,
                             Technique technique)
    {
        Offscreen offscreen = makeOffscreen(kSize, format);
        draw({offscreen.framebuffer(), kSize, kSize, transfer, kExposure}, material, technique);
        return offscreen.readPixels();
    }

    std::shared_ptr<gl::GpuMesh> mesh_;
};

TEST_P(Transfers, StoreWhatTheDefinitionGives)
{
    for (const size_t m : {0u, 2u, 4u}) {
        const Material material = testMaterials()[m];
        const double step = byteStep(material);
        const auto radiance =
            drawn(material, OffscreenFormat::rgba32f, Transfer::linear, Technique::single);
        for (const Transfer transfer : {Transfer::exposure, Transfer::srgb, Transfer::toneMap})
            for (const Technique technique : {Technique::single, Technique::twoLookup})
                for (const auto format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8}) {
                    const auto pixels = drawn(material, format, transfer, technique);
                    const bool bytes = format == OffscreenFormat::rgba8;
                    for (size_t i = 0; i < pixels.size(); ++i) {
                        if (i % 4 == 3) continue;
                        double expected =
                            transferred(transfer, double(kExposure), double(radiance[i]));
                        if (bytes) expected = std::min(expected, 1.0);
                        // Sums without a curve are blended in bytes where a form has two terms.
                        const double steps = bytes && !isCurved(transfer) ? 2.0 : 1.0;
                        ASSERT_NEAR(double(pixels[i]), expected,
                                    bytes ? steps * step : kCurve * std::max(1.0, expected))
                            << material.name << " transfer " << static_cast<int>(transfer)
                            << " number " << i;
                    }
                }
    }
}

TEST_P(Transfers, TheHostsSrgbSwitchAndFormatChangeNothing)
{
    if (!gl().VERSION_3_0) GTEST_SKIP() << "sRGB framebuffers need OpenGL 3.0";
    std::vector<std::vector<unsigned char>> images;
    for (const GLenum format : std::initializer_list<GLenum>{GL_RGBA8, GL_SRGB8_ALPHA8})
        for (const bool on : {false, true}) {
            GLuint framebuffer = 0, buffers[2] = {};
            gl().GenFramebuffers(1, &framebuffer);
            gl().GenRenderbuffers(2, buffers);
            gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
            for (int i = 0; i < 2; ++i) {
                gl().BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
                gl().RenderbufferStorage(GL_RENDERBUFFER, i == 0 ? format : GL_DEPTH_COMPONENT24,
                                         kSize, kSize);
                gl().FramebufferRenderbuffer(GL_FRAMEBUFFER,
                                             i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT,
                                             GL_RENDERBUFFER, buffers[i]);
            }
            gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            on ? gl().Enable(GL_FRAMEBUFFER_SRGB) : gl().Disable(GL_FRAMEBUFFER_SRGB);
            draw({framebuffer, kSize, kSize, Transfer::srgb, kExposure}, testMaterials()[0],
                 Technique::twoLookup);
            EXPECT_EQ(gl().IsEnabled(GL_FRAMEBUFFER_SRGB), on ? GL_TRUE : GL_FALSE);
            gl().Disable(GL_FRAMEBUFFER_SRGB);
            images.emplace_back(4u * kSize * kSize);
            gl().ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, images.back().data());
            gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
            gl().DeleteFramebuffers(1, &framebuffer);
            gl().DeleteRenderbuffers(2, buffers);
        }
    EXPECT_GT(std::count(images[0].begin(), images[0].end(), 255), 0);  // something was drawn
    for (const auto& image : images) EXPECT_EQ(image, images[0]);
}

TEST_P(Transfers, AnExposureOutOfRangeIsRefused)
{
    Offscreen offscreen = makeOffscreen(kSize);
    for (const float exposure : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity()})
        EXPECT_THROW(draw({offscreen.framebuffer(), kSize, kSize, Transfer::srgb, exposure},
                          testMaterials()[0], Technique::single),
                     Error);
}

INSTANTIATE_TEST_SUITE_P(Backends, Transfers, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
