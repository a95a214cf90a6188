#include <fbrdf/scene/LightEdit.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr std::array<const char*, kLightKinds> kKindNames{
    "point", "spot", "directional", "sphere", "disc", "rectangle", "tube", "polygon"};
constexpr int kKindsWithoutShape = 3;
// Radii of the objects at which directional lights are shown, and lights are added: in sight of a
// camera that the objects fill.
constexpr double kStandFor = 1.5, kDistance = 1.56;
constexpr double kIrradiance = 3.0;  // that a light sends: as the key lights (KeyLights.h)
constexpr double kSize = 0.35;       // of shapes, in radii
constexpr float kInnerCone = 0.25f, kOuterCone = 0.4f;  // radians

double radiusOf(const Bounds& objects)
{
    return objects.radius > 0.0f ? static_cast<double>(objects.radius) : 1.0;
}

AreaLight& areaOf(LightSet& set, int index)
{
    return set.areaLights[static_cast<size_t>(index) - set.lights.size()];
}

bool hasShape(const LightSet& set, int index)
{
    return index >= static_cast<int>(set.lights.size());
}

/// Solid angle times cosine at the objects of a shape that faces them: what its radiance causes.
double shareOf(LightKind kind, double size, double distance)
{
    const double ratio = size / distance;
    switch (kind) {
        case LightKind::rectangle:
        case LightKind::polygon: return 4.0 * ratio * ratio;
        case LightKind::tube: return 4.0 * 0.25 * ratio * ratio;
        default: return kPi * ratio * ratio;
    }
}

void shape(AreaLight& light, LightKind kind, const Vec3d& place, const Vec3d& towards, double size)
{
    const Vec3d side = glm::normalize(glm::cross(
        std::abs(towards.y) > 0.99 ? Vec3d(0.0, 0.0, 1.0) : Vec3d(0.0, 1.0, 0.0), towards));
    const Vec3d up = glm::cross(towards, side);
    light.shape = static_cast<AreaLight::Shape>(static_cast<int>(kind) - kKindsWithoutShape);
    light.position = Vec3f(place);
    light.size = static_cast<float>(size);
    light.normal = Vec3f(towards);
    light.axisU = Vec3f(size * side);
    light.axisV = Vec3f(size * up);
    if (kind == LightKind::tube) {
        light.position = Vec3f(place - size * side);
        light.end = Vec3f(place + size * side);
        light.size = static_cast<float>(0.25 * size);
    }
    if (kind == LightKind::polygon)
        for (const auto& [u, v] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
            light.vertices.emplace_back(place + size * (u * side + v * up));
}

/// Applies a motion of points and one of directions to a light.
template <class Point, class Direction>
void move(Light& light, const Point& point, const Direction& direction)
{
    light.position =
        light.type == Light::Type::directional ? direction(light.position) : point(light.position);
    light.axis = direction(light.axis);
}

template <class Point, class Direction>
void move(AreaLight& light, const Point& point, const Direction& direction)
{
    light.position = point(light.position);
    light.end = point(light.end);
    light.normal = direction(light.normal);
    light.axisU = direction(light.axisU);
    light.axisV = direction(light.axisV);
    for (Vec3f& vertex : light.vertices) vertex = point(vertex);
}

}  // namespace

const char* lightKindName(LightKind kind)
{
    return kKindNames[static_cast<size_t>(kind)];
}

LightKind kindOf(const LightSet& set, int index)
{
    if (hasShape(set, index)) {
        const AreaLight& light = set.areaLights[static_cast<size_t>(index) - set.lights.size()];
        return static_cast<LightKind>(static_cast<int>(light.shape) + kKindsWithoutShape);
    }
    switch (set.lights[static_cast<size_t>(index)].type) {
        case Light::Type::spot: return LightKind::spot;
        case Light::Type::directional: return LightKind::directional;
        case Light::Type::point: break;
    }
    return LightKind::point;
}

Vec3d placeOf(const LightSet& set, int index, const Bounds& objects)
{
    if (hasShape(set, index))
        return centreOf(set.areaLights[static_cast<size_t>(index) - set.lights.size()]);
    const Light& light = set.lights[static_cast<size_t>(index)];
    const Vec3d place(light.position);
    if (light.type != Light::Type::directional) return place;
    const double length = glm::length(place);
    if (!(length > 0.0)) return Vec3d(objects.centre);
    return Vec3d(objects.centre) + kStandFor * radiusOf(objects) / length * place;
}

void moveLight(LightSet& set, int index, const Vec3d& place, const Bounds& objects)
{
    const Vec3d moved = place - placeOf(set, index, objects);
    const auto shift = [&moved](const Vec3f& point) { return Vec3f(Vec3d(point) + moved); };
    const auto stay = [](const Vec3f& direction) { return direction; };
    if (hasShape(set, index)) return move(areaOf(set, index), shift, stay);
    Light& light = set.lights[static_cast<size_t>(index)];
    if (light.type != Light::Type::directional) return move(light, shift, stay);
    const Vec3d direction = place - Vec3d(objects.centre);
    const double length = glm::length(direction);
    if (length > 0.0) light.position = Vec3f(direction / length);
}

