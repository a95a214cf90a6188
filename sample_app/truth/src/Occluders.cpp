#include "RayScene.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/scene/Layout.h>
#include <fbrdf/truth/Occluders.h>

#include <array>
#include <cmath>

namespace fbrdf::truth {
namespace {

// A ground of five radii of its objects has texels of 8 % of one; linear filtering of 1 / d^3, the
// shape of contact shadows, is off by less than a code of 8 bits.
constexpr int kSkyTexels = 129;
constexpr int kSkyRings = 16, kSkySectors = 16;
constexpr double kLift = 1e-3;  ///< of the radius of the objects

/// Directions about +y, each as likely as its cosine, one in each cell of a grid (Malley's method).
/// With the same ones at every place shadows have no noise, and steps of 1 / 256.
std::array<Vec3d, kSkyRings * kSkySectors> skyDirections()
{
    std::array<Vec3d, kSkyRings * kSkySectors> directions;
    for (int ring = 0; ring < kSkyRings; ++ring)
        for (int sector = 0; sector < kSkySectors; ++sector) {
            const double u = (ring + 0.5) / kSkyRings, radius = std::sqrt(u);
            // Rings are turned against each other, so that their gaps do not line up.
            const double turn = std::fmod(0.5 + ring * 0.6180339887498949, 1.0);
            const double azimuth = 2.0 * kPi * (sector + turn) / kSkySectors;
            directions[static_cast<size_t>(ring * kSkySectors + sector)] = {
                radius * std::cos(azimuth), std::sqrt(1.0 - u), radius * std::sin(azimuth)};
        }
    return directions;
}

}  // namespace

class Occluders::State {
public:
    explicit State(const std::vector<scene::Instance>& objects)
        : rays_(objects), lift_(kLift * static_cast<double>(scene::boundsOf(objects).radius))
    {
    }

    bool hide(const scene::SurfacePoint& point, const Vec3d& direction, double distance) const
    {
        const Vec3d lifted = point.position + lift_ * glm::normalize(point.normal);
        return rays_.isBlocked({lifted, direction}, distance);
    }

private:
    RayScene rays_;
    double lift_;
};

Occluders::Occluders(const std::vector<scene::Instance>& objects)
    : state_(std::make_unique<State>(objects))
{
}

Occluders::~Occluders() = default;
Occluders::Occluders(Occluders&&) noexcept = default;
Occluders& Occluders::operator=(Occluders&&) noexcept = default;

bool Occluders::hide(const scene::SurfacePoint& point, const Vec3d& direction,
                     double distance) const
{
    return state_->hide(point, direction, distance);
}

scene::SkyVisibility visibleSky(const Occluders& objects, const scene::Ground& ground)
{
    const auto directions = skyDirections();
    scene::SkyVisibility sky{kSkyTexels, std::vector<float>(kSkyTexels * kSkyTexels)};
    parallelTasks(kSkyTexels, 0, [&](size_t row) {
        const auto radii = [](size_t i) { return 2.0 * double(i) / (kSkyTexels - 1) - 1.0; };
        for (size_t column = 0; column < kSkyTexels; ++column) {
            const Vec3d place = ground.radius() * Vec3d(radii(column), 0.0, radii(row));
            const scene::SurfacePoint point{ground.centre() + place, {0.0, 1.0, 0.0}, Vec3d(0.0)};
            int seen = 0;
            for (const Vec3d& direction : directions)
                seen += !objects.hide(point, direction, std::numeric_limits<double>::infinity());
            sky.texels[row * kSkyTexels + column] =
                static_cast<float>(seen) / static_cast<float>(directions.size());
        }
    });
    return sky;
}

}  // namespace fbrdf::truth
