#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/plan/AreaVectors.h>
#include <fbrdf/plan/Triangulate.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

using Shape = AreaLight::Shape;

/// Builds the vectors of one light from positions in the world.
class AreaRecord {
public:
    AreaRecord(const AreaLight& light, int number, const glm::dmat4& toEye)
        : light_(light), number_(number), toEye_(toEye)
    {
    }

    Vec3d point(const Vec3d& p) const { return Vec3d(toEye_ * glm::dvec4(p, 1.0)); }
    Vec3d vector(const Vec3d& v) const { return Vec3d(toEye_ * glm::dvec4(v, 0.0)); }

    AreaVectors of(AreaKind kind, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                   const Vec3d& d) const
    {
        const double inverse = inverseRadiusSquared(static_cast<double>(light_.radius));
        const int code = static_cast<int>(kind) + kAreaKinds * number_;
        const auto packed = [](const Vec3d& v, double w) { return glm::vec4(glm::dvec4(v, w)); };
        const Vec3d radiance(light_.radiance);
        return {packed(point(centreOf(light_)), inverse), packed(a, radiance.x),
                packed(b, radiance.y), packed(c, radiance.z), packed(d, code)};
    }

private:
    const AreaLight& light_;
    int number_;
    const glm::dmat4& toEye_;
};

AreaVectors rectangle(const AreaLight& light, const AreaRecord& record, AreaKind kind)
{
    const Vec3d centre(light.position), u(light.axisU), v(light.axisV);
    return record.of(kind, record.point(centre - u - v), record.point(centre + u - v),
                     record.point(centre + u + v), record.point(centre - u + v));
}

AreaVectors disc(const AreaLight& light, const AreaRecord& record, AreaKind kind)
{
    const auto axes = axesAbout(glm::normalize(Vec3d(light.normal)));
    const auto size = static_cast<double>(light.size);
    return record.of(kind, record.point(Vec3d(light.position)), record.vector(size * axes[0]),
                     record.vector(size * axes[1]), Vec3d(0.0));
}

void appendPolygon(const AreaLight& light, const AreaRecord& record, AreaKind kind,
                   std::vector<AreaVectors>& vectors)
{
    std::vector<Vec3d> corners;
    for (const Vec3f& vertex : light.vertices) corners.push_back(record.point(Vec3d(vertex)));
    const auto at = [&](int i) { return corners[static_cast<size_t>(i)]; };
    for (const auto& facet : convexFacets(corners))
        vectors.push_back(record.of(kind, at(facet[0]), at(facet[1]), at(facet[2]), at(facet[3])));
}

}  // namespace

void appendAreaVectors(const AreaLight& light, int number, const glm::dmat4& toEye,
                       std::vector<AreaVectors>& vectors)
{
    FBRDF_ASSERT(whyInvalid(light), ==, "");
    const AreaRecord record(light, number, toEye);
    const AreaKind facet = light.twoSided ? AreaKind::twoSidedFacet : AreaKind::facet;
    const Vec3d position = record.point(Vec3d(light.position));
    const Vec3d size(static_cast<double>(light.size), 0.0, 0.0);
    switch (light.shape) {
        case Shape::sphere:
            return vectors.push_back(
                record.of(AreaKind::sphere, position, size, Vec3d(0.0), Vec3d(0.0)));
        case Shape::tube:
            return vectors.push_back(record.of(AreaKind::tube, position,
                                               record.point(Vec3d(light.end)), size, Vec3d(0.0)));
        case Shape::disc:
            return vectors.push_back(
                disc(light, record, light.twoSided ? AreaKind::twoSidedDisc : AreaKind::disc));
        case Shape::rectangle: return vectors.push_back(rectangle(light, record, facet));
        case Shape::polygon: return appendPolygon(light, record, facet, vectors);
    }
}

// A flat light that shines from one side reaches what is in front of its plane, as
// fbrdfAreaContour has it: a cone of 90 degrees. Its apex is in the plane, to which the centre of a
// polygon need not be close, and the radius grows by what it is away from the centre.
LightVectors reachOf(const AreaVectors& light)
{
    const glm::vec4 intensity(light[1].w, light[2].w, light[3].w, 1.0f);
    const LightVectors ball{light[0], intensity, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)};
    const auto kind = static_cast<AreaKind>(static_cast<int>(light[4].w) % kAreaKinds);
    if ((kind != AreaKind::facet && kind != AreaKind::disc) || light[0].w == 0.0f) return ball;
    const Vec3d centre(light[0]), a(light[1]), b(light[2]), c(light[3]), d(light[4]);
    const Vec3d across = kind == AreaKind::disc ? glm::cross(b, c) : glm::cross(c - a, d - b);
    if (!(glm::length(across) > 0.0)) return ball;
    const Vec3d normal = glm::normalize(across);
    // Of the distance from the eye: above what floats leave of a plane.
    constexpr double kPlaneMargin = 1e-5;
    const double radius = 1.0 / std::sqrt(static_cast<double>(light[0].w)),
                 away = std::min(glm::dot(a - centre, normal), 0.0) -
                        kPlaneMargin * (glm::length(centre) + radius),
                 wider = radius - away;
    return {glm::vec4(glm::dvec4(centre + away * normal, 1.0 / (wider * wider))), intensity,
            glm::vec4(glm::dvec4(normal, 0.0))};
}

}  // namespace fbrdf
