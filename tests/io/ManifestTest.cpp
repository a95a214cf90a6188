// ManifestTest.cpp - JSON and PNG maps: 8-bit storages bit for bit, wider ones within half a step
// of 16 bits, and every damaged field or picture refused.
#include "FormJson.h"
#include "Manifest.h"

#include "io/TestMaterials.h"
#include "support/ExpectError.h"
#include "support/FileBytes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/pictures/Png.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace fbrdf;
using fbrdf::test::expectError;
using fbrdf::test::TemporaryDir;

namespace {

/// Half a step of 16 bits over the range of a table, and half of a half's own step at 20.
float wideTolerance(const Table& table)
{
    const auto [low, high] = std::minmax_element(table.texels.begin(), table.texels.end());
    const float halfStep = table.storage == Storage::half ? std::ldexp(1.0f, -6) * 0.5f : 1e-6f;
    return 0.5001f * (*high - *low) / 65535.0f + halfStep;
}

TEST(Manifest, RoundTripsEightBitStoragesBitForBit)
{
    for (const Form& form : test::testForms())
        for (const Storage storage : {Storage::log8, Storage::linear8}) {
            const TemporaryDir folder;
            const Material material = test::testMaterial(form, storage);
            writeMaterial(material, folder.file("m.json"));
            EXPECT_TRUE(isMaterialFile(folder.file("m.json")));
            EXPECT_EQ(test::firstDifference(readMaterial(folder.file("m.json")), material), "")
                << form.name << " " << storageName(storage);
        }
}

TEST(Manifest, WiderStoragesComeBackWithinHalfAStep)
{
    for (const Form& form : test::testForms())
        for (const Storage storage : {Storage::half, Storage::float32, Storage::signedHalf}) {
            const TemporaryDir folder;
            const Material material = test::testMaterial(form, storage);
            writeMaterial(material, folder.file("m.json"));
            const Material back = readMaterial(folder.file("m.json"));
            ASSERT_EQ(back.tables.size(), material.tables.size());
            for (size_t k = 0; k < back.tables.size(); ++k) {
                const Table &a = material.tables[k], &b = back.tables[k];
                EXPECT_EQ(b.storage, storage);
                ASSERT_EQ(a.texels.size(), b.texels.size());
                for (size_t i = 0; i < a.texels.size(); ++i)
                    ASSERT_NEAR(a.texels[i], b.texels[i], wideTolerance(a)) << form.name << k;
            }
        }
}

TEST(Manifest, SameMaterialGivesTheSameBytes)
{
    const TemporaryDir folder;
    const Material material = test::testMaterial(formPqp(8, 0.5), Storage::half);
    std::filesystem::create_directories(folder.file("a"));
    std::filesystem::create_directories(folder.file("b"));
    writeMaterial(material, folder.file("a/m.json"));
    writeMaterial(material, folder.file("b/m.json"));
    for (const char* name : {"m.json", "m_p.png", "m_q.png"}) {
        const std::string bytes = test::fileBytes(folder.file("a/") + name);
        EXPECT_FALSE(bytes.empty()) << name;
        EXPECT_EQ(bytes, test::fileBytes(folder.file("b/") + name)) << name;
    }
}

// An engine multiplies a texture's value by a range: no code of ours may be needed.
TEST(Manifest, PicturesMeanWhatTheManifestDefines)
{
    const TemporaryDir folder;
    const Material material = test::testMaterial(formHdio({7, 4, 6}), Storage::log8);
    writeMaterial(material, folder.file("m.json"));
    const Json json = parseJson(test::fileBytes(folder.file("m.json")), "m.json");
    const Json& map = json["maps"][0];
    const PngImage image = decodePng(test::fileBytes(folder.file(map["file"])), "png");
    const Table& table = material.tables[0];
    ASSERT_EQ(image.width, 7);
    ASSERT_EQ(image.height, 4);
    ASSERT_EQ(image.bits, map["bits"]);
    // Rounding of floats around 20: 2^-19 each in range and product.
    constexpr double kFloat = 1e-5;
    for (size_t i = 0; i < table.texels.size(); ++i) {
        const double low = map["lower"][i % 3], high = map["upper"][i % 3];
        EXPECT_NEAR(low + (high - low) * image.codes[i] / 65535.0, double(table.texels[i]), kFloat);
    }
}

TEST(Manifest, KeepsNotANumberAmongTheErrors)
{
    const TemporaryDir folder;
    Material material = test::testMaterial(formPqp(8, 0.5), Storage::log8);
    material.errors = {{"good", 0.5}, {"none", NAN}};
    writeMaterial(material, folder.file("m.json"));
    const Material back = readMaterial(folder.file("m.json"));
    EXPECT_EQ(back.errors.at("good"), 0.5);
    EXPECT_TRUE(std::isnan(back.errors.at("none")));
}

struct Damage {
    const char *pointer, *value, *says;
};

TEST(Manifest, NamesEveryBrokenField)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.json");
    writeMaterial(test::testMaterial(formPqp(8, 0.5), Storage::log8), path);
    const Json whole = parseJson(test::fileBytes(path), path);
    const Damage damages[] = {
        {"/version", "2", "version: found 2, expected at most 1"},
        {"/units", "\"nits\"", "expected '1/sr'"},
        {"/colorspace", "\"srgb\"", "expected 'lin_rec709'"},
        {"/name", "1", "expected a string"},
        {"/scales", "[[1,1,1],[1,1,1]]", "2 scales, expected one for each of 1 terms"},
        {"/scales/0", "[1,1]", "expected three numbers"},
        {"/scales/0/1", "-1", "a scale that is negative or not finite"},
        {"/scales/0/1", "1e300", "a scale that is negative or not finite"},
        {"/maps", "[]", "expected one map for each of 2 tables"},
        {"/maps/0/storage", "\"log9\"",
         "expected 'log8', 'half', 'float', 'linear8' or "
         "'signed'"},
        {"/maps/0/storage", "\"linear8\"", "expected 8 x 8 pixels of 8 bits"},
        {"/maps/0/lower/2", "null", "expected a finite number"},
        {"/maps/0/log8/stride/0", "0", "found stride 0"},
        {"/maps/0/log8/stride/0", "7", "expected numbers that log8 holds"},
        {"/maps/0/log8/start", "[1]", "expected three integers"},
        {"/maps/0/file", "\"absent.png\"", "absent.png: found no such file"},
        {"/maps/0/file", "\"../m_p.png\"", "expected the name of a file beside the manifest"},
        {"/maps/0/file", "\"/dev/zero\"", "expected the name of a file beside the manifest"},
        {"/maps/0/file", "\"..\"", "expected the name of a file beside the manifest"},
        {"/maps/0/file", "\"m.json\"", "expected a PNG file"},
        {"/form/tables/0/domain/disc/size", "9", "expected 9 x 9 pixels of 16 bits"},
        {"/notes", "7", "expected an object"},
        {"/errors/log_rms", "\"x\"", "errors/log_rms: found \"x\", expected a finite number"},
    };
    for (const Damage& damage : damages) {
        Json json = whole;
        json[Json::json_pointer(damage.pointer)] = Json::parse(damage.value);
        test::putFile(path, json.dump());
        expectError(ErrorKind::input, damage.says, [&] { readMaterial(path); });
    }
}

