#include "ComparisonSet.h"
#include "TestMaterials.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

Sample numbered(size_t i)
{
    return {{0, 0, 1}, {0, 0, 1}, Vec3f(static_cast<float>(i)), 1.0f};
}

Source heldSamples(size_t count)
{
    Source source;
    for (size_t i = 0; i < count; ++i) source.samples.push_back(numbered(i));
    return source;
}

Source streamedSamples(uint64_t count)
{
    Source source;
    source.stream.rows = count;
    source.stream.read = [](uint64_t first, size_t rows, std::vector<Sample>& out, SampleReport&) {
        for (size_t i = 0; i < rows; ++i) out.push_back(numbered(static_cast<size_t>(first) + i));
    };
    return source;
}

TEST(ComparisonSet, HoldsTheSourcesSamplesAndTheFitThere)
{
    const ComparisonSet set =
        comparisonSet(test::scatteredSource(0.5f), test::constantMaterial(Vec3f(0.25f)));
    EXPECT_TRUE(set.measured);
    EXPECT_EQ(set.rows, 34u);
    ASSERT_EQ(set.samples.size(), 34u);
    ASSERT_EQ(set.fitted.size(), 34u);
    for (const Vec3f& g : set.fitted) EXPECT_NEAR(g.x, 0.25f, 1e-6f);
}

TEST(ComparisonSet, AFunctionIsTakenAtTheUniformSet)
{
    const ComparisonSet set =
        comparisonSet(test::lambertianSource(0.5), test::constantMaterial(Vec3f(0.25f)));
    EXPECT_FALSE(set.measured);
    EXPECT_EQ(set.samples.size(), 65536u);
    EXPECT_EQ(set.samples[77].f, Vec3f(0.5f));
}

TEST(ComparisonSet, ThinsEvenly)
{
    for (const Source& source : {heldSamples(10000), streamedSamples(10000)}) {
        const ComparisonSet set = comparisonSet(source, test::constantMaterial(Vec3f(1.0f)), 320);
        EXPECT_EQ(set.rows, 10000u);
        ASSERT_EQ(set.samples.size(), 320u);
        EXPECT_LT(set.samples.front().f.x, 40.0f);
        EXPECT_GT(set.samples.back().f.x, 9960.0f);
        for (size_t i = 1; i < set.samples.size(); ++i)
            EXPECT_GT(set.samples[i].f.x, set.samples[i - 1].f.x);
    }
}

TEST(ComparisonSet, AShortStreamIsTakenWhole)
{
    EXPECT_EQ(
        comparisonSet(streamedSamples(50), test::constantMaterial(Vec3f(1.0f)), 320).samples.size(),
        50u);
}

TEST(ComparisonSet, OfNothingIsEmpty)
{
    EXPECT_TRUE(comparisonSet(Source{}, test::constantMaterial(Vec3f(1.0f))).samples.empty());
}

}  // namespace
}  // namespace fbrdf
