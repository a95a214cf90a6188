#include "Quantize.h"

#include "Known.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

State stateOf(const Material& material, const Layout& layout)
{
    const auto n = size_t(layout.unknowns());
    State x(3 * n);
    for (size_t t = 0; t < material.tables.size(); ++t)
        for (int i = 0; i < texelCount(material.tables[t].domain); ++i)
            for (size_t c = 0; c < 3; ++c)
                x[c * n + size_t(layout.unknownOf(t, i))] =
                    double(material.tables[t].texel(i, int(c)));
    return x;
}

TEST(Quantize, TheGaugeMovesConstantsIntoTheScaleAndKeepsTheValue)
{
    const Material wave = test::waveMaterial(formHdio({12, 6, 6}));
    const Layout layout(wave.form);
    const Material stored = quantize(wave.form, layout, stateOf(wave, layout), Storage::float32);
    for (const Table& table : stored.tables) {
        double mean = 0.0;
        for (int i = 0; i < texelCount(table.domain); ++i) mean += double(table.texel(i, 1));
        EXPECT_NEAR(mean / texelCount(table.domain), 0.0, 1e-6) << table.name;
    }
    for (const auto& pair : uniformPairs(200, 2)) {
        const Vec3d expected = evaluate(wave, pair.wo, pair.wi) / Vec3d(wave.scales[0]);
        const Vec3d found = evaluate(stored, pair.wo, pair.wi);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / expected[c], 1.0, 1e-5);
    }
}

TEST(Quantize, LinearMapsFillZeroToOne)
{
    const Material wave = test::waveMaterial(formPqp(16, 1.0));
    const Layout layout(wave.form);
    const Material stored = quantize(wave.form, layout, stateOf(wave, layout), Storage::linear8);
    for (const Table& table : stored.tables) {
        float largest = 0.0f;
        for (int i = 0; i < texelCount(table.domain); ++i)
            largest = std::max(largest, table.texel(i, 0));
        EXPECT_EQ(largest, 1.0f) << table.name;
    }
    for (const auto& pair : uniformPairs(200, 2)) {
        const Vec3d expected = evaluate(wave, pair.wo, pair.wi) / Vec3d(wave.scales[0]);
        const Vec3d found = evaluate(stored, pair.wo, pair.wi);
        // Three 8-bit factors that stay above 1/8: half a code of each.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / expected[c], 1.0, 3 * 8 * 0.5 / 255);
    }
}

TEST(Quantize, TexelsThatNoPositionReachesDoNotWidenTheRange)
{
    const Form form = formPqp(16, 0.5);
    const Layout layout(form);
    State x(3 * size_t(layout.unknowns()), 0.0);
    const auto n = size_t(layout.unknowns());
    for (size_t c = 0; c < 3; ++c) {
        x[c * n + size_t(layout.unknownOf(1, 0))] = 1000.0;  // a corner, far outside the disc
        x[c * n + size_t(layout.unknownOf(1, 8 + 16 * 8))] = 2.0;
    }
    const Material stored = quantize(form, layout, x, Storage::log8);
    EXPECT_LT(stored.tables[1].upper.x, 3.0f);
    EXPECT_NEAR(stored.tables[1].upper.x - stored.tables[1].lower.x, 2.0f,
                0.02f);  // and its margin
}

TEST(Quantize, EightBitsOfDifferencesStayNearTheFloatTable)
{
    const Material wave = test::waveMaterial(formHdio({48, 12, 12}));
    const Layout layout(wave.form);
    const State x = stateOf(wave, layout);
    const Material exact = quantize(wave.form, layout, x, Storage::float32);
    const Material stored = quantize(wave.form, layout, x, Storage::log8);
    for (size_t t = 0; t < 2; ++t) {
        const Table& table = stored.tables[t];
        for (int c = 0; c < 3; ++c) {
            const float step =
                float(table.log8.stride[size_t(c)]) / 65535.0f * (table.upper[c] - table.lower[c]);
            for (int i = 0; i < texelCount(table.domain); ++i)
                EXPECT_NEAR(table.texel(i, c), exact.tables[t].texel(i, c), 0.51f * step + 2e-5f);
            EXPECT_LT(step, 0.5f * (table.upper[c] - table.lower[c]) / 255.0f)
                << "no finer than absolute codes";
        }
    }
}

}  // namespace
}  // namespace fbrdf
