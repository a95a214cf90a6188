// CompareMapperGLTest.cpp - what the window shows of a comparison, against what the CPU makes of
// it.
#include "viewer/CompareMapper.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Offscreen.h>
#include <gtest/gtest.h>

#include <optional>

namespace fbrdf::viewer {
namespace {

using scene::CompareMode;

constexpr int kWidth = 40, kHeight = 10;

/// Another picture in every column and row, opaque.
scene::Image picture(float tint)
{
    scene::Image image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            float* const pixel = image.pixel(x, y);
            pixel[0] = static_cast<float>(x) / kWidth;
            pixel[1] = tint * static_cast<float>(y) / kHeight;
            pixel[2] = 0.5f * tint;
            pixel[3] = 1.0f;
        }
    return image;
}

TEST(CompareMapperGL, ShowsWhatTheCpuComposes)
{
    std::optional<HeadlessContext> context;
    try {
        context.emplace(HeadlessOptions{});
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    Offscreen offscreen(context->loader(), {kWidth, kHeight, OffscreenFormat::rgba8, false});
    ToneMapper toneMapper(context->loader());
    CompareMapper mapper(context->loader());
    const ComparePair pair{picture(1.0f), picture(0.9f), {0.7f, Transfer::toneMap}, "", "", ""};
    Look look;
    look.exposure = 0.7f;
    look.toneMap = true;
    for (const int side : {0, 1}) {
        toneMapper.upload(side == 0 ? pair.a : pair.b);
        toneMapper.showUploaded(mapper.seat(side, kWidth, kHeight), look);
    }
    for (int i = 0; i < scene::kCompareModeCount; ++i)
        for (const bool showsB : {false, true}) {
            const CompareLayout layout{static_cast<CompareMode>(i), 0.3f, 2.0f, showsB};
            mapper.show({offscreen.framebuffer(), kWidth, kHeight}, layout);
            const std::vector<float> shown = offscreen.readPixels();
            const std::vector<uint8_t> expected =
                srgbCodes(composed(pair, layout), 1.0f, Transfer::srgb);
            // One code where rounding meets float arithmetic; the gain doubles it, and heat spreads
            // a tenth of the codes over all.
            const int allowed = i < 3 ? 1 : i == 3 ? 4 : 45;
            int brightest = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x)
                    for (int c = 0; c < 3; ++c) {
                        const auto found = static_cast<int>(std::lround(
                            255.0f *
                            shown[static_cast<size_t>(4 * ((kHeight - 1 - y) * kWidth + x) + c)]));
                        const int code = expected[static_cast<size_t>(3 * (y * kWidth + x) + c)];
                        brightest = std::max(brightest, code);
                        ASSERT_LE(std::abs(found - code), allowed) << i << " " << x << " " << y;
                    }
            EXPECT_GT(brightest, 8) << i;
        }
}

}  // namespace
}  // namespace fbrdf::viewer
