// Isotropic or not, from samples alone: whether a turn about the normal, or the side of the plane
// of incidence, makes a difference.
#include "SampleSymmetry.h"

#include "ReaderTest.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

#include <functional>
#include <random>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

using Function = std::function<Vec3d(const Vec3d& wo, const Vec3d& wi)>;

const char* const kPlastic = "ggx:alpha=0.3,f0=0.04,kd=0.3";
const char* const kBrushedPlastic = "ggx:alpha_x=0.1,alpha_y=0.4,f0=0.04,kd=0.3";

Sample sampleAt(const Function& f, double thetaI, double phiI, double thetaO, double phiO)
{
    const Vec3d wi = directionFromAngles(thetaI, phiI), wo = directionFromAngles(thetaO, phiO);
    return {Vec3f(wo), Vec3f(wi), Vec3f(f(wo, wi)), 1.0f};
}

std::vector<Sample> spread(const Function& f, size_t count)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> zenith(0.0, 1.4), azimuth(-kPi, kPi);
    std::vector<Sample> samples;
    while (samples.size() < count)
        samples.push_back(
            sampleAt(f, zenith(random), azimuth(random), zenith(random), azimuth(random)));
    return samples;
}

/// Samples as a goniometer takes them, with the material turned by each of the azimuths (degrees).
std::vector<Sample> onGrid(const Function& f, const std::vector<double>& turns)
{
    std::vector<Sample> samples;
    for (const double turn : turns)
        for (int i = 0; i <= 75; i += 15)
            for (int o = 0; o <= 75; o += 15)
                for (int phi = -180; phi < 180; phi += 20)
                    samples.push_back(sampleAt(f, i * kDegree, turn * kDegree, o * kDegree,
                                               (phi + turn) * kDegree));
    return samples;
}

Function model(const std::string& spec)
{
    return openSource(spec).evaluate;
}

}  // namespace

TEST(SampleSymmetry, SpreadSamplesOfIsotropicMaterialsAreIsotropic)
{
    EXPECT_TRUE(areIsotropic(spread(model(kPlastic), 20000)));
    EXPECT_TRUE(areIsotropic(spread(model("ggx:alpha=0.15,f0=0.9,kd=0"), 20000)));
    EXPECT_TRUE(areIsotropic(spread(model("lambert:albedo=0.5"), 2000)));
}

TEST(SampleSymmetry, SpreadSamplesOfAnisotropicMaterialsAreNot)
{
    EXPECT_FALSE(areIsotropic(spread(model(kBrushedPlastic), 20000)));
    EXPECT_FALSE(areIsotropic(spread(model("ggx:alpha_x=0.2,alpha_y=0.4,f0=0.9,kd=0"), 20000)));
    EXPECT_FALSE(areIsotropic(spread(model("ward-rolled-brass"), 20000)));
}

TEST(SampleSymmetry, TurnsOfAGoniometerDecide)
{
    const std::vector<double> turns{0.0, 30.0, 60.0, 90.0};
    EXPECT_TRUE(areIsotropic(onGrid(model(kPlastic), turns)));
    EXPECT_FALSE(areIsotropic(onGrid(model(kBrushedPlastic), turns)));
}

TEST(SampleSymmetry, NoiseOfAPercentIsNoAnisotropy)
{
    std::vector<Sample> samples = onGrid(model(kPlastic), {0.0, 30.0, 60.0});
    std::mt19937_64 random(5);
    std::normal_distribution<float> noise(1.0f, 0.01f);
    for (Sample& s : samples) s.f *= noise(random);
    EXPECT_TRUE(areIsotropic(samples));
}

TEST(SampleSymmetry, OnePlaneOfIncidenceIsIsotropicUnlessItsSidesDiffer)
{
    EXPECT_TRUE(areIsotropic(onGrid(model(kPlastic), {0.0})));
    EXPECT_TRUE(areIsotropic(onGrid(model(kPlastic), {40.0, 220.0})));
    // Brush marks across the plane of incidence: what is left of it is not what is right of it.
    EXPECT_FALSE(areIsotropic(onGrid(model(kBrushedPlastic), {35.0})));
    std::vector<Sample> within;  // the plane alone decides nothing
    for (const Sample& s : onGrid(model(kPlastic), {0.0}))
        if (std::abs(s.wo.y) < 1e-4f) within.push_back(s);
    EXPECT_GT(within.size(), 50u);
    EXPECT_FALSE(areIsotropic(within));
    EXPECT_FALSE(areIsotropic(spread(model(kPlastic), 10)));
}

/// A grid of 64 theta_i by 64 theta_o by 2,048 azimuths in this order: 8 million rows.
Source gridStream(double brushedFrom)
{
    constexpr uint64_t kZeniths = 64, kAzimuths = 2048;
    Source source;
    source.stream.rows = kZeniths * kZeniths * kAzimuths;
    source.stream.read = [=](uint64_t first, size_t count, std::vector<Sample>& out,
                             SampleReport&) {
        for (uint64_t row = first; row < first + count; ++row) {
            const double theta_i = 1.4 * double(row / (kZeniths * kAzimuths)) / kZeniths,
                         theta_o = 1.4 * double(row / kAzimuths % kZeniths) / kZeniths;
            const double phi_i = 2 * kPi * double(row % 64) / 64,
                         phi_o = 2 * kPi * double(row / 64 % 32) / 32;
            const double brush = theta_o >= brushedFrom ? 0.05 * std::cos(2 * phi_i) : 0.0;
            const Function f = [&](const Vec3d&, const Vec3d&) { return Vec3d(0.1 + brush); };
            out.push_back(sampleAt(f, theta_i, phi_i, theta_o, phi_o));
        }
    };
    return source;
}

// The rows that are read must not all have one theta_o because the grid has as many lines as there
// are pieces.
TEST(SampleSymmetry, OfAGridOfAnyPeriodAllAnglesAreRead)
{
    EXPECT_TRUE(hasIsotropicSamples(gridStream(2.0)));
    EXPECT_FALSE(hasIsotropicSamples(gridStream(0.2)));
}

TEST(SampleSymmetry, TextAndColumnsAreRecognised)
{
    for (const bool isotropic : {true, false}) {
        std::string text = "theta_i,phi_i,theta_o,phi_o,value\n", rows;
        const Function f = model(isotropic ? kPlastic : kBrushedPlastic);
        size_t count = 0;
        for (int turn = 0; turn < 180; turn += 30)
            for (int i = 10; i < 80; i += 10)
                for (int o = 10; o < 80; o += 10)
                    for (int phi = 0; phi < 360; phi += 30, ++count) {
                        const double degree = kPi / 180.0;
                        const Sample s = sampleAt(f, i * degree, turn * degree, o * degree,
                                                  (turn + phi) * degree);
                        text += std::to_string(i) + "," + numberText(turn) + "," +
                                std::to_string(o) + "," + numberText(turn + phi) + "," +
                                numberText(double(s.f.x)) + "\n";
                        for (const int angle : {i, turn, o, turn + phi}) append(rows, float(angle));
                        append(rows, s.f.x);
                    }
        const TempFolder folder;
        EXPECT_EQ(openSource(folder.write("a.csv", text)).isotropic, isotropic);
        const std::string head =
            "fbrdf-columns 1\ntheta_i,phi_i,theta_o,phi_o,value\n" + std::to_string(count) + "\n";
        EXPECT_EQ(openSource(folder.write("a.f32c", head + rows)).isotropic, isotropic);
    }
}
