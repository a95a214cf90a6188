#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/environment/Panorama.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

bool isRadiance(const Vec3f& value)
{
    for (int c = 0; c < 3; ++c)
        if (!(std::isfinite(value[c]) && value[c] >= 0.0f)) return false;
    return true;
}

}  // namespace

void validate(const Panorama& panorama, const std::string& where)
{
    const auto width = static_cast<size_t>(std::max(0, panorama.width)),
               height = static_cast<size_t>(std::max(0, panorama.height));
    if (width == 0 || height == 0 || panorama.texels.size() != width * height)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(panorama.texels.size()) + " texels for a panorama of " +
                          std::to_string(panorama.width) + " x " + std::to_string(panorama.height))
                        .expected("width x height of them, and at least one"));
    for (size_t i = 0; i < panorama.texels.size(); ++i)
        if (!isRadiance(panorama.texels[i]))
            throw Error(ErrorKind::input, where,
                        Found("a texel in column " + std::to_string(i % width) + " of row " +
                              std::to_string(i / width) + " that is negative or not finite")
                            .expected("radiance, finite and at least 0"));
}

Vec3d panoramaDirection(double u, double v)
{
    const double theta = kPi * v, phi = 2.0 * kPi * (u - 0.5);
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

Vec2<double> panoramaPlace(const Vec3d& direction)
{
    const double across = std::hypot(direction.x, direction.z);
    const double v = std::atan2(across, direction.y) / kPi;
    if (!(across > 0.0)) return {0.5, v};
    return {0.5 + std::atan2(direction.x, -direction.z) / (2.0 * kPi), v};
}

double texelSolidAngle(const Panorama& panorama, int y)
{
    // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2): no digits are lost at the poles.
    const double height = kPi / panorama.height;
    const double zone = 2.0 * std::sin(height * (y + 0.5)) * std::sin(0.5 * height);
    return 2.0 * kPi / panorama.width * zone;
}

Vec3d upwardIrradiance(const Panorama& panorama)
{
    Vec3d sum(0.0);
    for (int y = 0; 2 * y < panorama.height; ++y) {
        // The mean of the cosine over a row times its solid angle: sin^2 / 2 at its edges.
        const double upper = std::sin(kPi * y / panorama.height),
                     lower =
                         std::sin(kPi * std::min(y + 1.0, 0.5 * panorama.height) / panorama.height);
        const double weight = kPi * (lower * lower - upper * upper) / panorama.width;
        for (int x = 0; x < panorama.width; ++x) sum += weight * Vec3d(panorama.texel(x, y));
    }
    return sum;
}

Panorama reduced(const Panorama& panorama, int most)
{
    Panorama result{std::min(panorama.width, most), std::min(panorama.height, most), {}};
    const double across = double(panorama.width) / result.width,
                 down = double(panorama.height) / result.height;
    const auto share = [](double low, double high, int i) {
        return std::min(high, i + 1.0) - std::max(low, double(i));
    };
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const double left = x * across, right = left + across, top = y * down,
                         bottom = top + down;
            Vec3d sum(0.0);
            double area = 0.0;
            for (int j = static_cast<int>(top); j < bottom && j < panorama.height; ++j)
                for (int i = static_cast<int>(left); i < right && i < panorama.width; ++i) {
                    const double weight = texelSolidAngle(panorama, j) * share(top, bottom, j) *
                                          share(left, right, i);
                    sum += weight * Vec3d(panorama.texel(i, j));
                    area += weight;
                }
            result.texels.emplace_back(sum / area);
        }
    return result;
}

}  // namespace fbrdf
