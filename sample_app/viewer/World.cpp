#include "World.h"

#include <fbrdf/codecs/PanoramaFile.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/plan/Plan.h>
#include <fbrdf/scene/KeyLights.h>
#include <fbrdf/truth/Occluders.h>

namespace fbrdf::viewer {
namespace {

// The material that is shown without --material: gold, brushed along the tangent. Its form and
// smoothness are given, so that it is ready in a second, without a search.
const char* const kDefaultMaterial = "ggx:alpha_x=0.18,alpha_y=0.45,f0=1.0/0.71/0.29,kd=0";
constexpr double kDefaultSmoothness = 1e-3;

constexpr int kDefaultLights = 5;
// A full scene is seen from a little above, so that the horizon is out of sight, with room around.
constexpr double kElevation = 0.36, kRoom = 1.3;

/// The materials that the options ask for, or the default one.
void loadMaterials(const Options& options, std::deque<MaterialSlot>& materials)
{
    FitOptions fit;
    fit.form = options.form;
    for (const std::string& spec : options.materials) materials.emplace_back(spec, fit);
    if (!materials.empty()) return;
    if (fit.form == "auto") fit.form = "pqpr";
    fit.smoothness = kDefaultSmoothness;
    materials.emplace_back(kDefaultMaterial, fit);
}

double aspectOf(const Options& options)
{
    return static_cast<double>(options.width) / options.height;
}

scene::LightSet lightsOf(const Options& options, const scene::Bounds& bounds)
{
    if (!options.lights.empty()) return scene::readLights(options.lights);
    if (options.full && !options.lightCount) return {scene::keyLights(), {}};
    const int count = options.lightCount.value_or(kDefaultLights);
    return {spreadAround(scene::makeLights(count, options.seed), bounds), {}};
}

scene::Camera cameraOf(const Options& options, const World& world)
{
    if (options.camera) return *options.camera;
    if (options.full) {
        scene::Bounds bounds = scene::boundsOf(world.instances);
        bounds.radius *= static_cast<float>(kRoom);
        const scene::Camera above{{0.0, std::sin(kElevation), std::cos(kElevation)}};
        return framed(above, bounds, aspectOf(options));
    }
    // One object is seen by the standard camera, wherever its file puts it; several must fit.
    return world.instances.size() == 1 ? scene::Camera()
                                       : scene::facing(world.instances, aspectOf(options));
}

}  // namespace

std::optional<scene::EnvironmentLight> environmentFrom(const std::string& name,
                                                       const Options& options)
{
    if (name.empty()) return std::nullopt;
    scene::EnvironmentLight light;
    light.panorama = isProceduralEnvironment(name) ? proceduralEnvironment(name)
                                                   : readPanorama(name, &light.note);
    light.rotation = options.environmentRotation * kDegree;
    light.intensity = options.environmentIntensity;
    return light;
}

void loadWorld(const Options& options, World& world)
{
    loadMaterials(options, world.materials);
    // Windows, sheets and turntables show one material at a time.
    const bool all = options.headless && options.command == Command::view;
    const int count = all ? static_cast<int>(world.materials.size()) : 1;
    world.mesh = scene::meshFromName(options.mesh);
    world.instances = scene::arranged(world.mesh, count, aspectOf(options));
    const scene::Bounds bounds = scene::boundsOf(world.instances);
    world.lights = lightsOf(options, bounds);
    world.environment = environmentFrom(options.environment, options);
    world.camera = cameraOf(options, world);
    makeGround(options, world);
}

void makeGround(const Options& options, World& world)
{
    if (!options.ground) return;
    world.ground = std::make_unique<scene::Ground>(world.instances);
    world.ground->setVisibility(visibleSky(truth::Occluders(world.instances), *world.ground));
}

void addBackground(const Options& options, const World& world, const gl::View& view,
                   scene::Image& image)
{
    const scene::EnvironmentLight* environment = world.environment ? &*world.environment : nullptr;
    if (options.background.environment && !environment) return;  // taken away in a window
    fillBackground(image, options.background, environment, view);
}

scene::Stats statsOf(const Options& options, const World& world)
{
    scene::Stats stats;
    stats.technique = viewTechniqueName(options.technique);
    if (!isOnCpu(options.technique)) {
        stats.lookUp = lookUpName(options.lookUp);
        stats.filter = filterName(options.precise ? Filter::shader : Filter::hardware);
    }
    stats.mesh = options.mesh;
    stats.environment = options.environment;
    if (world.environment) stats.environmentNote = world.environment->note;
    for (const MaterialSlot& slot : world.materials) stats.materials.push_back(slot.name());
    stats.evaluated = "material";
    stats.width = options.width;
    stats.samples = samplesOf(options, options.technique);
    stats.ground = world.ground != nullptr;
    stats.shadows = options.shadows || options.technique == scene::ViewTechnique::path;
    stats.height = options.height;
    stats.lightsGiven = static_cast<int>(world.lights.size());
    return stats;
}

gl::View viewOf(const World& world, const scene::Camera& camera, double aspect)
{
    return viewFromCamera(camera, aspect,
                          world.ground ? world.ground->bounds() : scene::boundsOf(world.instances));
}

gl::View viewOf(const Options& options, const World& world)
{
    return viewOf(world, world.camera, aspectOf(options));
}

}  // namespace fbrdf::viewer
