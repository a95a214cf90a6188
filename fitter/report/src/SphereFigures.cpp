#include "SphereFigures.h"

#include "Html.h"

#include <fbrdf/base/Srgb.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

template <class ColourAt>
Picture covered(const SphereImage& image, const ColourAt& colourAt)
{
    Picture picture(image.size, image.size);
    for (int y = 0; y < image.size; ++y)
        for (int x = 0; x < image.size; ++x) {
            const auto i = static_cast<size_t>(y * image.size + x);
            if (image.covered[i]) picture.set(x, y, colourAt(i));
        }
    return picture;
}

Vec3d difference(const SphereImage& a, const SphereImage& b, size_t i)
{
    return Vec3d(a.radiance[i]) - Vec3d(b.radiance[i]);
}

std::string figure(const Picture& picture, const std::string& alt, const std::string& caption)
{
    const std::string image =
        fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\"/>", picture.width,
                    picture.height, escaped(alt), dataUri(picture));
    return element("figure", "", image + element("figcaption", "", caption));
}

}  // namespace

Picture pictureOf(const SphereImage& image)
{
    return covered(image, [&](size_t i) {
        const Vec3d linear(image.radiance[i]);
        return Vec3d(srgbFromLinear(linear.x), srgbFromLinear(linear.y), srgbFromLinear(linear.z));
    });
}

Picture differencePicture(const SphereImage& fit, const SphereImage& data, double amplification)
{
    return covered(fit, [&](size_t i) { return 0.5 + amplification * difference(fit, data, i); });
}

double amplificationFor(const SphereImage& fit, const SphereImage& data)
{
    constexpr double kShare = 0.99, kRange = 0.5;
    std::vector<double> sizes;
    for (size_t i = 0; i < fit.covered.size(); ++i)
        for (int c = 0; fit.covered[i] && c < 3; ++c)
            sizes.push_back(std::abs(difference(fit, data, i)[c]));
    if (sizes.empty()) return 1.0;
    const auto rank =
        sizes.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), rank, sizes.end());
    double chosen = 1.0;
    for (const double candidate : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0})
        if (candidate * *rank <= kRange) chosen = candidate;
    return chosen;
}

Picture inventedPicture(const SphereImage& fit, const InventedSphere& invented)
{
    // Magenta is no colour of a grey picture. It keeps some brightness where the fit is black.
    constexpr Vec3d kMagenta(0.9, 0.1, 0.6);
    constexpr double kLeastBrightness = 0.35;
    return covered(fit, [&](size_t i) {
        const Vec3f& radiance = fit.radiance[i];
        const double grey = srgbFromLinear(double(radiance.x + radiance.y + radiance.z) / 3.0);
        return glm::mix(Vec3d(grey), glm::mix(kLeastBrightness, 1.0, grey) * kMagenta,
                        invented.shares[i]);
    });
}

std::string sphereFigures(const SphereImage& data, const SphereImage& fit,
                          const InventedSphere* invented)
{
    std::string figures;
    if (data.size > 0) figures += figure(pictureOf(data), "Standard sphere, data", "Data");
    figures += figure(pictureOf(fit), "Standard sphere, fit", "Fit");
    if (data.size > 0) {
        const double amplification = amplificationFor(fit, data);
        figures += figure(
            differencePicture(fit, data, amplification), "Amplified difference of fit and data",
            fmt::format("Difference \xC3\x97 {:g}: grey where equal, brighter where the fit is",
                        amplification));
    }
    if (invented)
        figures +=
            figure(inventedPicture(fit, *invented), "Standard sphere, what is invented in magenta",
                   fmt::format(
                       "Invented: magenta where no sample supports the maps, {:.3g} % of all light",
                       100.0 * invented->total));
    return element("div", "class=\"spheres\"", figures);
}

}  // namespace fbrdf
