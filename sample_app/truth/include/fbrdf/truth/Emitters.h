// Emitters.h - lights that a ray can meet, area lights and environments, drawn at random in
// proportion to what they send: for Monte Carlo integration. Densities are per solid angle, and a
// direction has the same one whether it was drawn or only asked about.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/scene/Environment.h>

#include <array>
#include <limits>
#include <vector>

namespace fbrdf::truth {

/// What a point receives from one direction of one emitter.
struct Emission {
    Vec3d direction{0.0};  ///< towards the emitter; unit, world space
    /// Where what lies farther away no longer blocks the emitter.
    double distance = std::numeric_limits<double>::infinity();
    Vec3d radiance{0.0};
    double pdf = 0.0;  ///< 1/sr with which `drawn` gives this direction; 0: nothing is there
};

/// The points of a light with a shape. Spheres are drawn by the solid angle of their cap, other
/// shapes by area.
class AreaEmitter {
public:
    /// Expects a valid light.
    explicit AreaEmitter(const AreaLight& light);

    /// u in [0, 1)^2.
    Emission drawn(const Vec3d& position, const Vec2<double>& u) const;
    Emission along(const Vec3d& position, const Vec3d& direction) const;

private:
    using Triangle = std::array<Vec3d, 3>;

    Vec3d towards(const Vec3d& position, const Vec2<double>& u) const;
    Vec3d pointOf(const Vec2<double>& u) const;
    Vec3d radianceAt(const Vec3d& position) const;
    void meet(Emission& ray, const Vec3d& position) const;
    void meetSphere(Emission& ray, const Vec3d& position) const;
    void meetTube(Emission& ray, const Vec3d& position) const;
    void meetPlane(Emission& ray, const Vec3d& position) const;
    bool contains(const Vec3d& inPlane) const;

    AreaLight light_;
    Vec3d centre_, axis_;  ///< the normal of flat shapes, the axis of tubes
    double size_, length_ = 0.0, area_;
    std::vector<Triangle> triangles_;  ///< of rectangles and polygons
    std::vector<double> areas_;        ///< theirs, added up
};

/// The texels of a panorama. Each is as likely as its mean radiance times its solid angle, and
/// constant, as in EnvironmentTruth.h.
class EnvironmentEmitter {
public:
    /// The light must outlive this.
    explicit EnvironmentEmitter(const scene::EnvironmentLight& light);

    Emission drawn(const Vec2<double>& u) const;
    Emission along(const Vec3d& direction) const;

private:
    Emission ofTexel(const Vec3d& direction, int x, int y) const;

    const scene::EnvironmentLight& light_;
    std::vector<double> sums_;  ///< of mean radiance times solid angle, up to and with each texel
};

}  // namespace fbrdf::truth
