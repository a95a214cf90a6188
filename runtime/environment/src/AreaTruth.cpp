#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/environment/AreaTruth.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Triangulate.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

using Shape = AreaLight::Shape;

// Turning by it leaves no gaps however many points follow each other (Vogel 1979).
constexpr double kGoldenAngle = kPi * 0.76393202250021030359;

/// Point i of `count` that lie evenly on the unit disc.
Vec2<double> onDisc(int i, int count)
{
    const double radius = std::sqrt((i + 0.5) / count), angle = i * kGoldenAngle;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Direction i of `count` that lie evenly on the cap about z down to a cosine.
Vec3d onCap(int i, int count, double cosine)
{
    const double z = 1.0 - (i + 0.5) / count * (1.0 - cosine), angle = i * kGoldenAngle;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Vec3d turned(const Vec3d& local, const Vec3d& axis)
{
    const auto axes = axesAbout(axis);
    return local.x * axes[0] + local.y * axes[1] + local.z * axis;
}

double distanceToSegment(const Vec3d& p, const Vec3d& a, const Vec3d& b)
{
    const Vec3d axis = b - a;
    const double length2 = glm::dot(axis, axis);
    const double along =
        length2 > 0.0 ? std::clamp(glm::dot(p - a, axis) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + along * axis);
}

int sideOf(double count)
{
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(count))));
}

}  // namespace

AreaTruth::AreaTruth(const AreaLight& light, const AreaPoints& points)
    : light_(light), points_(points), centre_(centreOf(light)), extent_(extentOf(light))
{
    FBRDF_ASSERT(whyInvalid(light), ==, "");
    FBRDF_ASSERT(std::min(points.far, points.near), >=, 1);
    if (light.shape == Shape::sphere) return;
    far_ = piecesOf(points.far);
    near_ = piecesOf(points.near);
}

std::vector<AreaTruth::Piece> AreaTruth::piecesOf(int count) const
{
    std::vector<Piece> pieces;
    const auto size = static_cast<double>(light_.size);
    if (light_.shape == Shape::disc) {
        const Vec3d normal = normalOf(light_);
        for (int i = 0; i < count; ++i) {
            const Vec2<double> place = onDisc(i, count);
            pieces.push_back({centre_ + size * turned({place.x, place.y, 0.0}, normal), normal,
                              kPi * size * size / count});
        }
        return pieces;
    }
    if (light_.shape == Shape::tube) {
        // Half of the surface looks away, so twice as many pieces.
        const Vec3d a(light_.position), b(light_.end);
        const double length = glm::distance(a, b), side = 2.0 * kPi * size * length,
                     ends = 4.0 * kPi * size * size;
        const Vec3d axis = length > 0.0 ? (b - a) / length : Vec3d(0.0, 0.0, 1.0);
        const int around = 2 * static_cast<int>(std::ceil(count * ends / (side + ends)));
        for (int i = 0; i < around; ++i) {
            const Vec3d normal = turned(onCap(i, around, -1.0), axis);
            pieces.push_back(
                {(glm::dot(normal, axis) > 0.0 ? b : a) + size * normal, normal, ends / around});
        }
        const int along = 2 * count;
        for (int i = 0; i < along && length > 0.0; ++i) {
            const double angle = i * kGoldenAngle;
            const Vec3d normal = turned({std::cos(angle), std::sin(angle), 0.0}, axis);
            pieces.push_back(
                {a + (i + 0.5) / along * (b - a) + size * normal, normal, side / along});
        }
        return pieces;
    }
    std::vector<Vec3d> corners(light_.vertices.begin(), light_.vertices.end());
    const Vec3d normal = normalOf(light_), u(light_.axisU), v(light_.axisV);
    if (light_.shape == Shape::rectangle) {
        const int n = sideOf(count);
        for (int i = 0; i < n * n; ++i)
            pieces.push_back({centre_ + ((2 * (i % n) + 1.0) / n - 1.0) * u +
                                  ((2 * (i / n) + 1.0) / n - 1.0) * v,
                              normal, 4.0 * glm::length(glm::cross(u, v)) / (n * n)});
        return pieces;
    }
    const double whole = glm::length(vectorArea(corners));
    for (const auto& triangle : triangulate(corners)) {
        const Vec3d a = corners[static_cast<size_t>(triangle[0])],
                    b = corners[static_cast<size_t>(triangle[1])],
                    c = corners[static_cast<size_t>(triangle[2])];
        const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
        const int n = sideOf(count * area / whole);
        for (int i = 0; i < n * n; ++i) {
            // Evenly over a triangle (Turk 1990, "Generating Random Points in Triangles").
            const double s = std::sqrt((i % n + 0.5) / n), t = (i / n + 0.5) / n;
            pieces.push_back(
                {(1.0 - s) * a + s * (1.0 - t) * b + s * t * c, normal, area / (n * n)});
        }
    }
    return pieces;
}

