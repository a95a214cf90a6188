#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/LightVectors.h>

#include <glm/geometric.hpp>

namespace fbrdf {
namespace {

glm::dvec4 unitDirection(const glm::dmat4& toEye, const Vec3f& direction)
{
    const glm::dvec4 moved = toEye * glm::dvec4(Vec3d(direction), 0.0);
    return {glm::normalize(Vec3d(moved)), 0.0};
}

glm::dvec4 positionVector(const Light& light, const glm::dmat4& toEye)
{
    if (light.type == Light::Type::directional) return unitDirection(toEye, light.position);
    return toEye * glm::dvec4(Vec3d(light.position), 1.0);
}

// A directional light has no window; its distance is 1.
double inverseReachSquared(const Light& light)
{
    return light.type == Light::Type::directional
               ? 0.0
               : inverseRadiusSquared(static_cast<double>(light.radius));
}

}  // namespace

LightVectors lightVectors(const Light& light, const glm::dmat4& toEye)
{
    FBRDF_ASSERT(isValid(light), ==, true);
    const Cone cone = coneOf(light);
    glm::dvec4 axis(0.0);
    if (cone.scale != 0.0) axis = cone.scale * unitDirection(toEye, light.axis);
    const glm::dvec4 position = positionVector(light, toEye);
    return {glm::vec4(glm::dvec4(Vec3d(position), inverseReachSquared(light))),
            glm::vec4(light.intensity, static_cast<float>(position.w)),
            glm::vec4(glm::dvec4(Vec3d(axis), cone.offset))};
}

}  // namespace fbrdf
