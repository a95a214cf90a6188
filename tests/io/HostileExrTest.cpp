// HostileExrTest.cpp - damaged .fbrdf files: each is an Error(input) of one line or a valid
// material; nothing crashes, prints, or takes memory that the file could not fill.
#include "ExrHeader.h"
#include "ExrMaterial.h"

#include "io/TestMaterials.h"
#include "support/ExpectError.h"
#include "support/FileBytes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/pictures/Exr.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

using namespace fbrdf;
using fbrdf::test::expectError;
using fbrdf::test::TemporaryDir;

namespace {

// Peak memory may grow by this much while refusing a file of a few KB; the headers ask for 200 MB.
constexpr long kMemoryKiB = 64 * 1024;

std::string bytesOf(const Material& material)
{
    const TemporaryDir folder;
    writeMaterial(material, folder.file("m.fbrdf"));
    return test::fileBytes(folder.file("m.fbrdf"));
}

long peakMemoryKiB()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

/// Replaces the value of part 0's first attribute `name` (its bytes follow name, type and size).
std::string patched(std::string bytes, const std::string& name, const std::string& value,
                    size_t from = 0)
{
    const size_t type = bytes.find(name + '\0', from) + name.size() + 1;
    const size_t at = bytes.find('\0', type) + 1 + 4;
    return bytes.replace(at, value.size(), value);
}

template <class T>
std::string raw(const T& value)
{
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// True when the bytes read as a material; fails the test unless they do or give
/// the reason in one line.
bool readsOrRefuses(const std::string& bytes)
{
    try {
        const Material material = readExrMaterial(bytes, "memory");
        validate(material, "what was read");
        evaluate<float>(material, Vec3f(0.0f, 0.6f, 0.8f), Vec3f(0.6f, 0.0f, 0.8f));
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return false;
    }
}

bool scans(const std::string& bytes)
{
    try {
        scanExr(bytes, "memory");
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
        return false;
    }
}

TEST(HostileExr, EveryPrefixIsRefused)
{
    const TemporaryDir folder;
    Material material = test::testMaterial(formPqpr(8, 0.5, 5), Storage::log8);
    material.lobes = test::testLobes(LobeAxes::tilted);
    const std::string bytes = bytesOf(material);
    for (size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(readsOrRefuses(bytes.substr(0, size))) << size;
    EXPECT_TRUE(readsOrRefuses(bytes));
}

TEST(HostileExr, ExtraBytesAtTheEndAreIgnored)
{
    const TemporaryDir folder;
    const Material material = test::testMaterial(formPqp(8, 0.5), Storage::half);
    test::putFile(folder.file("m.fbrdf"), bytesOf(material) + std::string(1000, 'x'));
    EXPECT_EQ(test::firstDifference(readMaterial(folder.file("m.fbrdf")), material), "");
}

TEST(HostileExr, DamagedBytesNeverCrashOrPrint)
{
    const TemporaryDir folder;
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::mt19937 random(7);
    int read = 0, refused = 0;
    for (const Form& form : test::testForms())
        for (const Storage storage : {Storage::log8, Storage::float32}) {
            const std::string bytes = bytesOf(test::testMaterial(form, storage));
            for (int i = 0; i < 60; ++i) {
                std::string damaged = bytes;
                for (unsigned k = 0; k < 1 + random() % 3; ++k)
                    damaged[random() % damaged.size()] = static_cast<char>(random());
                ++(readsOrRefuses(damaged) ? read : refused);
            }
        }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_GT(refused, 120) << "the damage does not reach what is checked";
    EXPECT_GT(read, 40) << "the damage never reaches what cannot be checked";
}

// Each byte of the header set, in turn, to one of the values that most often break parsers.
TEST(HostileExr, EveryHeaderByteMayBeExtreme)
{
    const TemporaryDir folder;
    const std::string bytes = bytesOf(test::testMaterial(formPqp(8, 0.5), Storage::log8));
    const long before = peakMemoryKiB();
    testing::internal::CaptureStderr();
    const size_t headers = bytes.find("screenWindowWidth");
    const char extremes[] = {'\0', '\x7f', '\xff'};
    for (size_t i = 0; i < headers; ++i) {
        std::string damaged = bytes;
        damaged[i] = extremes[i % 3];
        if (scans(damaged) && i % 5 == 0) readsOrRefuses(damaged);  // decoding all takes too long
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_LT(peakMemoryKiB() - before, kMemoryKiB);
}

struct Patch {
    const char* attribute;
    std::string value;
    const char* says;
};

TEST(HostileExr, EachFieldIsCheckedByItself)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    Material material = test::testMaterial(formPqp(8, 0.5), Storage::log8);
    material.lobes = test::testLobes(LobeAxes::tilted);
    const std::string bytes = bytesOf(material);
    const int huge[4] = {0, 0, 4095, 4095}, broad[4] = {0, 0, 4095, 15},
              endless[4] = {0, 0, 1 << 30, 1 << 30}, negative[4] = {5, 5, -5, -5},
              wide[4] = {0, 0, 15, 7};
    const Patch patches[] = {
        {"fbrdf:version", raw(2), "found format version 2, expected at most 1: written by a newer"},
        {"fbrdf:version", raw(0), "found format version 0"},
        {"fbrdf:units", "1/sX", "fbrdf:units: found '1/sX', expected '1/sr'"},
        {"fbrdf:colorspace", "lin_rec2020", "expected 'lin_rec709'"},
        {"fbrdf:form", "}", "not JSON"},
        {"fbrdf:scales", raw(-1.0f), "a scale that is negative or not finite"},
        {"fbrdf:scales", raw(NAN), "a scale that is negative or not finite"},
        {"fbrdf:lobes", "}", "not JSON"},
        {"fbrdf:lobes", R"({"axes":"tiltes)", "'tilted' or 'bent'"},
        {"fbrdf:lobes", R"({"axes":"tilted","lobes":3)", "numbers of knots, not 52"},
        {"fbrdf:lobes", R"({"axes":"tilted","lobes":0)", "expected 1 to 7"},
        {"fbrdf:lobes", R"({"axes":"tilted","lobes":2,"thetas":5)", "65 numbers of knots, not 52"},
        {"fbrdf:lobe_knots", raw(-1.0f), "knot 0 of the lobes out of range"},
        {"fbrdf:lobe_knots", raw(NAN), "knot 0 of the lobes out of range"},
        {"fbrdf:storage", "log9", "found 'log9', expected log8, half, float, linear8 or signed"},
        {"fbrdf:lower", raw(NAN), "found a range that is not finite"},
        {"fbrdf:stride", raw(0), "found stride 0, expected 1 to 65535"},
        {"fbrdf:stride", raw(1 << 30), "found stride 1073741824"},
        {"fbrdf:offset", raw(INT32_MIN), "expected a product within 131070"},
        {"fbrdf:start", raw(-1), "found start -1"},
        {"fbrdf:start", raw(65535), "leads out of the range"},
        {"dataWindow", raw(huge), "found a wrong chunkCount, expected 256"},
        {"dataWindow", raw(broad), "for 393216 bytes of texels"},
        {"dataWindow", raw(endless), "expected 1 to 2^24"},
        {"dataWindow", raw(negative), "expected 1 to 2^24"},
        {"dataWindow", raw(wide), "found 16 x 8 texels, expected 8 x 8"},
        {"displayWindow", raw(1 << 31), "found a window beyond 2^30"},
        {"chunkCount", raw(1 << 30), "found a wrong chunkCount, expected 1"},
        {"compression", "\x04", "found compression 4"},
        {"lineOrder", "\x02", "found an unknown line order"},
        {"type", "tiledimage123", "found a part of type 'tiledimage123'"},
        {"channels", "X", "found channels 'X"},
    };
    for (const Patch& patch : patches) {
        SCOPED_TRACE(patch.attribute);
        std::string damaged = patched(bytes, patch.attribute, patch.value);
        test::putFile(path, damaged);
        expectError(ErrorKind::input, patch.says, [&] { readMaterial(path); });
    }
}

TEST(HostileExr, RefusalsTakeNoMemory)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    const std::string bytes = bytesOf(test::testMaterial(formPqp(8, 0.5), Storage::float32));
    const int huge[4] = {0, 0, 4095, 4095};
    test::putFile(path, patched(patched(bytes, "dataWindow", raw(huge)), "chunkCount", raw(256)));
    const long before = peakMemoryKiB();
    EXPECT_THROW(readMaterial(path), Error);
    EXPECT_LT(peakMemoryKiB() - before, kMemoryKiB);
}

/// A whole EXR file with whatever a test wants in it.
struct Parts {
    std::vector<ExrImage> images;

    explicit Parts(const std::string& form, int count, Storage storage = Storage::float32)
    {
        for (int k = 0; k < count; ++k) {
            ExrImage image{"part" + std::to_string(k),  8,  8, 3,
                           storage != Storage::float32, {}, {}};
            image.pixels.assign(8 * 8 * 3, 1.0f);
            image.attributes = {{"fbrdf:storage", std::string(storageName(storage))},
                                {"fbrdf:lower", std::vector<float>{0, 0, 0}},
                                {"fbrdf:upper", std::vector<float>{1, 1, 1}}};
            images.push_back(image);
        }
        auto& first = images[0].attributes;
        first.insert(first.end(), {{"fbrdf:version", 1},
                                   {"fbrdf:form", form},
                                   {"fbrdf:units", std::string("1/sr")},
                                   {"fbrdf:colorspace", std::string("lin_rec709")},
                                   {"fbrdf:name", std::string("built")},
                                   {"fbrdf:scales", std::vector<float>{1, 1, 1}}});
    }

    void remove(size_t part, const std::string& name)
    {
        auto& values = images[part].attributes;
        for (size_t i = values.size(); i-- > 0;)
            if (values[i].first == name) values.erase(values.begin() + static_cast<long>(i));
    }
    void replace(size_t part, const std::string& name, const ExrValue& value)
    {
        remove(part, name);
        images[part].attributes.emplace_back(name, value);
    }
    void write(const std::string& path) const { test::putFile(path, encodeExr(images, path)); }
};

constexpr char kPqp[] =
    R"({"name":"pqp","tables":[{"name":"p","domain":{"disc":{"size":8,"gamma":1,"radius":3.5}}},
    {"name":"q","domain":{"disc":{"size":8,"gamma":1,"radius":3.5}}}],
    "terms":[[{"table":0,"argument":"wo"},{"table":1,"argument":"h"},{"table":0,"argument":"wi"}]]})";

