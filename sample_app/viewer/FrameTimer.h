// FrameTimer.h - how long the GL commands of a frame took.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <chrono>
#include <memory>

namespace fbrdf::viewer {

/// Timer queries where the context has them (OpenGL 3.3), else the wall clock around finished
/// frames. Belongs to the context that is current when it is made.
class FrameTimer {
public:
    explicit FrameTimer(gl::LoadFunction load);
    ~FrameTimer();
    FrameTimer(const FrameTimer&) = delete;
    FrameTimer& operator=(const FrameTimer&) = delete;

    void begin();
    /// Milliseconds since begin(). Waits until the commands in between have ended.
    double end();
    const char* clock() const;  ///< "gpu" or "cpu"

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf::viewer
