#include <fbrdf/base/Srgb.h>
#include <fbrdf/metrics/StandardSphere.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// Radiance is stored in float: decibels of small differences are good to this.
constexpr double kDecibel = 1e-3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Radiance>
SphereImage picture(const Radiance& radiance, int size = 48)
{
    SphereImage image;
    image.size = size;
    const auto pixels = static_cast<size_t>(size) * static_cast<size_t>(size);
    image.covered.assign(pixels, true);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) image.radiance.push_back(Vec3f(radiance(x, y)));
    return image;
}

SphereImage grey(double value)
{
    return picture([&](int, int) { return Vec3d(value); });
}

SphereImage lambertianSphere(const Vec3d& albedo)
{
    return renderStandardSphere([&](const Vec3d&, const Vec3d&) { return albedo / kPi; }, 64);
}

TEST(ImageErrors, IdenticalPicturesArePerfect)
{
    const SphereImage image = lambertianSphere({0.5, 0.3, 0.2});
    const ImageErrors errors = imageErrors(image, image);
    EXPECT_EQ(errors.psnrLinear, kInfinity);
    EXPECT_EQ(errors.psnrSrgb, kInfinity);
    EXPECT_DOUBLE_EQ(errors.ssim, 1.0);
    EXPECT_EQ(errors.deltaEItp, 0.0);
    EXPECT_EQ(errors.flip, 0.0);
}

TEST(ImageErrors, PicturesNeedNotBeSquareAndWhatIsNotCoveredDoesNotCount)
{
    ShownImage image{32, 8, std::vector<Vec3f>(256, Vec3f(0.5f)), std::vector<bool>(256, true)};
    ShownImage reference = image;
    for (Vec3f& value : reference.radiance) value = Vec3f(0.4f);
    EXPECT_NEAR(imageErrors(image, reference).psnrLinear, 20.0, kDecibel);
    for (size_t i = 0; i < 256; i += 2) {
        image.covered[i] = false;
        image.radiance[i] = Vec3f(1.0f);
    }
    EXPECT_NEAR(imageErrors(image, reference).psnrLinear, 20.0, kDecibel);
    EXPECT_GT(imageErrors(image, reference).flip, 0.0);
}

TEST(ImageErrors, PsnrOfKnownOffsets)
{
    EXPECT_NEAR(imageErrors(grey(0.5), grey(0.4)).psnrLinear, 20.0, kDecibel);
    EXPECT_NEAR(imageErrors(grey(0.5), grey(0.49)).psnrLinear, 40.0, kDecibel);
    EXPECT_NEAR(imageErrors(grey(1.0), grey(0.0)).psnrLinear, 0.0, kDecibel);
    // One channel of three is off: 10 log10 3 better.
    const SphereImage red = picture([](int, int) { return Vec3d(0.6, 0.5, 0.5); });
    EXPECT_NEAR(imageErrors(red, grey(0.5)).psnrLinear, 20.0 + 10.0 * std::log10(3.0), kDecibel);
}

TEST(ImageErrors, PsnrSrgbIsOfEncodedValues)
{
    const double a = linearFromSrgb(0.7), b = linearFromSrgb(0.6);
    const ImageErrors errors = imageErrors(grey(a), grey(b));
    EXPECT_NEAR(errors.psnrSrgb, 20.0, kDecibel);
    EXPECT_GT(std::abs(errors.psnrLinear - 20.0), 1.0);
}

TEST(ImageErrors, OnlyCoveredPixelsCount)
{
    SphereImage a = grey(0.5), b = grey(0.4);
    for (size_t i = 0; i < a.covered.size() / 2; ++i) {
        a.covered[i] = b.covered[i] = false;
        a.radiance[i] = Vec3f(1.0f);
        b.radiance[i] = Vec3f(0.0f);
    }
    EXPECT_NEAR(imageErrors(a, b).psnrLinear, 20.0, kDecibel);
}

TEST(ImageErrors, SsimOfConstantsIsTheirLuminanceTerm)
{
    // Wang et al. 2004, Eq. 6: (2 a b + C1) / (a^2 + b^2 + C1), C1 = 1e-4.
    const double a = 0.8, b = 0.5;
    const ImageErrors errors = imageErrors(grey(linearFromSrgb(a)), grey(linearFromSrgb(b)));
    EXPECT_NEAR(errors.ssim, (2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-4);
}

TEST(ImageErrors, SsimOfAnInvertedPatternIsNegative)
{
    // A checkerboard of amplitude s and its inverse: equal means, covariance -s^2: (C2 - 2 s^2) /
    // (C2 + 2 s^2).
    const double s = 0.1, c2 = 9e-4;
    const auto board = [&](double sign) {
        return picture([&, sign](int x, int y) {
            return Vec3d(linearFromSrgb(0.5 + sign * ((x + y) % 2 == 0 ? s : -s)));
        });
    };
    // Beyond the border pixels repeat, which breaks the pattern there: measure the inside.
    SphereImage a = board(1.0);
    const SphereImage b = board(-1.0);
    for (int y = 0; y < a.size; ++y)
        for (int x = 0; x < a.size; ++x)
            a.covered[static_cast<size_t>(y * a.size + x)] = x > 5 && y > 5 && x < 42 && y < 42;
    EXPECT_NEAR(imageErrors(a, b).ssim, (c2 - 2 * s * s) / (c2 + 2 * s * s), 1e-3);
}

TEST(ImageErrors, ItpDifferenceOfConstants)
{
    EXPECT_NEAR(imageErrors(grey(1.0), grey(0.0)).deltaEItp, 418.0955, 1e-3);
}

TEST(ImageErrors, FlipOfConstants)
{
    EXPECT_NEAR(imageErrors(grey(1.0), grey(0.0)).flip, 0.967379, 1e-5);
}

TEST(ImageErrors, EveryMetricSeesAWrongMaterial)
{
    const SphereImage reference = lambertianSphere({0.5, 0.3, 0.2});
    const ImageErrors errors = imageErrors(lambertianSphere({0.05, 0.05, 0.4}), reference);
    EXPECT_LT(errors.psnrLinear, 20.0);
    EXPECT_LT(errors.psnrSrgb, 20.0);
    EXPECT_LT(errors.ssim, 0.99);
    EXPECT_GT(errors.deltaEItp, 20.0);
    EXPECT_GT(errors.flip, 0.2);
}

TEST(ImageErrors, EveryMetricRanksASmallErrorBelowALargeOne)
{
    const SphereImage reference = lambertianSphere(Vec3d(0.5));
    const ImageErrors small = imageErrors(lambertianSphere(Vec3d(0.48)), reference);
    const ImageErrors large = imageErrors(lambertianSphere(Vec3d(0.4)), reference);
    EXPECT_GT(small.psnrLinear, large.psnrLinear);
    EXPECT_GT(small.psnrSrgb, large.psnrSrgb);
    EXPECT_GT(small.ssim, large.ssim);
    EXPECT_LT(small.deltaEItp, large.deltaEItp);
    EXPECT_LT(small.flip, large.flip);
}

}  // namespace
}  // namespace fbrdf
