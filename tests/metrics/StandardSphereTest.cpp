// Expected numbers: `standard_sphere.py 256`, the definition in code that comes with the contract.
#include <fbrdf/metrics/StandardSphere.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace fbrdf {
namespace {

// The reference prints six decimals; radiance is stored in float.
constexpr double kSixDecimals = 1e-6;

Vec3d meanOf(const SphereImage& image)
{
    Vec3d sum(0.0);
    size_t count = 0;
    for (size_t i = 0; i < image.radiance.size(); ++i) {
        if (!image.covered[i]) continue;
        sum += Vec3d(image.radiance[i]);
        ++count;
    }
    return sum / static_cast<double>(count);
}

double meanOfLambertian(double albedo)
{
    const Vec3d mean = meanOf(
        renderStandardSphere([&](const Vec3d&, const Vec3d&) { return Vec3d(albedo / kPi); }));
    return (mean.x + mean.y + mean.z) / 3.0;
}

// Depends on both azimuths, so that a wrong tangent or a swapped pair shows.
Vec3d lopsided(const Vec3d& wo, const Vec3d& wi)
{
    return 0.05 * (1.0 + wi.x) * (1.0 + 0.5 * wo.y) * Vec3d(1.0, 0.5, 0.25);
}

void expectPixel(const SphereImage& image, int row, int column, const Vec3d& expected)
{
    const Vec3f pixel = image.radiance[static_cast<size_t>(row * image.size + column)];
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(pixel[c]), expected[c], kSixDecimals);
}

TEST(StandardSphere, CoversTheReferencesPixels)
{
    const SphereImage image = renderStandardSphere(lopsided);
    EXPECT_EQ(image.size, 256);
    EXPECT_EQ(std::count(image.covered.begin(), image.covered.end(), true), 51468);
}

TEST(StandardSphere, LambertiansHaveTheReferencesMeans)
{
    EXPECT_NEAR(meanOfLambertian(0.1), 0.080000, kSixDecimals);
    EXPECT_NEAR(meanOfLambertian(0.5), 0.400000, kSixDecimals);
    EXPECT_NEAR(meanOfLambertian(0.9), 0.716858, kSixDecimals);  // some of it clamped
}

TEST(StandardSphere, AnisotropyFollowsTheTangentOfIncreasingAzimuth)
{
    const SphereImage image = renderStandardSphere(lopsided);
    const Vec3d mean = meanOf(image);
    EXPECT_NEAR(mean.x, 0.12780876, kSixDecimals);
    EXPECT_NEAR(mean.y, 0.06146023, kSixDecimals);
    EXPECT_NEAR(mean.z, 0.0300636, kSixDecimals);
    expectPixel(image, 64, 100, {0.15213852, 0.07451796, 0.03729006});
    expectPixel(image, 200, 40, {0.077387, 0.0393099, 0.02319949});
    expectPixel(image, 128, 250, {0.07699446, 0.03568451, 0.0156372});
}

TEST(StandardSphere, IsTheSameForAnyNumberOfThreads)
{
    EXPECT_EQ(renderStandardSphere(lopsided, 64, 1).radiance,
              renderStandardSphere(lopsided, 64, 5).radiance);
}

TEST(StandardSphere, ClampsAndLeavesTheBackgroundBlack)
{
    const SphereImage image =
        renderStandardSphere([](const Vec3d&, const Vec3d&) { return Vec3d(1e6, -1.0, 0.0); }, 64);
    for (size_t i = 0; i < image.radiance.size(); ++i) {
        EXPECT_LE(image.radiance[i].x, 1.0f);
        EXPECT_EQ(image.radiance[i].y, 0.0f);
        EXPECT_EQ(image.radiance[i].x > 0.0f, image.covered[i]) << i;
    }
}

}  // namespace
}  // namespace fbrdf
