#include "bench/Turns.h"

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
    rig.timer.begin();
    const double before = cpuMilliseconds();
    rig.offscreen.clear();
    run.draw();
    const double wall = rig.timer.end(), cpu = cpuMilliseconds() - before;
    run.frames.push_back(rig.clock == Options::Clock::cpu ? cpu : wall);
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

Rig::Rig(const Options& options)
    : context(HeadlessOptions{}),
      gl(viewer::loadGlFunctions(context.loader())),
      renderer(rendererOptions(context)),
      offscreen(context.loader(), {options.width, options.height}),
      timer(context.loader()),
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
