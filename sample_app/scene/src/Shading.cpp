#include <fbrdf/scene/Shading.h>

#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace fbrdf::scene {

ToWorld::ToWorld(const glm::mat4& model)
    : model_(model), normals_(glm::transpose(glm::inverse(glm::dmat3(model_))))
{
}

SurfacePoint ToWorld::operator()(const SurfacePoint& object) const
{
    return {Vec3d(model_ * glm::dvec4(object.position, 1.0)), normals_ * object.normal,
            glm::dmat3(model_) * object.tangent};
}

SurfacePoint cornerOf(const Mesh& mesh, size_t i)
{
    return {Vec3d(mesh.positions[i]), Vec3d(mesh.normals[i]),
            mesh.tangents.empty() ? Vec3d(0.0) : Vec3d(mesh.tangents[i])};
}

SurfacePoint surfacePoint(const Mesh& mesh, const ToWorld& toWorld, const Fragment& fragment)
{
    return toWorld(
        {interpolate<Vec3d>(mesh.positions, mesh, fragment),
         interpolate<Vec3d>(mesh.normals, mesh, fragment),
         mesh.tangents.empty() ? Vec3d(0.0) : interpolate<Vec3d>(mesh.tangents, mesh, fragment)});
}

Eye::Eye(const gl::View& view)
    : toWorld_(glm::inverse(glm::dmat4(view.view))),
      // The last row of a perspective is (0, 0, -1, 0), of a parallel projection (0, 0, 0, 1).
      parallel_(view.projection[3][3] != 0.0f)
{
}

Vec3d Eye::directionFrom(const Vec3d& position) const
{
    return glm::normalize(parallel_ ? Vec3d(toWorld_[2]) : Vec3d(toWorld_[3]) - position);
}

Incident incidentFrom(const Light& light, const Vec3d& position)
{
    const Vec3d where(light.position), intensity(light.intensity);
    if (light.type == Light::Type::directional)
        return {glm::normalize(where), intensity, std::numeric_limits<double>::infinity()};
    const Vec3d toLight = where - position;
    const double distance2 = glm::dot(toLight, toLight), distance = std::sqrt(distance2);
    const Vec3d direction = toLight / distance;
    return {direction,
            intensity *
                (falloff<double>(distance2, double(light.radius)) * coneFactor(light, direction)),
            distance};
}

}  // namespace fbrdf::scene
