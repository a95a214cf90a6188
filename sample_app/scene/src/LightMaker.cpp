#include <fbrdf/scene/Lights.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fbrdf::scene {
namespace {

// Irradiance of all lights at the origin if each faced the surface: pi, so that a white wall
// towards a single light is just white at exposure 1.
constexpr double kTotalIrradiance = kPi;
constexpr double kKeyShare = 0.5;  ///< of the total, when there are others
const Vec3d kKeyDirection = glm::normalize(Vec3d(0.55, 0.65, 0.75));
const Vec3d kKeyColor(1.0, 0.95, 0.88);
constexpr double kKeyDistance = 4.0, kNearest = 3.0, kFarthest = 6.0;
constexpr double kSaturation = 0.28;
// Steps of the additive recurrence in two dimensions: 1/g, 1/g^2 with g^3 = g + 1 (Roberts 2018,
// "The Unreasonable Effectiveness of Quasirandom Sequences"); the golden ratio for the hue.
constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;
constexpr double kGolden = 0.6180339887498949;

double fraction(double x)
{
    return x - std::floor(x);
}

/// In [0, 1); std::uniform_real_distribution may differ between libraries, the engine may not.
double uniform(std::mt19937& engine)
{
    return static_cast<double>(engine()) / 4294967296.0;
}

/// Soft colours around the hue circle, of mean 1.
Vec3d colorOfHue(double hue)
{
    Vec3d color;
    for (int k = 0; k < 3; ++k)
        color[k] = 1.0 + kSaturation * std::cos(2.0 * kPi * (hue - k / 3.0));
    return color;
}

/// Two of three in front (+z), from 20 degrees below the horizon to the zenith.
Vec3d directionOf(double x, double y)
{
    const double azimuth = kPi * (x < 2.0 / 3.0 ? 1.5 * x - 0.5 : 3.0 * x - 1.5);
    const double height = -0.35 + 1.35 * y;
    const double level = std::sqrt(std::max(0.0, 1.0 - height * height));
    return {level * std::sin(azimuth), height, level * std::cos(azimuth)};
}

Light pointLight(const Vec3d& direction, double distance, const Vec3d& color, double irradiance)
{
    Light light;
    light.position = Vec3f(distance * direction);
    light.intensity = Vec3f(irradiance * distance * distance * color);
    return light;
}

}  // namespace

std::vector<Light> makeLights(int count, uint32_t seed)
{
    std::vector<Light> lights;
    if (count <= 0) return lights;
    const double keyIrradiance = kTotalIrradiance * (count == 1 ? 1.0 : kKeyShare);
    lights.push_back(pointLight(kKeyDirection, kKeyDistance, kKeyColor, keyIrradiance));
    std::mt19937 engine(seed);
    const double x0 = uniform(engine), y0 = uniform(engine), hue0 = uniform(engine);
    const double share = kTotalIrradiance * (1.0 - kKeyShare) / std::max(1, count - 1);
    for (int i = 1; i < count; ++i) {
        const Vec3d direction = directionOf(fraction(x0 + i * kStepX), fraction(y0 + i * kStepY));
        const double distance = kNearest + (kFarthest - kNearest) * uniform(engine);
        const double hue = fraction(hue0 + i * kGolden);
        lights.push_back(pointLight(direction, distance, colorOfHue(hue), share));
    }
    return lights;
}

}  // namespace fbrdf::scene
