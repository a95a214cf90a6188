#include "ReaderTest.h"

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

const std::string kNames = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b";

std::string head(uint64_t rows, const std::string& names = kNames)
{
    return "fbrdf-columns 1\n" + names + "\n" + std::to_string(rows) + "\n";
}

std::string row(const std::vector<float>& numbers)
{
    std::string bytes;
    for (const float number : numbers) append(bytes, number);
    return bytes;
}

Source read(const std::string& bytes, bool cosine = false)
{
    const TempFolder folder;
    return openSource(folder.write("scan.f32c", bytes), {cosine});
}

void expectRefused(const std::string& bytes, const std::string& part)
{
    const TempFolder folder;
    expectInputError(folder.write("scan.f32c", bytes), part);
}

/// Resident memory of this process in bytes.
size_t residentBytes()
{
    size_t whole = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * size_t(::sysconf(_SC_PAGESIZE));
}

}  // namespace

TEST(BinaryColumns, StreamsItsRows)
{
    const Source source =
        read(head(3) + row({0, 0, 2, 0.6f, 0, 0.8f, 1, 2, 3}) + row({0, 0, 1, 0, 0, -1, 1, 1, 1}) +
             row({0, 0, 1, 0, 0, 1, 4, NAN, 6}));
    EXPECT_EQ(source.format, "columns");
    EXPECT_EQ(source.stream.rows, 3u);
    const std::vector<Sample> samples = allSamples(source);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].f, Vec3f(1, 2, 3));
    EXPECT_EQ(samples[0].wo, Vec3f(0, 0, 1));
    const SampleReport report = reportOf(source);
    EXPECT_EQ(report.belowHorizon, 1u);
    EXPECT_EQ(report.nonFinite, 1u);
    expectSound(source);
}

TEST(BinaryColumns, ColumnsAreThoseOfCsv)
{
    const Source source = read(head(1, "value,other,theta_i,phi_i,theta_o,phi_o,weight") +
                                   row({0.5f, NAN, 30, 0, 60, 90, 3}),
                               true);
    const std::vector<Sample> samples = allSamples(source);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_NEAR(samples[0].f.x, 1.0f, 1e-6f);  // the cosine of 60 degrees divided out
    EXPECT_NEAR(samples[0].wi.x, 0.5f, 1e-6f);
    EXPECT_EQ(samples[0].weight, 3.0f);
}

TEST(BinaryColumns, AnyRangeOfRowsCanBeRead)
{
    std::string bytes = head(10);
    for (int i = 0; i < 10; ++i) bytes += row({0, 0, 1, 0, 0, 1, float(i), 0, 0});
    const Source source = read(bytes);
    std::vector<Sample> samples;
    SampleReport report;
    source.stream.read(7, 2, samples, report);
    source.stream.read(0, 1, samples, report);
    ASSERT_EQ(samples.size(), 3u);
    EXPECT_EQ(samples[0].f.x, 7.0f);
    EXPECT_EQ(samples[2].f.x, 0.0f);
    EXPECT_EQ(report.given, 3u);
}

TEST(BinaryColumns, RefusesWhatDoesNotAddUp)
{
    const std::string data = row({0, 0, 1, 0, 0, 1, 1, 1, 1});
    expectRefused(head(2) + data, "expected 2 rows of 36 bytes");
    expectRefused(head(1) + data + "x", "expected 1 rows");
    expectRefused(head(0), ":3: found '0'");
    expectRefused("fbrdf-columns 1\n" + kNames + "\n-1\n" + data, ":3: found '-1'");
    expectRefused("fbrdf-columns 1\n" + kNames + "\n1e3\n" + data, ":3: found '1e3'");
    expectRefused(head(9223372036854775807ull) + data, "expected 9223372036854775807 rows");
    expectRefused("fbrdf-columns 1\n" + kNames + "\n99999999999999999999\n", ":3:");
    expectRefused(head(1, "wo_x,wo_y") + data, ":2: found the header");
    expectRefused("fbrdf-columns 1\n" + kNames, ":2: found no end of the line");
    expectRefused("fbrdf-columns 1\n" + std::string(100000, ','), ":2: found no end of the line");
    expectRefused("fbrdf-columns 2\n" + data, ":1:");
}

TEST(BinaryColumns, EveryPrefixIsRefused)
{
    const std::string bytes =
        head(2) + row({0, 0, 1, 0, 0, 1, 1, 1, 1}) + row({0, 0, 1, 0.6f, 0, 0.8f, 1, 2, 3});
    EXPECT_EQ(refusedPrefixes("s.f32c", bytes), bytes.size());
    expectSurvivesDamage("s.f32c", bytes);
}

// A sparse file of 300 MB: 8.7 million rows whose directions have no length.
TEST(BinaryColumns, MemoryDoesNotGrowWithTheRows)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer takes memory of its own";
#endif
    constexpr uint64_t kRows = 8'700'000;
    const TempFolder folder;
    const std::string path = folder.write("big.f32c", head(kRows));
    std::filesystem::resize_file(path, std::filesystem::file_size(path) + kRows * 36);
    const size_t before = residentBytes();
    const Source source = openSource(path);
    size_t most = 0;
    SampleReport report;
    std::vector<Sample> block;
    for (uint64_t first = 0; first < kRows; first += 100'000) {
        source.stream.read(first, 100'000, block, report);
        most = std::max(most, residentBytes());
    }
    EXPECT_EQ(report.nonFinite, kRows);
    // A block is 3.6 MB; the rest is what the allocator keeps.
    EXPECT_LT(most, before + (size_t(32) << 20));
}
