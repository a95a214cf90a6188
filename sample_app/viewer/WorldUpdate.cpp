#include "WorldUpdate.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/scene/LightEdit.h>

#include <utility>

namespace fbrdf::viewer {

WorldUpdate::WorldUpdate(World& world, GlScene& scene, ToneMapper& toneMapper,
                         scene::Document document)
    : world_(world), scene_(scene), toneMapper_(toneMapper), shown_(std::move(document))
{
    if (world_.environment) toneMapper_.setPanorama(world_.environment->panorama);
    placed_ = lightsOf(shown_.lights, scene::boundsOf(world_.mesh));
}

void WorldUpdate::follow(scene::Document& document)
{
    try {
        followMesh(document);
        followEnvironment(document);
    } catch (const Error&) {
        document.mesh = shown_.mesh;
        document.environment.name = shown_.environment.name;
        throw;
    }
    followLights(document);
    followStyle(document);
}

void WorldUpdate::followMesh(const scene::Document& document)
{
    if (document.mesh == shown_.mesh && document.ground == shown_.ground) return;
    if (document.mesh != shown_.mesh) {
        world_.mesh = scene::meshFromName(document.mesh);
        world_.coarseMesh = scene::coarseMeshFromName(document.mesh);
        scene_.replaceMesh(world_);
        placed_.reset();
    }
    world_.instances = {{&world_.mesh}};
    world_.ground.reset();
    if (document.ground) {
        makeGround(world_);
        scene_.replaceGround(*world_.ground);
    }
    shown_.mesh = document.mesh;
    shown_.ground = document.ground;
    countChange();
}

void WorldUpdate::followLights(const scene::Document& document)
{
    if (!(document.lights == shown_.lights)) placed_.reset();
    const double degrees = document.moment.lightsDegrees;
    if (placed_ && degrees == shown_.moment.lightsDegrees) return;
    const scene::Bounds objects = scene::boundsOf(world_.mesh);
    if (!placed_) placed_ = lightsOf(document.lights, objects);
    world_.lights =
        degrees == 0.0 ? *placed_ : orbited(*placed_, Vec3d(objects.centre), degrees * kDegree);
    shown_.lights = document.lights;
    shown_.moment.lightsDegrees = degrees;
    countChange();
}

bool WorldUpdate::readEnvironment(const std::string& path)
{
    read_ = panoramaOf(path);
    readPath_ = path;
    return read_.has_value();
}

void WorldUpdate::followEnvironment(const scene::Document& document)
{
    const scene::SceneEnvironment& wanted = document.environment;
    scene::SceneEnvironment& shown = shown_.environment;
    if (wanted == shown) return;
    // Directions need a table beside the cube.
    const bool sampledAnew = (wanted.samples > 0) != (shown.samples > 0);
    if (wanted.name != shown.name)
        world_.environment =
            read_ && wanted.name == readPath_ ? std::exchange(read_, {}) : environmentFrom(wanted);
    scene_.setEnvironmentSamples(wanted.samples);
    if (wanted.name != shown.name || sampledAnew) {
        scene_.replaceEnvironment(world_.environment ? &*world_.environment : nullptr);
        if (world_.environment) toneMapper_.setPanorama(world_.environment->panorama);
    }
    if (world_.environment) {
        turnTo(wanted, *world_.environment);
        scene_.turnEnvironment(*world_.environment, wanted.lobes);
    }
    shown = wanted;
    countChange();
}

void WorldUpdate::followStyle(const scene::Document& document)
{
    if (document.lookUp != shown_.lookUp || document.precise != shown_.precise) {
        scene_.setUpload(document.lookUp, document.precise, world_);
        countChange();
    }
    if (document.shadows != shown_.shadows) {
        scene_.setShadows(document.shadows, world_);
        countChange();
    }
    if (!(document.limits == shown_.limits)) {
        scene_.setLimits(document.limits);
        countChange();
    }
    if (document.target != shown_.target || document.samples != shown_.samples ||
        document.pathSamples != shown_.pathSamples || document.spread != shown_.spread)
        countChange();
    shown_.lookUp = document.lookUp;
    shown_.precise = document.precise;
    shown_.shadows = document.shadows;
    shown_.limits = document.limits;
    shown_.target = document.target;
    shown_.samples = document.samples;
    shown_.pathSamples = document.pathSamples;
    shown_.spread = document.spread;
}

}  // namespace fbrdf::viewer
