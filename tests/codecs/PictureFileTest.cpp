// PictureFileTest.cpp - pictures of every format through the module, and what damage does.
#include <fbrdf/codecs/PictureFile.h>
#include <gtest/gtest.h>
#include <support/ExpectError.h>

#include <array>
#include <cmath>
#include <random>

namespace fbrdf {
namespace {

const char* const kExtensions[] = {".bmp", ".gif", ".hdr",  ".jpeg", ".jpg",
                                   ".ppm", ".tga", ".tiff", ".tif",  ".webp"};

/// Smooth colours, so that JPEG has little to lose, and at most 256 of them for GIF.
PictureSamples gradient(float most)
{
    PictureSamples picture{16, 16, 3, {}};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (const int c : {x, y, 8})
                picture.samples.push_back(most * static_cast<float>(c) / 16.0f);
    return picture;
}

std::string encoded(const std::string& extension, const PictureSamples& picture)
{
    const PictureFormat* format = pictureFormatOf("picture" + extension);
    if (format == nullptr) throw std::runtime_error("no format " + extension);
    return encodePicture(picture, *format, "picture" + extension);
}

DecodedPicture decoded(const std::string& extension, const std::string& bytes)
{
    return decodePicture(bytes, pictureFormatOf("a" + extension)->name, "picture" + extension);
}

float worst(const std::vector<float>& a, const std::vector<float>& b)
{
    float most = 0.0f;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Half a code, and what the format loses beside it.
float toleranceOf(const std::string& extension)
{
    if (extension == ".tif" || extension == ".tiff") return 0.51f / 65535.0f;
    if (extension == ".jpg" || extension == ".jpeg") return 4.0f / 255.0f;  // quality 95
    if (extension == ".gif") return 24.0f / 255.0f;                         // 256 colours, dithered
    if (extension == ".webp") return 12.0f / 255.0f;  // colours at half the resolution
    return 0.51f / 255.0f;
}

TEST(PictureFile, EveryFormatOfTheTableReadsBackWhatWasWritten)
{
    const PictureSamples picture = gradient(1.0f);
    for (const std::string extension : kExtensions) {
        if (extension == ".hdr") continue;  // below
        const DecodedPicture back = decoded(extension, encoded(extension, picture));
        EXPECT_EQ(back.width, 16) << extension;
        EXPECT_EQ(back.height, 16) << extension;
        ASSERT_GE(back.channels.size(), 3u) << extension;
        EXPECT_EQ(back.channels[0] + back.channels[1] + back.channels[2], "RGB") << extension;
        std::vector<float> colours;  // without the alpha that GIF adds
        for (size_t i = 0; i < back.samples.size(); ++i)
            if (i % back.channels.size() < 3) colours.push_back(back.samples[i]);
        ASSERT_EQ(colours.size(), picture.samples.size()) << extension;
        EXPECT_LE(worst(colours, picture.samples), toleranceOf(extension)) << extension;
        EXPECT_EQ(back.sampleType, extension.substr(0, 4) == ".tif" ? "uint16" : "uint8");
        if (extension == ".jpg" || extension == ".webp") {
            EXPECT_EQ(back.colourSpace, "sRGB") << extension;
        }
    }
}

TEST(PictureFile, HdrKeepsRadianceAboveWhite)
{
    const PictureSamples picture = gradient(4000.0f);
    const DecodedPicture back = decoded(".hdr", encoded(".hdr", picture));
    EXPECT_EQ(back.sampleType, "float");
    ASSERT_EQ(back.samples.size(), picture.samples.size());
    // Eight bits of mantissa, shared by the pixel: 1/256 of the largest channel, cut and not
    // rounded.
    for (size_t i = 0; i < picture.samples.size(); i += 3) {
        const float most =
            std::max({picture.samples[i], picture.samples[i + 1], picture.samples[i + 2]});
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(back.samples[i + c], picture.samples[i + c], most / 127.0f) << i;
    }
}

TEST(PictureFile, TheSamePictureGivesTheSameBytes)
{
    for (const std::string extension : kExtensions)
        EXPECT_EQ(encoded(extension, gradient(1.0f)), encoded(extension, gradient(1.0f)))
            << extension;
}

TEST(PictureFile, TheTableNamesItsExtensionsInAnyCase)
{
    for (const std::string extension : kExtensions)
        EXPECT_NE(pictureExtensions().find(extension), std::string::npos) << extension;
    EXPECT_STREQ(pictureFormatOf("A.JPG")->name, "jpeg");
    for (const char* path : {"a", "a.png", "a.exr", ".jpg", "a.jpg.gz", "jpg", "a.null"})
        EXPECT_EQ(pictureFormatOf(path), nullptr) << path;
}

/// Decodes damaged bytes: a picture comes out, or one line of an Error(input) that names the file.
void survive(const std::string& extension, const std::string& bytes)
{
    try {
        decoded(extension, bytes);
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_EQ(error.kind(), ErrorKind::input) << what;
        EXPECT_EQ(what.rfind("picture" + extension + ": found ", 0), 0u) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

// The formats that the tools read; decoders of the others meet no foreign file.
const char* const kReadExtensions[] = {".hdr", ".tif"};

TEST(PictureFile, EveryPrefixIsRefusedOrRead)
{
    for (const std::string extension : kReadExtensions) {
        const std::string bytes = encoded(extension, gradient(1.0f));
        for (size_t size = 0; size < bytes.size(); ++size)
            survive(extension, bytes.substr(0, size));
    }
}

TEST(PictureFile, DamagedBytesAreRefusedOrRead)
{
    std::mt19937 random(7);
    for (const std::string extension : kReadExtensions) {
        const std::string bytes = encoded(extension, gradient(1.0f));
        for (int i = 0; i < 2000; ++i) {
            std::string damaged = bytes;
            for (int k = 0; k < 1 + i % 4; ++k)
                damaged[random() % damaged.size()] = static_cast<char>(random());
            survive(extension, damaged);
        }
    }
}

TEST(PictureFile, TheCheckSeesTheHeaderAndItsErrorComesOut)
{
    const std::string bytes = encoded(".hdr", gradient(1.0f));
    const auto refuse = [](const DecodedPicture& picture) {
        EXPECT_EQ(picture.width, 16);
        EXPECT_EQ(picture.sampleType, "float");
        EXPECT_TRUE(picture.samples.empty());
        throw Error(ErrorKind::usage, "check", "found this picture, expected another");
    };
    test::expectError(ErrorKind::usage, "check: found this picture",
                      [&] { decodePicture(bytes, "hdr", "picture.hdr", refuse); });
}

TEST(PictureFile, SizesThatDoNotFitTheFileAreRefused)
{
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4000 +X 4000\n";
    test::expectError(ErrorKind::input, "4000 x 4000 pixels of 3 channels",
                      [&] { decoded(".hdr", header + "no pixels"); });
    test::expectError(ErrorKind::input, "expected a whole tiff file",
                      [&] { decoded(".tif", "II*"); });
}

}  // namespace
}  // namespace fbrdf
