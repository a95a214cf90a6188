// Pictures of OpenSceneGraph as panoramas. No GL.
#include "PanoramaPicture.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/brdf/Half.h>

#include "OsgScene.h"
#include "support/ExpectError.h"
#include "support/TemporaryDir.h"

#include <osgDB/WriteFile>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

namespace fbrdf::test {
namespace {

using osgFbrdf::panoramaOf;
using osgFbrdf::readPanoramaPicture;

/// 4 x 2 pixels, all of the bytes 0.
osg::ref_ptr<osg::Image> picture(GLenum format, GLenum type)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(4, 2, 1, format, type);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    return image;
}

template <class T>
void put(osg::Image& image, int x, int y, int channel, T value)
{
    std::memcpy(image.data(static_cast<unsigned int>(x), static_cast<unsigned int>(y)) +
                    static_cast<size_t>(channel) * sizeof(T),
                &value, sizeof(T));
}

// Row 0 of a picture is the lowest, row 0 of a panorama the uppermost.
TEST(PanoramaPicture, HasItsUpperEdgeFirst)
{
    const auto image = picture(GL_RGB, GL_FLOAT);
    put(*image, 2, 1, 0, 3.0f);
    put(*image, 2, 1, 2, 5.0f);
    EXPECT_EQ(panoramaOf(*image, "sky").texel(2, 0), Vec3f(3.0f, 0.0f, 5.0f));
    image->setOrigin(osg::Image::TOP_LEFT);
    EXPECT_EQ(panoramaOf(*image, "sky").texel(2, 1), Vec3f(3.0f, 0.0f, 5.0f));
}

TEST(PanoramaPicture, IsReadInEveryFormat)
{
    const auto texel = [](const osg::Image& image) { return panoramaOf(image, "sky").texel(1, 1); };
    const auto grey = picture(GL_LUMINANCE, GL_FLOAT);
    put(*grey, 1, 0, 0, 2.0f);
    EXPECT_EQ(texel(*grey), Vec3f(2.0f));
    const auto halves = picture(GL_RGBA, GL_HALF_FLOAT);
    put(*halves, 1, 0, 1, halfFromFloat(0.5f));
    EXPECT_EQ(texel(*halves), Vec3f(0.0f, 0.5f, 0.0f));
    const auto codes = picture(GL_BGRA, GL_UNSIGNED_BYTE);
    put(*codes, 1, 0, 2, static_cast<unsigned char>(128));
    EXPECT_EQ(texel(*codes), Vec3f(linearFromSrgb(128.0f / 255.0f), 0.0f, 0.0f));
    const auto words = picture(GL_RGB, GL_UNSIGNED_SHORT);
    put(*words, 1, 0, 2, static_cast<uint16_t>(65535));
    EXPECT_EQ(texel(*words), Vec3f(0.0f, 0.0f, 1.0f));
}

TEST(PanoramaPicture, IsRepaired)
{
    const auto image = picture(GL_RGB, GL_FLOAT);
    put(*image, 0, 1, 0, -1.0f);
    put(*image, 0, 1, 1, std::nanf(""));
    put(*image, 0, 1, 2, std::numeric_limits<float>::infinity());
    EXPECT_EQ(panoramaOf(*image, "sky").texel(0, 0), Vec3f(0.0f, 0.0f, 65504.0f));
}

TEST(PanoramaPicture, OfAnotherKindIsRefused)
{
    const auto expectRefused = [](const osg::Image& image, const std::string& words) {
        expectError(ErrorKind::input, words, [&] { panoramaOf(image, "sky"); });
    };
    const osg::ref_ptr<osg::Image> empty = new osg::Image, square = new osg::Image;
    square->allocateImage(4, 4, 1, GL_RGB, GL_FLOAT);
    expectRefused(*empty, "sky: found a picture of 0 x 0 pixels");
    expectRefused(*square, "4 x 4 pixels, expected latitude and longitude");
    expectRefused(*picture(GL_RGB, GL_INT), "samples of another type");
    expectRefused(*picture(GL_DEPTH_COMPONENT, GL_FLOAT), "pixels of another format");
}

TEST(PanoramaPicture, OfManyColumnsIsMadeSmaller)
{
    const osg::ref_ptr<osg::Image> large = new osg::Image;
    large->allocateImage(40, 20, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    std::memset(large->data(), 255, large->getTotalSizeInBytes());
    EXPECT_EQ(panoramaOf(*large, "sky").width, 40);
    const Panorama panorama = panoramaOf(*large, "sky", 16);
    EXPECT_EQ(panorama.width, 16);
    EXPECT_NEAR(double(panorama.texels.front().x), 1.0, 1e-5);
}

class PanoramaPictureFile : public OsgTest {
protected:
    std::string file(const std::string& name, const std::string& content) const
    {
        std::ofstream(folder_.file(name), std::ios::binary) << content;
        return folder_.file(name);
    }
    TemporaryDir folder_;
};

TEST_F(PanoramaPictureFile, IsReadByOsgDb)
{
    // RGBE of 2, 1, 0.5 above and of 0 below, without run lengths.
    const std::string upper("\x80\x40\x20\x82", 4), lower("\0\0\0\0", 4);
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    const Panorama panorama = readPanoramaPicture(file("sky.hdr", header + upper + lower), nullptr);
    ASSERT_EQ(panorama.texels.size(), 2u);
    EXPECT_EQ(panorama.texels[0], Vec3f(2.0f, 1.0f, 0.5f));
    EXPECT_EQ(panorama.texels[1], Vec3f(0.0f));
    const std::string two = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    const Panorama rows = readPanoramaPicture(
        file("rows.hdr", two + upper + upper + upper + upper + lower + lower + lower + lower),
        nullptr);
    ASSERT_EQ(rows.texels.size(), 8u);
    EXPECT_EQ(rows.texel(3, 0).x, 2.0f);
    EXPECT_EQ(rows.texel(0, 1).x, 0.0f);
}

// OSG's own reader would read on for ever where a header does not end.
TEST_F(PanoramaPictureFile, OfAnotherKindIsRefused)
{
    const auto expectRefused = [](const std::string& name, const std::string& words) {
        expectError(ErrorKind::input, words, [&] { readPanoramaPicture(name, nullptr); });
    };
    expectRefused(folder_.file("none.hdr"), "found no such file");
    expectRefused(file("empty.hdr", ""), "a file of another kind");
    expectRefused(file("text.hdr", "no picture"), "a file of another kind");
    expectRefused(file("endless.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"),
                  "a file of another kind");
    expectRefused(file("upward.hdr", "#?RADIANCE\n\n+Y 1 +X 2\n        "),
                  "a file of another kind");
    expectRefused(file("text.unknown", "no picture"), "no plugin of osgDB reads");
    expectRefused(file("text.png", "no picture"), "no plugin of osgDB reads");
}

}  // namespace
}  // namespace fbrdf::test