int addLight(LightSet& set, LightKind kind, const Camera& camera, const Bounds& objects)
{
    const Vec3d centre(objects.centre);
    const double distance = kDistance * radiusOf(objects), size = kSize * radiusOf(objects);
    // From above on the right, as seen by the camera.
    const Vec3d back = glm::normalize(camera.eye - camera.centre);
    const Vec3d right = std::abs(back.y) > 0.999
                            ? Vec3d(1.0, 0.0, 0.0)
                            : glm::normalize(glm::cross(Vec3d(0.0, 1.0, 0.0), back));
    const Vec3d from = glm::normalize(back + 0.85 * right + 0.85 * glm::cross(back, right));
    const Vec3d place = centre + distance * from;
    if (static_cast<int>(kind) >= kKindsWithoutShape) {
        AreaLight light;
        shape(light, kind, place, -from, size);
        light.radiance = Vec3f(static_cast<float>(kIrradiance / shareOf(kind, size, distance)));
        set.areaLights.push_back(light);
        return static_cast<int>(set.size()) - 1;
    }
    Light light;
    light.position = Vec3f(place);
    light.intensity = Vec3f(static_cast<float>(kIrradiance * distance * distance));
    if (kind == LightKind::spot) {
        light.type = Light::Type::spot;
        light.axis = Vec3f(-from);
        light.innerAngle = kInnerCone;
        light.outerAngle = kOuterCone;
    } else if (kind == LightKind::directional) {
        light.type = Light::Type::directional;
        light.position = Vec3f(from);
        light.intensity = Vec3f(static_cast<float>(kIrradiance));
    }
    set.lights.push_back(light);
    return static_cast<int>(set.lights.size()) - 1;
}

void removeLight(LightSet& set, int index)
{
    if (hasShape(set, index))
        set.areaLights.erase(set.areaLights.begin() + index -
                             static_cast<std::ptrdiff_t>(set.lights.size()));
    else
        set.lights.erase(set.lights.begin() + index);
}

LightSet orbited(LightSet set, const Vec3d& centre, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turned = [c, s](const Vec3d& v) {
        return Vec3d(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
    };
    const auto point = [&](const Vec3f& v) { return Vec3f(centre + turned(Vec3d(v) - centre)); };
    const auto direction = [&](const Vec3f& v) { return Vec3f(turned(Vec3d(v))); };
    for (Light& light : set.lights) move(light, point, direction);
    for (AreaLight& light : set.areaLights) move(light, point, direction);
    return set;
}

Vec3f& colourOf(LightSet& set, int index)
{
    return hasShape(set, index) ? areaOf(set, index).radiance
                                : set.lights[static_cast<size_t>(index)].intensity;
}

std::optional<glm::dvec2> pixelOf(const Vec3d& place, const gl::View& view, int width, int height)
{
    const glm::dvec4 clip =
        glm::dmat4(view.projection) * glm::dmat4(view.view) * glm::dvec4(place, 1.0);
    if (!(clip.w > 1e-9)) return std::nullopt;
    return glm::dvec2(0.5 * (1.0 + clip.x / clip.w) * width,
                      0.5 * (1.0 - clip.y / clip.w) * height);
}

std::vector<LightHandle> handlesOf(const LightSet& set, const Bounds& objects, const gl::View& view,
                                   int width, int height)
{
    std::vector<LightHandle> handles;
    LightSet copy = set;
    for (int light = 0; light < static_cast<int>(set.size()); ++light) {
        const auto at = pixelOf(placeOf(set, light, objects), view, width, height);
        if (!at) continue;
        const Vec3f colour = colourOf(copy, light);
        const float largest = std::max({colour.x, colour.y, colour.z, 1e-6f});
        handles.push_back({light, *at, kindOf(set, light), colour / largest});
    }
    return handles;
}

int lightAt(const std::vector<LightHandle>& handles, const glm::dvec2& pixel, double radius)
{
    int nearest = -1;
    for (const LightHandle& handle : handles) {
        const double distance = glm::length(handle.at - pixel);
        if (distance > radius) continue;
        radius = distance;
        nearest = handle.light;
    }
    return nearest;
}

Vec3d draggedTo(const Vec3d& place, const glm::dvec2& pixel, const gl::View& view, int width,
                int height)
{
    const glm::dmat4 clipFromWorld = glm::dmat4(view.projection) * glm::dmat4(view.view);
    glm::dvec4 clip = clipFromWorld * glm::dvec4(place, 1.0);
    // The plane of all points that are as deep.
    clip.x = (2.0 * pixel.x / width - 1.0) * clip.w;
    clip.y = (1.0 - 2.0 * pixel.y / height) * clip.w;
    const glm::dvec4 moved = glm::inverse(clipFromWorld) * clip;
    return Vec3d(moved) / moved.w;
}

}  // namespace fbrdf::scene
