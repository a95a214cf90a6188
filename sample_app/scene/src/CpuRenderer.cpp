#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/AreaTruth.h>
#include <fbrdf/environment/EnvironmentTruth.h>
#include <fbrdf/scene/CpuRenderer.h>
#include <fbrdf/scene/Shading.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fbrdf::scene {
namespace {

/// The lights of a scene, ready to shade points with.
class Lighting {
public:
    explicit Lighting(const Scene& scene) : lights_(scene.lights), environment_(scene.environment)
    {
        if (environment_) truth_.emplace(std::vector<Panorama>{environment_->panorama});
        // Lights that are not valid light nothing.
        for (const AreaLight& light : scene.areaLights)
            if (whyInvalid(light).empty()) areas_.emplace_back(light);
    }

    /// docs/method.md, Eq. 2, and the integrals over the environment and area lights.
    Vec3d radiance(const Brdf& brdf, const SurfacePoint& point, const Vec3d& toEye) const
    {
        const ShadingFrame<double> frame = shadingFrame(point.normal, point.tangent);
        const Vec3d wo = frame.local(toEye);
        if (!(wo.z > 0.0)) return Vec3d(0.0);
        Vec3d sum = fromLights(brdf, point, frame, wo);
        for (const AreaTruth& area : areas_)
            sum += area.reflected(brdf, point.position, frame, toEye);
        if (environment_) {
            const auto turned = [&](const Vec3d& w) { return environment_->toEnvironment(w); };
            const ShadingFrame<double> inEnvironment{turned(frame.t), turned(frame.s),
                                                     turned(frame.n)};
            sum += environment_->intensity *
                   truth_->reflected(brdf, inEnvironment, turned(toEye)).front();
        }
        return sum;
    }

private:
    Vec3d fromLights(const Brdf& brdf, const SurfacePoint& point, const ShadingFrame<double>& frame,
                     const Vec3d& wo) const;

    const std::vector<Light>& lights_;
    const EnvironmentLight* environment_;
    std::optional<EnvironmentTruth> truth_;
    std::vector<AreaTruth> areas_;
};

Vec3d Lighting::fromLights(const Brdf& brdf, const SurfacePoint& point,
                           const ShadingFrame<double>& frame, const Vec3d& wo) const
{
    Vec3d sum(0.0);
    for (const Light& light : lights_) {
        const Incident incident = incidentFrom(light, point.position);
        const Vec3d wi = frame.local(incident.direction);
        if (wi.z > 0.0) sum += brdf(wo, wi) * wi.z * incident.irradiance;
    }
    return sum;
}

void setPixel(float* pixel, const Vec3d& colour)
{
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(colour[c]);
    pixel[3] = 1.0f;
}

/// Sets every covered pixel to colour(fragment), rows in parallel.
template <class Colour>
Image pictureOf(const Scene& scene, const PictureOptions& options, const Colour& colour)
{
    const Fragments fragments =
        rasterise(scene.instances, scene.view, options.width, options.height);
    Image image(options.width, options.height);
    parallelTasks(static_cast<size_t>(options.height), options.threads, [&](size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < options.width; ++x)
            if (const Fragment& fragment = fragments.at(x, y); fragment.covered())
                setPixel(image.pixel(x, y), colour(fragment));
    });
    return image;
}

/// Radiance of every vertex of an instance towards the eye.
std::vector<Vec3d> vertexRadiance(const Scene& scene, const Lighting& lighting,
                                  const Instance& instance, int threads)
{
    const Mesh& mesh = *instance.mesh;
    const Brdf& brdf = scene.brdfs[static_cast<size_t>(instance.material)];
    const Eye eye(scene.view);
    const ToWorld toWorld(instance.model);
    std::vector<Vec3d> result(mesh.positions.size());
    parallelFor(result.size(), threads, [&](size_t i) {
        const SurfacePoint point = toWorld(cornerOf(mesh, i));
        result[i] = lighting.radiance(brdf, point, eye.directionFrom(point.position));
    });
    return result;
}

}  // namespace

Image renderReference(const Scene& scene, const PictureOptions& options)
{
    const Eye eye(scene.view);
    const Lighting lighting(scene);
    std::vector<ToWorld> toWorld;
    for (const Instance& instance : scene.instances) toWorld.emplace_back(instance.model);
    return pictureOf(scene, options, [&](const Fragment& fragment) {
        const size_t index = static_cast<size_t>(fragment.instance);
        const Instance& instance = scene.instances[index];
        const SurfacePoint point = surfacePoint(*instance.mesh, toWorld[index], fragment);
        return lighting.radiance(scene.brdfs[static_cast<size_t>(instance.material)], point,
                                 eye.directionFrom(point.position));
    });
}

Image renderVertex(const Scene& scene, const PictureOptions& options)
{
    const Lighting lighting(scene);
    std::vector<std::vector<Vec3d>> colours;
    for (const Instance& instance : scene.instances)
        colours.push_back(vertexRadiance(scene, lighting, instance, options.threads));
    return pictureOf(scene, options, [&](const Fragment& fragment) {
        const size_t index = static_cast<size_t>(fragment.instance);
        return interpolate<Vec3d>(colours[index], *scene.instances[index].mesh, fragment);
    });
}

}  // namespace fbrdf::scene
