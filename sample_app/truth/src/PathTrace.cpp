#include "PathTrace.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/LobeSampling.h>
#include <fbrdf/scene/Ground.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::truth {
namespace {

// Paths are cut at random once they have so many surfaces behind them; before, all go on.
constexpr int kSafeSurfaces = 3;
// So many of those that lose no light go on all the same, so that every path ends.
constexpr double kMostSurvive = 0.95;

/// A local direction in proportion to the cosine (Malley's method: Pharr, Jakob, Humphreys 2016,
/// section 13.6.3).
SampledDirection<double> cosineDirection(const Vec2<double>& u)
{
    const double radius = std::sqrt(u.x), azimuth = 2.0 * kPi * u.y, cosine = std::sqrt(1.0 - u.x);
    return {{radius * std::cos(azimuth), radius * std::sin(azimuth), cosine}, cosine / kPi};
}

Vec3d toWorld(const ShadingFrame<double>& frame, const Vec3d& local)
{
    return local.x * frame.t + local.y * frame.s + local.z * frame.n;
}

double largestOf(const Vec3d& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

PathTrace::PathTrace(const scene::Scene& scene, std::vector<LobeTable> lobes,
                     const PathOptions& options)
    : scene_(scene),
      lobes_(std::move(lobes)),
      bounces_(options.bounces),
      search_(options.search),
      shadows_(options.shadows),
      eye_(scene.view),
      rays_(scene.instances)
{
    FBRDF_ASSERT(lobes_.size(), ==, scene.brdfs.size());
    FBRDF_ASSERT(bounces_, >=, 0);
    FBRDF_ASSERT(shadows_ || bounces_ == 0, ==, true);
    for (const AreaLight& light : scene.areaLights)
        if (whyInvalid(light).empty()) areas_.emplace_back(light);
    if (scene.environment) environment_.emplace(*scene.environment);
    if (scene.environment && scene.ground) sky_ = scene.environment->upwardIrradiance();
}

Vec3d PathTrace::radiance(const scene::Fragment& seen, Random& random) const
{
    Vec3d sum(0.0), throughput(1.0);
    Vertex vertex = vertexAt(seen, eye_.directionFrom(rays_.pointOf(seen).position));
    for (int surface = 0;; ++surface) {
        if (!(vertex.wo.z > 0.0)) return sum;
        if (!vertex.seesSky) sum += scene_.ground->reflectedSky(vertex.point.position, sky_);
        sum += throughput * (fromLights(vertex) + fromEmitters(vertex, random));
        if (surface == bounces_ && areas_.empty() && !environment_) return sum;
        const Step step = stepFrom(vertex, random);
        if (!(step.pdf > 0.0)) return sum;
        throughput *= step.weight;
        const Hit hit = shadows_ ? rays_.nearest(step.ray) : Hit();
        sum += throughput * emittedAlong(vertex, step, hit.distance);
        if (!hit.fragment.covered() || surface == bounces_) return sum;
        if (surface >= kSafeSurfaces) {
            // Arvo, Kirk 1990, "Particle Transport and Image Synthesis": Russian roulette.
            const double survival = std::min(kMostSurvive, largestOf(throughput));
            if (!(random.one() < survival)) return sum;
            throughput /= survival;
        }
        vertex = vertexAt(hit.fragment, -step.ray.direction);
    }
}

PathTrace::Vertex PathTrace::vertexAt(const scene::Fragment& fragment, const Vec3d& toViewer) const
{
    const scene::SurfacePoint point = rays_.pointOf(fragment);
    const auto material = static_cast<size_t>(rays_.instanceOf(fragment).material);
    const ShadingFrame<double> frame = shadingFrame(point.normal, point.tangent);
    return {point,
            rays_.departureFrom(fragment),
            frame.local(toViewer),
            frame,
            &scene_.brdfs[material],
            &lobes_[material],
            shadows_ || !scene_.isGround(fragment)};
}

PathTrace::Step PathTrace::stepFrom(const Vertex& vertex, Random& random) const
{
    const Vec2<double> u = random.two();
    const SampledDirection<double> drawn =
        vertex.lobes->isEmpty() ? cosineDirection(u) : sampleLobes(*vertex.lobes, vertex.wo, u);
    if (!(drawn.wi.z > 0.0)) return {};
    return {{vertex.departure, toWorld(vertex.frame, drawn.wi)},
            (*vertex.brdf)(vertex.wo, drawn.wi) * (drawn.wi.z / drawn.pdf),
            drawn.pdf};
}

/// docs/method.md, Eq. 2, with shadows.
Vec3d PathTrace::fromLights(const Vertex& vertex) const
{
    Vec3d sum(0.0);
    for (size_t i = 0; i < scene_.lights.size(); ++i) {
        const scene::Incident incident =
            scene::incidentFrom(scene_.lights[i], vertex.point.position);
        const Vec3d wi = vertex.frame.local(incident.direction);
        if (!(wi.z > 0.0) || incident.irradiance == Vec3d(0.0)) continue;
        if (isBlocked(vertex, incident.direction, incident.distance)) continue;
        if (!shadows_ && scene_.shadow && scene_.shadow(i, vertex.point, incident)) continue;
        sum += (*vertex.brdf)(vertex.wo, wi) * wi.z * incident.irradiance;
    }
    return sum;
}

/// One direction to each area light and to the environment.
Vec3d PathTrace::fromEmitters(const Vertex& vertex, Random& random) const
{
    Vec3d sum(0.0);
    if (search_ == LightSearch::byMaterials) return sum;
    for (const AreaEmitter& area : areas_)
        sum += reflected(vertex, area.drawn(vertex.point.position, random.two()));
    if (environment_ && vertex.seesSky) sum += reflected(vertex, environment_->drawn(random.two()));
    return sum;
}

Vec3d PathTrace::reflected(const Vertex& vertex, const Emission& emission) const
{
    const Vec3d wi = vertex.frame.local(emission.direction);
    if (!(wi.z > 0.0) || !(emission.pdf > 0.0) || emission.radiance == Vec3d(0.0))
        return Vec3d(0.0);
    if (isBlocked(vertex, emission.direction, emission.distance)) return Vec3d(0.0);
    const double materialPdf =
        vertex.lobes->isEmpty() ? wi.z / kPi : lobePdf(*vertex.lobes, vertex.wo, wi);
    return (*vertex.brdf)(vertex.wo, wi) * emission.radiance *
           (wi.z * shareOfLights(emission.pdf, materialPdf) / emission.pdf);
}

/// What arrives along a step from lights before something blocks them.
Vec3d PathTrace::emittedAlong(const Vertex& vertex, const Step& step, double blocked) const
{
    Vec3d sum(0.0);
    if (search_ == LightSearch::byLights) return sum;
    const auto add = [&](const Emission& emission) {
        // An emitter without a density is never drawn, so all of it is found here.
        if (emission.radiance != Vec3d(0.0) && rays_.isSeen(emission.distance, blocked))
            sum += emission.radiance * (1.0 - shareOfLights(emission.pdf, step.pdf));
    };
    for (const AreaEmitter& area : areas_)
        add(area.along(vertex.point.position, step.ray.direction));
    if (environment_ && vertex.seesSky) add(environment_->along(step.ray.direction));
    return sum;
}

/// The weight of light that was found by the lights' own densities; the rest is that of what
/// materials find. Veach, Guibas 1995, "Optimally Combining Sampling Techniques", section 4.2: the
/// power heuristic with exponent 2.
double PathTrace::shareOfLights(double lightPdf, double materialPdf) const
{
    if (search_ != LightSearch::combined) return search_ == LightSearch::byLights ? 1.0 : 0.0;
    const double ratio = materialPdf / lightPdf;
    return 1.0 / (1.0 + ratio * ratio);
}

}  // namespace fbrdf::truth
