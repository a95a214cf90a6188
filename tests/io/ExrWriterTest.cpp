// ExrWriterTest.cpp - what encodeExr writes is what OpenImageIO reads: sizes of chunks, channels,
// attributes.
#include <fbrdf/base/Error.h>
#include <fbrdf/pictures/Exr.h>
#include <gtest/gtest.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <random>

using namespace fbrdf;

namespace {

/// Noise that half can hold, as compressible as `values` different numbers are.
ExrImage noise(int width, int height, int channels, unsigned values, unsigned seed)
{
    ExrImage image;
    image.name = "noise" + std::to_string(seed);
    image.width = width;
    image.height = height;
    image.channels = channels;
    std::mt19937 random(seed);
    for (int i = 0; i < width * height * channels; ++i)
        image.pixels.push_back(static_cast<float>(random() % values) / 64.0f);
    return image;
}

std::vector<float> readBack(const std::string& bytes, int part, OIIO::ImageSpec& spec)
{
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::open("memory.exr", nullptr, &memory);
    EXPECT_TRUE(input) << OIIO::geterror();
    if (!input || !input->seek_subimage(part, 0)) return {};
    spec = input->spec();
    std::vector<float> pixels(static_cast<size_t>(spec.width * spec.height * spec.nchannels));
    EXPECT_TRUE(input->read_image(part, 0, 0, spec.nchannels, OIIO::TypeFloat, pixels.data()))
        << input->geterror();
    return pixels;
}

// Among 120 images some have chunks that are as long compressed as they are plain.
TEST(ExrWriter, ChunksOfEverySizeComeBack)
{
    for (const bool half : {false, true})
        for (unsigned seed = 0; seed < 120; ++seed) {
            ExrImage image = noise(1 + int(seed % 13), 1 + int(seed % 37), seed % 2 ? 3 : 1,
                                   2 + seed % 60, seed);
            image.half = half;
            OIIO::ImageSpec spec;
            EXPECT_EQ(readBack(encodeExr({image}, "test"), 0, spec), image.pixels)
                << "seed " << seed << " half " << half;
        }
}

TEST(ExrWriter, PartsHaveTheirChannelsAndAttributes)
{
    ExrImage colour = noise(7, 40, 4, 1000, 1), grey = noise(20, 3, 1, 1000, 2);
    colour.attributes = {{"number", 3}, {"real", 0.1}, {"text", std::string("a\nb")}};
    grey.half = true;
    grey.attributes = {{"triple", std::array<int, 3>{1, -2, 3}},
                       {"range", std::array<float, 3>{0.5f, 1.5f, 2.5f}},
                       {std::string(200, 'k'), std::vector<float>{1, 2, 3, 4}}};
    const std::string bytes = encodeExr({colour, grey}, "test");
    OIIO::ImageSpec spec;
    EXPECT_EQ(readBack(bytes, 0, spec), colour.pixels);
    EXPECT_EQ(spec.channelnames, (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(spec.format, OIIO::TypeFloat);
    EXPECT_EQ(spec.get_int_attribute("number"), 3);
    EXPECT_EQ(spec.get_string_attribute("text"), "a\nb");
    EXPECT_EQ(readBack(bytes, 1, spec), grey.pixels);
    EXPECT_EQ(spec.channelnames, std::vector<std::string>{"Y"});
    EXPECT_EQ(spec.format, OIIO::TypeHalf);
    EXPECT_EQ(spec.full_width, 20) << "one display window for all parts";
    EXPECT_EQ(spec.full_height, 40);
    EXPECT_NE(spec.find_attribute(std::string(200, 'k')), nullptr);
    const OIIO::ParamValue* range = spec.find_attribute("range");
    ASSERT_NE(range, nullptr);
    EXPECT_EQ(static_cast<const float*>(range->data())[2], 2.5f);
}

TEST(ExrWriter, NamesThatOpenExrRefusesAreErrors)
{
    ExrImage image = noise(4, 4, 1, 10, 1);
    image.attributes = {{std::string(300, 'k'), 1}};
    try {
        encodeExr({image}, "there");
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::output);
        EXPECT_EQ(std::string(error.what()).rfind("there: cannot be written as OpenEXR: ", 0), 0u)
            << error.what();
    }
}

}  // namespace
