#include "TexelWeights.h"

#include "Known.h"
#include "solve/LeastSquares.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

// One axis over theta_o alone: texels are easy to count.
Material curveMaterial()
{
    Form form{"curve",
              {{"c", GridDomain{{{11, {AxisMap::From::cosine, 1.0}}}}}},
              {{{{0, std::vector<Angle>{Angle::theta_o}}}}}};
    return test::waveMaterial(form);
}

Sample sampleAt(float cosine, float value)
{
    return {Vec3f(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine), Vec3f(0, 0, 1), Vec3f(value),
            1.0f};
}

void mark(Material& material, const std::vector<Sample>& samples, const DataStatistics& statistics)
{
    const LeastSquares problem(material.form, datasetInMemory(samples), statistics, 1, 2);
    markUnsupported(material, problem.layout(), texelWeights(problem));
}

std::vector<bool> marksOf(const std::vector<Sample>& samples, const DataStatistics& statistics)
{
    Material material = curveMaterial();
    mark(material, samples, statistics);
    return material.tables[0].unsupported;
}

TEST(TexelWeights, TexelsBetweenSamplesAreMarked)
{
    const auto marks = marksOf({sampleAt(0.25f, 1.0f), sampleAt(0.995f, 1.0f)}, {});
    for (int i = 0; i < 11; ++i)  // 0.25: texels 2 and 3; 0.995: 9 by a twentieth, and 10
        EXPECT_EQ(marks[static_cast<size_t>(i)], i != 2 && i != 3 && i != 10) << i;
}

TEST(TexelWeights, ValuesBelowTheFloorSupportNothing)
{
    DataStatistics statistics;
    statistics.floor = Vec3f(0.1f);
    const auto marks = marksOf({sampleAt(0.2f, 1e-4f), sampleAt(0.8f, 1.0f)}, statistics);
    EXPECT_TRUE(marks[2]);
    EXPECT_FALSE(marks[8]);
}

TEST(TexelWeights, DenseDataSupportEverythingThatCanBeRead)
{
    Material material = test::waveMaterial(formPqp(9, 0.5));
    const Source source = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3}), 20000, 2);
    mark(material, source.samples, {});
    for (const Table& table : material.tables) {
        EXPECT_FALSE(table.unsupported[0]) << "a corner is read by nothing";
        EXPECT_FALSE(isReachable(table.domain, 0));
        EXPECT_TRUE(isReachable(table.domain, 4));
    }
    // Directions reach every texel of p; no half vector of theirs reaches the rim of q.
    EXPECT_EQ(material.tables[0].unsupportedCount(), 0u);
    EXPECT_GT(material.tables[1].unsupportedCount(), 0u);
    material.tables[0].unsupported[3] = true;
    EXPECT_EQ(material.tables[0].unsupportedCount(), 1u);
}

}  // namespace
}  // namespace fbrdf