TEST(HostileExr, AFileBuiltByHandReads)  // the tester: only what the next tests change is wrong
{
    const TemporaryDir folder;
    Parts(kPqp, 2).write(folder.file("m.fbrdf"));
    const Material material = readMaterial(folder.file("m.fbrdf"));
    EXPECT_EQ(material.name, "built");
    const Vec3d n(0.0, 0.0, 1.0);
    EXPECT_EQ(evaluate<double>(material, n, n).x, 8.0);  // 2^(1 + 1 + 1)
}

TEST(HostileExr, MissingAndMismatchedPartsAreNamed)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    const auto expectRefused = [&](const std::string& says, const Parts& parts) {
        parts.write(path);
        expectError(ErrorKind::input, says, [&] { readMaterial(path); });
    };
    expectRefused("found 1 parts, expected one for each of 2 tables", Parts(kPqp, 1));
    expectRefused("found 3 parts", Parts(kPqp, 3));
    Parts parts(kPqp, 2);
    parts.images[1].width = 4;
    parts.images[1].height = 16;
    expectRefused("part 1 'part1': found 4 x 16 texels, expected 8 x 8", parts);
    parts = Parts(kPqp, 2);
    parts.images[1].pixels[5] = NAN;
    expectRefused("table 'q' with a number that is not finite", parts);
    parts = Parts(kPqp, 2);
    parts.images[0].half = true;
    expectRefused("found float in half channels", parts);
    for (const char* name : {"fbrdf:storage", "fbrdf:lower", "fbrdf:upper", "fbrdf:version",
                             "fbrdf:form", "fbrdf:scales", "fbrdf:name", "fbrdf:units"}) {
        parts = Parts(kPqp, 2);
        parts.remove(0, name);
        expectRefused(std::string("found no ") + name, parts);
    }
    parts = Parts(kPqp, 2);
    parts.replace(0, "fbrdf:scales", std::vector<float>{1, 1, 1, 1, 1, 1});
    expectRefused("found 6 numbers, expected 3", parts);
    parts.replace(0, "fbrdf:scales", std::string("1 1 1"));
    expectRefused("fbrdf:scales: found type string", parts);
}

