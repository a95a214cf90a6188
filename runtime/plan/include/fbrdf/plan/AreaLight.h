// AreaLight.h - a light with a shape: it sends the same radiance from each of its points into each
// direction of its side. Materials reflect it by their lobes (LobeTable.h).
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <string>
#include <vector>

namespace fbrdf {

struct AreaLight {
    enum class Shape { sphere, disc, rectangle, tube, polygon } shape = Shape::sphere;
    /// World space. Spheres, discs, rectangles: the centre. Tubes: one end of the axis.
    Vec3f position{0.0f};
    Vec3f end{0.0f, 1.0f, 0.0f};     ///< tubes: the other end; they end in half spheres around both
    float size = 0.5f;               ///< radius of spheres, discs and tubes, > 0
    Vec3f normal{0.0f, 0.0f, 1.0f};  ///< discs shine along it; not 0, need not be unit
    /// Rectangles: half of each side; they shine along axisU x axisV, which is not 0. They need not
    /// be perpendicular.
    Vec3f axisU{0.5f, 0.0f, 0.0f}, axisV{0.0f, 0.5f, 0.0f};
    /// Polygons: corners of a simple one in a plane, counterclockwise as seen from the side to
    /// which it shines. 3 to kMostVertices.
    std::vector<Vec3f> vertices = {};
    Vec3f radiance{1.0f};   ///< W/(sr m^2), at least 0
    bool twoSided = false;  ///< discs, rectangles, polygons: the other side shines as well
    /// Points farther from the centre (centreOf) are not lit: the light is windowed to 0 there, as
    /// a point light is (Light.h). 0: unlimited.
    float radius = 0.0f;
};
constexpr int kMostVertices = 256;
const char* shapeName(AreaLight::Shape shape);  ///< "sphere", ...

/// What is wrong with a light, "NAME: found X, expected Y"; "" for a valid one. Lights that are not
/// valid light nothing and are reported as dropped.
std::string whyInvalid(const AreaLight& light);

/// The centre of a valid light, from which its influence is measured.
Vec3d centreOf(const AreaLight& light);
/// The unit normal of a valid disc, rectangle or polygon, on the side that shines.
Vec3d normalOf(const AreaLight& light);
/// The largest distance of a point of a valid light from its centre.
double extentOf(const AreaLight& light);

}  // namespace fbrdf
