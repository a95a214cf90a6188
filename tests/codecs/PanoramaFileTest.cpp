// PanoramaFileTest.cpp - light from published kinds of files, and what damage does.
#include "support/CommaLocale.h"

#include <fbrdf/codecs/PanoramaFile.h>
#include <fbrdf/codecs/PictureFile.h>
#include <fbrdf/environment/CubeImage.h>
#include <fbrdf/pictures/Exr.h>
#include <fbrdf/pictures/Png.h>
#include <gtest/gtest.h>
#include <support/DataDir.h>
#include <support/ExpectError.h>
#include <support/TemporaryDir.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

namespace fbrdf {
namespace {

void write(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

/// Bytes of a file, read as a panorama.
Panorama readBytes(const std::string& bytes, std::string* note = nullptr)
{
    const test::TemporaryDir folder;
    write(folder.file("sky"), bytes);
    return readPanorama(folder.file("sky"), note);
}

std::string noteOf(const std::string& bytes)
{
    std::string note;
    readBytes(bytes, &note);
    return note;
}

void expectRefused(const std::string& bytes, const std::string& words)
{
    test::expectError(ErrorKind::input, words, [&] { readBytes(bytes); });
}

std::string exrOf(int width, int height, const std::vector<float>& pixels, bool half = false)
{
    const int channels = static_cast<int>(pixels.size()) / (width * height);
    return encodeExr({{"light", width, height, channels, half, {}, pixels}}, "test");
}

std::string hdrHeader(const std::string& sides, const std::string& variables = "")
{
    return "#?RADIANCE\n# made by a test\nFORMAT=32-bit_rle_rgbe\n" + variables + "\n" + sides +
           "\n";
}

/// Pixels of RGBE, one after the other.
std::string flat(const std::vector<std::array<int, 4>>& pixels)
{
    std::string bytes;
    for (const auto& pixel : pixels)
        for (const int value : pixel) bytes += static_cast<char>(value);
    return bytes;
}

/// A value of 1, 0.5 and 0.25, as RGBE and as light.
constexpr std::array<int, 4> kPixel = {128, 64, 32, 129};
const Vec3f kLight(1.0f, 0.5f, 0.25f);

TEST(PanoramaFile, ReadsOpenExr)
{
    std::vector<float> pixels;
    for (int i = 0; i < 24; ++i) pixels.push_back(0.5f * static_cast<float>(i));
    for (const bool half : {false, true}) {
        std::string note;
        const Panorama panorama = readBytes(exrOf(4, 2, pixels, half), &note);
        EXPECT_EQ(note, "lat-long 4 x 2");
        ASSERT_EQ(panorama.width, 4);
        ASSERT_EQ(panorama.height, 2);
        for (size_t i = 0; i < 8; ++i)
            EXPECT_EQ(panorama.texels[i],
                      Vec3f(pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]));
    }
}

TEST(PanoramaFile, ReadsGreyAndIgnoresAlpha)
{
    EXPECT_EQ(readBytes(exrOf(2, 1, {0.25f, 3.0f})).texels,
              (std::vector<Vec3f>{Vec3f(0.25f), Vec3f(3.0f)}));
    EXPECT_EQ(readBytes(exrOf(2, 1, {1, 2, 3, 0.5f, 4, 5, 6, 0})).texels,
              (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(PanoramaFile, ReadsFlatAndRunLengthsOfBothAges)
{
    const std::vector<Vec3f> same(16, kLight);
    const std::string header = hdrHeader("-Y 2 +X 4"), wide = hdrHeader("-Y 8 +X 16");
    EXPECT_EQ(readBytes(header + flat(std::vector(8, kPixel))).texels,
              std::vector<Vec3f>(8, kLight));
    EXPECT_EQ(readBytes(header + flat({kPixel, {1, 1, 1, 3}, kPixel, {1, 1, 1, 2}, kPixel})).texels,
              std::vector<Vec3f>(8, kLight));
    // Of new run lengths: a run of 10 and 6 bytes as they are, for each channel.
    std::string rows;
    for (int y = 0; y < 8; ++y) {
        rows += flat({{2, 2, 0, 16}});
        for (const int value : kPixel) {
            rows += static_cast<char>(128 + 10);
            rows += static_cast<char>(value);
            rows += static_cast<char>(6) + std::string(6, static_cast<char>(value));
        }
    }
    EXPECT_EQ(readBytes(wide + rows).texels, std::vector<Vec3f>(128, kLight));
    // A long run of old ones: 1 and 2 x 256 - 2 more.
    const std::string tall = hdrHeader("-Y 256 +X 512");
    std::string old;
    for (int y = 0; y < 256; ++y) old += flat({kPixel, {1, 1, 1, 255}, {1, 1, 1, 1}});
    EXPECT_EQ(readBytes(tall + old).texels, std::vector<Vec3f>(512 * 256, kLight));
}

TEST(PanoramaFile, UndoesExposureAndTurns)
{
    const std::vector<std::array<int, 4>> pixels = {{128, 128, 128, 129}, {128, 128, 128, 130}};
    const auto read = [&](const std::string& sides, const std::string& variables) {
        std::vector<float> reds;
        for (const Vec3f& texel : readBytes(hdrHeader(sides, variables) +
                                            flat({pixels[0], pixels[1], pixels[0], pixels[0],
                                                  pixels[0], pixels[0], pixels[0], pixels[1]}))
                                      .texels)
            reds.push_back(texel.x);
        return reds;
    };
    EXPECT_EQ(read("-Y 2 +X 4", ""), (std::vector<float>{1, 2, 1, 1, 1, 1, 1, 2}));
    EXPECT_EQ(read("-Y 2 +X 4", "EXPOSURE=4\nEXPOSURE= 0.5\n"),
              (std::vector<float>{.5, 1, .5, .5, .5, .5, .5, 1}));
    {
        const test::CommaLocale comma;  // of the host: the file's numbers have points all the same
        EXPECT_EQ(read("-Y 2 +X 4", "EXPOSURE=0.5\n"),
                  (std::vector<float>{2, 4, 2, 2, 2, 2, 2, 4}));
    }
    EXPECT_EQ(read("+Y 2 +X 4", ""), (std::vector<float>{1, 1, 1, 2, 1, 2, 1, 1}));
    EXPECT_EQ(read("-Y 2 -X 4", ""), (std::vector<float>{1, 1, 2, 1, 2, 1, 1, 1}));
    EXPECT_EQ(read("+Y 2 -X 4", ""), (std::vector<float>{2, 1, 1, 1, 1, 1, 2, 1}));
}

TEST(PanoramaFile, RefusesHeadersOfHdrThatItDoesNotKnow)
{
    const std::string pixels = flat(std::vector(8, kPixel));
    expectRefused(hdrHeader("+X 4 -Y 2") + pixels, "rows");
    expectRefused(hdrHeader("-Y 2 +X 4 x") + pixels, "rows");
    expectRefused(hdrHeader("-Y 0 +X 4") + pixels, "4 x 0");
    expectRefused(hdrHeader("-Y -2 +X 4") + pixels, "4 x -2");
    expectRefused(hdrHeader("-Y 9999999 +X 9999999") + pixels, "131072");
    expectRefused(hdrHeader("-Y 2 +X 4", "EXPOSURE=0\n") + pixels, "exposure");
    expectRefused(hdrHeader("-Y 2 +X 4", "EXPOSURE=nan\n") + pixels, "exposure");
    expectRefused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 4\n" + pixels, "xyze");
    expectRefused(hdrHeader("-Y 1 +X 2") + flat({kPixel, {1, 1, 1, 9}}), "run of 9");
    expectRefused("#?RADIANCE\n" + std::string(100000, '\n'), "rows");
    expectRefused("#?RADIANCE\n" + std::string(100000, 'a'), "does not end");
}

TEST(PanoramaFile, ReadsWhatTheModuleWritesAsHdr)
{
    constexpr float kRgbe = 1.0f / 128.0f;  // a mantissa of 8 bits that was cut
    PictureSamples picture{16, 8, 3, {}};
    for (int i = 0; i < 384; ++i)
        picture.samples.push_back(0.01f * static_cast<float>(i * i % 977));
    const Panorama panorama = readBytes(encodePicture(picture, *pictureFormatOf("a.hdr"), "a.hdr"));
    for (size_t i = 0; i < 128; ++i) {
        const Vec3f expected(picture.samples[3 * i], picture.samples[3 * i + 1],
                             picture.samples[3 * i + 2]);
        const float most = std::max({expected.x, expected.y, expected.z});
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(panorama.texels[i][c], expected[c], kRgbe * most) << i;
    }
}

TEST(PanoramaFile, TakesIntegersForSrgb)
{
    PictureSamples picture{4, 2, 3, std::vector<float>(24, 0.5f)};
    for (const char* name : {"a.tif", "a.jpg"}) {
        std::string note;
        const Panorama panorama =
            readBytes(encodePicture(picture, *pictureFormatOf(name), name), &note);
        EXPECT_NEAR(panorama.texels[3].y, 0.2140f, 0.006f) << name;  // a code of 8 bits
        EXPECT_NE(note.find("sRGB"), std::string::npos) << note;
    }
}

TEST(PanoramaFile, RepairsAndSaysSo)
{
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    std::string note;
    const Panorama panorama = readBytes(exrOf(2, 1, {-1.0f, 2.0f, inf, nan, nan, -inf}), &note);
    EXPECT_EQ(panorama.texels[0], Vec3f(0.0f, 2.0f, 65504.0f));
    EXPECT_EQ(panorama.texels[1], Vec3f(0.0f, 2.0f, 0.0f));
    EXPECT_EQ(note,
              "lat-long 2 x 1; 2 negative values count as 0; 1 infinite values became 65504; 2 "
              "values that were no number became the one to the left");
    validate(panorama, "repaired");
}

TEST(PanoramaFile, AveragesLargePicturesWhileReading)
{
    // 8192 x 4096 in run lengths of constant rows, each row with its own value.
    std::string bytes = hdrHeader("-Y 4096 +X 8192");
    for (int y = 0; y < 4096; ++y) {
        bytes += flat({{2, 2, 32, 0}});
        for (const int value : {128 + y % 2 * 64, 128, 128, 129}) {
            for (int run = 0; run < 8192 / 127; ++run) {
                bytes += static_cast<char>(128 + 127);
                bytes += static_cast<char>(value);
            }
            bytes += static_cast<char>(128 + 8192 % 127);
            bytes += static_cast<char>(value);
        }
    }
    std::string note;
    const Panorama panorama = readBytes(bytes, &note);
    EXPECT_EQ(note, "lat-long 4096 x 2048; averaged from 8192 x 4096");
    EXPECT_EQ(panorama.width, 4096);
    EXPECT_EQ(panorama.texel(17, 1000), Vec3f(1.25f, 1.0f, 1.0f));
    expectRefused(hdrHeader("-Y 32749 +X 65498"), "2^24");  // a prime and twice that
}

TEST(PanoramaFile, SaysWhichSidesItKnows)
{
    expectRefused(exrOf(1, 1, {1.0f}), "square");
    expectRefused(exrOf(5, 3, std::vector<float>(15, 1.0f)), "2:1 (lat-long), 4:3 or 3:4");
    EXPECT_EQ(readBytes(exrOf(2, 1, {1.0f, 1.0f})).texels.size(), size_t(2));
    expectRefused("", "an empty file");
    expectRefused("hello", "another kind");
    const test::TemporaryDir folder;
    test::expectError(ErrorKind::input, "no such file",
                      [&] { readPanorama(folder.file("none.exr")); });
    test::expectError(ErrorKind::input, "a folder", [&] { readPanorama(folder.file("")); });
}

/// Light that tells all directions apart, in the frame of panoramas.
Vec3d skyAt(const Vec3d& w)
{
    return 1.5 + w;
}

/// A face of skyAt as files have it: +z of the file is forward, -z of a panorama.
std::vector<float> faceOfSky(int face, int size)
{
    std::vector<float> pixels;
    for (int i = 0; i < size * size; ++i) {
        const Vec3d w = cubeTexelDirection(face, i % size, i / size, size);
        const Vec3d light = skyAt({w.x, w.y, -w.z});
        for (int c = 0; c < 3; ++c) pixels.push_back(static_cast<float>(light[c]));
    }
    return pixels;
}

void expectSky(const Panorama& panorama)
{
    constexpr double kFilter = 0.02;  // linear filtering between texels of pi / 32
    ASSERT_EQ(panorama.width, 2 * panorama.height);
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const Vec3d expected =
                skyAt(panoramaDirection((x + 0.5) / panorama.width, (y + 0.5) / panorama.height));
            ASSERT_NEAR(glm::distance(Vec3d(panorama.texel(x, y)), expected), 0.0, kFilter)
                << x << " " << y;
        }
}

struct CellOfFace {
    int column, row;
};

/// Faces of 16 texels at their places; `turned` stands on its head.
std::string layoutOfSky(const std::vector<CellOfFace>& cells, int columns, int rows,
                        int turned = -1)
{
    constexpr int kSize = 16;
    const int width = columns * kSize;
    std::vector<float> pixels(static_cast<size_t>(3 * width * rows * kSize), 0.0f);
    for (int face = 0; face < 6; ++face) {
        const std::vector<float> light = faceOfSky(face, kSize);
        const CellOfFace& cell = cells[static_cast<size_t>(face)];
        for (int i = 0; i < kSize * kSize; ++i) {
            const int from = face == turned ? kSize * kSize - 1 - i : i;
            const int x = cell.column * kSize + i % kSize, y = cell.row * kSize + i / kSize;
            for (int c = 0; c < 3; ++c)
                pixels[static_cast<size_t>(3 * (y * width + x) + c)] =
                    light[static_cast<size_t>(3 * from + c)];
        }
    }
    return exrOf(width, rows * kSize, pixels);
}

TEST(PanoramaFile, UnfoldsCrossesAndStrips)
{
    const std::vector<CellOfFace> across = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}},
                                  down = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}},
                                  row = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}},
                                  column = {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}};
    expectSky(readBytes(layoutOfSky(across, 4, 3)));
    expectSky(readBytes(layoutOfSky(down, 3, 4, 5)));
    expectSky(readBytes(layoutOfSky(row, 6, 1)));
    expectSky(readBytes(layoutOfSky(column, 1, 6)));
    EXPECT_EQ(noteOf(layoutOfSky(down, 3, 4, 5)), "vertical cross 48 x 64");
    // The tester sees a back that does not stand on its head.
    const Panorama wrong = readBytes(layoutOfSky(down, 3, 4));
    EXPECT_GT(
        glm::distance(Vec3d(wrong.texel(0, 10)), skyAt(panoramaDirection(0.5 / 64, 10.5 / 32))),
        0.1);
}

