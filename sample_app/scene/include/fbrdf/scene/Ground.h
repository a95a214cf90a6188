// Ground.h - a matt plane below the objects, which takes their shadows and fades into what is
// behind it.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/scene/CpuRenderer.h>

#include <vector>

namespace fbrdf::scene {

/// What the sky sends to places of the ground past the objects, over what it sends to an open one,
/// for a sky that is the same everywhere: 1 is open, 0 hidden.
struct SkyVisibility {
    int size = 1;  ///< texels on a side
    /// size x size; texel centres lie evenly on [-1, 1]^2 radii of the ground, from the first to
    /// the last. The first row is at the least z, its first texel at the least x.
    std::vector<float> texels = {1.0f};

    /// Filtered linearly. x, z: from the ground's centre, in radii; beyond [-1, 1] the border's.
    double at(double x, double z) const;
};

class Ground {
public:
    static constexpr double kAlbedo = 0.3;
    /// Radii from the centre up to which the ground is opaque; it is gone at 1.
    static constexpr double kOpaque = 0.3;

    /// The plane through the lowest point of the objects, centred below them. Expects at least one
    /// object, and no motion of the ground while something points to it (object()).
    explicit Ground(const std::vector<Instance>& objects);
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;

    const Vec3d& centre() const { return centre_; }
    double radius() const { return radius_; }  ///< world units
    /// Takes unit circles about +y to the plane, with what was turned by turnTo.
    glm::mat4 placement() const;
    /// Turns the plane, and so what objects that turn with it hide, to an angle about its centre:
    /// radians, counter-clockwise seen from above.
    void turnTo(double angle) { angle_ = angle; }
    /// The plane as an object, a square around the disc of that radius. Its material is `index`.
    Instance object(int index) const;
    /// A ball around the ground and the objects on it.
    Bounds bounds() const;

    /// The factored material of the plane, and the same as a function: a Lambertian of kAlbedo.
    static Material material();
    static Brdf brdf();
    /// 1 - transparency, in [0, 1]. Twin: groundOpacity in ground.frag.
    double opacity(const Vec3d& position) const;
    /// What the plane shows of the environment, which arrives as `irradiance` where it is open.
    Vec3d reflectedSky(const Vec3d& position, const Vec3d& irradiance) const;

    /// False from below, where the plane would hide everything: it is not drawn then.
    bool isSeenFrom(const gl::View& view) const;

    const SkyVisibility& visibility() const { return visibility_; }
    void setVisibility(SkyVisibility visibility) { visibility_ = std::move(visibility); }

private:
    Vec3d centre_{0.0};
    double radius_ = 1.0, angle_ = 0.0;
    Bounds objects_;
    Mesh mesh_;
    SkyVisibility visibility_;
};

}  // namespace fbrdf::scene
