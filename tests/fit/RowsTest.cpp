#include "solve/Rows.h"

#include "Known.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

constexpr float kFloat = 1e-5f;  // sums of a dozen float weights

TEST(Layout, MirroredTexelsOfASymmetricTableAreOneUnknown)
{
    const Form form = formHdio({8, 4, 6});
    const Layout layout(form);
    EXPECT_EQ(layout.unknowns(), 8 * 4 + 6 * 7 / 2);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            EXPECT_EQ(layout.unknownOf(1, i + 6 * j), layout.unknownOf(1, j + 6 * i))
                << i << " " << j;
}

TEST(Layout, TheLargestTableOfASingleFactorIsBanded)
{
    const Layout hdio(formHdio({8, 4, 6}));
    EXPECT_EQ(hdio.banded(), 8 * 4);
    EXPECT_EQ(hdio.bandwidth(), 2 * 4);  // second differences along theta_h, numbered across it
    const Layout pqp(formPqp(8, 0.5));   // p is looked up twice
    EXPECT_EQ(pqp.banded(), 64);
    EXPECT_LT(pqp.unknownOf(1, 63), 64);
    EXPECT_GE(pqp.unknownOf(0, 0), 64);
    const Axis axis{5, {}};
    const Layout symmetric(Form{"",
                                {{"T", GridDomain{{axis, axis}, true}}},
                                {{{{0, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}}}}});
    EXPECT_EQ(symmetric.banded(), 0);
}

TEST(Layout, WhatSamplesAndSmoothnessCoupleLiesWithinTheBand)
{
    const Axis h{7, {}}, d{5, {}}, phi{4, {}};
    const Form forms[] = {
        formHdio({9, 4, 5}), formPqpr(8, 0.5, 6),
        Form{"volume",
             {{"V", GridDomain{{h, d, phi}}}},
             {{{{0, std::vector<Angle>{Angle::theta_h, Angle::theta_d, Angle::phi_d}}}}}}};
    for (const Form& form : forms) {
        const Layout layout(form);
        int widest = 0;
        const auto look = [&](const int* unknown, int count) {
            for (int a = 0; a < count; ++a)
                for (int b = 0; b < count; ++b)
                    if (unknown[a] < layout.banded() && unknown[b] < layout.banded())
                        widest = std::max(widest, unknown[a] - unknown[b]);
        };
        for (const SmoothnessRow& row : smoothnessRows(form, layout, 0.1))
            look(row.unknown, row.count);
        const RowMaker maker(form, layout);
        std::vector<int> unknown(size_t(maker.width()));
        std::vector<float> weight(unknown.size());
        for (const auto& pair : uniformPairs(2000, 3)) {
            maker.make({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(1.0f), 1.0f}, unknown.data(),
                       weight.data());
            look(unknown.data(), maker.width());
            for (int k = 0; k < maker.width(); ++k)
                EXPECT_EQ(unknown[size_t(k)] < layout.banded(),
                          k >= maker.bandedFirst() && k < maker.bandedLast());
        }
        EXPECT_EQ(widest, layout.bandwidth()) << form.name;
    }
}

TEST(RowMaker, WeightsOfEveryFactorSumToOne)
{
    const Form form = formPqpr(16, 0.5, 12);
    const Layout layout(form);
    const RowMaker maker(form, layout);
    ASSERT_EQ(maker.width(), 4 + 4 + 4 + 2);
    std::vector<int> unknown(14);
    std::vector<float> weight(14);
    for (const auto& pair : uniformPairs(200, 3)) {
        maker.make({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(1.0f), 1.0f}, unknown.data(),
                   weight.data());
        for (const auto& [from, to] : {std::pair(0, 4), {4, 8}, {8, 12}, {12, 14}}) {
            float sum = 0.0f;
            for (int k = from; k < to; ++k) sum += weight[size_t(k)];
            EXPECT_NEAR(sum, 1.0f, kFloat);
        }
    }
}

TEST(RowMaker, ARowTimesTheTexelsIsTheLogOfTheMaterial)
{
    const Material material = test::waveMaterial(formPqp(12, 0.5));
    const Layout layout(material.form);
    const RowMaker maker(material.form, layout);
    std::vector<double> texels(size_t(layout.unknowns()));
    for (size_t t = 0; t < 2; ++t)
        for (int i = 0; i < 144; ++i)
            texels[size_t(layout.unknownOf(t, i))] = double(material.tables[t].texel(i, 0));
    std::vector<int> unknown(size_t(maker.width()));
    std::vector<float> weight(size_t(maker.width()));
    for (const auto& pair : uniformPairs(100, 4)) {
        maker.make({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(1.0f), 1.0f}, unknown.data(),
                   weight.data());
        double sum = std::log2(0.5);  // the scale of the red channel
        for (size_t k = 0; k < unknown.size(); ++k)
            sum += double(weight[k]) * texels[size_t(unknown[k])];
        EXPECT_NEAR(sum, std::log2(evaluate(material, pair.wo, pair.wi).x), 1e-4);
    }
}

TEST(Smoothness, VanishesOnLinearTablesButForTheFirstDifferences)
{
    const Form form = formHdio({8, 4, 5});
    const Layout layout(form);
    const auto slope = [&](int unknown) {
        for (int i = 0; i < 32; ++i)
            if (layout.unknownOf(0, i) == unknown) return 2.0 * (i % 8) - 3.0 * (i / 8);
        return 0.0;
    };
    int seconds = 0;
    for (const SmoothnessRow& row : smoothnessRows(form, layout, 0.0)) {
        if (row.table != 0 || row.count != 3) continue;
        double sum = 0.0;
        for (int k = 0; k < 3; ++k) sum += row.weight[k] * slope(row.unknown[k]);
        EXPECT_NEAR(sum, 0.0, 1e-12);
        ++seconds;
    }
    EXPECT_EQ(seconds, 6 * 4 + 8 * 2);
}

}  // namespace
}  // namespace fbrdf
