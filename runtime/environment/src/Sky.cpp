#include "SkyModels.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/environment/Sky.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr const char* kNames[] = {"studio", "overcast", "clear"};
constexpr int kMostWidth = 16384;
constexpr int kSkySamples = 2, kSunSamples = 4;  // of a texel, on a side
constexpr double kGroundAlbedo = 0.2;
const Vec3d kLuminanceOf(0.2126, 0.7152, 0.0722);  // Rec. 709

/// The sun is over the left shoulder of who looks along -z, 42 degrees high.
const Vec3d kToSun = glm::normalize(Vec3d(-0.55, 0.77, 0.65));
/// Angular radius of the sun as it is drawn, and its limb darkening (Eddington: 1 - 0.6 (1 - mu)).
/// The real one has 0.27 degrees: less than the narrowest lobe (LobeTable.h), which would show it
/// as waves in smooth highlights.
constexpr double kSunRadius = 0.9 * kDegree, kLimb = 0.6;
/// The sun is drawn at least so large, in texels: smaller ones would flicker as a panorama turns.
constexpr double kSunTexels = 1.5;

/// Means over the texels of rows from `firstRow` on, of radiance by direction. side: samples on a
/// side of a texel.
template <class Radiance>
void addRadiance(Panorama& panorama, int firstRow, int endRow, int side, const Radiance& radiance)
{
    parallelTasks(static_cast<size_t>(endRow - firstRow), 0, [&](size_t row) {
        const int y = firstRow + static_cast<int>(row);
        for (int x = 0; x < panorama.width; ++x) {
            Vec3d sum(0.0);
            for (int i = 0; i < side * side; ++i)
                sum += radiance(panoramaDirection((x + (i % side + 0.5) / side) / panorama.width,
                                                  (y + (i / side + 0.5) / side) / panorama.height));
            panorama.texels[static_cast<size_t>(y) * static_cast<size_t>(panorama.width) +
                            static_cast<size_t>(x)] += Vec3f(sum / double(side * side));
        }
    });
}

Panorama blackPanorama(int width)
{
    return {width, width / 2, std::vector<Vec3f>(size_t(width) * size_t(width / 2), Vec3f(0.0f))};
}

/// Of the sun in a direction, over that of its middle.
double sunDisc(const Vec3d& direction, double radius)
{
    // Chords keep the digits that cosines of small angles lose.
    const double r = glm::distance(direction, kToSun) / (2.0 * std::sin(0.5 * radius));
    return r < 1.0 ? 1.0 - kLimb * (1.0 - std::sqrt(1.0 - r * r)) : 0.0;
}

/// Adds a sun of an irradiance, however the texels lie to it.
void addSun(Panorama& panorama, const Vec3d& irradiance)
{
    const double radius = std::max(kSunRadius, kSunTexels * 2.0 * kPi / panorama.width);
    Panorama sun = blackPanorama(panorama.width);
    addRadiance(sun, 0, panorama.height / 2, kSunSamples,
                [&](const Vec3d& w) { return Vec3d(sunDisc(w, radius)); });
    double energy = 0.0;
    for (int y = 0; y < panorama.height / 2; ++y)
        for (int x = 0; x < panorama.width; ++x)
            energy += texelSolidAngle(sun, y) * double(sun.texel(x, y).x);
    for (size_t i = 0; i < sun.texels.size(); ++i)
        panorama.texels[i] += Vec3f(Vec3d(sun.texels[i]) * irradiance / energy);
}

/// The lower half: a matt ground under the upper one.
void addGround(Panorama& panorama)
{
    const Vec3f ground(upwardIrradiance(panorama) * (kGroundAlbedo / kPi));
    const auto first = static_cast<std::ptrdiff_t>(panorama.height / 2 * panorama.width);
    std::fill(panorama.texels.begin() + first, panorama.texels.end(), ground);
}

Panorama unscaled(const std::string& name, int width)
{
    Panorama panorama = blackPanorama(width);
    const int horizon = panorama.height / 2;
    if (name == "studio") {
        addRadiance(panorama, 0, panorama.height, kSkySamples, studioRadiance);
    } else if (name == "overcast") {
        addRadiance(panorama, 0, horizon, kSkySamples,
                    [](const Vec3d& w) { return Vec3d(overcastLuminance(w)); });
        addGround(panorama);
    } else {
        const ClearSky sky{kToSun, 3.0};
        addRadiance(panorama, 0, horizon, kSkySamples,
                    [&](const Vec3d& w) { return sky.radiance(w); });
        addSun(panorama, sky.sunIrradiance());
        addGround(panorama);
    }
    return panorama;
}

}  // namespace

double overcastLuminance(const Vec3d& direction)
{
    return (1.0 + 2.0 * direction.y) / 3.0;  // Moon and Spencer 1942
}

std::vector<std::string> proceduralEnvironments()
{
    return {std::begin(kNames), std::end(kNames)};
}

bool isProceduralEnvironment(const std::string& name)
{
    return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

Panorama proceduralEnvironment(const std::string& name, int width)
{
    if (!isProceduralEnvironment(name))
        throw Error(ErrorKind::usage, "environment",
                    Found("\"" + name + "\"").expected("studio, overcast or clear"));
    if (width < 4 || width > kMostWidth || width % 4 != 0)
        throw Error(ErrorKind::usage, "environment",
                    Found("a width of " + std::to_string(width))
                        .expected("a multiple of 4 up to " + std::to_string(kMostWidth)));
    Panorama panorama = unscaled(name, width);
    const double scale = kPi / glm::dot(kLuminanceOf, upwardIrradiance(panorama));
    for (Vec3f& texel : panorama.texels) texel = Vec3f(scale * Vec3d(texel));
    return panorama;
}

}  // namespace fbrdf
