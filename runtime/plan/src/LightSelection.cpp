#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/LightSelection.h>

#include <algorithm>
#include <utility>

namespace fbrdf {

namespace {

/// False when the cone of a spot misses the sphere by more than a small margin.
bool isAimedAt(const Light& light, const Sphere& bounds)
{
    if (light.type != Light::Type::spot) return true;
    const Vec3d toCentre = Vec3d(bounds.centre) - Vec3d(light.position);
    const double distance = glm::length(toCentre), radius = static_cast<double>(bounds.radius);
    if (!(distance > radius)) return true;
    const double cosine = glm::dot(glm::normalize(Vec3d(light.axis)), toCentre) / distance,
                 angle = std::acos(std::clamp(cosine, -1.0, 1.0)),
                 // 1e-3 radians exceed the least width of a cone's edge (Cone, Light.h).
        margin = std::asin(radius / distance) + 1e-3;
    return angle - margin <= static_cast<double>(light.outerAngle);
}

/// The factor of the intensity at the nearest point of the sphere.
double strongestFactor(const Light& light, const Sphere& bounds)
{
    if (light.type == Light::Type::directional) return 1.0;
    if (!isAimedAt(light, bounds)) return 0.0;
    const double distance = std::max(
        0.0, glm::distance(Vec3d(light.position), Vec3d(bounds.centre)) - double(bounds.radius));
    return falloff(distance * distance, double(light.radius));
}

/// True where no point of the sphere, whose centre sees the light's centre along toLight, is in
/// front of a flat light that shines from one side.
bool isBehind(const AreaLight& light, const Vec3d& toLight, double radius)
{
    const bool isFlat =
        light.shape != AreaLight::Shape::sphere && light.shape != AreaLight::Shape::tube;
    if (!isFlat || light.twoSided) return false;
    // 1e-5: of what rounding leaves of corners in a plane.
    return glm::dot(normalOf(light), -toLight) < -radius - 1e-5 * extentOf(light);
}

template <class AnyLight, class IsValid>
LightSelection selected(const std::vector<AnyLight>& lights, const Sphere& bounds, int most,
                        IsValid isValidLight)
{
    LightSelection selection;
    std::vector<std::pair<double, int>> reaching;
    for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
        FBRDF_ASSERT(isValidLight(lights[static_cast<size_t>(i)]), ==, true);
        const double irradiance = strongestIrradiance(lights[static_cast<size_t>(i)], bounds);
        if (irradiance != 0.0)
            reaching.emplace_back(-irradiance, i);
        else
            ++selection.culled;
    }
    if (most > 0) std::sort(reaching.begin(), reaching.end());  // by index where they tie
    if (most > 0 && reaching.size() > static_cast<size_t>(most)) {
        selection.dropped = static_cast<int>(reaching.size()) - most;
        reaching.resize(static_cast<size_t>(most));
    }
    for (const auto& [irradiance, index] : reaching) selection.lights.push_back(index);
    return selection;
}

}  // namespace

double strongestIrradiance(const Light& light, const Sphere& bounds)
{
    const double mean = glm::dot(Vec3d(light.intensity), Vec3d(1.0)) / 3.0;
    return mean * strongestFactor(light, bounds);
}

double largestIrradiance(const Light& light, const Sphere& bounds)
{
    const Vec3d channels(light.intensity);
    return std::max({0.0, channels.x, channels.y, channels.z}) * strongestFactor(light, bounds);
}

double strongestIrradiance(const AreaLight& light, const Sphere& bounds)
{
    const Vec3d toLight = centreOf(light) - Vec3d(bounds.centre);
    const double distance = glm::length(toLight), radius = double(bounds.radius),
                 extent = extentOf(light), nearest = std::max(0.0, distance - radius);
    const double window =
        influenceWindow(nearest * nearest, inverseRadiusSquared(static_cast<double>(light.radius)));
    if (isBehind(light, toLight, radius)) return 0.0;
    // A sphere that fills the sine s of an angle causes pi s^2.
    const double sine = nearest > extent ? extent / nearest : 1.0;
    const double mean = glm::dot(Vec3d(light.radiance), Vec3d(1.0)) / 3.0;
    return mean * kPi * sine * sine * window;
}

LightSelection selectLights(const std::vector<Light>& lights, const Sphere& bounds, int most)
{
    return selected(lights, bounds, most, [](const Light& light) { return isValid(light); });
}

LightSelection selectLights(const std::vector<AreaLight>& lights, const Sphere& bounds, int most)
{
    return selected(lights, bounds, most,
                    [](const AreaLight& light) { return whyInvalid(light).empty(); });
}

}  // namespace fbrdf
