// AreaShapes.h - a light of every shape, and which directions one covers, by tracing rays:
// independent of outlines.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Triangulate.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

/// Above the origin, in nobody's plane.
inline AreaLight ofShape(AreaLight::Shape shape)
{
    AreaLight light;
    light.shape = shape;
    light.position = {0.3f, 0.2f, 1.5f};
    light.end = {1.2f, -0.4f, 1.1f};
    light.size = 0.4f;
    light.normal = {-0.3f, 0.1f, -1.0f};
    light.axisU = {0.1f, 0.5f, 0.1f};
    light.axisV = {0.7f, 0.0f, 0.2f};
    light.vertices = {{0, 0, 1.5f},
                      {0.2f, 0.9f, 1.5f},
                      {0.9f, 0.9f, 1.5f},
                      {0.9f, 0.2f, 1.5f},
                      {0.5f, 0.5f, 1.5f}};
    return light;
}

inline bool hitsSphere(const Vec3d& centre, double radius, const Vec3d& w)
{
    const double along = glm::dot(centre, w), c2 = glm::dot(centre, centre);
    return c2 <= radius * radius || (along > 0.0 && c2 - along * along <= radius * radius);
}

/// The ray from 0 along w passes the segment from a to b within the radius: the smallest distance
/// between the two, searched because it is unimodal along the segment.
inline bool hitsTube(const Vec3d& a, const Vec3d& b, double radius, const Vec3d& w)
{
    const auto distance2 = [&](double t) {
        const Vec3d p = a + t * (b - a);
        const double along = std::max(0.0, glm::dot(p, w));
        return glm::dot(p - along * w, p - along * w);
    };
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 40; ++i) {
        const double third = (high - low) / 3.0;
        (distance2(low + third) < distance2(high - third) ? high : low) +=
            distance2(low + third) < distance2(high - third) ? -third : third;
    }
    return distance2(0.5 * (low + high)) <= radius * radius;
}

/// Even-odd rule in the plane of the polygon.
inline bool isInside(const std::vector<Vec3d>& corners, const Vec3d& normal, const Vec3d& p)
{
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    bool inside = false;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
        if ((a[y] > p[y]) != (b[y] > p[y]) &&
            p[x] < a[x] + (b[x] - a[x]) * (p[y] - a[y]) / (b[y] - a[y]))
            inside = !inside;
    }
    return inside;
}

/// True where the ray from `point` along w meets the side that shines.
inline bool covers(const AreaLight& light, const Vec3d& point, const Vec3d& w)
{
    using Shape = AreaLight::Shape;
    const Vec3d a = Vec3d(light.position) - point, b = Vec3d(light.end) - point;
    const double size = double(light.size);
    if (light.shape == Shape::sphere) return hitsSphere(a, size, w);
    if (light.shape == Shape::tube) return hitsTube(a, b, size, w);
    std::vector<Vec3d> corners;
    const Vec3d u(light.axisU), v(light.axisV);
    if (light.shape == Shape::rectangle) corners = {a - u - v, a + u - v, a + u + v, a - u + v};
    if (light.shape == Shape::polygon)
        for (const Vec3f& vertex : light.vertices) corners.push_back(Vec3d(vertex) - point);
    const Vec3d normal = light.shape == Shape::disc ? Vec3d(light.normal) : vectorArea(corners);
    const double facing = -glm::dot(normal, w);
    if (facing == 0.0 || (facing < 0.0 && !light.twoSided)) return false;
    const Vec3d onPlane = light.shape == Shape::disc ? a : corners[0];
    const double distance = glm::dot(normal, onPlane) / glm::dot(normal, w);
    if (distance <= 0.0) return false;
    const Vec3d hit = distance * w;
    if (light.shape == Shape::disc) return glm::distance(hit, a) <= size;
    return isInside(corners, normal, hit);
}

}  // namespace fbrdf