bool AreaTruth::isNear(const Vec3d& position, const Vec3d& mirror) const
{
    const Vec3d toCentre = centre_ - position;
    const double distance = glm::length(toCentre);
    if (distance <= extent_) return true;
    const double angle = std::acos(std::clamp(glm::dot(toCentre, mirror) / distance, -1.0, 1.0));
    return angle < std::asin(extent_ / distance) + points_.nearAngle;
}

std::vector<AreaTruth::Incoming> AreaTruth::incomingAt(const Vec3d& position, bool near) const
{
    std::vector<Incoming> incoming;
    const auto size = static_cast<double>(light_.size);
    const Vec3d a(light_.position), b(light_.shape == Shape::tube ? light_.end : light_.position);
    const bool isRound = light_.shape == Shape::sphere || light_.shape == Shape::tube;
    const bool isInside = isRound && distanceToSegment(position, a, b) <= size;
    if (isInside || light_.shape == Shape::sphere) {
        const double sine = isInside ? 1.0 : size / glm::distance(position, centre_);
        const double cosine = isInside ? -1.0 : std::sqrt(1.0 - sine * sine);
        const Vec3d axis = isInside ? Vec3d(0.0, 0.0, 1.0) : glm::normalize(centre_ - position);
        // 1 - cosine without cancellation, for lights that are far away.
        const double solidAngle = 2.0 * kPi * (isInside ? 2.0 : sine * sine / (1.0 + cosine));
        const int count = near ? points_.near : points_.far;
        for (int i = 0; i < count; ++i)
            incoming.push_back({turned(onCap(i, count, cosine), axis), solidAngle / count});
        return incoming;
    }
    for (const Piece& piece : near ? near_ : far_) {
        const Vec3d toPiece = piece.position - position;
        const double distance2 = glm::dot(toPiece, toPiece);
        const Vec3d direction = toPiece / std::sqrt(distance2);
        const double facing = -glm::dot(direction, piece.normal);
        const double cosine = light_.twoSided && !isRound ? std::abs(facing) : facing;
        if (cosine > 0.0) incoming.push_back({direction, piece.area * cosine / distance2});
    }
    return incoming;
}

Vec3d AreaTruth::reflected(const Reflectance& f, const Vec3d& position,
                           const ShadingFrame<double>& frame, const Vec3d& viewer) const
{
    const Vec3d toCentre = centre_ - position;
    const double window = influenceWindow(glm::dot(toCentre, toCentre),
                                          inverseRadiusSquared(static_cast<double>(light_.radius)));
    if (!(window > 0.0)) return Vec3d(0.0);
    const Vec3d mirror = 2.0 * glm::dot(frame.n, viewer) * frame.n - viewer,
                wo = frame.local(viewer);
    Vec3d sum(0.0);
    for (const Incoming& from : incomingAt(position, isNear(position, mirror))) {
        const Vec3d wi = frame.local(from.direction);
        if (wi.z > 0.0) sum += f(wo, wi) * (wi.z * from.solidAngle);
    }
    return sum * window * Vec3d(light_.radiance);
}

}  // namespace fbrdf
