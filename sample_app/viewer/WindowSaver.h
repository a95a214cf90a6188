// WindowSaver.h - writes what a window shows: its picture, and its scene.
#pragma once
#include "CompareStage.h"
#include "DocumentFiles.h"
#include "Progressive.h"

#include <fbrdf/scene/Controls.h>

#include <string>

namespace fbrdf::viewer {

class WindowSaver {
public:
    /// All must outlive this; options have the document that is drawn.
    WindowSaver(const Options& options, World& world, scene::ViewState& state,
                Progressive& progressive, CompareStage& compare, DocumentFiles& files);

    /// Writes the picture with all its samples where that is wished for: sRGB as it is shown (.png)
    /// or linear radiance (.exr). seconds: Motion::seconds(). Fills `message` where it did.
    void savePictures(double seconds, scene::Stats& stats, std::string& message);
    /// The same of the scene, whose picture has that size.
    void saveScene(int width, int height, std::string& message);
    /// Both sides of a comparison with all their samples, laid over each other.
    scene::Image compared(double seconds, scene::Stats& stats);

private:
    void savePicture(const std::string& path, double seconds, scene::Stats& stats);

    const Options& options_;
    World& world_;
    scene::ViewState& state_;
    Progressive& progressive_;
    CompareStage& compare_;
    DocumentFiles& files_;
};

}  // namespace fbrdf::viewer
