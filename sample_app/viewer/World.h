// World.h - everything that the options ask to see, loaded.
#pragma once
#include "MaterialSlot.h"
#include "Options.h"

#include <fbrdf/scene/Environment.h>
#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/Image.h>
#include <fbrdf/scene/Layout.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/scene/Stats.h>

#include <deque>
#include <memory>
#include <optional>

namespace fbrdf::viewer {

struct World {
    std::deque<MaterialSlot> materials;  ///< a deque, so that truth() may point into it
    scene::Mesh mesh;
    std::optional<scene::Mesh> coarseMesh;  ///< of it, for coarse pictures; none: there is no other
    std::vector<scene::Instance> instances;  ///< of mesh, one a material
    scene::LightSet lights;
    std::optional<scene::EnvironmentLight> environment;
    std::unique_ptr<scene::Ground> ground;  ///< below the instances; null: none
    scene::Camera camera;
};

/// Throws Error for whatever cannot be loaded. The world must stay where it is made.
void loadWorld(const Options& options, World& world);

/// The material that is shown where none is asked for; form: "auto" for the one that suits it.
scene::SceneMaterial defaultMaterial(const std::string& form);

/// Reads or makes an environment; none for one without a name. Throws what reading it throws.
std::optional<scene::EnvironmentLight> environmentFrom(const scene::SceneEnvironment& environment);
/// The panorama that a picture is; none where it has another shape, says that it is a table of
/// reflectance, or cannot be read.
std::optional<scene::EnvironmentLight> panoramaOf(const std::string& path);
/// Gives a light that has been read the rotation and intensity of an environment.
void turnTo(const scene::SceneEnvironment& environment, scene::EnvironmentLight& light);

/// Puts a ground below the instances, and finds what they hide of its sky.
void makeGround(World& world);
/// Turns a single object and the ground to an angle about +y.
void turnTable(double degrees, World& world);

/// A finished picture and what was done for it.
struct Picture {
    scene::Image image;  ///< without background, unless it is shown
    scene::Stats stats;
    gl::View view;
    bool isShown = false;  ///< linear values of what a screen shows, to be written at exposure 1
};

/// The fields of the stats that do not depend on how the picture was drawn.
scene::Stats statsOf(const Options& options, const World& world);

/// Puts the background that the options ask for behind what was drawn from a view.
void addBackground(const Options& options, const World& world, const gl::View& view,
                   scene::Image& image);

/// What a camera sees in a picture of `aspect` = width / height.
gl::View viewOf(const World& world, const scene::Camera& camera, double aspect);
/// The view that the options ask for.
gl::View viewOf(const Options& options, const World& world);

}  // namespace fbrdf::viewer
