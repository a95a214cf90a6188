#include "RayScene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fbrdf::truth {
namespace {

// Embree computes in float: 256 units in the last place of the largest coordinate, as Waechter and
// Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection", Listing 6-1.
constexpr double kMargin = 256.0 * 0x1p-24;

RTCRay rayOf(const Ray& ray, double distance)
{
    RTCRay r{};
    r.org_x = static_cast<float>(ray.origin.x);
    r.org_y = static_cast<float>(ray.origin.y);
    r.org_z = static_cast<float>(ray.origin.z);
    r.dir_x = static_cast<float>(ray.direction.x);
    r.dir_y = static_cast<float>(ray.direction.y);
    r.dir_z = static_cast<float>(ray.direction.z);
    r.tfar = static_cast<float>(distance);
    r.mask = ~0u;
    return r;
}

}  // namespace

RayScene::RayScene(std::vector<scene::Instance> instances)
    : instances_(std::move(instances)),
      // With one thread nothing, ties between triangles included, depends on how trees are built.
      device_(rtcNewDevice("threads=1"))
{
    checkDevice();
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    for (const scene::Instance& instance : instances_) toWorld_.emplace_back(instance.model);
    for (size_t i = 0; i < instances_.size(); ++i) attach(i);
    rtcCommitScene(scene_.get());
    checkDevice();
    RTCBounds b{};
    rtcGetSceneBounds(scene_.get(), &b);
    for (const float side : {b.lower_x, b.lower_y, b.lower_z, b.upper_x, b.upper_y, b.upper_z})
        if (std::isfinite(side))
            margin_ = std::max(margin_, kMargin * std::abs(static_cast<double>(side)));
}

void RayScene::checkDevice() const
{
    const RTCError error = rtcGetDeviceError(device_.get());
    if (error != RTC_ERROR_NONE)
        throw std::runtime_error("Embree: error " + std::to_string(static_cast<int>(error)));
}

/// Instances are few, so each has triangles of its own in world space: what is shaded and what rays
/// meet then differ by rounding alone, whatever the matrix.
void RayScene::attach(size_t i)
{
    const scene::Mesh& mesh = *instances_[i].mesh;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), std::max<size_t>(1, mesh.positions.size())));
    auto* const indices = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), mesh.indices.size() / 3));
    if (positions && indices) {
        for (size_t k = 0; k < mesh.positions.size(); ++k) {
            const Vec3f position(toWorld_[i](scene::cornerOf(mesh, k)).position);
            for (int c = 0; c < 3; ++c) positions[3 * k + static_cast<size_t>(c)] = position[c];
        }
        std::copy_n(mesh.indices.begin(), mesh.indices.size() / 3 * 3, indices);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, static_cast<unsigned>(i));
    rtcReleaseGeometry(geometry);
}

Hit RayScene::nearest(const Ray& ray) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit found{};
    found.ray = rayOf(ray, std::numeric_limits<double>::infinity());
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &found);
    Hit hit;
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
    const auto u = static_cast<double>(found.hit.u), v = static_cast<double>(found.hit.v);
    hit.fragment.instance = static_cast<int>(found.hit.geomID);
    hit.fragment.first = 3 * found.hit.primID;
    hit.fragment.weights = {1.0 - u - v, u, v};
    hit.distance = static_cast<double>(found.ray.tfar);
    return hit;
}

bool RayScene::isBlocked(const Ray& ray, double distance) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay shadow = rayOf(ray, distance - 2.0 * margin_);
    if (!(shadow.tfar > 0.0f)) return false;
    rtcOccluded1(scene_.get(), &context, &shadow);
    return shadow.tfar < 0.0f;
}

scene::SurfacePoint RayScene::pointOf(const scene::Fragment& fragment) const
{
    return scene::surfacePoint(*instanceOf(fragment).mesh,
                               toWorld_[static_cast<size_t>(fragment.instance)], fragment);
}

/// Hanika 2021, "Hacking the Shadow Terminator" (Ray Tracing Gems II, chapter 4): the point is
/// moved out to where the planes of the corners' normals meet, so rays above its interpolated
/// normal pass over the facets of a convex surface. Then the margin, along the triangle's normal.
Vec3d RayScene::departureFrom(const scene::Fragment& fragment) const
{
    const scene::Mesh& mesh = *instanceOf(fragment).mesh;
    const scene::ToWorld& toWorld = toWorld_[static_cast<size_t>(fragment.instance)];
    std::array<scene::SurfacePoint, 3> corner;
    Vec3d point(0.0), normal(0.0);
    for (size_t k = 0; k < 3; ++k) {
        corner[k] = toWorld(scene::cornerOf(mesh, mesh.indices[fragment.first + k]));
        corner[k].normal = glm::normalize(corner[k].normal);
        point += fragment.weights[static_cast<int>(k)] * corner[k].position;
        normal += fragment.weights[static_cast<int>(k)] * corner[k].normal;
    }
    Vec3d raised = point;
    for (size_t k = 0; k < 3; ++k) {
        const double above = glm::dot(point - corner[k].position, corner[k].normal);
        raised -= fragment.weights[static_cast<int>(k)] * std::min(0.0, above) * corner[k].normal;
    }
    const Vec3d facet = glm::cross(corner[1].position - corner[0].position,
                                   corner[2].position - corner[0].position);
    const double size = glm::length(facet);
    if (!(size > 0.0)) return raised;
    const double outward = glm::dot(facet, normal) < 0.0 ? -1.0 : 1.0;
    return raised + margin_ * outward / size * facet;
}

}  // namespace fbrdf::truth
