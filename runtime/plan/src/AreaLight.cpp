#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Triangulate.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace fbrdf {
namespace {

using Shape = AreaLight::Shape;

// Of the light's extent: corners of a polygon are read from text, and need not be exact.
constexpr double kFlat = 1e-3;

bool allFinite(std::initializer_list<Vec3f> vectors)
{
    return std::all_of(vectors.begin(), vectors.end(), [](const Vec3f& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    });
}

bool hasSize(Shape shape)
{
    return shape == Shape::sphere || shape == Shape::disc || shape == Shape::tube;
}

std::vector<Vec3d> corners(const AreaLight& light)
{
    return {light.vertices.begin(), light.vertices.end()};
}

std::string whyInvalidPolygon(const AreaLight& light)
{
    const size_t count = light.vertices.size();
    if (count < 3 || count > static_cast<size_t>(kMostVertices))
        return "vertices: " +
               Found(std::to_string(count)).expected("3 to " + std::to_string(kMostVertices));
    for (const Vec3f& vertex : light.vertices)
        if (!allFinite({vertex}))
            return "vertices: " + Found("a number that is none").expected("finite ones");
    const Vec3d area = vectorArea(corners(light));
    const double extent = extentOf(light), size = glm::length(area);
    // 1e-12: what rounding leaves of the area of corners on a line.
    if (!(size > 1e-12 * extent * extent))
        return "vertices: " + Found("corners on one line").expected("a polygon with an area");
    const Vec3d centre = centreOf(light);
    for (const Vec3f& vertex : light.vertices)
        if (std::abs(glm::dot(Vec3d(vertex) - centre, area / size)) > kFlat * extent)
            return "vertices: " +
                   Found("corners that are not in one plane").expected("a flat polygon");
    return "";
}

}  // namespace

const char* shapeName(Shape shape)
{
    switch (shape) {
        case Shape::sphere: return "sphere";
        case Shape::disc: return "disc";
        case Shape::rectangle: return "rectangle";
        case Shape::tube: return "tube";
        case Shape::polygon: return "polygon";
    }
    return "";
}

std::string whyInvalid(const AreaLight& light)
{
    if (!allFinite({light.position, light.end, light.normal, light.axisU, light.axisV}))
        return "position: " + Found("a number that is none").expected("finite ones");
    if (!allFinite({light.radiance}) || light.radiance.x < 0.0f || light.radiance.y < 0.0f ||
        light.radiance.z < 0.0f)
        return "radiance: " + Found("a negative number or none").expected("three finite ones >= 0");
    if (!std::isfinite(light.radius) || light.radius < 0.0f)
        return "radius: " +
               Found(numberText(double(light.radius))).expected("a finite number >= 0");
    // The negation also refuses a size that is not a number.
    if (hasSize(light.shape) && !(light.size > 0.0f && std::isfinite(light.size)))
        return "size: " + Found(numberText(double(light.size))).expected("a finite number > 0");
    if (light.shape == Shape::disc && light.normal == Vec3f(0.0f))
        return "normal: " + Found("a vector of length 0").expected("a direction");
    if (light.shape == Shape::rectangle) {
        const Vec3d u(light.axisU), v(light.axisV);
        if (!(glm::length(glm::cross(u, v)) > 1e-12 * glm::length(u) * glm::length(v)))
            return "axis_u, axis_v: " +
                   Found("vectors on one line or of length 0").expected("the sides of a rectangle");
    }
    return light.shape == Shape::polygon ? whyInvalidPolygon(light) : "";
}

Vec3d centreOf(const AreaLight& light)
{
    if (light.shape == Shape::tube) return 0.5 * (Vec3d(light.position) + Vec3d(light.end));
    if (light.shape != Shape::polygon) return Vec3d(light.position);
    Vec3d low(light.vertices.front()), high = low;
    for (const Vec3f& vertex : light.vertices) {
        low = glm::min(low, Vec3d(vertex));
        high = glm::max(high, Vec3d(vertex));
    }
    return 0.5 * (low + high);
}

Vec3d normalOf(const AreaLight& light)
{
    if (light.shape == Shape::disc) return glm::normalize(Vec3d(light.normal));
    if (light.shape == Shape::rectangle)
        return glm::normalize(glm::cross(Vec3d(light.axisU), Vec3d(light.axisV)));
    return glm::normalize(vectorArea(corners(light)));
}

double extentOf(const AreaLight& light)
{
    const auto size = static_cast<double>(light.size);
    const Vec3d u(light.axisU), v(light.axisV), centre = centreOf(light);
    double extent = 0.0;
    switch (light.shape) {
        case Shape::sphere:
        case Shape::disc: return size;
        case Shape::rectangle: return std::max(glm::length(u + v), glm::length(u - v));
        case Shape::tube: return size + glm::distance(Vec3d(light.end), centre);
        case Shape::polygon:
            for (const Vec3f& vertex : light.vertices)
                extent = std::max(extent, glm::distance(Vec3d(vertex), centre));
    }
    return extent;
}

}  // namespace fbrdf
