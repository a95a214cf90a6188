// Occluders.h - what objects hide of lights and of the sky, by rays.
#pragma once
#include <fbrdf/scene/Ground.h>

#include <memory>
#include <vector>

namespace fbrdf::truth {

/// Objects as rays meet them. Their meshes must outlive this.
class Occluders {
public:
    explicit Occluders(const std::vector<scene::Instance>& objects);
    ~Occluders();
    Occluders(Occluders&&) noexcept;
    Occluders& operator=(Occluders&&) noexcept;

    /// True where an object is between a point of a surface and what is `distance` away in a unit
    /// direction, world space. Points are lifted off their surface, along its normal, by a
    /// thousandth of the size of the objects: facets do not shade the smooth surface that they
    /// stand for.
    bool hide(const scene::SurfacePoint& point, const Vec3d& direction, double distance) const;

private:
    class State;
    std::unique_ptr<State> state_;
};

/// What the objects leave of the sky above a ground, by 256 rays for each of 129 x 129 places. The
/// result does not depend on the number of threads.
scene::SkyVisibility visibleSky(const Occluders& objects, const scene::Ground& ground);

}  // namespace fbrdf::truth
