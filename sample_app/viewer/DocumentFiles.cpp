#include "DocumentFiles.h"

#include "FreeName.h"
#include "SceneFile.h"

#include <fbrdf/base/Text.h>
#include <fbrdf/io/MaterialFile.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

/// True where a file, by its ending, may be a picture.
bool isPicture(const std::string& path)
{
    const std::string ending = lowerCase(std::filesystem::path(path).extension().string());
    constexpr const char* kEndings[] = {".exr", ".hdr",  ".pic", ".png",
                                        ".jpg", ".jpeg", ".tif", ".tiff"};
    return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

}  // namespace

void addName(const std::string& name, std::vector<std::string>& names)
{
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

void DocumentFiles::open(const std::string& path)
{
    const std::string extension = std::filesystem::path(path).extension().string();
    scene::Document& document = state_.document;
    if (extension == ".obj") {
        document.mesh = path;
        addName(path, state_.meshes);
    } else if (isSceneFile(path)) {
        openScene(path);
    } else if (extension == ".json" && !readIfMaterial(path)) {
        document.lights = {0, document.lights.seed, scene::readLights(path)};
    } else if (isPicture(path) && update_.readEnvironment(path)) {
        document.environment.name = path;
        addName(path, state_.environments);
    } else {
        editor_.open(path);
    }
}

void DocumentFiles::openScene(const std::string& path)
{
    scene::Document document = readScene(path);
    if (!document.camera) document.camera = state_.home;
    if (document.materials.empty()) document.materials.push_back(defaultMaterial("auto"));
    document.shown = std::max(0, document.shown);
    addName(document.mesh, state_.meshes);
    addName(document.environment.name, state_.environments);
    state_.document = std::move(document);
    scenePath_ = path;
}

std::string DocumentFiles::save(int width, int height)
{
    scene::Document document = state_.document;
    document.moment.width = width;
    document.moment.height = height;
    const std::string path = scenePath_.empty() ? freeName("fbrdf-viewer", ".json") : scenePath_;
    writeScene(document, path);
    scenePath_ = path;
    return path;
}

}  // namespace fbrdf::viewer
