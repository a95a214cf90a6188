// Shading.h - points of instances in world space, where they are seen from, and what lights without
// a shape send there: what every renderer on the CPU begins with.
#pragma once
#include <fbrdf/plan/Light.h>
#include <fbrdf/scene/Raster.h>

namespace fbrdf::scene {

/// A point to shade, world space; directions need not be unit.
struct SurfacePoint {
    Vec3d position, normal, tangent;
};

/// Takes points of one instance from object to world space.
class ToWorld {
public:
    explicit ToWorld(const glm::mat4& model);
    SurfacePoint operator()(const SurfacePoint& object) const;

private:
    glm::dmat4 model_;
    glm::dmat3 normals_;
};

/// Corner i of a mesh in object space; the tangent is 0 where the mesh has none.
SurfacePoint cornerOf(const Mesh& mesh, size_t i);
/// The point of an instance that a fragment of it is, in world space.
SurfacePoint surfacePoint(const Mesh& mesh, const ToWorld& toWorld, const Fragment& fragment);

/// The eye; for a parallel projection, which has none, the direction towards it.
class Eye {
public:
    explicit Eye(const gl::View& view);
    /// Unit, world space.
    Vec3d directionFrom(const Vec3d& position) const;

private:
    glm::dmat4 toWorld_;
    bool parallel_;
};

/// What arrives at a point of one light.
struct Incident {
    Vec3d direction;   ///< to the light, unit
    Vec3d irradiance;  ///< on a surface that faces it
    double distance;   ///< infinite for a directional light
};
Incident incidentFrom(const Light& light, const Vec3d& position);

}  // namespace fbrdf::scene
