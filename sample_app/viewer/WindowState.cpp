#include "WindowState.h"

#include "DocumentFiles.h"

#include <fbrdf/environment/Sky.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

/// The document of a world as it was loaded: what had been left to the program is decided.
scene::Document documentOf(const Options& options, const World& world)
{
    scene::Document document = options.document;
    document.camera = world.camera;
    document.shown = std::max(0, document.shown);
    if (!options.lights.empty()) document.lights = {0, document.lights.seed, world.lights};
    return document;
}

}  // namespace

scene::ViewState initialState(const Options& options, const World& world)
{
    scene::Document document = documentOf(options, world);
    scene::ViewState state;
    state.meshes = {"sphere", "knot", "plane"};
    state.environments = proceduralEnvironments();
    state.environments.emplace_back();  // none
    addName(document.mesh, state.meshes);
    addName(document.environment.name, state.environments);
    state.home = *document.camera;
    state.document = std::move(document);
    return state;
}

std::string browsedFolder(const Options& options)
{
    if (!options.browse.empty()) return options.browse;
    for (const scene::SceneMaterial& material : options.document.materials)
        if (std::filesystem::is_regular_file(material.source)) {
            const auto folder = std::filesystem::path(material.source).parent_path();
            return folder.empty() ? "." : folder.string();
        }
    return "";
}

}  // namespace fbrdf::viewer
