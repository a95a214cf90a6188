// ImageTest.cpp - sRGB codes, EXR and PNG content, and files that appear whole or not at all.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Image.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace fbrdf::scene {
namespace {

Image gradient(int width, int height)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float* pixel = image.pixel(x, y);
            pixel[0] = 0.013f * static_cast<float>(x);
            pixel[1] = 3.7f / static_cast<float>(y + 1);  // brighter than white
            pixel[2] = 1e-6f * static_cast<float>(x * y);
            pixel[3] = x > y ? 1.0f : 0.0f;
        }
    return image;
}

template <class T>
std::vector<T> pixelsOf(const std::string& path, int channels, OIIO::TypeDesc type)
{
    const auto file = OIIO::ImageInput::open(path);
    if (!file) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = file->spec();
    EXPECT_EQ(spec.nchannels, channels);
    EXPECT_EQ(spec.format, type);
    std::vector<T> pixels(static_cast<size_t>(spec.width * spec.height * channels));
    EXPECT_TRUE(file->read_image(0, 0, 0, channels, type, pixels.data()));
    return pixels;
}

TEST(Srgb, HasTheValuesOfTheStandard)
{
    EXPECT_EQ(srgbCode(0.0f), 0);
    EXPECT_EQ(srgbCode(1.0f), 255);
    EXPECT_EQ(srgbCode(0.5f), 188);        // 0.735357 x 255 = 187.5+
    EXPECT_EQ(srgbCode(0.0031308f), 10);   // the joint: 0.04045 x 255 = 10.3
    EXPECT_EQ(srgbCode(0.001f), 3);        // the linear part: 12.92 x 0.001 x 255 = 3.29
    EXPECT_EQ(srgbCode(0.2158605f), 128);  // 128/255 decoded
    EXPECT_EQ(srgbCode(-1.0f), 0);
    EXPECT_EQ(srgbCode(1e30f), 255);
    EXPECT_EQ(srgbCode(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(srgbCode(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(WriteImage, ExrKeepsEveryFloatAndCoverage)
{
    const test::TemporaryDir dir;
    const Image image = gradient(17, 9);
    writeImage(image, dir.file("a.exr"), 0.1f);  // exposure is for PNG alone
    EXPECT_EQ(pixelsOf<float>(dir.file("a.exr"), 4, OIIO::TypeDesc::FLOAT), image.rgba);
}

TEST(WriteImage, PngIsSrgbOfExposureTimesRadiance)
{
    const test::TemporaryDir dir;
    const Image image = gradient(17, 9);
    writeImage(image, dir.file("a.png"), 0.4f);
    const auto codes = pixelsOf<uint8_t>(dir.file("a.png"), 3, OIIO::TypeDesc::UINT8);
    ASSERT_EQ(codes.size(), 3 * image.pixelCount());
    for (size_t i = 0; i < image.pixelCount(); ++i)
        for (size_t c = 0; c < 3; ++c)
            ASSERT_EQ(codes[3 * i + c], srgbCode(0.4f * image.rgba[4 * i + c])) << i;
}

TEST(SrgbCodes, FollowTheToneCurveWhereAskedTo)
{
    Image image(2, 1);
    image.rgba = {0.25f, 1.0f, 8.0f, 1.0f, 2.0f, 0.0f, -1.0f, 0.5f};
    const auto curved = [](float x) { return srgbCode(toneMapped(0.5f * x)); };
    EXPECT_EQ(srgbCodes(image, 0.5f, Transfer::toneMap),
              (std::vector<uint8_t>{curved(0.25f), curved(1.0f), 255, curved(2.0f), 0, 0}));
    EXPECT_EQ(srgbCodes(image, 0.5f, Transfer::srgb),
              (std::vector<uint8_t>{srgbCode(0.125f), srgbCode(0.5f), 255, 255, 0, 0}));
}

TEST(WriteImage, TiffAndTargaAreSrgbOfExposureTimesRadiance)
{
    const test::TemporaryDir dir;
    const Image image = gradient(17, 9);
    writeImage(image, dir.file("a.TIF"), 0.4f);
    writeImage(image, dir.file("a.tga"), 0.4f);
    const auto fine = pixelsOf<uint16_t>(dir.file("a.TIF"), 3, OIIO::TypeDesc::UINT16);
    const auto codes = pixelsOf<uint8_t>(dir.file("a.tga"), 3, OIIO::TypeDesc::UINT8);
    for (size_t i = 0; i < image.pixelCount(); ++i)
        for (size_t c = 0; c < 3; ++c) {
            ASSERT_NEAR(fine[3 * i + c] / 257.0, srgbCode(0.4f * image.rgba[4 * i + c]), 0.51) << i;
            ASSERT_EQ(codes[3 * i + c], srgbCode(0.4f * image.rgba[4 * i + c])) << i;
        }
}

TEST(WriteImage, HdrIsRadianceWithoutExposure)
{
    const test::TemporaryDir dir;
    const Image image = gradient(17, 9);
    writeImage(image, dir.file("a.hdr"), 0.1f);
    const auto radiance = pixelsOf<float>(dir.file("a.hdr"), 3, OIIO::TypeDesc::FLOAT);
    for (size_t i = 0; i < image.pixelCount(); ++i)
        for (size_t c = 0; c < 3; ++c)  // eight bits, shared by the pixel, whose green is largest
            ASSERT_NEAR(radiance[3 * i + c], image.rgba[4 * i + c], image.rgba[4 * i + 1] / 127)
                << i;
}

TEST(WriteImage, OtherExtensionsAreAUsageError)
{
    for (const char* name : {"a.xyz", "a", "a.exr.gz", ".png", ".jpg"}) try {
            writeImage(gradient(2, 2), name, 1.0f);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
        }
}

TEST(WriteImage, FailureLeavesNothingAndKeepsWhatWasThere)
{
    const test::TemporaryDir dir;
    std::filesystem::create_directory(dir.file("taken.png"));
    for (const std::string& path : {dir.file("none/a.png"), dir.file("none/a.exr"),
                                    dir.file("none/a.jpg"), dir.file("taken.png")}) {
        try {
            writeImage(gradient(4, 4), path, 1.0f);
            FAIL() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::output);
            EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
        }
    }
    EXPECT_EQ(dir.names(), std::vector<std::string>{"taken.png"});
}

}  // namespace
}  // namespace fbrdf::scene
