// ToneMapperGLTest.cpp - what the window shows of a picture, against what the CPU makes of it.
#include "viewer/ToneMapper.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/headless/Offscreen.h>
#include <fbrdf/scene/Camera.h>
#include <gtest/gtest.h>

namespace fbrdf::viewer {
namespace {

constexpr int kSize = 24;
// A code of 8 bits is off where rounding meets float arithmetic, and the texels of the panorama
// where llvmpipe filters with 8 bits of place.
constexpr double kOneCode = 1.01 / 255.0;

class ToneMapping : public testing::Test {
protected:
    void SetUp() override
    {
        try {
            context_.emplace(HeadlessOptions{});
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
        offscreen_.emplace(context_->loader(),
                           OffscreenOptions{kSize, kSize, OffscreenFormat::rgba8, false});
        mapper_.emplace(context_->loader());
        sky_.panorama = proceduralEnvironment("studio", 64);
        sky_.rotation = 0.7;
        sky_.intensity = 0.4;
        mapper_->setPanorama(sky_.panorama);
        look_.view =
            scene::viewFromCamera({{0.0, 1.0, 4.0}, Vec3d(0.0), 1.2}, 1.0, {Vec3f(0.0f), 1.0f});
        look_.environment = &sky_;
    }

    /// Radiance and coverage that differ in every pixel, premultiplied.
    static scene::Image picture()
    {
        scene::Image image(kSize, kSize);
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const float alpha = static_cast<float>(x % 3) / 2.0f;
                float* const pixel = image.pixel(x, y);
                pixel[0] = alpha * static_cast<float>(x) / kSize;
                pixel[1] = alpha * static_cast<float>(y) / kSize;
                pixel[2] = alpha * 3.0f;
                pixel[3] = alpha;
            }
        return image;
    }

    /// The largest difference, of codes in [0, 1], to the picture with its background on the CPU.
    double worst()
    {
        mapper_->upload(picture());
        mapper_->showUploaded({offscreen_->framebuffer(), kSize, kSize}, look_);
        const std::vector<float> shown = offscreen_->readPixels();
        scene::Image expected = picture();
        fillBackground(expected, look_.background, &sky_, look_.view);
        double largest = 0.0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double found = static_cast<double>(
                        shown[static_cast<size_t>(4 * ((kSize - 1 - y) * kSize + x) + c)]);
                    const double code =
                        transferred<double>(look_.toneMap ? Transfer::toneMap : Transfer::srgb,
                                            static_cast<double>(look_.exposure),
                                            static_cast<double>(expected.pixel(x, y)[c]));
                    largest = std::max(largest, std::abs(found - code));
                }
        return largest;
    }

    std::optional<HeadlessContext> context_;
    std::optional<Offscreen> offscreen_;
    std::optional<ToneMapper> mapper_;
    scene::EnvironmentLight sky_;
    Look look_;
};

TEST_F(ToneMapping, IsThatOfTheFiles)
{
    look_.background.colour = Vec3f(0.2f, 0.3f, 0.1f);
    EXPECT_LE(worst(), kOneCode);
    look_.toneMap = true;
    look_.exposure = 1.7f;
    EXPECT_LE(worst(), kOneCode);
    look_.exposure = 1e-3f;
    EXPECT_LE(worst(), kOneCode);
}

TEST_F(ToneMapping, ShowsTheEnvironmentThatTheFilesShow)
{
    look_.background.environment = true;
    EXPECT_LE(worst(), 3.0 * kOneCode);
    sky_.rotation = 2.0;
    EXPECT_LE(worst(), 3.0 * kOneCode);
    look_.toneMap = true;
    EXPECT_LE(worst(), 3.0 * kOneCode);
}

TEST_F(ToneMapping, WithoutABackgroundThereIsADarkBackdrop)
{
    mapper_->upload(scene::Image(kSize, kSize));
    mapper_->showUploaded({offscreen_->framebuffer(), kSize, kSize}, look_);
    for (const float value : offscreen_->readPixels()) EXPECT_TRUE(value < 0.25f || value == 1.0f);
}

TEST_F(ToneMapping, ShowsTheMeanOfSamples)
{
    GladGLContext gl = loadGlFunctions(context_->loader());
    SampleSum sum(context_->loader());
    sum.restart(kSize, kSize);
    for (const float value : {0.1f, 0.5f, 0.3f}) {
        const gl::Target target = sum.clearedTarget();
        gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        gl.ClearColor(value, 2.0f * value, 0.0f, 1.0f);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        sum.add();
    }
    EXPECT_EQ(sum.count(), 3);
    const scene::Image mean = sum.mean();
    EXPECT_NEAR(mean.pixel(3, 5)[0], 0.3f, 1e-6f);
    EXPECT_NEAR(mean.pixel(3, 5)[1], 0.6f, 1e-6f);
    EXPECT_NEAR(mean.pixel(3, 5)[3], 1.0f, 1e-6f);
    mapper_->show({offscreen_->framebuffer(), kSize, kSize}, sum, look_);
    EXPECT_NEAR(offscreen_->readPixels()[0], srgbFromLinear(0.3), kOneCode);
    sum.restart(kSize / 2, kSize);
    EXPECT_EQ(sum.count(), 0);
}

}  // namespace
}  // namespace fbrdf::viewer
