// AnimationFileTest.cpp - moving pictures, read back by OpenImageIO.
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/codecs/AnimationFile.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <vector>

namespace fbrdf {
namespace {

constexpr int kWidth = 23, kHeight = 17;  // odd: chunks of WebP are padded

Animation fading()
{
    Animation animation{kWidth, kHeight, 20, {}};
    for (int frame = 0; frame < 4; ++frame)
        animation.frames.emplace_back(3 * kWidth * kHeight, uint8_t(40 + 50 * frame));
    for (auto& frame : animation.frames) frame[0] = 255;
    return animation;
}

/// The middle of every frame as it is shown, in [0, 255], and the frames a second.
std::vector<double> middlesOf(const std::string& path, double& framesPerSecond)
{
    std::vector<double> middles;
    const auto file = OIIO::ImageInput::open(path);
    if (!file) throw std::runtime_error(OIIO::geterror());
    for (int frame = 0; file->seek_subimage(frame, 0); ++frame) {
        const OIIO::ImageSpec spec = file->spec();
        if (spec.width != kWidth || spec.height != kHeight) throw std::runtime_error("wrong size");
        std::vector<uint8_t> codes(static_cast<size_t>(spec.nchannels) * kWidth * kHeight);
        if (!file->read_image(frame, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, codes.data()))
            throw std::runtime_error(file->geterror());
        const int channels = spec.nchannels;
        middles.push_back(
            codes[static_cast<size_t>(channels * (kWidth * (kHeight / 2) + kWidth / 2))]);
        int rate[2] = {0, 1};
        spec.getattribute("FramesPerSecond", OIIO::TypeRational, rate);
        framesPerSecond = double(rate[0]) / rate[1];
    }
    return middles;
}

TEST(Animations, KeepTheirFramesAndTheirRate)
{
    const test::TemporaryDir dir;
    for (const char* name : {"a.gif", "a.WEBP"}) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(isAnimationPath(name));
        const std::string path = dir.file(name);
        const std::string bytes = encodeAnimation(fading(), path);
        writeFile(path, bytes);
        double rate = 0.0;
        const std::vector<double> middles = middlesOf(path, rate);
        ASSERT_EQ(middles.size(), 4u);
        for (size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(middles[i], 40.0 + 50.0 * double(i), 8.0)
                << "few colours, and a lossy code";
        // OpenImageIO does not report that of WebP: it is in the header of each frame.
        if (const size_t frame = bytes.find("ANMF"); frame != std::string::npos)
            rate = 1000.0 / static_cast<unsigned char>(bytes[frame + 20]);
        EXPECT_NEAR(rate, 20.0, 0.01);
    }
}

TEST(Animations, AreOfTwoFormats)
{
    for (const char* path : {"a.png", "a.exr", "a.tif", "gif", "a"})
        EXPECT_FALSE(isAnimationPath(path)) << path;
}

}  // namespace
}  // namespace fbrdf
