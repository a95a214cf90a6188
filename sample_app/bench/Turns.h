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

/// How long the GPU takes, by a timer query.
class GpuTimer {
public:
    /// wanted: false makes a timer that must not be used. Throws Error(gl) for a context that has
    /// none.
    GpuTimer(const GladGLContext& gl, bool wanted);
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;
    void begin() const;
    double end() const;  ///< milliseconds; waits for them

private:
    const GladGLContext& gl_;
    GLuint query_ = 0;
};

/// A context of this program, with a renderer and a target in it.
struct Rig {
    explicit Rig(const Options& options);
    Scene scene(Stage stage, std::vector<Light> lights);

    HeadlessContext context;
    GladGLContext gl;
    gl::Renderer renderer;
    Offscreen offscreen;
    viewer::FrameTimer timer;
    GpuTimer gpuTimer;
    Options::Clock clock;
};

struct Run {
    std::string name;
    Draw draw;
    bool draws = true;                ///< false: it calls no GL, and no GPU's clock can time it
    std::vector<double> frames = {};  ///< milliseconds of each frame
    double spent = 0.0;
};

/// Draws each once untimed (drivers compile what they need while they draw), then fills in frames.
void time(Rig& rig, std::vector<Run>& runs);

}  // namespace fbrdf::bench
