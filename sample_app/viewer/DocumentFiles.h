// DocumentFiles.h - opens what is dropped on a window, and saves its scene.
#pragma once
#include "MaterialEditor.h"
#include "WorldUpdate.h"

#include <fbrdf/scene/Controls.h>

#include <string>

namespace fbrdf::viewer {

/// Adds a name to a list unless it is in there.
void addName(const std::string& name, std::vector<std::string>& names);

class DocumentFiles {
public:
    /// All must outlive this. scenePath: of the scene that the document came from, or empty.
    DocumentFiles(scene::ViewState& state, MaterialEditor& editor, WorldUpdate& update,
                  std::string scenePath)
        : state_(state), editor_(editor), update_(update), scenePath_(std::move(scenePath))
    {
    }

    /// Opens a mesh, lights, a scene, a picture of the shape of a panorama (others may be tables of
    /// reflectance), or else a material or what one is fitted to. Throws what reading it throws;
    /// what is fitted says so later.
    void open(const std::string& path);
    /// Writes the scene to its file, or to a new one, for a picture of so many pixels. Returns the
    /// path. Throws Error(output).
    std::string save(int width, int height);

private:
    void openScene(const std::string& path);

    scene::ViewState& state_;
    MaterialEditor& editor_;
    WorldUpdate& update_;
    std::string scenePath_;
};

}  // namespace fbrdf::viewer
