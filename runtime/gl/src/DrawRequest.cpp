#include "DrawRequest.h"

#include "MeshResources.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/environment/SampledLight.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf::gl {
namespace {

// Moving so many lights to eye space takes as long as waking a thread.
constexpr size_t kLightsPerTask = 512;

bool isFinite(const glm::mat4& m)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

// Lights are moved to eye space and pixels back by these matrices: NaN would spread silently.
void checkView(const View& view)
{
    const auto fail = [](const std::string& what) { throw Error(ErrorKind::usage, "view", what); };
    if (!isFinite(view.view) || !isFinite(view.projection))
        fail(Found("a number that is not finite").expected("finite matrices"));
    if (glm::determinant(glm::dmat4(view.projection)) == 0.0)
        fail(Found("a singular projection").expected("an invertible one"));
}

/// True where the columns are orthonormal but for what rounding leaves of a product of rotations.
bool isRotation(const glm::mat3& m)
{
    constexpr float kRounding = 1e-3f;
    const glm::mat3 squared = glm::transpose(m) * m;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(squared[c][r] - (c == r ? 1.0f : 0.0f)) <= kRounding)) return false;
    return true;
}

bool passes(float depth, DepthTest test, float stored)
{
    switch (test) {
        case DepthTest::less: return depth < stored;
        case DepthTest::lessEqual: return depth <= stored;
        case DepthTest::greater: return depth > stored;
        case DepthTest::greaterEqual: return depth >= stored;
    }
    return false;
}

void checkDepth(const Device& device, const DepthOptions& depth)
{
    const auto fail = [](const std::string& what) { throw Error(ErrorKind::usage, "view", what); };
    for (const float value : {depth.rangeLow, depth.rangeHigh, depth.clear})
        if (!(value >= 0.0f && value <= 1.0f))
            fail(Found("depth " + numberText(double(value))).expected("one in [0, 1]"));
    // Everything would be hidden: most often reversed depth with the usual test or clear value.
    if (!passes(depth.rangeLow, depth.test, depth.clear) &&
        !passes(depth.rangeHigh, depth.test, depth.clear))
        fail(Found("clear depth " + numberText(double(depth.clear)) +
                   " against which no depth of the range passes the depth test")
                 .expected("one"));
    if (depth.clip == ClipDepth::zeroToOne && !device.capabilities.clipControl)
        throw Error(ErrorKind::gl, "view",
                    Found("a context without glClipControl").expected("it for depths in [0, 1]"));
}

/// The item that loses most counts: lights that are not valid are lost by every item.
void countLost(const LightSelection& selection, DrawStats& stats)
{
    stats.lightsCulled += selection.culled;
    stats.lightsDropped =
        std::max(stats.lightsDropped, stats.lightsGiven - stats.lightsUsed + selection.dropped);
}

void checkTarget(const Device& device, const Target& target)
{
    const auto fail = [](const std::string& what) { throw Error(ErrorKind::gl, "target", what); };
    if (target.width <= 0 || target.height <= 0)
        fail(Found(std::to_string(target.width) + "x" + std::to_string(target.height) + " pixels")
                 .expected("at least one"));
    if (!(target.exposure > 0.0f) || !std::isfinite(target.exposure))
        fail(Found("exposure " + numberText(double(target.exposure)))
                 .expected("a finite number above 0"));
    if (target.framebuffer != 0 && !device.capabilities.framebufferObjects)
        fail(Found("framebuffer object " + std::to_string(target.framebuffer) +
                   " in a context without framebuffer objects")
                 .expected("0"));
}

}  // namespace

void checkRequest(const Device& device, const Target& target, const View& view)
{
    checkTarget(device, target);
    checkView(view);
    checkDepth(device, view.depth);
}

bool isInvertible(const glm::mat4& model)
{
    return isFinite(model) && glm::determinant(glm::dmat3(model)) != 0.0;
}

void setLights(DrawRequest& request, const std::vector<Light>& lights, Workers& workers)
{
    // In double: far from the origin of the world floats lose the distance between light and
    // surface.
    const glm::dmat4 toEye(request.view.view);
    // Linear targets store radiance itself, without exposure (Target::exposure).
    const bool exposed = request.target.transfer != Transfer::linear;
    // Numbers stay those of the host's list, invalid lights included: hooks receive them.
    request.eye.numbers.reserve(lights.size());
    for (size_t i = 0; i < lights.size(); ++i)
        if (isValid(lights[i])) request.eye.numbers.push_back(static_cast<int32_t>(i));
    request.lights.resize(request.eye.numbers.size());
    request.eye.vectors.resize(request.eye.numbers.size());
    const size_t count = request.lights.size();
    workers.run((count + kLightsPerTask - 1) / kLightsPerTask, [&](size_t task) {
        const size_t end = std::min(count, (task + 1) * kLightsPerTask);
        for (size_t i = task * kLightsPerTask; i < end; ++i) {
            Light& light = request.lights[i];
            light = lights[static_cast<size_t>(request.eye.numbers[i])];
            if (exposed) light.intensity *= request.target.exposure;
            request.eye.vectors[i] = lightVectors(light, toEye);
        }
    });
}