TEST(HostileExr, CodesMustBeCodes)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    for (const float code : {-1.0f, 256.0f, 0.5f, NAN, INFINITY}) {
        Parts parts(kPqp, 2, Storage::linear8);
        parts.images[1].pixels[7] = code;
        parts.write(path);
        expectError(ErrorKind::input, "texel 2: found code", [&] { readMaterial(path); });
    }
    Parts parts(kPqp, 2, Storage::linear8);
    parts.replace(1, "fbrdf:upper", std::vector<float>{2, 2, 2});
    parts.write(path);
    expectError(ErrorKind::input, "range of linear8, expected 0 to 1", [&] { readMaterial(path); });
}

// 4096 x 1024 equal texels are 16 MiB of floats and some 16 KB of deflated zeros.
TEST(HostileExr, SmallFilesOfHugeTablesAreRefused)
{
    const TemporaryDir folder;
    Parts parts(kPqp, 4);
    for (ExrImage& image : parts.images) {
        image.width = 4096;
        image.height = 1024;
        image.channels = 1;
        image.pixels.assign(4096 * 1024, 0.0f);
    }
    parts.write(folder.file("m.fbrdf"));
    const std::string bytes = test::fileBytes(folder.file("m.fbrdf"));
    EXPECT_LT(bytes.size(), 200000u);
    expectError(ErrorKind::input, "found texels of 67108864 bytes in a file of",
                [&] { materialFromFileBytes(bytes, "scene"); });
}

TEST(HostileExr, FormsOfMegabytesAreRefused)
{
    Parts parts("[" + std::string(1 << 20, ' ') + "]", 2);
    const std::string bytes = encodeExr(parts.images, "x");
    expectError(ErrorKind::input, "found 1048578 bytes, expected at most 2^20",
                [&] { readExrMaterial(bytes, "scene"); });
}

// Chunks in every compression that scanExr lets through, damaged: what OpenEXR decodes of them.
TEST(HostileExr, DamagedChunksOfEachCompressionNeverCrash)
{
    const std::string bytes = bytesOf(test::testMaterial(formPqp(16, 0.5), Storage::float32));
    const size_t pixels = bytes.size() / 2;
    std::mt19937 random(11);
    for (const char compression : {'\0', '\1', '\2', '\3'})
        for (int i = 0; i < 100; ++i) {
            std::string damaged = patched(bytes, "compression", std::string(1, compression));
            for (int k = 0; k < 3; ++k)
                damaged[pixels + random() % (bytes.size() - pixels)] = static_cast<char>(random());
            readsOrRefuses(damaged);
        }
}

}  // namespace
