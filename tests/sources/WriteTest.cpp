#include "ReaderTest.h"

#include <fbrdf/sources/OpenSource.h>
#include <fbrdf/sources/Write.h>
#include <SpreadPairs.h>
#include <sys/stat.h>

#include <limits>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

Source functionSource()
{
    Source source;
    source.isotropic = true;
    source.evaluate = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(0.1 + wo.z, 0.2 + wi.z, 3.0 * wo.z * wi.z);
    };
    return source;
}

Source heldSource()
{
    Source source;
    source.samples = {{{0, 0, 1}, {0.6f, 0, 0.8f}, {0.1f, 1e-20f, 123456.7f}},
                      {{0, 0.6f, 0.8f}, {0, 0, 1}, {-1.5f, 0.0f, 1.0f / 3.0f}}};
    return source;
}

size_t filesIn(const std::string& folder)
{
    size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) count += entry.exists();
    return count;
}

int outputKind(const std::function<void()>& write)
{
    try {
        write();
        return 0;
    } catch (const Error& error) {
        return static_cast<int>(error.kind());
    }
}

}  // namespace

TEST(WriteCsv, ReadsBackTheSame)
{
    const TempFolder folder;
    const Source source = heldSource();
    writeCsv(source, folder.path("a.csv"));
    const Source back = openSource(folder.path("a.csv"));
    ASSERT_EQ(back.samples.size(), source.samples.size());
    for (size_t i = 0; i < back.samples.size(); ++i) {
        EXPECT_EQ(back.samples[i].f, source.samples[i].f);
        EXPECT_LT(glm::length(back.samples[i].wi - source.samples[i].wi), 1e-7f);
        EXPECT_EQ(back.samples[i].weight, 1.0f);
    }
}

TEST(WriteCsv, KeepsWeights)
{
    const TempFolder folder;
    Source source = heldSource();
    source.samples[1].weight = 0.25f;
    writeCsv(source, folder.path("a.csv"));
    EXPECT_EQ(openSource(folder.path("a.csv")).samples[1].weight, 0.25f);
}

TEST(WriteCsv, SamplesAFunction)
{
    const TempFolder folder;
    const Source source = functionSource();
    writeCsv(source, folder.path("a.csv"));
    const Source back = openSource(folder.path("a.csv"));
    EXPECT_EQ(back.samples.size(), 65536u);
    EXPECT_EQ(back.report.belowHorizon, 0u);
    for (size_t i = 0; i < back.samples.size(); i += 997) {
        const Sample& s = back.samples[i];
        EXPECT_LT(glm::length(source.evaluate(Vec3d(s.wo), Vec3d(s.wi)) - Vec3d(s.f)), 1e-5);
    }
}

TEST(WriteMerl, ReadsBackWhatItEvaluates)
{
    const TempFolder folder;
    const Source source = functionSource();
    writeMerl(source, folder.path("a.binary"));
    const Source back = openSource(folder.path("a.binary"));
    EXPECT_EQ(back.format, "merl");
    const SampleReport report = reportOf(back);
    EXPECT_EQ(report.invalid, 0u);
    EXPECT_GT(report.belowHorizon, 100000u);
    size_t seen = 0;
    double worst = 0.0;
    forEachBlock(back, [&](const Sample* samples, size_t count) {
        for (size_t i = 0; i < count; i += 101, ++seen) {
            const Vec3d f = source.evaluate(Vec3d(samples[i].wo), Vec3d(samples[i].wi));
            worst = std::max(worst, glm::length(f - Vec3d(samples[i].f)));
        }
    });
    EXPECT_GT(seen, 5000u);
    EXPECT_LT(worst, 1e-6);
}

TEST(WriteMerl, ATableIsCopiedWithItsInvalidCells)
{
    const TempFolder folder;
    Source source = functionSource();
    source.evaluate = [](const Vec3d& wo, const Vec3d&) {
        return wo.x > 0.5 ? Vec3d(std::numeric_limits<double>::quiet_NaN(), 1, 1) : Vec3d(1, 2, 3);
    };
    writeMerl(source, folder.path("a.binary"));
    const Source once = openSource(folder.path("a.binary"));
    writeMerl(once, folder.path("b.binary"));
    const SampleReport a = reportOf(once), b = reportOf(openSource(folder.path("b.binary")));
    EXPECT_GT(a.invalid, 1000u);
    EXPECT_EQ(a.invalid, b.invalid);
    EXPECT_EQ(a.belowHorizon, b.belowHorizon);
}

TEST(WriteMerl, ScatteredSamplesAreNotEnough)
{
    const TempFolder folder;
    EXPECT_EQ(outputKind([&] { writeMerl(heldSource(), folder.path("a.binary")); }),
              int(ErrorKind::usage));
    EXPECT_EQ(filesIn(folder.path("")), 0u);
}

TEST(Write, UnwritablePathsAreOutputErrorsAndLeaveNothing)
{
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("sub"));
    for (const std::string& path :
         {folder.path("missing/a.csv"), folder.path("sub"), std::string("/dev/null/a.csv")})
        EXPECT_EQ(outputKind([&] { writeCsv(heldSource(), path); }), int(ErrorKind::output))
            << path;
    EXPECT_EQ(filesIn(folder.path("")), 1u);
}

TEST(Write, AFailureWhileWritingKeepsTheOldFile)
{
    const TempFolder folder;
    folder.write("a.csv", "old");
    Source source = heldSource();
    source.samples.clear();
    source.stream.rows = 1;
    source.stream.read = [](uint64_t, size_t, std::vector<Sample>&, SampleReport&) {
        throw Error(ErrorKind::input, "source", "gone");
    };
    EXPECT_EQ(outputKind([&] { writeCsv(source, folder.path("a.csv")); }), int(ErrorKind::input));
    EXPECT_EQ(std::filesystem::file_size(folder.path("a.csv")), 3u);
    EXPECT_EQ(filesIn(folder.path("")), 1u);
}

TEST(Write, FollowsALinkAndReplacesItsTarget)
{
    const TempFolder folder;
    folder.write("real.csv", "old");
    std::filesystem::create_symlink(folder.path("real.csv"), folder.path("link.csv"));
    writeCsv(heldSource(), folder.path("link.csv"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.csv")));
    EXPECT_EQ(openSource(folder.path("real.csv")).samples.size(), 2u);
}

TEST(SpreadPairs, AreUnitAboveTheHorizonAndFillTheHighlight)
{
    const auto pairs = spreadPairs(1001);
    ASSERT_EQ(pairs.size(), 1001u);
    size_t near = 0;
    for (const auto& pair : pairs) {
        EXPECT_NEAR(glm::length(pair.wo), 1.0, 1e-12);
        EXPECT_NEAR(glm::length(pair.wi), 1.0, 1e-12);
        EXPECT_GT(std::min(pair.wo.z, pair.wi.z), std::sin(2 * kPi / 180) - 1e-12);
        near += glm::normalize(pair.wo + pair.wi).z > std::cos(5 * kPi / 180);
    }
    EXPECT_GT(near, 100u);  // 5 degrees hold 0.4 % of a uniform distribution
}
