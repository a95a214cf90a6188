#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Triangulate.h>
#include <fbrdf/truth/Emitters.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::truth {
namespace {

using Shape = AreaLight::Shape;

Vec3d about(const Vec3d& axis, double cosine, double sine, double turns)
{
    const auto axes = axesAbout(axis);
    const double angle = 2.0 * kPi * turns;
    return sine * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1]) + cosine * axis;
}

/// Even on the sphere (Archimedes): the cosine is even in [-1, 1].
Vec3d onSphere(const Vec3d& axis, const Vec2<double>& u)
{
    const double cosine = 1.0 - 2.0 * u.x;
    return about(axis, cosine, std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), u.y);
}

double areaOf(const std::array<Vec3d, 3>& t)
{
    return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
}

std::vector<Vec3d> cornersOf(const AreaLight& light)
{
    if (light.shape == Shape::polygon) return {light.vertices.begin(), light.vertices.end()};
    if (light.shape != Shape::rectangle) return {};
    const Vec3d c(light.position), u(light.axisU), v(light.axisV);
    return {c - u - v, c + u - v, c + u + v, c - u + v};
}

/// Where a ray enters and leaves a ball or, with the part along `axis` taken out of both vectors, a
/// cylinder. Empty where it passes by.
struct Chord {
    double enter = 1.0, leave = 0.0;
    bool isEmpty() const { return !(enter <= leave); }
};
Chord chordOf(const Vec3d& toCentre, const Vec3d& direction, double radius)
{
    const double length2 = glm::dot(direction, direction);
    if (!(length2 > 0.0)) return {};
    const double middle = glm::dot(toCentre, direction) / length2;
    const Vec3d beside = toCentre - middle * direction;
    const double left2 = radius * radius - glm::dot(beside, beside);
    if (left2 < 0.0) return {};
    const double half = std::sqrt(left2 / length2);
    return {middle - half, middle + half};
}

}  // namespace

AreaEmitter::AreaEmitter(const AreaLight& light)
    : light_(light), centre_(centreOf(light)), axis_(0.0, 0.0, 1.0), size_(double(light.size))
{
    FBRDF_ASSERT(whyInvalid(light), ==, "");
    const std::vector<Vec3d> corners = cornersOf(light);
    if (!corners.empty())
        for (const auto& t : triangulate(corners))
            triangles_.push_back({corners[static_cast<size_t>(t[0])],
                                  corners[static_cast<size_t>(t[1])],
                                  corners[static_cast<size_t>(t[2])]});
    for (const Triangle& t : triangles_)
        areas_.push_back((areas_.empty() ? 0.0 : areas_.back()) + areaOf(t));
    area_ = areas_.empty() ? kPi * size_ * size_ : areas_.back();
    if (light.shape == Shape::tube) {
        const Vec3d span = Vec3d(light.end) - Vec3d(light.position);
        length_ = glm::length(span);
        if (length_ > 0.0) axis_ = span / length_;
        area_ = 2.0 * kPi * size_ * (length_ + 2.0 * size_);
    } else if (light.shape != Shape::sphere) {
        axis_ = normalOf(light);
    }
}

Vec3d AreaEmitter::radianceAt(const Vec3d& position) const
{
    const Vec3d toCentre = centre_ - position;
    return influenceWindow(glm::dot(toCentre, toCentre),
                           inverseRadiusSquared(static_cast<double>(light_.radius))) *
           Vec3d(light_.radiance);
}

Emission AreaEmitter::drawn(const Vec3d& position, const Vec2<double>& u) const
{
    return along(position, towards(position, u));
}

Emission AreaEmitter::along(const Vec3d& position, const Vec3d& direction) const
{
    Emission ray{direction};
    meet(ray, position);
    if (ray.pdf > 0.0) ray.radiance = radianceAt(position);
    return ray;
}

Vec3d AreaEmitter::towards(const Vec3d& position, const Vec2<double>& u) const
{
    if (light_.shape != Shape::sphere) return glm::normalize(pointOf(u) - position);
    const Vec3d toCentre = centre_ - position;
    const double distance = glm::length(toCentre);
    if (distance <= size_) return onSphere(axis_, u);
    // Evenly on the cap that is seen (Shirley, Wang, Zimmerman 1996, section 3.2), with 1 - cosine
    // in place of the cosine: lights that are far away would have no digits left.
    const double sine = size_ / distance;
    const double height = u.x * sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
    return about(toCentre / distance, 1.0 - height, std::sqrt(height * (2.0 - height)), u.y);
}