void setAreaLights(DrawRequest& request, Device& device, int lights)
{
    const glm::dmat4 toEye(request.view.view);
    const bool exposed = request.target.transfer != Transfer::linear;
    int number = lights;
    for (const AreaLight& given : request.options.areaLights) {
        const int index = number++;
        const std::string why = whyInvalid(given);
        if (!why.empty()) {
            device.logOnce(Severity::warning,
                           "area light " + std::to_string(index - lights) + " left out: " + why);
            continue;
        }
        AreaLight& light = request.areaLights.emplace_back(given);
        if (exposed) light.radiance *= request.target.exposure;
        request.firstAreas.push_back(request.eye.areas.size());
        appendAreaVectors(light, index, toEye, request.eye.areas);
    }
    request.firstAreas.push_back(request.eye.areas.size());
}

void setEnvironment(DrawRequest& request, const Device& device)
{
    const EnvironmentLight& light = request.options.environment;
    const auto fail = [](const std::string& what) {
        throw Error(ErrorKind::usage, "environment", what);
    };
    if (!light.map) return;
    const EnvironmentResources& map = light.map->resources();
    if (map.device() != &device) fail(Found("one of another renderer").expected("one of this"));
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(light.intensity[c]) || light.intensity[c] < 0.0f)
            fail(Found("intensity " + numberText(double(light.intensity[c])))
                     .expected("a finite number, 0 or more"));
    if (!isRotation(light.rotation))
        fail(Found("a matrix that is no rotation").expected("orthonormal columns"));
    if (light.lobes < 0)
        fail(Found(std::to_string(light.lobes) + " lobes").expected("0 (all) or more"));
    if (light.samples < 0 || light.samples > kMostSamples)
        fail(Found(std::to_string(light.samples) + " directions")
                 .expected("0 (none) to " + std::to_string(kMostSamples)));
    if (light.samples > 0 && map.unfiltered() == 0)
        fail(Found("directions of an environment whose unfiltered cube was not kept")
                 .expected("EnvironmentOptions::unfiltered"));
    if (light.intensity == Vec3f(0.0f)) return;
    const bool exposed = request.target.transfer != Transfer::linear;
    request.environment.map = &map;
    // Both matrices are rigid, so that their inverses are their transposes.
    request.environment.fromEye =
        glm::mat3(glm::transpose(glm::dmat3(light.rotation)) *
                  glm::transpose(glm::dmat3(glm::dmat4(request.view.view))));
    request.environment.scale =
        glm::vec4(light.intensity * (exposed ? request.target.exposure : 1.0f),
                  static_cast<float>(map.levels() - kLobeLevels));
    request.environment.lobes = light.lobes;
    request.environment.samples = light.samples;
}

EyeLights lightsOf(const Sphere& bounds, const DrawRequest& request, DrawStats& stats)
{
    const LightSelection selection =
        selectLights(request.lights, bounds, request.options.maxLights);
    countLost(selection, stats);
    EyeLights result;
    for (const int i : selection.lights) {
        result.vectors.push_back(request.eye.vectors[static_cast<size_t>(i)]);
        result.numbers.push_back(request.eye.numbers[static_cast<size_t>(i)]);
        result.peaks.push_back(largestIrradiance(request.lights[static_cast<size_t>(i)], bounds));
    }
    return result;
}

std::vector<AreaVectors> areasOf(const Sphere& bounds, const DrawRequest& request, DrawStats& stats)
{
    // Lists have their own limit, for each part of the view.
    const int most = request.areaClusters ? 0 : request.options.maxLights;
    const LightSelection selection = selectLights(request.areaLights, bounds, most);
    countLost(selection, stats);
    std::vector<AreaVectors> result;
    for (const int i : selection.lights) {
        const auto light = static_cast<size_t>(i);
        for (size_t k = request.firstAreas[light]; k < request.firstAreas[light + 1]; ++k)
            result.push_back(request.eye.areas[k]);
    }
    return result;
}

void putNeighboursTogether(EyeLights& lights, const DrawRequest& request)
{
    // Lights are sorted by their places on screen: neighbours in space may be far apart there, and
    // the other way round.
    std::vector<PixelRect> rects;
    for (const LightVectors& light : lights.vectors)
        rects.push_back(pixelBounds(light, glm::dmat4(request.view.projection),
                                    request.target.width, request.target.height));
    EyeLights ordered;
    ordered.areas = std::move(lights.areas);
    for (const int i : neighboursTogether(rects)) {
        ordered.vectors.push_back(lights.vectors[static_cast<size_t>(i)]);
        ordered.numbers.push_back(lights.numbers[static_cast<size_t>(i)]);
        ordered.peaks.push_back(lights.peaks[static_cast<size_t>(i)]);
    }
    lights = std::move(ordered);
}

/// A matrix stretches no vector by more than its Frobenius norm. The last factor is more than the
/// float rounding of centre and radius.
Sphere worldBounds(const Sphere& bounds, const glm::mat4& model)
{
    const glm::dmat3 linear(model);
    const double norm = std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                                  glm::dot(linear[2], linear[2]));
    return {Vec3f(glm::dmat4(model) * glm::dvec4(Vec3d(bounds.centre), 1.0)),
            static_cast<float>(norm * static_cast<double>(bounds.radius) * (1.0 + 1e-6))};
}

Sphere enclosing(const std::vector<Sphere>& spheres)
{
    FBRDF_ASSERT(spheres.size(), >, 0u);
    Vec3f low = spheres[0].centre, high = low;
    for (const Sphere& sphere : spheres) {
        low = glm::min(low, sphere.centre);
        high = glm::max(high, sphere.centre);
    }
    Sphere result{0.5f * (low + high), 0.0f};
    for (const Sphere& sphere : spheres)
        result.radius =
            std::max(result.radius, glm::distance(result.centre, sphere.centre) + sphere.radius);
    return result;
}

}  // namespace fbrdf::gl
