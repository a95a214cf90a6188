// SceneFile.h - scenes on disk: JSON, in which paths of files are relative to the scene's folder.
#pragma once
#include <fbrdf/scene/Document.h>

#include <string>

namespace fbrdf::viewer {

/// True where a file that can be read looks like a scene, a damaged one included.
bool isSceneFile(const std::string& path);

/// Throws Error(input) for a file that is missing or no scene. The files that it names are not
/// opened. Their paths begin at the scene's folder.
scene::Document readScene(const std::string& path);

/// Writes a document, with paths relative to the folder of `path`: files below it or beside it may
/// be moved along with it. Throws Error(output).
void writeScene(const scene::Document& document, const std::string& path);

}  // namespace fbrdf::viewer
