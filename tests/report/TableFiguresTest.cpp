#include "SphereFigures.h"
#include "TableFigures.h"
#include "TestMaterials.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

Table gridTable(Storage storage)
{
    Table table;
    table.name = "T";
    table.domain = GridDomain{{Axis{4, {}}, Axis{2, {}}}, false};
    table.storage = storage;
    for (int i = 0; i < 8; ++i) table.texels.insert(table.texels.end(), 3, static_cast<float>(i));
    return table;
}

TEST(TablePicture, SpansItsStatedRange)
{
    const Table table = gridTable(Storage::float32);
    const ShownRange range = shownRange(table);
    EXPECT_EQ(range.low, 0.0);
    EXPECT_EQ(range.high, 7.0);
    const Picture picture = pictureOf(table, range);
    ASSERT_EQ(picture.width, 4);
    ASSERT_EQ(picture.height, 2);
    EXPECT_EQ(picture.rgba[0], 0);                  // first texel: black
    EXPECT_EQ(picture.rgba[(1 * 4 + 3) * 4], 255);  // last one: white
    EXPECT_EQ(picture.rgba[1 * 4], 36);             // 255 / 7, x is the fast axis
}

TEST(TablePicture, LinearTablesAreSrgbEncoded)
{
    Table table = gridTable(Storage::linear8);
    for (float& texel : table.texels) texel = 0.2158605f;
    EXPECT_EQ(shownRange(table).high, 1.0);
    EXPECT_EQ(pictureOf(table, shownRange(table)).rgba[0], 128);
}

TEST(TablePicture, SignedTablesHaveZeroInTheMiddle)
{
    Table table;
    table.domain = GridDomain{{{3, {}}, {1, {}}}};
    table.storage = Storage::signedHalf;
    table.channels = 1;
    table.texels = {-2.0f, 0.0f, 1.0f};
    const ShownRange range = shownRange(table);
    EXPECT_EQ(range.low, -2.0);
    EXPECT_EQ(range.high, 2.0);
    EXPECT_EQ(pictureOf(table, range).rgba[0], 0);
    EXPECT_EQ(pictureOf(table, range).rgba[4], 128);
    EXPECT_EQ(pictureOf(table, range).rgba[8], 191);
}

TEST(TablePicture, AConstantTableIsMidGrey)
{
    Table table = gridTable(Storage::half);
    for (float& texel : table.texels) texel = -3.0f;
    EXPECT_EQ(pictureOf(table, shownRange(table)).rgba[0], 128);
}

TEST(TablePicture, CornersOfADiscAreTransparentAndDoNotCount)
{
    Table table;
    table.name = "p";
    table.domain = DiscDomain::fitting(16, 0.5);
    table.texels.assign(16 * 16 * 3, 1.0f);
    table.texels[0] = 1000.0f;  // a corner that nothing reads
    EXPECT_EQ(shownRange(table).high, 1.0);
    const Picture picture = pictureOf(table, shownRange(table));
    EXPECT_EQ(picture.rgba[3], 0);
    EXPECT_EQ(picture.rgba[(8 * 16 + 8) * 4 + 3], 255);
}

TEST(TableFigures, ShowEveryTableOfAForm)
{
    const std::string figures =
        tableFigures(test::constantMaterial(Vec3f(1.0f), formPqpr(8, 0.5, 16)));
    for (const char* name : {"<b>p</b>", "<b>q</b>", "<b>r</b>"})
        EXPECT_NE(figures.find(name), std::string::npos) << name;
    EXPECT_NE(figures.find("class=\"ring\""), std::string::npos);
}

SphereImage constantSphere(float value)
{
    SphereImage image;
    image.size = 4;
    image.radiance.assign(16, Vec3f(value));
    image.covered.assign(16, true);
    image.covered[0] = false;
    return image;
}

TEST(SpherePicture, IsSrgbWithTransparentBackground)
{
    const Picture picture = pictureOf(constantSphere(0.2158605f));
    EXPECT_EQ(picture.rgba[3], 0);
    EXPECT_EQ(picture.rgba[4], 128);
    EXPECT_EQ(picture.rgba[7], 255);
}

TEST(SphereDifference, IsGreyWhereEqualAndBrighterWhereTheFitIs)
{
    const SphereImage data = constantSphere(0.4f), fit = constantSphere(0.42f);
    EXPECT_EQ(differencePicture(data, data, 10.0).rgba[4], 128);
    EXPECT_NEAR(differencePicture(fit, data, 10.0).rgba[4], 255.0 * 0.7, 1.0);
    EXPECT_NEAR(differencePicture(data, fit, 10.0).rgba[4], 255.0 * 0.3, 1.0);
}

TEST(SphereDifference, IsAmplifiedAsFarAsItFits)
{
    EXPECT_EQ(amplificationFor(constantSphere(0.42f), constantSphere(0.4f)), 20.0);
    EXPECT_EQ(amplificationFor(constantSphere(1.0f), constantSphere(0.0f)), 1.0);
    EXPECT_EQ(amplificationFor(constantSphere(0.5f), constantSphere(0.5f)), 1000.0);
}

TEST(SphereFigures, WithoutDataShowTheFitAlone)
{
    const std::string figures = sphereFigures({}, constantSphere(0.5f), nullptr);
    EXPECT_NE(figures.find("sphere, fit"), std::string::npos);
    EXPECT_EQ(figures.find("ifference"), std::string::npos);
}

}  // namespace
}  // namespace fbrdf
