#include "Picture.h"

#include <gtest/gtest.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace fbrdf {
namespace {

TEST(Picture, StartsTransparentAndClampsColours)
{
    Picture picture(2, 1);
    picture.set(1, 0, {-1.0, 0.5, 2.0});
    EXPECT_EQ(picture.rgba, (std::vector<uint8_t>{0, 0, 0, 0, 0, 128, 255, 255}));
}

TEST(Png, DecodesToTheSamePixels)
{
    Picture picture(5, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) picture.set(x, y, {x / 4.0, y / 3.0, 0.2});
    const std::vector<uint8_t> bytes = pngOf(picture);
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const auto reader = OIIO::ImageInput::open("picture.png", nullptr, &memory);
    ASSERT_TRUE(reader) << OIIO::geterror();
    ASSERT_EQ(reader->spec().width, 5);
    ASSERT_EQ(reader->spec().nchannels, 4);
    std::vector<uint8_t> pixels(picture.rgba.size());
    ASSERT_TRUE(reader->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, pixels.data()));
    EXPECT_EQ(pixels, picture.rgba);
}

TEST(Png, IsADataUri)
{
    EXPECT_EQ(dataUri(Picture(1, 1)).rfind("data:image/png;base64,iVBORw0KGgo", 0), 0u);
}

}  // namespace
}  // namespace fbrdf