TEST(Manifest, EveryPrefixIsRefused)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.json");
    writeMaterial(test::testMaterial(formPqp(8, 0.5), Storage::log8), path);
    const std::string text = test::fileBytes(path);
    for (size_t size = 0; size + 2 < text.size(); ++size)  // the last two: a brace, a new line
        EXPECT_THROW(readManifest(text.substr(0, size), path), Error) << size;
    const std::string png = folder.file("m_p.png"), picture = test::fileBytes(png);
    test::putFile(png, picture.substr(0, picture.size() - 1));
    expectError(ErrorKind::input, png, [&] { readMaterial(path); });
}

/// Colours of a smooth ramp: compresses to several kinds of blocks.
PngImage ramp(int bits)
{
    PngImage image{24, 24, 3, bits, {}};
    for (int i = 0; i < 24 * 24 * 3; ++i)
        image.codes.push_back(static_cast<uint16_t>(i * i / 7 % (bits == 8 ? 256 : 65536)));
    return image;
}

TEST(Png, EveryPrefixIsRefused)
{
    const std::string picture = encodePng(ramp(16), "png");
    testing::internal::CaptureStderr();
    for (size_t size = 0; size < picture.size(); ++size)
        expectError(ErrorKind::input, "name.png",
                    [&] { decodePng(picture.substr(0, size), "name.png"); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Png, DamageNeverCrashesOrPrints)
{
    const std::string picture = encodePng(ramp(8), "png");
    testing::internal::CaptureStderr();
    std::mt19937 random(11);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = picture;
        for (unsigned k = 0; k < 1 + random() % 3; ++k)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        try {
            decodePng(damaged, "png");
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            ++refused;
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_GT(refused, 2900) << "PNG has checksums: nearly all damage must be seen";
}

// Width and height of a header chunk, its checksum made right: the file is whole but for its
// pixels.
TEST(Png, HugeHeadersAreRefusedBeforeTheirPixels)
{
    std::string picture = encodePng(ramp(8), "png");
    const auto checksum = [](const std::string& bytes) {  // PNG specification, annex D
        uint32_t sum = 0xffffffffu;
        for (const char byte : bytes) {
            sum ^= static_cast<unsigned char>(byte);
            for (int k = 0; k < 8; ++k) sum = sum & 1u ? 0xedb88320u ^ (sum >> 1) : sum >> 1;
        }
        return ~sum;
    };
    for (const int byte : {16, 20}) picture.replace(static_cast<size_t>(byte), 4, {0, 0, 64, 0});
    const uint32_t sum = checksum(picture.substr(12, 17));
    for (int k = 0; k < 4; ++k)
        picture[static_cast<size_t>(29 + k)] = static_cast<char>(sum >> (24 - 8 * k));
    expectError(ErrorKind::input, "found 16384 x 16384 pixels", [&] { decodePng(picture, "png"); });
}

TEST(Png, RoundTripsOneAndThreeChannelsOfEightAndSixteenBits)
{
    for (const int channels : {1, 3})
        for (const int bits : {8, 16}) {
            PngImage image{5, 3, channels, bits, {}};
            for (int i = 0; i < 5 * 3 * channels; ++i)
                image.codes.push_back(static_cast<uint16_t>(bits == 8 ? i * 5 : i * 1400));
            const PngImage back = decodePng(encodePng(image, "png"), "png");
            EXPECT_EQ(back.width, 5);
            EXPECT_EQ(back.height, 3);
            EXPECT_EQ(back.channels, channels);
            EXPECT_EQ(back.bits, bits);
            EXPECT_EQ(back.codes, image.codes);
        }
}

}  // namespace
