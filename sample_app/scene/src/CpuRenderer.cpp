#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/AreaTruth.h>
#include <fbrdf/environment/EnvironmentTruth.h>
#include <fbrdf/scene/CpuRenderer.h>
#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/Shading.h>
#include <fbrdf/scene/SubPixels.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fbrdf::scene {
namespace {

/// The lights of a scene, ready to shade points with.
class Lighting {
public:
    explicit Lighting(const Scene& scene)
        : lights_(scene.lights), shadow_(scene.shadow), environment_(scene.environment)
    {
        if (environment_) truth_.emplace(std::vector<Panorama>{environment_->panorama});
        if (environment_ && scene.ground) sky_ = environment_->upwardIrradiance();
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
        Vec3d sum = fromShapes(brdf, point, frame, toEye);
        if (environment_) {
            const auto turned = [&](const Vec3d& w) { return environment_->toEnvironment(w); };
            const ShadingFrame<double> inEnvironment{turned(frame.t), turned(frame.s),
                                                     turned(frame.n)};
            sum += environment_->intensity *
                   truth_->reflected(brdf, inEnvironment, turned(toEye)).front();
        }
        return sum;
    }

    /// The same of the ground, which sees as much of the sky as the objects leave of it.
    Vec3d ofGround(const Ground& ground, const SurfacePoint& point, const Vec3d& toEye) const
    {
        const ShadingFrame<double> frame = shadingFrame(point.normal, point.tangent);
        if (!(frame.local(toEye).z > 0.0)) return Vec3d(0.0);
        return fromShapes(Ground::brdf(), point, frame, toEye) +
               ground.reflectedSky(point.position, sky_);
    }

private:
    /// Of all lights but the environment.
    Vec3d fromShapes(const Brdf& brdf, const SurfacePoint& point, const ShadingFrame<double>& frame,
                     const Vec3d& toEye) const
    {
        Vec3d sum = fromLights(brdf, point, frame, frame.local(toEye));
        for (const AreaTruth& area : areas_)
            sum += area.reflected(brdf, point.position, frame, toEye);
        return sum;
    }
    Vec3d fromLights(const Brdf& brdf, const SurfacePoint& point, const ShadingFrame<double>& frame,
                     const Vec3d& wo) const;

    const std::vector<Light>& lights_;
    const Shadow& shadow_;
    const EnvironmentLight* environment_;
    Vec3d sky_{0.0};  ///< irradiance of an open ground
    std::optional<EnvironmentTruth> truth_;
    std::vector<AreaTruth> areas_;
};

Vec3d Lighting::fromLights(const Brdf& brdf, const SurfacePoint& point,
                           const ShadingFrame<double>& frame, const Vec3d& wo) const
{
    Vec3d sum(0.0);
    for (size_t i = 0; i < lights_.size(); ++i) {
        const Incident incident = incidentFrom(lights_[i], point.position);
        const Vec3d wi = frame.local(incident.direction);
        if (!(wi.z > 0.0) || (shadow_ && shadow_(i, point, incident))) continue;
        sum += brdf(wo, wi) * wi.z * incident.irradiance;
    }
    return sum;
}

/// A colour and how much of what is behind it it hides.
struct Shade {
    Vec3d colour;
    double opacity = 1.0;
};

void addTo(float* pixel, const Shade& shade, double share)
{
    for (int c = 0; c < 3; ++c)
        pixel[c] += static_cast<float>(share * shade.opacity * shade.colour[c]);
    pixel[3] += static_cast<float>(share * shade.opacity);
}

Shade shadeOfGround(const Scene& scene, const Lighting& lighting, const Eye& eye,
                    const Fragment& fragment)
{
    const Instance& plane = scene.instances.back();
    const SurfacePoint point = surfacePoint(*plane.mesh, ToWorld(plane.model), fragment);
    return {lighting.ofGround(*scene.ground, point, eye.directionFrom(point.position)),
            scene.ground->opacity(point.position)};
}

/// Gives every covered pixel colour(fragment), the mean of its samples, rows in parallel; fragments
/// of the ground have a colour of their own.
template <class Colour>
Image pictureOf(const Scene& scene, const PictureOptions& options, const Lighting& lighting,
                const Colour& colour)
{
    const Eye eye(scene.view);
    const auto shade = [&](const Fragment& fragment) {
        return scene.isGround(fragment) ? shadeOfGround(scene, lighting, eye, fragment)
                                        : Shade{colour(fragment)};
    };
    Image image(options.width, options.height);
    for (int sample = 0; sample < options.samples; ++sample) {
        const gl::View view = movedBy(scene.view, subPixel(options.firstSample + sample),
                                      options.width, options.height);
        const Fragments fragments = rasterise(scene.instances, view, options.width, options.height);
        parallelTasks(static_cast<size_t>(options.height), options.threads, [&](size_t row) {
            const int y = static_cast<int>(row);
            for (int x = 0; x < options.width; ++x)
                if (const Fragment& fragment = fragments.at(x, y); fragment.covered())
                    addTo(image.pixel(x, y), shade(fragment), 1.0 / options.samples);
        });
    }
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
    return pictureOf(scene, options, lighting, [&](const Fragment& fragment) {
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
    for (size_t i = 0; i < scene.instances.size() - (scene.ground ? 1 : 0); ++i)
        colours.push_back(vertexRadiance(scene, lighting, scene.instances[i], options.threads));
    return pictureOf(scene, options, lighting, [&](const Fragment& fragment) {
        const size_t index = static_cast<size_t>(fragment.instance);
        return interpolate<Vec3d>(colours[index], *scene.instances[index].mesh, fragment);
    });
}

}  // namespace fbrdf::scene
