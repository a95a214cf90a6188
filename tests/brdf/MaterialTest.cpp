// MaterialTest.cpp - evaluation: closed forms, reciprocity, horizon, float against double; and what
// validate refuses.
#include "brdf/Directions.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/Material.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace fbrdf;

namespace {

// Swapping wo and wi changes only the order in which a few logs of up to 20 are added, which costs
// 20 eps each.
constexpr double kReciprocal = 1e-13;

Material filled(const Form& form, Storage storage, int channels = 3)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> value(-6.0f, 0.0f);
    Material material;
    material.form = form;
    for (const TableSpec& spec : form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.channels = channels;
        table.texels.resize(static_cast<size_t>(texelCount(spec.domain) * channels));
        for (float& texel : table.texels) texel = value(random);
        const auto* grid = std::get_if<GridDomain>(&spec.domain);
        const int n = domainSize(spec.domain)[0];
        if (grid && grid->symmetric)
            for (int i = 0; i < n * n * channels; ++i) {
                const int c = i % channels, x = i / channels % n, y = i / channels / n;
                if (x > y) table.texels[static_cast<size_t>(i)] = table.texel(y + n * x, c);
            }
        material.tables.push_back(quantized(table, storage));
    }
    material.scales.assign(form.terms.size(), Vec3f(0.5f, 1.0f, 3.0f));
    return material;
}

const Form kForms[] = {formPqp(16, 0.5), formPqpr(16, 1.0, 9), formHdio({12, 6, 8})};

TEST(Material, TheFillingOfSymmetricTablesIsSymmetric)  // the tester of the next test
{
    const Table t2 = filled(formHdio({12, 6, 8}), Storage::float32).tables[1];
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) ASSERT_EQ(t2.texel(x + 8 * y, 1), t2.texel(y + 8 * x, 1));
}

TEST(Material, IsReciprocal)
{
    for (const Form& form : kForms) {
        const Material material = filled(form, Storage::float32);
        for (int n = 0; n < test::kPoints; ++n) {
            const auto pair = test::pair(n);
            const Vec3d f = evaluate<double>(material, pair.wo, pair.wi),
                        g = evaluate<double>(material, pair.wi, pair.wo);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(f[c] / g[c], 1.0, kReciprocal) << form.name;
        }
    }
}

TEST(Material, AnUnsymmetricProductIsNotReciprocal)  // the tester of the last test
{
    Material material = filled(formPqp(16, 0.5), Storage::float32);
    material.form.terms[0].factors[2].table = 1;
    const auto pair = test::pair(1);
    EXPECT_GT(std::abs(evaluate<double>(material, pair.wo, pair.wi).x /
                           evaluate<double>(material, pair.wi, pair.wo).x -
                       1.0),
              0.01);
}

TEST(Material, IsZeroBelowTheHorizon)
{
    const Vec3d up = directionFromAngles(0.5, 1.0);
    for (const Form& form : kForms) {
        const Material material = filled(form, Storage::log8);
        EXPECT_GT(evaluate<double>(material, up, up).x, 0.0);
        for (const double z : {0.0, -1e-9, -0.5, std::nan("")}) {
            const Vec3d down(std::sqrt(1.0 - 0.25), 0.0, z);
            for (const Vec3d& wo : {up, down})
                for (const Vec3d& wi : {up, down})
                    if (wo != up || wi != up) {
                        EXPECT_EQ(evaluate<double>(material, wo, wi), Vec3d(0.0));
                        EXPECT_EQ(evaluate<float>(material, Vec3f(wo), Vec3f(wi)), Vec3f(0.0f));
                    }
        }
    }
}

TEST(Material, DirectionsThatAreNoNumbersReadSomeTexel)
{
    const Vec3d up = directionFromAngles(0.5, 1.0), none(std::nan(""), 0.0, 0.5);
    for (const Form& form : kForms) {
        const Material material = filled(form, Storage::log8);
        EXPECT_TRUE(std::isfinite(evaluate<double>(material, none, up).x));
        EXPECT_TRUE(std::isfinite(evaluate<float>(material, Vec3f(up), Vec3f(none)).x));
    }
}

