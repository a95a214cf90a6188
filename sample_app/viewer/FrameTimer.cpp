#include "FrameTimer.h"

#include "GlFunctions.h"

namespace fbrdf::viewer {

using Clock = std::chrono::steady_clock;

struct FrameTimer::State {
    GladGLContext gl{};
    GLuint query = 0;  ///< 0: the wall clock
    Clock::time_point start;
};

FrameTimer::FrameTimer(gl::LoadFunction load) : state_(std::make_unique<State>())
{
    state_->gl = loadGlFunctions(load);
    if (state_->gl.VERSION_3_3) state_->gl.GenQueries(1, &state_->query);
}

FrameTimer::~FrameTimer()
{
    if (state_->query) state_->gl.DeleteQueries(1, &state_->query);
}

void FrameTimer::begin()
{
    if (state_->query) {
        state_->gl.BeginQuery(GL_TIME_ELAPSED, state_->query);
    } else {
        state_->gl.Finish();
        state_->start = Clock::now();
    }
}

double FrameTimer::end()
{
    if (state_->query) {
        GLuint64 nanoseconds = 0;
        state_->gl.EndQuery(GL_TIME_ELAPSED);
        state_->gl.GetQueryObjectui64v(state_->query, GL_QUERY_RESULT, &nanoseconds);
        return 1e-6 * static_cast<double>(nanoseconds);
    }
    state_->gl.Finish();
    return std::chrono::duration<double, std::milli>(Clock::now() - state_->start).count();
}

const char* FrameTimer::clock() const
{
    return state_->query ? "gpu" : "cpu";
}

}  // namespace fbrdf::viewer
