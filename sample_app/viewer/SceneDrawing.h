// SceneDrawing.h - one picture of a world after the other, without a display, by whatever technique
// the options name.
#pragma once
#include "HeadlessDrawing.h"

namespace fbrdf::viewer {

class SceneDrawing {
public:
    /// The world must outlive this. Throws Error(gl) where the technique needs GL and there is
    /// none.
    SceneDrawing(const Options& options, World& world);

    /// Takes the environment and the lights that the world has now.
    void followLights();
    /// An object of the world's mesh, with ground and background.
    scene::Image draw(const scene::Instance& instance);

private:
    const Options& options_;
    World& world_;
    std::optional<HeadlessDrawing> runtime_;  ///< of its techniques
};

}  // namespace fbrdf::viewer
