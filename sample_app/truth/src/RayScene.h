// RayScene.h - what rays meet of the instances of a scene, by Embree (Wald et al. 2014, "Embree: A
// Kernel Framework for Efficient CPU Ray Tracing").
#pragma once
#include <fbrdf/scene/Shading.h>

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <vector>

namespace fbrdf::truth {

/// From a point into a unit direction, world space.
struct Ray {
    Vec3d origin, direction;
};

struct Hit {
    scene::Fragment fragment;  ///< its depth is not set; not covered where the ray meets nothing
    double distance = std::numeric_limits<double>::infinity();
};

class RayScene {
public:
    /// The meshes must outlive this. Throws std::runtime_error where Embree fails.
    explicit RayScene(std::vector<scene::Instance> instances);

    Hit nearest(const Ray& ray) const;
    /// True when a ray that meets something at `blocked` reaches `distance`; what is there, but for
    /// rounding, does not count.
    bool isSeen(double distance, double blocked) const
    {
        return !(blocked < distance - 2.0 * margin_);
    }
    /// The contrary for a ray of which the nearest point is not known.
    bool isBlocked(const Ray& ray, double distance) const;

    scene::SurfacePoint pointOf(const scene::Fragment& fragment) const;
    /// Where rays leave a point of a surface, so that they do not meet its own triangle, nor the
    /// facets of a mesh that stands for something convex.
    Vec3d departureFrom(const scene::Fragment& fragment) const;
    const scene::Instance& instanceOf(const scene::Fragment& fragment) const
    {
        return instances_[static_cast<size_t>(fragment.instance)];
    }

private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    void attach(size_t instance);
    void checkDevice() const;

    std::vector<scene::Instance> instances_;
    std::vector<scene::ToWorld> toWorld_;
    std::unique_ptr<RTCDeviceTy, Release> device_;
    std::unique_ptr<RTCSceneTy, Release> scene_;
    double margin_ = 0.0;  ///< length that rounding may move a point by
};

}  // namespace fbrdf::truth