TEST(Material, IsotropicFormsDoNotTurnWithTheSurface)
{
    const Material material = filled(formHdio({12, 6, 8}), Storage::float32);
    const double c = std::cos(1.1), s = std::sin(1.1);
    const auto turned = [&](const Vec3d& v) {
        return Vec3d(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
    };
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const Vec3d f = evaluate<double>(material, pair.wo, pair.wi),
                    g = evaluate<double>(material, turned(pair.wo), turned(pair.wi));
        // theta_h^(1/2) near the normal turns 1e-16 of a sine into 1e-12 of a coordinate.
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(f[k] / g[k], 1.0, 1e-9) << n;
    }
}

TEST(Material, ConstantTablesGiveTheirProduct)
{
    Material material = filled(formPqpr(8, 0.5, 5), Storage::float32);
    const float logs[] = {-1.0f, 2.0f, 0.5f};
    for (size_t k = 0; k < 3; ++k)
        std::fill(material.tables[k].texels.begin(), material.tables[k].texels.end(), logs[k]);
    for (int n = 0; n < 100; ++n) {
        const auto pair = test::pair(n);
        const Vec3d f = evaluate<double>(material, pair.wo, pair.wi);
        const double product = std::exp2(-1.0 + 2.0 - 1.0 + 0.5);  // p q p r
        ASSERT_NEAR(f.x, 0.5 * product, 1e-14);
        ASSERT_NEAR(f.z, 3.0 * product, 1e-14);
    }
}

// log2 F linear in a coordinate is reproduced by linear filtering: a power of (1 - cos theta_h).
TEST(Material, LogLinearTableHasAClosedForm)
{
    const Axis axis{9, {AxisMap::From::oneMinusCosine, 0.5}};
    Material material;
    material.form = {
        "line", {{"T", GridDomain{{axis}}}}, {{{{0, std::vector<Angle>{Angle::theta_h}}}}}};
    Table table;
    table.domain = material.form.tables[0].domain;
    table.channels = 1;
    for (int i = 0; i < 9; ++i) table.texels.push_back(static_cast<float>(1 - 2 * i));
    material.tables = {table};
    material.scales = {Vec3f(1.0f)};
    for (int n = 0; n < test::kPoints; ++n) {
        const auto pair = test::pair(n);
        const double theta_h = halfDifferenceFromPair(pair).theta_h;
        const double u = std::sqrt(1.0 - std::cos(theta_h));
        const double expected = std::exp2(1.0 - 16.0 * u);
        ASSERT_NEAR(evaluate<double>(material, pair.wo, pair.wi).y / expected, 1.0, 1e-7) << n;
    }
}

TEST(Material, TermsAddUp)
{
    Material sum = filled(formPqp(8, 0.5), Storage::half);
    const Material one = sum;
    sum.form.terms.push_back({{{1, Direction::h}}});
    sum.scales.emplace_back(2.0f);
    Material other = sum;
    other.form.terms.erase(other.form.terms.begin());
    other.scales.erase(other.scales.begin());
    for (int n = 0; n < 200; ++n) {
        const auto pair = test::pair(n);
        const Vec3d a = evaluate<double>(one, pair.wo, pair.wi),
                    b = evaluate<double>(other, pair.wo, pair.wi),
                    f = evaluate<double>(sum, pair.wo, pair.wi);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(f[c], a[c] + b[c], 1e-14);
    }
}

TEST(Material, LinearAndLogTablesMultiply)
{
    Material material = filled(formPqp(8, 0.5), Storage::float32);
    material.tables[1] = quantized(material.tables[1], Storage::linear8);
    const Vec3d n(0.0, 0.0, 1.0);
    const Vec3d centre(3.5, 3.5, 0.0);
    const double p = sample(material.tables[0], centre).x, q = sample(material.tables[1], centre).x;
    EXPECT_NEAR(evaluate<double>(material, n, n).x, 0.5 * q * std::exp2(2.0 * p), 1e-12);
}

