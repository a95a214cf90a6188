// The anisotropic measurements of MIT. The file is made here; the layout is that of the reader.
#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

/// theta_in, theta_out, phi_diff, phi_in.
constexpr int kBins[4] = {2, 3, 4, 5};
constexpr int kCells = 2 * 3 * 4 * 5;

/// Bin k of channel c has k + 200 c, and 1000 for each step of phi_in, which is not isotropic; bin
/// 7 was not measured.
std::string aniso(int half = 0)
{
    std::string bytes;
    const int32_t head[16] = {kBins[0], kBins[1], kBins[2], kBins[3], 0, 0, 1, 0, 0, half, 3};
    for (const int32_t number : head) append(bytes, number);
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < kCells; ++k)
            append(bytes, k == 7 ? -1.0f : float(1000 * (k % kBins[3]) + 200 * c + k));
    return bytes;
}

Source read(const std::string& bytes)
{
    const TempFolder folder;
    return openSource(folder.write("brushed.dat", bytes));
}

}  // namespace

TEST(MitAniso, BinsAreCentresWithPhiInFastest)
{
    for (const int half : {0, 1}) {
        const Source source = read(aniso(half));
        EXPECT_EQ(source.format, "mit-aniso");
        EXPECT_FALSE(source.isotropic);
        const std::vector<Sample> samples = allSamples(source);
        const SampleReport report = reportOf(source);
        EXPECT_EQ(report.given, uint64_t(kCells));
        EXPECT_EQ(report.invalid, 1u);
        ASSERT_EQ(samples.size(), size_t(kCells - 1));
        expectSound(source);
        // Bin ((1 * 3 + 2) * 4 + 1) * 5 + 3 = 108 is sample 107, as bin 7 is missing.
        const double phi = (3 + 0.5) / 5 * 2 * kPi;
        const double diff = (1 + 0.5) / 4 * (half ? 1 : 2) * kPi;
        const Sample& s = samples[107];
        EXPECT_LT(glm::length(Vec3d(s.wi) - directionFromAngles(0.75 * kPi / 2, phi)), 1e-6);
        EXPECT_LT(glm::length(Vec3d(s.wo) - directionFromAngles(2.5 / 3 * kPi / 2, phi + diff)),
                  1e-6);
        EXPECT_EQ(s.f, Vec3f(3108, 3308, 3508));
    }
}

TEST(MitAniso, RefusesWhatDoesNotAddUp)
{
    const TempFolder folder;
    const auto refuse = [&](size_t number, int32_t value, const std::string& part) {
        std::string bytes = aniso();
        std::memcpy(bytes.data() + 4 * number, &value, 4);
        expectInputError(folder.write("a.dat", bytes), part);
    };
    refuse(0, 3, "expected it");
    refuse(0, -2, "expected it");
    refuse(1, 2000000000, "expected it");
    refuse(6, 0, "expected it");
    refuse(7, 1, "found binning 1");
    refuse(9, 5, "found 5 for half data");
    std::string empty = aniso();
    for (size_t i = 64; i < empty.size(); i += 4) {
        const float missing = -1.0f;
        std::memcpy(empty.data() + i, &missing, 4);
    }
    expectInputError(folder.write("a.dat", empty), "no bin that was measured");
}

TEST(MitAniso, EveryPrefixIsRefused)
{
    const std::string bytes = aniso();
    // Of 588 bytes it could be a MERL table of 2 x 3 x 4 cells.
    EXPECT_EQ(refusedPrefixes("a.dat", bytes), bytes.size() - 1);
    expectSurvivesDamage("a.dat", bytes, 7);
}
