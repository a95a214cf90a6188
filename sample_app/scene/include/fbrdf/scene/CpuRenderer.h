// CpuRenderer.h - draws the scene on the CPU in double, as a reference for the runtime's pictures.
//
// Both pictures contain linear radiance and coverage, and their samples cover the same pixels as
// OpenGL's (Raster.h). They do not depend on the number of threads.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/scene/Environment.h>
#include <fbrdf/scene/Image.h>
#include <fbrdf/scene/Raster.h>
#include <fbrdf/scene/Shading.h>

#include <functional>
#include <vector>

namespace fbrdf::scene {

/// f(wo, wi) in 1/sr for unit directions in the local frame, both above the horizon. It is called
/// from several threads at once.
using Brdf = std::function<Vec3d(const Vec3d& wo, const Vec3d& wi)>;

class Ground;

/// True where something is between a point and lights[light], from which it would receive
/// `incident`. It is called from several threads at once.
using Shadow =
    std::function<bool(size_t light, const SurfacePoint& point, const Incident& incident)>;

/// What is drawn: instances[i] is made of brdfs[instances[i].material].
struct Scene {
    std::vector<Instance> instances;
    std::vector<Brdf> brdfs;
    std::vector<Light> lights;
    std::vector<AreaLight> areaLights;
    const EnvironmentLight* environment = nullptr;  ///< may be null
    gl::View view;
    /// May be null. Where there is one it is the last instance as well; its environment is
    /// Ground::reflectedSky instead of what is said below.
    const Ground* ground = nullptr;
    Shadow shadow = {};  ///< may be empty

    bool isGround(const Fragment& fragment) const
    {
        return ground && fragment.instance + 1 == static_cast<int>(instances.size());
    }
};

struct PictureOptions {
    int width = 512, height = 512;  ///< pixels, > 0
    int threads = 0;                ///< 0: one a core
    /// Samples of a pixel, > 0: those of these numbers (subPixel in SubPixels.h). The picture is
    /// their mean.
    int firstSample = 0, samples = 1;
};

/// docs/method.md, Eq. 2, at every pixel: sum_j f(wo, wi_j) max(0, n.wi_j) E_j, with the
/// interpolated position, normal and tangent of the pixel (fbrdf/brdf/ShadingFrame.h), and the sums
/// over all texels of an environment (EnvironmentTruth.h) and over points of area lights
/// (AreaTruth.h).
Image renderReference(const Scene& scene, const PictureOptions& options);

/// Gouraud shading with the true BRDF: docs/method.md, Eq. 2, at every vertex of the mesh, and its
/// radiance interpolated over the triangles. Highlights smaller than a triangle are lost.
Image renderVertex(const Scene& scene, const PictureOptions& options);

}  // namespace fbrdf::scene
