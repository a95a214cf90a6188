#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/scene/KeyLights.h>
#include <fbrdf/scene/Shading.h>
#include <fbrdf/scene/SubPixels.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

Light farLight(const Vec3f& direction, const Vec3f& irradiance)
{
    Light light;
    light.type = Light::Type::directional;
    light.position = direction;
    light.intensity = irradiance;
    return light;
}

/// A point of the unit disc; that of sample 0 is its middle.
Vec2<double> discPoint(int sample)
{
    // Shirley, Chiu 1997, "A Low Distortion Map Between Disk and Square".
    const Vec2<double> p = 2.0 * subPixel(sample);
    if (p.x == 0.0 && p.y == 0.0) return p;
    const bool isWide = std::abs(p.x) > std::abs(p.y);
    const double radius = isWide ? p.x : p.y;
    const double angle = isWide ? 0.25 * kPi * p.y / p.x : 0.5 * kPi - 0.25 * kPi * p.x / p.y;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

Light movedOnDisc(Light light, const Vec3d& target, int sample)
{
    const bool isFar = light.type == Light::Type::directional;
    const Vec3d away = isFar ? Vec3d(light.position) : Vec3d(light.position) - target;
    const double radius = std::tan(kShadowSoftness) * glm::length(away);
    const auto axes = axesAbout(glm::normalize(away));
    const Vec2<double> place = discPoint(sample);
    light.position += Vec3f(radius * (place.x * axes[0] + place.y * axes[1]));
    return light;
}

}  // namespace

std::vector<ShadowedLight> shadowedLights(const std::vector<Light>& lights, const Bounds& objects,
                                          int sample)
{
    const Vec3d centre(objects.centre);
    std::vector<std::pair<double, int>> found;
    for (size_t i = 0; i < lights.size(); ++i) {
        if (!isValid(lights[i])) continue;
        const Incident incident = incidentFrom(lights[i], centre);
        const double sent = incident.irradiance.x + incident.irradiance.y + incident.irradiance.z;
        // A light needs some distance, or its view of the ball would be half a sphere wide.
        const bool isOutside = incident.distance > 1.1 * static_cast<double>(objects.radius);
        if (sent > 0.0 && isOutside) found.emplace_back(-sent, static_cast<int>(i));
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min<size_t>(found.size(), kMostShadowed));
    std::vector<ShadowedLight> shadowed;
    for (const auto& [sent, place] : found)
        shadowed.push_back(
            {place, movedOnDisc(lights[static_cast<size_t>(place)], centre, sample)});
    return shadowed;
}

std::vector<Light> keyLights()
{
    return {farLight({0.55f, 0.85f, 0.65f}, {3.2f, 3.05f, 2.85f}),
            farLight({-0.7f, 0.6f, -0.6f}, {1.75f, 1.8f, 1.9f})};
}

}  // namespace fbrdf::scene
