#include "SceneFile.h"

#include "CompareSide.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/scene/DocumentJson.h>
#include <fbrdf/scene/TextFile.h>
#include <fbrdf/sources/Model.h>

#include <filesystem>

namespace fbrdf::viewer {
namespace {

namespace fs = std::filesystem;

bool isMeshName(const std::string& name)
{
    return name == "sphere" || name == "knot" || name == "plane";
}

/// Changes what names a file, and leaves what names something built in.
template <class Change>
void changePaths(scene::Document& document, const Change& change)
{
    for (scene::SceneMaterial& material : document.materials)
        if (!namesModel(material.source)) change(material.source);
    if (!isMeshName(document.mesh)) change(document.mesh);
    for (std::string* side : {&document.compare.a, &document.compare.b})
        if (namesFile(*side)) change(*side);
    std::string& environment = document.environment.name;
    if (!environment.empty() && !isProceduralEnvironment(environment)) change(environment);
}

/// A choice after a path, as in FILE@0.532, stays at its end: it is a part of the last name.
fs::path folderOf(const std::string& path)
{
    return fs::absolute(path).lexically_normal().parent_path();
}

}  // namespace

bool isSceneFile(const std::string& path)
{
    if (fs::path(path).extension() != ".json" || !fs::is_regular_file(path)) return false;
    try {
        return scene::readText(path, "a scene").find("\"fbrdf_scene\"") != std::string::npos;
    } catch (const Error&) {
        return false;
    }
}

scene::Document readScene(const std::string& path)
{
    scene::Document document =
        scene::documentFromJson(scene::readText(path, "a scene, JSON"), path);
    const fs::path folder = fs::path(path).parent_path();
    changePaths(document, [&folder](std::string& file) { file = (folder / file).string(); });
    return document;
}

void writeScene(const scene::Document& document, const std::string& path)
{
    const fs::path folder = folderOf(path);
    scene::Document moved = document;
    changePaths(moved, [&folder](std::string& file) {
        file = fs::absolute(file).lexically_normal().lexically_proximate(folder).string();
    });
    writeFile(path, scene::documentToJson(moved));
}

}  // namespace fbrdf::viewer
