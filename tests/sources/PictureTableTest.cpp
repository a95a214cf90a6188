// PictureTableTest.cpp - reflectance in TIFF and Radiance HDR images.
#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

#include <OpenImageIO/imageio.h>

#include <functional>

namespace fbrdf::test {
namespace {

constexpr double kHdr = 1.0 / 127;  // eight bits, shared by the three channels of a pixel

using Pixel = std::function<float(int x, int y, int channel)>;

struct Image {
    const char* name = "table.tif";
    int width = 10, height = 8, channels = 3;
    OIIO::TypeDesc type = OIIO::TypeFloat;
};

std::string write(const TempFolder& folder, const Image& image, const Pixel& pixel)
{
    OIIO::ImageSpec spec(image.width, image.height, image.channels, image.type);
    std::vector<float> samples;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c) samples.push_back(pixel(x, y, c));
    const std::string path = folder.path(image.name);
    const auto output = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(output->open(path, spec)) << output->geterror();
    EXPECT_TRUE(output->write_image(OIIO::TypeFloat, samples.data()));
    EXPECT_TRUE(output->close());
    return path;
}

std::string bytesAt(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

float coordinates(int x, int y, int channel)
{
    return channel == 0 ? float(x) : float(y);
}

// The axes are told from the values, which are the numbers of column and line.
void expectSlice(const Source& source, double relative)
{
    EXPECT_EQ(source.format, "picture");
    EXPECT_TRUE(source.isotropic);
    EXPECT_EQ(source.assumptions.size(), 2u);
    ASSERT_EQ(allSamples(source).size(), 80u);
    expectSound(source);
    for (const Sample& s : allSamples(source)) {
        const HalfDifference a = halfDifferenceFromPair({Vec3d(s.wo), Vec3d(s.wi)});
        const double tolerance = 1e-5 + relative * double(std::max(s.f.x, s.f.y)) / 8 * kPi / 2;
        EXPECT_NEAR(a.theta_h, (double(s.f.x) + 0.5) / 10 * kPi / 2, tolerance);
        EXPECT_NEAR(a.theta_d, (1 - (double(s.f.y) + 0.5) / 8) * kPi / 2, tolerance);
    }
}

TEST(PictureTable, TiffAndHdrAreSlices)
{
    const TempFolder folder;
    expectSlice(openSource(write(folder, {}, coordinates)), 0.0);
    expectSlice(openSource(write(folder, {"half.tif", 10, 8, 3, OIIO::TypeHalf}, coordinates)), 0);
    expectSlice(openSource(write(folder, {"table.hdr"}, coordinates)), kHdr);
}

TEST(PictureTable, ContentDecidesAndNotTheName)
{
    const TempFolder folder;
    const std::string bytes = bytesAt(write(folder, {}, coordinates));
    expectSlice(openSource(folder.write("table.dat", bytes)), 0.0);
}

TEST(PictureTable, AGreyImageIsGrey)
{
    const TempFolder folder;
    const Source source = openSource(write(folder, {"grey.tif", 10, 8, 1}, coordinates));
    ASSERT_EQ(allSamples(source).size(), 80u);
    for (const Sample& s : allSamples(source)) EXPECT_EQ(s.f, Vec3f(s.f.x));
}

TEST(PictureTable, An288ImageIsUtias)
{
    const TempFolder folder;
    const Source source = openSource(
        write(folder, {"utia.tif", 288, 288, 3}, [](int x, int y, int) { return float(x + y); }));
    EXPECT_FALSE(source.isotropic);
    EXPECT_EQ(source.stream.geometry, "utia");
}

TEST(PictureTable, CodesOfADisplayAreRefusedBeforeTheyAreDecoded)
{
    const TempFolder folder;
    const auto half = [](int, int, int) { return 0.5f; };
    expectInputError(write(folder, {"codes.tif", 4, 4, 3, OIIO::TypeUInt8}, half),
                     "samples of type uint8, expected floating point");
    expectInputError(write(folder, {"codes.tif", 4, 4, 3, OIIO::TypeUInt16}, half),
                     "samples of type uint16, expected floating point");
}

TEST(PictureTable, OtherChannelsAreRefused)
{
    const TempFolder folder;
    const auto half = [](int, int, int) { return 0.5f; };
    expectInputError(write(folder, {"two.tif", 4, 4, 2}, half), "2 channels without");
}

TEST(PictureTable, EveryPrefixAndDamageIsSoundOrRefused)
{
    const TempFolder folder;
    for (const char* name : {"a.tif", "a.hdr"}) {
        const std::string bytes = bytesAt(write(folder, {name, 6, 5, 3}, coordinates));
        EXPECT_GT(refusedPrefixes(name, bytes, 3), 30u);
        expectSurvivesDamage(name, bytes, 5);
    }
}

}  // namespace
}  // namespace fbrdf::test