TEST(Material, OneChannelIsGreyButForItsScale)
{
    for (const Form& form : kForms) {
        const Material material = filled(form, Storage::float32, 1);
        for (int n = 0; n < 100; ++n) {
            const auto pair = test::pair(n);
            const Vec3d f = evaluate<double>(material, pair.wo, pair.wi);
            ASSERT_NEAR(f.y, 2.0 * f.x, 1e-12 * f.y);
            ASSERT_NEAR(f.z, 3.0 * f.y, 1e-12 * f.z);
        }
    }
}

// Noise between texels is the worst case: a gradient of up to 6 octaves per texel, times an error
// of float positions of 1e-5 texels where the warp is steep, plus the rounding of sums of logs of
// up to 18.
TEST(Material, FloatAgreesWithDouble)
{
    constexpr double kFloat = 5e-4;
    for (const Form& form : kForms) {
        const Material material = filled(form, Storage::log8);
        double most = 0.0;
        for (int n = 0; n < test::kPoints; ++n) {
            const auto pair = test::pair(n, 0.02);
            const Vec3d f = evaluate<double>(material, pair.wo, pair.wi);
            const Vec3f g = evaluate<float>(material, Vec3f(pair.wo), Vec3f(pair.wi));
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(double(g[c]) / f[c] - 1.0));
        }
        EXPECT_LT(most, kFloat) << form.name;
    }
}

TEST(Material, BytesAreThoseOfAllTables)
{
    EXPECT_EQ(materialBytes(filled(formPqpr(16, 1.0, 9), Storage::log8)), 3u * (256 + 256 + 9));
    EXPECT_EQ(materialBytes(filled(formHdio({12, 6, 8}), Storage::half, 1)), 2u * (72 + 64));
}

struct Fault {
    const char* words;
    std::function<void(Material&)> make;
};

TEST(Material, RefusesWhatDoesNotFit)
{
    const Fault faults[] = {
        {"a term without factors", [](Material& m) { m.form.terms[0].factors.clear(); }},
        {"1 tables, expected the form's 2", [](Material& m) { m.tables.pop_back(); }},
        {"2 scales, expected one for each of 1", [](Material& m) { m.scales.emplace_back(1.0f); }},
        {"a scale", [](Material& m) { m.scales[0].y = -1.0f; }},
        {"a scale", [](Material& m) { m.scales[0].z = NAN; }},
        {"table 'q' of 2 channels", [](Material& m) { m.tables[1].channels = 2; }},
        {"table 'q' of 191 numbers, expected 192",
         [](Material& m) { m.tables[1].texels.pop_back(); }},
        {"found table 'p' with a number", [](Material& m) { m.tables[0].texels[5] = INFINITY; }},
        {"found table 'p' with a range", [](Material& m) { m.tables[0].lower.x = NAN; }},
        {"over another domain",
         [](Material& m) {
             m.tables[0].domain = DiscDomain{8, 0.25, 3.5};
         }},
        {"over another domain", [](Material& m) {
             m.tables[0].domain = GridDomain{{Axis{8, {}}, Axis{8, {}}}};
         }}};
    EXPECT_NO_THROW(validate(filled(formPqp(8, 0.5), Storage::log8), "here"));
    for (const Fault& fault : faults) {
        Material material = filled(formPqp(8, 0.5), Storage::log8);
        fault.make(material);
        try {
            validate(material, "here");
            ADD_FAILURE() << "accepted; expected an error with the words: " << fault.words;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_NE(std::string(error.what()).find(fault.words), std::string::npos)
                << error.what() << "\n  " << fault.words;
        }
    }
}

TEST(Material, TheDiffuseAlbedoOfALambertianIsItsOwn)
{
    constexpr float kPiF = static_cast<float>(kPi);
    Material material = filled(formPqp(8, 0.5), Storage::half);
    for (Table& table : material.tables) std::fill(table.texels.begin(), table.texels.end(), 0.0f);
    material.scales = {Vec3f(0.25f, 0.5f, 2.0f) / kPiF};
    const Vec3f albedo = diffuseAlbedo(material);
    EXPECT_NEAR(albedo.x, 0.25f, 1e-5f);
    EXPECT_NEAR(albedo.y, 0.5f, 1e-5f);
    EXPECT_EQ(albedo.z, 1.0f) << "more than all light";
}

}  // namespace
