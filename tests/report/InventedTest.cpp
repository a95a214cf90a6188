// InventedTest.cpp - shares that follow from marks in closed form, and when a page has a picture of
// them.
#include "Invented.h"
#include "TestMaterials.h"

#include <fbrdf/report/Report.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

const Vec3d kWo = glm::normalize(Vec3d(0.3, 0.1, 0.8)), kWi = glm::normalize(Vec3d(-0.2, 0.4, 0.6));

Material markedMaterial(bool mark)
{
    Material material = test::constantMaterial(Vec3f(0.2f));
    for (Table& table : material.tables)
        table.unsupported.assign(static_cast<size_t>(texelCount(table.domain)), mark);
    return material;
}

TEST(Invented, IsNothingWhereEverythingIsSupportedOrSupportIsUnknown)
{
    for (const Material& material : {test::constantMaterial(Vec3f(0.2f)), markedMaterial(false)}) {
        EXPECT_FALSE(hasInvented(material));
        EXPECT_EQ(inventedShare(material, kWo, kWi), 0.0);
        EXPECT_EQ(inventedSphere(material, 16).total, 0.0);
    }
}

TEST(Invented, IsEverythingWhereNothingIsSupported)
{
    const Material material = markedMaterial(true);
    EXPECT_TRUE(hasInvented(material));
    EXPECT_DOUBLE_EQ(inventedShare(material, kWo, kWi), 1.0);
    const InventedSphere sphere = inventedSphere(material, 16);
    EXPECT_NEAR(sphere.total, 1.0, 1e-6);
    EXPECT_NEAR(sphere.shares[8 * 16 + 8], 1.0, 1e-6) << "the centre";
    EXPECT_EQ(sphere.shares[0], 0.0) << "outside the disc";
}

TEST(Invented, IsTheWeightOfMarkedTexelsInOneLookUp)
{
    Material material = markedMaterial(false);
    Table& table = material.tables[0];
    const Factor& factor = material.form.terms[0].factors[0];
    const PairGeometry<double> geometry(DirectionPair<double>{kWo, kWi});
    const auto stencil =
        stencilAt(table.domain, texelPosition(table.domain, factor.argument, geometry));
    ASSERT_GT(stencil.count, 1);
    table.unsupported[static_cast<size_t>(stencil.texel[0])] = true;
    EXPECT_DOUBLE_EQ(inventedShare(material, kWo, kWi), stencil.weight[0]);
}

TEST(Invented, OfTwoTermsIsTheMeanByWhatTheyAdd)
{
    Material material = markedMaterial(false);
    material.form.terms.push_back(material.form.terms[0]);
    material.form.tables.push_back(material.form.tables[0]);
    material.tables.push_back(material.tables[0]);
    material.form.terms[1].factors[0].table = 2;
    material.scales = {Vec3f(0.3f), Vec3f(0.1f)};
    material.tables[2].unsupported.assign(material.tables[2].unsupported.size(), true);
    EXPECT_NEAR(inventedShare(material, kWo, kWi), 0.25, 1e-6);
    material.scales = {Vec3f(0.0f), Vec3f(0.0f)};
    EXPECT_EQ(inventedShare(material, kWo, kWi), 0.0) << "of nothing";
}

TEST(Invented, HasAPictureOnThePageWhereItIsSeen)
{
    const Source source = test::scatteredSource(0.2f);
    const auto page = [&](const Material& material) {
        ReportInput input{material, source};
        input.sphereOfFit =
            renderStandardSphere([](const Vec3d&, const Vec3d&) { return Vec3d(0.2); }, 32);
        return reportHtml(input);
    };
    EXPECT_EQ(page(markedMaterial(false)).find("Invented"), std::string::npos);
    EXPECT_NE(page(markedMaterial(true)).find("100 % of all light"), std::string::npos);
}

}  // namespace
}  // namespace fbrdf
