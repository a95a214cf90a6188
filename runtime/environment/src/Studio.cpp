// A room for photographs of products: a dark grey sweep without a horizon, with a spot on the wall
// behind the product, which is at the origin and seen from +z. Soft boxes are rectangles in space.
#include "SkyModels.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fbrdf {
namespace {

struct SoftBox {
    Vec3d centre;  ///< it faces the origin
    double halfWidth, halfHeight;
    Vec3d radiance;  ///< of its middle, over that of the room
};

constexpr SoftBox kSoftBoxes[] = {
    {{-1.7, 1.5, 1.5}, 0.95, 0.75, {26.0, 24.6, 22.6}},  // key, warm, over the left shoulder
    {{1.9, 0.7, 1.7}, 0.8, 1.0, {4.6, 4.8, 5.0}},        // fill, from the right
    {{2.1, 0.6, -0.9}, 0.18, 1.25, {33.0, 34.5, 36.5}},  // strip, a cool rim from behind right
    {{-0.2, 2.4, -0.7}, 1.0, 0.45, {12.0, 12.0, 12.0}},  // from above
};
/// Fabric is dimmer towards the edges of a box, and fades over this length: 3 degrees, some texels.
constexpr double kSoftEdge = 0.12, kDimming = 0.4;

double smooth(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Where a box stands, found once for millions of directions.
struct BoxFrame {
    explicit BoxFrame(const SoftBox& box)
        : distance(glm::length(box.centre)),
          normal(box.centre / distance),
          right(glm::normalize(glm::cross(Vec3d(0.0, 1.0, 0.0), normal))),
          up(glm::cross(normal, right))
    {
    }
    double distance;  ///< of its middle from the origin
    Vec3d normal, right, up;
};
const BoxFrame kBoxFrames[] = {BoxFrame(kSoftBoxes[0]), BoxFrame(kSoftBoxes[1]),
                               BoxFrame(kSoftBoxes[2]), BoxFrame(kSoftBoxes[3])};

/// How much of a box is seen in a direction, 0 to 1.
double boxIn(const SoftBox& box, const BoxFrame& frame, const Vec3d& direction)
{
    const double towards = glm::dot(direction, frame.normal);
    if (!(towards > 0.0)) return 0.0;
    const Vec3d point = direction * (frame.distance / towards);
    const double x = std::abs(glm::dot(point, frame.right)) / box.halfWidth,
                 y = std::abs(glm::dot(point, frame.up)) / box.halfHeight;
    if (x >= 1.0 || y >= 1.0) return 0.0;
    const double edge = smooth((1.0 - x) * box.halfWidth / kSoftEdge) *
                        smooth((1.0 - y) * box.halfHeight / kSoftEdge);
    return edge * (1.0 - kDimming * 0.5 * (x * x + y * y));
}

/// Walls darken upwards, the floor has some light from the boxes, and there is a spot on the wall.
double roomIn(const Vec3d& direction)
{
    const double wall = 0.30 - 0.18 * smooth(direction.y), floor = 0.42;
    const double sweep = smooth((direction.y + 0.45) / 0.5);
    const Vec3d spot = glm::normalize(Vec3d(0.0, 0.12, -1.0));
    const double away = 1.0 - glm::dot(direction, spot);
    return floor + (wall - floor) * sweep + 0.55 * std::exp(-away / 0.16);
}

}  // namespace

Vec3d studioRadiance(const Vec3d& direction)
{
    Vec3d sum(roomIn(direction));
    for (size_t i = 0; i < std::size(kSoftBoxes); ++i)
        sum += boxIn(kSoftBoxes[i], kBoxFrames[i], direction) * kSoftBoxes[i].radiance;
    return sum;
}

}  // namespace fbrdf
