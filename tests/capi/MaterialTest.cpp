// Materials of the C ABI: from numbers, from files, and what is refused; no GL.
#include "Materials.h"

#include <fbrdf/brdf/Half.h>
#include <fbrdf/io/MaterialFile.h>

#include <gtest/gtest.h>

#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

namespace fbrdf::test {
namespace {

struct Log {
    std::string text;
    fbrdf_log log{[](void* user, fbrdf_severity, fbrdf_result, const char* line) {
                      static_cast<Log*>(user)->text = line;
                  },
                  this};
};

Material pqp()
{
    return constantMaterial(formPqp(3, 0.5), -1.0f);
}

TEST(CApiMaterial, EvaluatesWhatItWasGiven)
{
    Log log;
    abi::Material material;
    ASSERT_EQ(GivenMaterial(pqp()).create(log.log, material), FBRDF_RESULT_OK) << log.text;
    const float up[3] = {0.0f, 0.0f, 1.0f}, below[3] = {0.0f, 0.6f, -0.8f};
    float rgb[3] = {};
    ASSERT_EQ(fbrdf_material_evaluate(material.get(), up, up, rgb), FBRDF_RESULT_OK);
    for (const float channel : rgb) EXPECT_NEAR(channel, 0.125f, 1e-6f);  // p q p, each 1/2
    ASSERT_EQ(fbrdf_material_evaluate(material.get(), up, below, rgb), FBRDF_RESULT_OK);
    for (const float channel : rgb) EXPECT_EQ(channel, 0.0f);
    EXPECT_EQ(fbrdf_material_evaluate(nullptr, up, up, rgb), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_material_evaluate(material.get(), up, nullptr, rgb),
              FBRDF_RESULT_ERROR_ARGUMENT);
}

/// Fails where the two differ in a bit in any of a hundred pairs of directions.
void expectTheSame(const fbrdf_material* material, const Material& expected)
{
    for (int i = 0; i < 100; ++i) {
        const float a = 0.37f * static_cast<float>(i), b = 0.61f * static_cast<float>(i);
        const float tilt = 0.015f * static_cast<float>(i);
        const Vec3f wo(std::sin(tilt) * std::cos(a), std::sin(tilt) * std::sin(a), std::cos(tilt));
        const Vec3f wi(std::sin(1.5f - tilt) * std::cos(b), std::sin(1.5f - tilt) * std::sin(b),
                       std::cos(1.5f - tilt));
        const Vec3f f = evaluate<float>(expected, wo, wi);
        float rgb[3] = {};
        ASSERT_EQ(fbrdf_material_evaluate(material, &wo.x, &wi.x, rgb), FBRDF_RESULT_OK);
        ASSERT_EQ(Vec3f(rgb[0], rgb[1], rgb[2]), f) << expected.name << " pair " << i;
    }
}

TEST(CApiMaterial, EveryFormThatAFileHoldsIsMadeFromMemory)
{
    Material everything = everythingMaterial();
    for (Table& table : everything.tables) table = quantized(table, Storage::float32);
    for (const Material& expected :
         {everything, noiseMaterial(formPqp(8, 0.5), Storage::float32),
          noiseMaterial(formPqpr(8, 0.7, 6), Storage::float32),
          noiseMaterial(sumOf(formIo(), formHdio({8, 6, 4})), Storage::float32)}) {
        Log log;
        abi::Material material;
        ASSERT_EQ(GivenMaterial(expected).create(log.log, material), FBRDF_RESULT_OK) << log.text;
        expectTheSame(material.get(), expected);
    }
}

TEST(CApiMaterial, TexelsAreRoundedToTheirStorage)
{
    const Material given = noiseMaterial(formHdio({8, 6, 4}), Storage::float32);
    const auto made = [&](fbrdf_storage storage, const std::function<Table(const Table&)>& round) {
        Log log;
        abi::Material material;
        ASSERT_EQ(GivenMaterial(given, storage).create(log.log, material), FBRDF_RESULT_OK)
            << log.text;
        Material expected = given;
        for (Table& table : expected.tables) table = round(table);
        expectTheSame(material.get(), expected);
    };
    const auto rounded = [](Table table, Storage storage, float (*round)(float)) {
        table.storage = storage;
        std::transform(table.texels.begin(), table.texels.end(), table.texels.begin(), round);
        return table;
    };
    made(FBRDF_STORAGE_HALF, [&](const Table& t) { return quantized(t, Storage::half); });
    made(FBRDF_STORAGE_LOG8, [&](const Table& t) { return quantized(t, Storage::log8); });
    made(FBRDF_STORAGE_LINEAR8, [&](const Table& t) {
        return rounded(t, Storage::linear8, [](float x) {
            return std::round(std::clamp(x, 0.0f, 1.0f) * 255.0f) / 255.0f;
        });
    });
    made(FBRDF_STORAGE_SIGNED, [&](const Table& t) {
        return rounded(t, Storage::signedHalf,
                       [](float x) { return floatFromHalf(halfFromFloat(x)); });
    });
}

TEST(CApiMaterial, RefusesWhatIsWrong)
{
    const auto expectRefused = [&](fbrdf_result expected, const std::string& words,
                                   const std::function<void(GivenMaterial&)>& spoil) {
        GivenMaterial given(pqp());
        spoil(given);
        Log log;
        abi::Material material;
        EXPECT_EQ(given.create(log.log, material), expected) << words;
        EXPECT_FALSE(material);
        EXPECT_NE(log.text.find(words), std::string::npos) << log.text;
    };
    using G = GivenMaterial;
    const auto argument = FBRDF_RESULT_ERROR_ARGUMENT, input = FBRDF_RESULT_ERROR_INPUT;
    expectRefused(input, "form: byte 1", [](G& g) { g.form = "pqp"; });
    expectRefused(input, "expected at least one table",
                  [](G& g) { g.form = R"({"name": "none", "tables": [], "terms": []})"; });
    expectRefused(input, "form: /tables/0/domain/disc/size", [](G& g) {
        const std::string key = "\"size\":";
        g.form.insert(g.form.find(key) + key.size(), "99999999999");
    });
    expectRefused(argument, "found 1 tables, expected 2", [](G& g) { g.tables.pop_back(); });
    expectRefused(argument, "table 'q': found 8 texels, expected 9",
                  [](G& g) { g.tables[1].texel_count = 8; });
    expectRefused(argument, "found 2 channels", [](G& g) { g.tables[0].channels = 2; });
    expectRefused(argument, "storage: found 5", [](G& g) { g.tables[0].storage = 5; });
    expectRefused(argument, "table 'q': found NULL", [](G& g) { g.tables[1].texels = nullptr; });
    expectRefused(FBRDF_RESULT_ERROR_VERSION, "tables[1]: found reserved 3",
                  [](G& g) { g.tables[1].reserved = 3; });
    const float nan = std::numeric_limits<float>::quiet_NaN();
    expectRefused(input, "not finite", [&](G& g) { g.texels[1][5] = nan; });
    expectRefused(input, "scale", [](G& g) { g.scales[1] = -1.0f; });
    expectRefused(input, "scale", [](G& g) { g.scales.resize(6); });
    fbrdf_material_desc desc = GivenMaterial(pqp()).desc();
    desc.form = nullptr;
    Log log;
    abi::Material material;
    EXPECT_EQ(material.create(fbrdf_material_create, &desc, &log.log), argument);
    EXPECT_NE(log.text.find("form: found NULL"), std::string::npos) << log.text;
    EXPECT_EQ(fbrdf_material_create(nullptr, &log.log, nullptr), argument);
}

TEST(CApiMaterial, ReadsFilesAndTheirBytes)
{
    const TemporaryDir folder;
    const std::string path = folder.file("m.fbrdf");
    const Material expected = noiseMaterial(formPqp(8, 0.5), Storage::half);
    writeMaterial(expected, path);
    Log log;
    abi::Material material;
    ASSERT_EQ(material.create(fbrdf_material_read, path.c_str(), &log.log), FBRDF_RESULT_OK);
    expectTheSame(material.get(), expected);
    const std::string bytes = materialFileBytes(expected);
    const auto read = [&](size_t size) {
        return material.create(fbrdf_material_read_bytes, static_cast<const void*>(bytes.data()),
                               size, "archive/m", &log.log);
    };
    ASSERT_EQ(read(bytes.size()), FBRDF_RESULT_OK) << log.text;
    expectTheSame(material.get(), expected);
    EXPECT_EQ(read(bytes.size() / 2), FBRDF_RESULT_ERROR_INPUT);
    EXPECT_NE(log.text.find("archive/m"), std::string::npos) << log.text;
    EXPECT_EQ(material.create(fbrdf_material_read, "no such file", &log.log),
              FBRDF_RESULT_ERROR_INPUT);
    EXPECT_NE(log.text.find("no such file"), std::string::npos) << log.text;
    EXPECT_TRUE(material);  // a handle keeps its object when a call fails
}

}  // namespace
}  // namespace fbrdf::test
