#include "bench/Turns.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <ctime>

namespace fbrdf::bench {
namespace {

constexpr int kMostFrames = 15, kFewestFrames = 3;
// Time and frames for one drawing: many frames of a fast one, few of a slow one.
constexpr double kBudgetMilliseconds = 600.0;

gl::RendererOptions rendererOptions(const HeadlessContext& context)
{
    gl::RendererOptions options;
    options.load = context.loader();
    return options;
}

HeadlessOptions contextOptions(const Options& options)
{
    HeadlessOptions result;
    result.device = options.device;
    return result;
}

/// The CPU time of all threads of this process.
double cpuMilliseconds()
{
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

bool wantsMore(const Run& run)
{
    const auto count = static_cast<int>(run.frames.size());
    return count < kFewestFrames || (count < kMostFrames && run.spent < kBudgetMilliseconds);
}

void frame(Rig& rig, Run& run)
{
    const bool onGpu = rig.clock == Options::Clock::gpu && run.draws;
    rig.timer.begin();
    if (onGpu) rig.gpuTimer.begin();
    const double before = cpuMilliseconds();
    rig.offscreen.clear();
    run.draw();
    const double gpu = onGpu ? rig.gpuTimer.end() : 0.0, wall = rig.timer.end(),
                 cpu = cpuMilliseconds() - before;
    run.frames.push_back(onGpu ? gpu : rig.clock == Options::Clock::cpu ? cpu : wall);
    run.spent += wall;
}

bool round(Rig& rig, std::vector<Run>& runs)
{
    bool any = false;
    for (Run& run : runs) {
        if (!wantsMore(run)) continue;
        frame(rig, run);
        any = true;
    }
    return any;
}

}  // namespace

GpuTimer::GpuTimer(const GladGLContext& gl, bool wanted) : gl_(gl)
{
    if (!wanted) return;
    GLint bits = 0;
    if (gl.VERSION_3_3) gl.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0)
        throw Error(ErrorKind::gl, "--clock gpu",
                    Found("a context without timer queries").expected("OpenGL 3.3 with them"));
    gl.GenQueries(1, &query_);
}

GpuTimer::~GpuTimer()
{
    if (query_ != 0) gl_.DeleteQueries(1, &query_);
}

void GpuTimer::begin() const
{
    gl_.BeginQuery(GL_TIME_ELAPSED, query_);
}

double GpuTimer::end() const
{
    gl_.EndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
    return 1e-6 * static_cast<double>(nanoseconds);
}

Rig::Rig(const Options& options)
    : context(contextOptions(options)),
      gl(viewer::loadGlFunctions(context.loader())),
      renderer(rendererOptions(context)),
      offscreen(context.loader(), {options.width, options.height}),
      timer(context.loader()),
      gpuTimer(gl, options.clock == Options::Clock::gpu),
      clock(options.clock)
{
}

Scene Rig::scene(Stage stage, std::vector<Light> lights)
{
    return {gl,
            renderer,
            std::move(stage),
            std::move(lights),
            {offscreen.framebuffer(), offscreen.width(), offscreen.height()}};
}

void time(Rig& rig, std::vector<Run>& runs)
{
    for (Run& run : runs) frame(rig, run);
    for (Run& run : runs) run.frames.clear(), run.spent = 0.0;
    while (round(rig, runs)) {
    }
}

}  // namespace fbrdf::bench