TEST(PanoramaFile, ReadsSixFiles)
{
    const char* const names[][6] = {{"px", "nx", "py", "ny", "pz", "nz"},
                                    {"POSX", "NEGX", "POSY", "NEGY", "POSZ", "NEGZ"},
                                    {"right", "left", "top", "bottom", "front", "back"}};
    for (const auto& set : names) {
        const test::TemporaryDir folder;
        const auto file = [&](int face) {
            return folder.file(std::string("sky_") + set[face] + ".exr");
        };
        for (int face = 0; face < 6; ++face) write(file(face), exrOf(16, 16, faceOfSky(face, 16)));
        std::string note;
        for (int face = 0; face < 6; face += 5) expectSky(readPanorama(file(face), &note));
        EXPECT_EQ(note, "one of six faces 16 x 16");
        write(file(3), exrOf(8, 8, faceOfSky(3, 8)));
        test::expectError(ErrorKind::input, "8 x 8 pixels, expected 16 x 16",
                          [&] { readPanorama(file(0)); });
        std::filesystem::remove(file(3));
        test::expectError(ErrorKind::input, "no such file", [&] { readPanorama(file(0)); });
    }
}

/// A small file of each of the two kinds.
std::vector<std::string> smallFiles()
{
    std::vector<float> pixels;
    for (int i = 0; i < 8 * 4 * 3; ++i) pixels.push_back(0.1f * static_cast<float>(i % 37));
    return {exrOf(8, 4, pixels, true),
            encodePicture({8, 4, 3, pixels}, *pictureFormatOf("a.hdr"), "a.hdr")};
}

