// FrameTimer.h - how long a frame takes: wall clock from finished GL commands to finished GL
// commands. Timer queries would leave out what a pass costs before it reaches the GPU, and on
// llvmpipe the vertices, which it processes before the query that precedes them.
#pragma once
#include "GlFunctions.h"

#include <chrono>

namespace fbrdf::viewer {

/// Belongs to the context that is current when it is made.
class FrameTimer {
public:
    explicit FrameTimer(gl::LoadFunction load) : gl_(loadGlFunctions(load)) {}

    void begin()
    {
        gl_.Finish();
        start_ = Clock::now();
    }
    /// Milliseconds since begin(). Waits until the commands in between have ended.
    double end()
    {
        gl_.Finish();
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    GladGLContext gl_;
    Clock::time_point start_;
};

}  // namespace fbrdf::viewer
