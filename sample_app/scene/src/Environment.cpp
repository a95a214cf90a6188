#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/scene/Environment.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fbrdf::scene {
namespace {

Vec3f colourFromText(const std::string& text)
{
    Vec3f colour(0.0f);
    const char *at = text.data(), *const end = text.data() + text.size();
    for (int c = 0; c < 3; ++c) {
        const auto parsed = std::from_chars(at, end, colour[c]);
        const bool isLast = c == 2;
        const bool ends = isLast ? parsed.ptr == end : parsed.ptr != end && *parsed.ptr == ',';
        if (parsed.ec != std::errc() || !ends || !std::isfinite(colour[c]) || colour[c] < 0.0f)
            throw Error(
                ErrorKind::usage, "--background",
                Found("'" + text + "'").expected("environment, none, or R,G,B of numbers >= 0"));
        at = parsed.ptr + 1;
    }
    return colour;
}

}  // namespace

Vec3d EnvironmentLight::toEnvironment(const Vec3d& world) const
{
    const double c = std::cos(rotation), s = std::sin(rotation);
    return {c * world.x - s * world.z, world.y, s * world.x + c * world.z};
}

Vec3d EnvironmentLight::fromEnvironment(const Vec3d& w) const
{
    const double c = std::cos(rotation), s = std::sin(rotation);
    return {c * w.x + s * w.z, w.y, c * w.z - s * w.x};
}

Vec3d EnvironmentLight::radianceFrom(const Vec3d& world) const
{
    const Vec2<double> place = panoramaPlace(toEnvironment(world));
    const double x = place.x * panorama.width - 0.5, y = place.y * panorama.height - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const auto texel = [&](double column, double row) {
        const int wrapped = static_cast<int>(column + panorama.width) % panorama.width;
        const int clamped = std::clamp(static_cast<int>(row), 0, panorama.height - 1);
        return Vec3d(panorama.texel(wrapped, clamped));
    };
    const Vec3d upper = glm::mix(texel(left, top), texel(left + 1.0, top), x - left);
    const Vec3d lower = glm::mix(texel(left, top + 1.0), texel(left + 1.0, top + 1.0), x - left);
    return intensity * glm::mix(upper, lower, y - top);
}

Background backgroundFromText(const std::string& text)
{
    Background background;
    if (text == "environment")
        background.environment = true;
    else if (text != "none")
        background.colour = colourFromText(text);
    return background;
}

void fillBackground(Image& image, const Background& background, const EnvironmentLight* environment,
                    const gl::View& view)
{
    if (background.isNone()) return;
    const glm::dmat4 fromClip = glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view));
    const auto unprojected = [&](double x, double y, double depth) {
        const glm::dvec4 point = fromClip * glm::dvec4(x, y, depth, 1.0);
        return Vec3d(point) / point.w;
    };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float* const pixel = image.pixel(x, y);
            const double uncovered = 1.0 - double(pixel[3]);
            if (!(uncovered > 0.0)) continue;
            Vec3d colour = background.colour ? Vec3d(*background.colour) : Vec3d(0.0);
            if (background.environment) {
                const double u = (2.0 * x + 1.0) / image.width - 1.0,
                             v = 1.0 - (2.0 * y + 1.0) / image.height;
                colour =
                    environment->radianceFrom(unprojected(u, v, 0.5) - unprojected(u, v, -0.5));
            }
            for (int c = 0; c < 3; ++c) pixel[c] += static_cast<float>(uncovered * colour[c]);
        }
}

}  // namespace fbrdf::scene