TEST(PanoramaFile, RefusesEveryPrefix)
{
    const test::TemporaryDir folder;
    for (const std::string& whole : smallFiles())
        for (size_t size = 0; size < whole.size(); ++size) {
            write(folder.file("a"), whole.substr(0, size));
            EXPECT_THROW(readPanorama(folder.file("a")), Error) << size << " of " << whole.size();
        }
}

TEST(PanoramaFile, SurvivesDamage)
{
    const test::TemporaryDir folder;
    std::mt19937 random(1);
    int read = 0, refused = 0;
    for (const std::string& whole : smallFiles())
        for (int i = 0; i < 100; ++i) {
            std::string damaged = whole;
            for (int k = 0; k < 1 + i % 3; ++k)
                damaged[random() % damaged.size()] = static_cast<char>(random());
            write(folder.file("a"), damaged);
            try {
                validate(readPanorama(folder.file("a")), "damaged");
                ++read;
            } catch (const Error& error) {
                EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(ErrorKind::input));
                ++refused;
            }
        }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

/// The 4 bytes of a number, little-endian.
std::string bytesOf(uint32_t value)
{
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

TEST(PanoramaFile, RefusesOpenExrThatAsksForMemory)
{
    const std::string whole = smallFiles()[0];
    const auto changed = [&](const std::string& after, size_t offset, uint32_t value) {
        std::string bytes = whole;
        const size_t at = bytes.find(after);
        if (at == std::string::npos) throw std::runtime_error("no " + after);
        return bytes.replace(at + after.size() + offset, 4, bytesOf(value));
    };
    using namespace std::string_literals;
    const std::string window = "dataWindow\0box2i\0"s, display = "displayWindow\0box2i\0"s;
    expectRefused(changed(window, 12, 200000), "a dataWindow of 200001 x 4 pixels");
    expectRefused(changed(window, 16, 131072), "dataWindow");
    expectRefused(changed(display, 16, 0x80000000u), "displayWindow");
    expectRefused(changed(window, 0, 0x7fffff00u), "attribute of 2147483392 bytes");
    // Data of 8 x 4 pixels in a large picture.
    std::string bytes = changed(display, 12, 511);
    bytes.replace(bytes.find(display) + display.size() + 16, 4, bytesOf(255));
    expectRefused(bytes, "data of 8 x 4 pixels in a picture of 512 x 256");
}

TEST(PanoramaFile, ReadsPng)
{
    const std::string bytes = encodePng({2, 1, 3, 8, {0, 255, 188, 64, 64, 64}}, "test");
    std::string note;
    const Panorama panorama = readBytes(bytes, &note);
    constexpr float kCode = 0.005f;  // half a code of 8 bits, in the middle
    EXPECT_EQ(panorama.texels[0].x, 0.0f);
    EXPECT_EQ(panorama.texels[0].y, 1.0f);
    EXPECT_NEAR(panorama.texels[0].z, 0.5f, kCode);
    EXPECT_EQ(note, "lat-long 2 x 1; sRGB, so that no light is above 1");
}

TEST(PanoramaFile, ReadsPublishedFiles)
{
    for (const std::string name : {"studio", "city", "forest", "lobby"}) {
        FBRDF_NEEDS_DATA("hdri/" + name + ".exr");
        std::string note;
        const Panorama panorama = readPanorama(test::dataPath("hdri/" + name + ".exr"), &note);
        EXPECT_EQ(panorama.width, 512);
        EXPECT_EQ(panorama.height, 256);
        EXPECT_NE(note.find("negative values"), std::string::npos) << note;
        validate(panorama, name);
    }
}

}  // namespace
}  // namespace fbrdf
