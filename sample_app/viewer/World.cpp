#include "World.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/codecs/PanoramaFile.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/plan/Plan.h>
#include <fbrdf/scene/LightEdit.h>
#include <fbrdf/truth/Occluders.h>

#include <fstream>

namespace fbrdf::viewer {
namespace {

// A full scene is seen from a little above, so that the horizon is out of sight, with room around.
constexpr double kElevation = 0.36, kRoom = 1.3;

double aspectOf(const Options& options)
{
    return static_cast<double>(options.width) / options.height;
}

scene::Camera cameraOf(const Options& options, const World& world)
{
    if (options.document.camera) return *options.document.camera;
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

scene::SceneMaterial defaultMaterial(const std::string& form)
{
    // Gold, brushed along the tangent. Form and smoothness are given, so that it is ready in a
    // second, without a search.
    scene::SceneMaterial gold;
    gold.source = "ggx:alpha_x=0.18,alpha_y=0.45,f0=1.0/0.71/0.29,kd=0";
    gold.form = form == "auto" ? "pqpr" : form;
    gold.smoothness = 1e-3;
    return gold;
}

std::optional<scene::EnvironmentLight> environmentFrom(const scene::SceneEnvironment& environment)
{
    const std::string& name = environment.name;
    if (name.empty()) return std::nullopt;
    scene::EnvironmentLight light;
    light.panorama = isProceduralEnvironment(name) ? proceduralEnvironment(name)
                                                   : readPanorama(name, &light.note);
    turnTo(environment, light);
    return light;
}

std::optional<scene::EnvironmentLight> panoramaOf(const std::string& path)
{
    // The tables of fitter/sources/src/formats/ImageTable.h may name their layout in an attribute,
    // which is in the header.
    constexpr size_t kHeader = 65536;
    std::ifstream file(path, std::ios::binary);
    std::string begin(kHeader, '\0');
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (begin.find("fbrdf:layout") != std::string::npos) return std::nullopt;
    scene::SceneEnvironment environment;
    environment.name = path;
    try {
        return environmentFrom(environment);
    } catch (const Error&) {
        return std::nullopt;
    }
}

void turnTo(const scene::SceneEnvironment& environment, scene::EnvironmentLight& light)
{
    light.rotation = static_cast<double>(environment.degrees) * kDegree;
    light.intensity = static_cast<double>(environment.intensity);
}

void loadWorld(const Options& options, World& world)
{
    const scene::Document& document = options.document;
    for (const scene::SceneMaterial& material : document.materials)
        world.materials.emplace_back(material.source, fitOptionsOf(material));
    // Windows, sheets and turntables show one material at a time.
    const bool all = options.headless && options.command == Command::view && document.shown < 0;
    const int count = all ? static_cast<int>(world.materials.size()) : 1;
    world.mesh = scene::meshFromName(document.mesh);
    world.coarseMesh = scene::coarseMeshFromName(document.mesh);
    world.instances = scene::arranged(world.mesh, count, aspectOf(options));
    const scene::Bounds bounds = scene::boundsOf(world.instances);
    world.lights = options.lights.empty()
                       ? orbited(lightsOf(document.lights, bounds), Vec3d(bounds.centre),
                                 document.moment.lightsDegrees * kDegree)
                       : scene::readLights(options.lights);
    world.environment = environmentFrom(document.environment);
    world.camera = cameraOf(options, world);
    if (document.ground) makeGround(world);
    if (document.shown >= 0) {
        world.instances[0].material = document.shown;
        turnTable(document.moment.tableDegrees, world);
    }
}

void makeGround(World& world)
{
    world.ground = std::make_unique<scene::Ground>(world.instances);
    world.ground->setVisibility(visibleSky(truth::Occluders(world.instances), *world.ground));
}

void turnTable(double degrees, World& world)
{
    const scene::Instance standing{&world.mesh, glm::mat4(1.0f), world.instances[0].material};
    world.instances = {turned(standing, degrees * kDegree)};
    if (world.ground) world.ground->turnTo(degrees * kDegree);
}

void addBackground(const Options& options, const World& world, const gl::View& view,
                   scene::Image& image)
{
    const scene::EnvironmentLight* environment = world.environment ? &*world.environment : nullptr;
    if (options.document.background.environment && !environment) return;  // taken away in a window
    fillBackground(image, options.document.background, environment, view);
}

scene::Stats statsOf(const Options& options, const World& world)
{
    scene::Stats stats;
    stats.technique = viewTechniqueName(options.document.technique);
    if (!isOnCpu(options.document.technique)) {
        stats.lookUp = lookUpName(options.document.lookUp);
        stats.filter = filterName(options.document.precise ? Filter::shader : Filter::hardware);
    }
    stats.mesh = options.document.mesh;
    stats.environment = options.document.environment.name;
    if (world.environment) stats.environmentNote = world.environment->note;
    for (const MaterialSlot& slot : world.materials) stats.materials.push_back(slot.name());
    stats.evaluated = "material";
    stats.width = options.width;
    stats.samples = samplesOf(options, options.document.technique);
    stats.ground = world.ground != nullptr;
    stats.shadows =
        options.document.shadows || options.document.technique == scene::ViewTechnique::path;
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
