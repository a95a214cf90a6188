// ReciprocityTest.cpp - forms that are reciprocal stay so as stored. No GL.
#include <fbrdf/fit/Fit.h>

#include "Known.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

// log2 texels reach 10 and are added in another order for swapped directions: a few ulps of double.
constexpr double kSame = 1e-12;

double largestDifference(const Material& material)
{
    double largest = 0.0;
    for (const auto& pair : uniformPairs(500, 3)) {
        const Vec3d a = evaluate(material, pair.wo, pair.wi),
                    b = evaluate(material, pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(a[c] - b[c]) / std::max(a[c], b[c]));
    }
    return largest;
}

Material stored(Material material, Storage storage)
{
    for (Table& table : material.tables) table = quantized(table, storage);
    return material;
}

TEST(Reciprocity, IsExactInEveryStorage)
{
    size_t forms = 0;
    for (const NamedForm& named : namedForms()) {
        if (!named.isReciprocal) continue;
        ++forms;
        const Material material = test::waveMaterial(makeForm(named.name));
        for (const Storage storage : {Storage::log8, Storage::half, Storage::float32})
            EXPECT_LT(largestDifference(stored(material, storage)), kSame)
                << named.name << " as " << storageName(storage);
    }
    EXPECT_EQ(forms, 12u);
}

TEST(Reciprocity, IsMissedWhereAFormHasNone)
{
    for (const NamedForm& named : namedForms()) {
        if (named.isReciprocal) continue;
        EXPECT_GT(largestDifference(test::waveMaterial(makeForm(named.name))), 0.01) << named.name;
    }
}

}  // namespace
}  // namespace fbrdf
