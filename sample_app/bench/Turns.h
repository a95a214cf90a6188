// Turns.h - times drawings in turn: one frame of each, then the next frame of each, so that
// other load of the machine affects all alike.
#pragma once
#include "bench/Options.h"
#include "bench/Variants.h"
#include "viewer/FrameTimer.h"

#include <fbrdf/headless/Context.h>
#include <fbrdf/headless/Offscreen.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

/// A context of this program, with a renderer and a target in it.
struct Rig {
    explicit Rig(const Options& options);
    Scene scene(Stage stage, std::vector<Light> lights);

    HeadlessContext context;
    GladGLContext gl;
    gl::Renderer renderer;
    Offscreen offscreen;
    viewer::FrameTimer timer;
    Options::Clock clock;
};

struct Run {
    std::string name;
    Draw draw;
    std::vector<double> frames = {};  ///< milliseconds of each frame
    double spent = 0.0;
};

/// Draws each once untimed (drivers compile what they need while they draw), then fills in frames.
void time(Rig& rig, std::vector<Run>& runs);

}  // namespace fbrdf::bench
