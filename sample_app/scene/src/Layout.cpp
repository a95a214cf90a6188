#include <fbrdf/scene/Layout.h>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr float kSpacing = 2.15f;     ///< between neighbours, in radii: nearly touching
constexpr float kSceneRadius = 1.2f;  ///< that makeLights was made for

std::vector<Bounds> ballsOf(const std::vector<Instance>& instances)
{
    std::vector<Bounds> balls;
    for (const Instance& instance : instances) {
        Bounds ball = boundsOf(*instance.mesh);
        ball.centre = Vec3f(instance.model * glm::vec4(ball.centre, 1.0f));
        balls.push_back(ball);
    }
    return balls;
}

/// Distance before the ball's centre from which it just fits: the eye and the plane through it at
/// `halfAngle` off the axis, which touches the ball.
double fittingDistance(double aside, double radius, double halfAngle)
{
    return (radius + std::abs(aside) * std::cos(halfAngle)) / std::sin(halfAngle);
}

}  // namespace

std::vector<Instance> arranged(const Mesh& mesh, int materials, double aspect)
{
    const int columns = std::clamp(static_cast<int>(std::lround(std::sqrt(materials * aspect))), 1,
                                   std::max(1, materials));
    const int rows = (materials + columns - 1) / columns;
    const float step = kSpacing * boundsOf(mesh).radius;
    std::vector<Instance> instances;
    for (int i = 0; i < materials; ++i) {
        Instance instance;
        instance.mesh = &mesh;
        instance.material = i;
        const int inRow = std::min(columns, materials - i / columns * columns);
        const float right = static_cast<float>(i % columns) - 0.5f * static_cast<float>(inRow - 1);
        const float down = static_cast<float>(i / columns) - 0.5f * static_cast<float>(rows - 1);
        instance.model[3] = glm::vec4(step * right, -step * down, 0.0f, 1.0f);
        instances.push_back(instance);
    }
    return instances;
}

Instance turned(Instance instance, double angle)
{
    const Vec3f centre = boundsOf(*instance.mesh).centre;
    const glm::mat4 placed = glm::translate(instance.model, centre);
    instance.model = glm::translate(
        glm::rotate(placed, static_cast<float>(angle), Vec3f(0.0f, 1.0f, 0.0f)), -centre);
    return instance;
}

Bounds boundsOf(const std::vector<Instance>& instances)
{
    const std::vector<Bounds> balls = ballsOf(instances);
    if (balls.empty()) return {};
    Vec3f low = balls.front().centre, high = low;
    for (const Bounds& ball : balls) {
        low = glm::min(low, ball.centre);
        high = glm::max(high, ball.centre);
    }
    Bounds all{0.5f * (low + high), 0.0f};
    for (const Bounds& ball : balls)
        all.radius = std::max(all.radius, glm::distance(all.centre, ball.centre) + ball.radius);
    return all;
}

Camera facing(const std::vector<Instance>& instances, double aspect)
{
    Camera camera;
    camera.centre = Vec3d(boundsOf(instances).centre);
    const double halfHeight = 0.5 * camera.fovy;
    const double halfWidth = std::atan(std::tan(halfHeight) * aspect);
    double depth = 0.0;
    for (const Bounds& ball : ballsOf(instances)) {
        const Vec3d offset = Vec3d(ball.centre) - camera.centre;
        const double radius = std::max(1e-6, double(ball.radius));
        depth = std::max({depth, offset.z + fittingDistance(offset.x, radius, halfWidth),
                          offset.z + fittingDistance(offset.y, radius, halfHeight)});
    }
    camera.eye = camera.centre + Vec3d(0.0, 0.0, std::max(depth, 1e-6));
    return camera;
}

std::vector<Light> spreadAround(std::vector<Light> lights, const Bounds& bounds)
{
    // The scene must lie inside the innermost shell of lights, which were made around the origin.
    const float reach = glm::length(bounds.centre) + bounds.radius;
    if (reach <= kSceneRadius) return lights;
    const float scale = bounds.radius / kSceneRadius;
    for (Light& light : lights) {
        light.position = bounds.centre + scale * light.position;
        light.intensity *= scale * scale;
        light.radius *= scale;
    }
    return lights;
}

}  // namespace fbrdf::scene
