// Measured BSDFs of NVIDIA's MDL.
#include "ReaderTest.h"
#include "support/DataDir.h"

#include <fbrdf/brdf/HalfDifference.h>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

/// Value k at number k, 2 zenith angles and 3 azimuths.
std::string block(const std::string& key, uint32_t type, uint32_t thetas = 2, uint32_t phis = 3)
{
    std::string bytes = key + "=\n";
    for (const uint32_t number : {type, thetas, phis}) append(bytes, number);
    const uint32_t count = 2 * 2 * 3 * (type == 1 ? 3 : 1);
    for (uint32_t k = 0; k < count; ++k) append(bytes, float(k));
    return bytes;
}

std::string mbsdf(const std::string& blocks)
{
    return "NVIDIA ARC MBSDF V1\nproperty=\"of no use\"\n" + blocks;
}

Source read(const std::string& bytes)
{
    const TempFolder folder;
    return openSource(folder.write("a.mbsdf", bytes));
}

}  // namespace

TEST(Mbsdf, BinsAreCentresWithAzimuthFastest)
{
    for (const char* key : {"MBSDF_DATA", "MBSDF_DATA_REFLECTION"}) {
        const Source source =
            read(mbsdf(block("MBSDF_DATA_TRANSMISSION", 0) + "\n" + block(key, 1)));
        EXPECT_EQ(source.format, "mbsdf");
        EXPECT_TRUE(source.isotropic);
        const std::vector<Sample> samples = allSamples(source);
        ASSERT_EQ(samples.size(), 12u);
        expectSound(source);
        // Bin theta_in 1, theta_out 0, phi 2 is (1 * 2 + 0) * 3 + 2 = 8.
        EXPECT_EQ(samples[8].f, Vec3f(24, 25, 26));
        EXPECT_LT(glm::length(Vec3d(samples[8].wi) - directionFromAngles(0.75 * kPi / 2, 0)), 1e-6);
        EXPECT_LT(
            glm::length(Vec3d(samples[8].wo) - directionFromAngles(0.25 * kPi / 2, 2.5 / 3 * kPi)),
            1e-6);
    }
    EXPECT_EQ(allSamples(read(mbsdf(block("MBSDF_DATA", 0)))).at(8).f, Vec3f(8));
}

TEST(Mbsdf, RefusesWhatDoesNotAddUp)
{
    const TempFolder folder;
    const auto refuse = [&](const std::string& bytes, const std::string& part) {
        expectInputError(folder.write("a.mbsdf", bytes), part);
    };
    refuse(mbsdf(""), "found no reflection");
    refuse(mbsdf(block("MBSDF_DATA_TRANSMISSION", 0)), "found no reflection");
    refuse("x" + mbsdf(block("MBSDF_DATA", 0)), "found no 'NVIDIA ARC MBSDF V1'");
    refuse(mbsdf(block("MBSDF_DATA", 7)), "found type 7");
    refuse(mbsdf(block("MBSDF_DATA", 0, 3)), "expected 3^2 x 3");
    refuse(mbsdf(block("MBSDF_DATA", 0, 100000, 100000)), "expected 100000^2 x 100000");
    refuse(mbsdf(block("MBSDF_DATA", 0, 0)), "found 0 bins");
    const std::string whole = mbsdf(block("MBSDF_DATA_REFLECTION", 1));
    EXPECT_EQ(refusedPrefixes("a.mbsdf", whole), whole.size());
    expectSurvivesDamage("a.mbsdf", whole, 3);
}

TEST(Mbsdf, TheMirrorOfRealPaintIsAtAzimuth180)
{
    for (const char* file : {"mbsdf/carpaint_red.mbsdf", "mbsdf/carpaint_blue.mbsdf"}) {
        FBRDF_NEEDS_DATA(file);
        const Source source = openSource(dataPath(file));
        EXPECT_EQ(source.stream.rows, 45u * 45 * 90);
        const std::vector<Sample> samples = allSamples(source);
        const Sample* most = nullptr;  // of an incidence of 41 degrees
        for (const Sample& s : samples)
            if (std::abs(std::acos(s.wi.z) - 41.0f * float(kDegree)) < 0.01f &&
                (!most || s.f.y > most->f.y))
                most = &s;
        ASSERT_TRUE(most);
        EXPECT_LT(std::acos(glm::dot(most->wo, Vec3f(-most->wi.x, -most->wi.y, most->wi.z))),
                  3.0f * float(kDegree));
        EXPECT_GT(reportOf(source).negative, 10000u);
    }
}
