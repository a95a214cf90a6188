#include "FlipMetric.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/metrics/Colour.h>
#include <fbrdf/metrics/StandardSphere.h>

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

double psnrFromMse(double mse)
{
    return mse > 0.0 ? -10.0 * std::log10(mse) : std::numeric_limits<double>::infinity();
}

RgbPlanes planesOf(const ShownImage& image)
{
    RgbPlanes planes;
    for (int c = 0; c < 3; ++c) {
        Plane& plane = planes[static_cast<size_t>(c)];
        plane = Plane(image.width, image.height);
        for (size_t i = 0; i < plane.values.size(); ++i) plane.values[i] = image.radiance[i][c];
    }
    return planes;
}

RgbPlanes encoded(RgbPlanes planes)
{
    for (Plane& plane : planes)
        for (float& v : plane.values)
            v = static_cast<float>(srgbFromLinear(static_cast<double>(v)));
    return planes;
}

// Mean of perPixel(i) over the covered pixels.
template <class PerPixel>
double meanOver(const std::vector<bool>& covered, const PerPixel& perPixel)
{
    double sum = 0.0;
    size_t count = 0;
    for (size_t i = 0; i < covered.size(); ++i) {
        if (!covered[i]) continue;
        sum += perPixel(i);
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

double psnr(const RgbPlanes& a, const RgbPlanes& b, const std::vector<bool>& covered)
{
    return psnrFromMse(meanOver(covered, [&](size_t i) {
        double squares = 0.0;
        for (size_t c = 0; c < 3; ++c) {
            const double d =
                static_cast<double>(a[c].values[i]) - static_cast<double>(b[c].values[i]);
            squares += d * d;
        }
        return squares / 3.0;
    }));
}

// Rec. 709 luma of encoded values.
Plane luma(const RgbPlanes& srgb)
{
    Plane result = srgb[0];
    for (size_t i = 0; i < result.values.size(); ++i)
        result.values[i] =
            0.2126f * srgb[0].values[i] + 0.7152f * srgb[1].values[i] + 0.0722f * srgb[2].values[i];
    return result;
}

Plane product(const Plane& a, const Plane& b)
{
    Plane result = a;
    for (size_t i = 0; i < result.values.size(); ++i) result.values[i] *= b.values[i];
    return result;
}

// Wang, Bovik, Sheikh, Simoncelli 2004, Eq. 13, with their constants K1 = 0.01, K2 = 0.03 for a
// range of 1.
double ssim(const Plane& a, const Plane& b, const std::vector<bool>& covered)
{
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    const Kernel window = gaussianKernel(1.5, 5);
    const auto smooth = [&](const Plane& plane) { return convolved(plane, window, window); };
    const Plane meanA = smooth(a), meanB = smooth(b);
    const Plane aa = smooth(product(a, a)), bb = smooth(product(b, b)), ab = smooth(product(a, b));
    return meanOver(covered, [&](size_t i) {
        const auto at = [i](const Plane& plane) { return static_cast<double>(plane.values[i]); };
        const double ma = at(meanA), mb = at(meanB);
        const double variances = (at(aa) - ma * ma) + (at(bb) - mb * mb);
        const double covariance = at(ab) - ma * mb;
        return (2.0 * ma * mb + kC1) * (2.0 * covariance + kC2) /
               ((ma * ma + mb * mb + kC1) * (variances + kC2));
    });
}

double meanDeltaEItp(const ShownImage& a, const ShownImage& b)
{
    return meanOver(a.covered, [&](size_t i) {
        return deltaEItp(itpFromLinear(Vec3d(a.radiance[i])), itpFromLinear(Vec3d(b.radiance[i])));
    });
}

ShownImage shownOf(const SphereImage& sphere)
{
    return {sphere.size, sphere.size, sphere.radiance, sphere.covered};
}

}  // namespace

ImageErrors imageErrors(const SphereImage& image, const SphereImage& reference)
{
    return imageErrors(shownOf(image), shownOf(reference));
}

ImageErrors imageErrors(const ShownImage& image, const ShownImage& reference)
{
    FBRDF_ASSERT(image.width, ==, reference.width);
    FBRDF_ASSERT(image.height, ==, reference.height);
    const RgbPlanes linearA = planesOf(image), linearB = planesOf(reference);
    const RgbPlanes srgbA = encoded(linearA), srgbB = encoded(linearB);
    const Plane flip = flipMap(linearA, linearB);
    ImageErrors errors;
    errors.psnrLinear = psnr(linearA, linearB, image.covered);
    errors.psnrSrgb = psnr(srgbA, srgbB, image.covered);
    errors.ssim = ssim(luma(srgbA), luma(srgbB), image.covered);
    errors.deltaEItp = meanDeltaEItp(image, reference);
    errors.flip =
        meanOver(image.covered, [&](size_t i) { return static_cast<double>(flip.values[i]); });
    return errors;
}

}  // namespace fbrdf
