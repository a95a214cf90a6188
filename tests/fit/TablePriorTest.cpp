#include <fbrdf/fit/LearnPrior.h>

#include "forms/NamedForms.h"
#include "Known.h"
#include "solve/Rows.h"

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// A prior of few numbers, as waves.
TablePrior wavePrior()
{
    TablePrior prior{formHdio({8, 4, 4}), {}, {}};
    const auto count = static_cast<size_t>(Layout(prior.form).unknowns());
    for (size_t i = 0; i < count; ++i)
        prior.mean.push_back(-2.0f + std::sin(0.3f * static_cast<float>(i)));
    for (const float k : {0.1f, 0.5f, 0.9f}) {
        std::vector<float>& mode = prior.modes.emplace_back();
        for (size_t i = 0; i < count; ++i) mode.push_back(k * std::cos(k * static_cast<float>(i)));
    }
    return prior;
}

float largest(const std::vector<float>& values)
{
    float most = 0.0f;
    for (const float v : values) most = std::max(most, std::abs(v));
    return most;
}

TEST(TablePrior, BytesKeepTheMeanIn16BitsAndModesIn8)
{
    const TablePrior prior = wavePrior();
    const std::string bytes = tablePriorBytes(prior);
    EXPECT_EQ(bytes.size(),
              std::string("fbrdf-prior 1 hdio 8 4 4 3\n").size() + 8 + 42 * 2 + 3 * (4 + 42));
    const TablePrior read = tablePriorFromBytes(bytes, "p");
    ASSERT_EQ(read.mean.size(), prior.mean.size());
    ASSERT_EQ(read.modes.size(), prior.modes.size());
    EXPECT_EQ(describe(read.form), describe(prior.form));
    for (size_t i = 0; i < prior.mean.size(); ++i)
        EXPECT_NEAR(read.mean[i], prior.mean[i], 2.0f / 65535.0f);
    for (size_t k = 0; k < prior.modes.size(); ++k)
        for (size_t i = 0; i < prior.mean.size(); ++i)
            EXPECT_NEAR(read.modes[k][i], prior.modes[k][i],
                        0.51f * largest(prior.modes[k]) / 127.0f);
    EXPECT_EQ(tablePriorBytes(read), bytes);
}

TEST(TablePrior, EveryPrefixIsRefused)
{
    const std::string bytes = tablePriorBytes(wavePrior());
    for (size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(tablePriorFromBytes(bytes.substr(0, size), "p"), Error) << size;
    EXPECT_THROW(tablePriorFromBytes(bytes + '\0', "p"), Error);
}

TEST(TablePrior, HostileSizesAreRefusedWithoutMemory)
{
    for (const char* line :
         {"fbrdf-prior 1 hdio 8 4 4 99999999\n", "fbrdf-prior 1 hdio 999999 4 4 1\n",
          "fbrdf-prior 1 hdio -8 4 4 1\n", "fbrdf-prior 1 hdio 8 4 4\n",
          "fbrdf-prior 1 hdio 8 4 4 3 1\n", "fbrdf-prior 2 hdio 8 4 4 3\n",
          "fbrdf-prior 1 hdio 256 256 256 1024\n"})
        EXPECT_THROW(tablePriorFromBytes(line, "p"), Error) << line;
}

TEST(TablePrior, NumbersThatAreNotFiniteAreRefused)
{
    std::string bytes = tablePriorBytes(wavePrior());
    const size_t step = bytes.find('\n') + 1 + 4;
    bytes[step + 2] = static_cast<char>(0x80);  // an infinity, little-endian
    bytes[step + 3] = 0x7f;
    bytes[step] = bytes[step + 1] = 0;
    EXPECT_THROW(tablePriorFromBytes(bytes, "p"), Error);
}

TEST(TablePrior, TheShippedOneHas32ModesOfHdio)
{
    const TablePrior prior = shippedTablePrior();
    EXPECT_EQ(describe(prior.form), describe(makeForm("hdio")));
    ASSERT_EQ(prior.modes.size(), 32u);
    // Each as long as its standard deviation: the first is the longest but for what is not seen.
    EXPECT_GT(largest(prior.modes[0]), largest(prior.modes[31]));
    EXPECT_LE(tablePriorBytes(prior).size(), 40000u);
}

// Tables that differ from a mean in one way have one mode: that way, as long as its standard
// deviation.
TEST(LearnPrior, FindsTheWayInWhichTablesDiffer)
{
    KnownMaterials known;
    known.form = formHdio({8, 4, 4});
    const auto n = static_cast<size_t>(Layout(known.form).unknowns());
    std::vector<double> way(n);
    for (size_t i = 0; i < n; ++i) way[i] = std::sin(static_cast<double>(i));
    for (const double a : {-1.0, 1.0, -1.0, 1.0, 0.0, 0.0}) {
        std::vector<double>& table = known.tables.emplace_back(n, 3.0);
        for (size_t i = 0; i < n; ++i) table[i] += a * way[i];
    }
    known.seen.assign(n * n, 0.0);
    for (size_t i = 0; i < n; ++i) known.seen[i * n + i] = 1.0 / static_cast<double>(n);
    known.sampled = known.seen;
    const TablePrior prior = learnTablePrior(known, 2);
    ASSERT_EQ(prior.modes.size(), 2u);
    EXPECT_NEAR(largest(prior.modes[0]), std::sqrt(4.0 / 6.0), 1e-2);
    EXPECT_NEAR(largest(prior.modes[1]), 0.0, 1e-6);
    for (const float m : prior.mean) EXPECT_NEAR(m, 3.0f, 1e-6f);
    EXPECT_THROW(learnTablePrior(known, 0), Error);
    EXPECT_THROW(learnTablePrior(known, 7), Error);
}

TEST(LearnPrior, FitsTablesToFunctions)
{
    const std::vector<Source> sources{test::sourceOf(test::Ggx{0.3, 0.3, 0.04, 0.3}),
                                      test::sourceOf(test::Ggx{0.2, 0.2, 0.9, 0.0})};
    const KnownMaterials known = knownMaterials(sources, 0);
    ASSERT_EQ(known.tables.size(), 6u);
    EXPECT_EQ(known.tables[0], known.tables[2]);  // grey
    EXPECT_NE(known.tables[0], known.tables[3]);
    EXPECT_THROW(knownMaterials({}, 0), Error);
    Source samples = sources[0];
    samples.evaluate = nullptr;
    EXPECT_THROW(knownMaterials({samples}, 0), Error);
}

}  // namespace
}  // namespace fbrdf