/// A point of the surface, even by area.
Vec3d AreaEmitter::pointOf(const Vec2<double>& u) const
{
    if (light_.shape == Shape::disc)
        return centre_ + about(axis_, 0.0, size_ * std::sqrt(u.x), u.y);
    const Vec3d a(light_.position), b(light_.end);
    if (light_.shape == Shape::tube) {
        const double side = length_ / (length_ + 2.0 * size_);  // of the area
        if (u.x < side) return a + u.x / side * (b - a) + about(axis_, 0.0, size_, u.y);
        const Vec3d n = onSphere(axis_, {(u.x - side) / (1.0 - side), u.y});
        return (glm::dot(n, axis_) > 0.0 ? b : a) + size_ * n;
    }
    const double along = u.x * area_;
    const auto chosen = std::min<std::ptrdiff_t>(
        std::upper_bound(areas_.begin(), areas_.end(), along) - areas_.begin(),
        std::ptrdiff_t(areas_.size()) - 1);
    const auto i = static_cast<size_t>(chosen);
    const double before = i == 0 ? 0.0 : areas_[i - 1];
    // Turk 1990, "Generating Random Points in Triangles".
    const double s = std::sqrt((along - before) / (areas_[i] - before));
    const Triangle& t = triangles_[i];
    return (1.0 - s) * t[0] + s * (1.0 - u.y) * t[1] + s * u.y * t[2];
}

/// Sets distance and pdf of what the ray meets.
void AreaEmitter::meet(Emission& ray, const Vec3d& position) const
{
    switch (light_.shape) {
        case Shape::sphere: meetSphere(ray, position); break;
        case Shape::tube: meetTube(ray, position); break;
        default: meetPlane(ray, position);
    }
}

void AreaEmitter::meetSphere(Emission& ray, const Vec3d& position) const
{
    const Vec3d toCentre = centre_ - position;
    const double squaredSine = size_ * size_ / glm::dot(toCentre, toCentre);
    const Chord chord = chordOf(toCentre, ray.direction, size_);
    if (chord.isEmpty() || !(chord.leave > 0.0)) return;
    const bool isInside = squaredSine >= 1.0;
    ray.distance = isInside ? chord.leave : chord.enter;
    ray.pdf = isInside ? 1.0 / (4.0 * kPi)
                       : (1.0 + std::sqrt(1.0 - squaredSine)) / (2.0 * kPi * squaredSine);
}

/// A direction is drawn by both points of the surface that lie in it.
void AreaEmitter::meetTube(Emission& ray, const Vec3d& position) const
{
    const Vec3d a = Vec3d(light_.position) - position, b = Vec3d(light_.end) - position;
    const auto across = [this](const Vec3d& v) { return v - glm::dot(v, axis_) * axis_; };
    const auto add = [&](double t) {
        if (!(t > 0.0)) return;
        const Vec3d onAxis =
            a + std::clamp(glm::dot(t * ray.direction - a, axis_), 0.0, length_) * axis_;
        const double facing = std::abs(glm::dot(t * ray.direction - onAxis, ray.direction)) / size_;
        ray.distance = std::min(ray.distance, t);
        ray.pdf += t * t / (area_ * facing);
    };
    /// Adds those of both ends whose place along the axis is in [from, to].
    const auto addWithin = [&](const Chord& chord, double from, double to) {
        if (chord.isEmpty()) return;
        for (const double t : {chord.enter, chord.leave}) {
            const double place = glm::dot(t * ray.direction - a, axis_);
            if (place >= from && place < to) add(t);
        }
    };
    constexpr double kFar = std::numeric_limits<double>::infinity();
    addWithin(chordOf(a, ray.direction, size_), -kFar, 0.0);
    addWithin(chordOf(across(a), across(ray.direction), size_), 0.0, length_);
    addWithin(chordOf(b, ray.direction, size_), length_, kFar);
}

void AreaEmitter::meetPlane(Emission& ray, const Vec3d& position) const
{
    const double facing = -glm::dot(ray.direction, axis_);
    if (!(light_.twoSided ? facing != 0.0 : facing > 0.0)) return;
    const double t = glm::dot(position - centre_, axis_) / facing;
    if (!(t > 0.0) || !contains(position + t * ray.direction)) return;
    ray.distance = t;
    ray.pdf = t * t / (area_ * std::abs(facing));
}

bool AreaEmitter::contains(const Vec3d& p) const
{
    if (light_.shape == Shape::disc) return glm::distance(p, centre_) <= size_;
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) {
        for (size_t i = 0; i < 3; ++i)
            if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), axis_) < 0.0) return false;
        return true;
    });
}

}  // namespace fbrdf::truth
