#include "WindowLoop.h"

#include "CpuDrawing.h"
#include "FrameTimer.h"
#include "GlfwWindow.h"
#include "GlScene.h"
#include "Headless.h"
#include "Panel.h"
#include "ToneMapper.h"

#include <fmt/core.h>

#include <fbrdf/base/Error.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

// While the view changes, the CPU draws one pixel in 4 x 4, so that the mouse stays responsive.
constexpr int kCoarseStep = 4;
constexpr size_t kKeptTimes = 240;  ///< frames whose times a window remembers

/// What a picture depends on; a CPU picture is drawn anew only when it changes.
struct Shown {
    scene::Camera camera;
    scene::ViewTechnique technique;
    int material, mesh, lightCount, width, height;

    bool operator==(const Shown& o) const
    {
        return camera.eye == o.camera.eye && camera.centre == o.camera.centre &&
               technique == o.technique && material == o.material && mesh == o.mesh &&
               lightCount == o.lightCount && width == o.width && height == o.height;
    }
};

/// A file without its folders; a model as it is.
std::string shortName(const std::string& spec)
{
    const std::filesystem::path path(spec);
    return std::filesystem::exists(path) ? path.filename().string() : spec;
}

class WindowLoop {
public:
    WindowLoop(const Options& options, World& world)
        : options_(options),
          world_(world),
          state_(initialState(options, world)),
          window_(options.width, options.height, "fbrdf", state_),
          panel_(window_.handle()),
          timer_(GlfwWindow::loader()),
          toneMapper_(GlfwWindow::loader()),
          scene_(GlfwWindow::loader(), world, options),
          stats_(statsOf(options, world))
    {
        window_.setFilter(
            {[this] { return panel_.wantsMouse(); }, [this] { return panel_.wantsKeys(); }});
        facts_.meshes = meshNames(options.mesh);
        state_.meshCount = static_cast<int>(facts_.meshes.size());
        for (const MaterialSlot& slot : world.materials)
            facts_.materials.push_back(shortName(slot.name()));
        facts_.renderer = scene_.renderer().glRenderer();
    }

    Picture run()
    {
        const int frames = options_.frames.value_or(0);
        for (int frame = 0; !window_.shouldClose() && (frames == 0 || frame < frames); ++frame)
            drawFrame();
        finishStats();
        return {picture(), stats_};
    }

private:
    static scene::ViewState initialState(const Options& options, const World& world)
    {
        scene::ViewState state;
        state.camera = state.home = options.camera ? world.camera : scene::Camera();
        state.technique = options.technique;
        state.materialCount = static_cast<int>(world.materials.size());
        state.lightCount = static_cast<int>(world.lights.size());
        state.madeLights = options.lights.empty();
        state.exposure = options.exposure;
        return state;
    }

    /// The mesh asked for, then the others.
    static std::vector<std::string> meshNames(const std::string& first)
    {
        std::vector<std::string> names{first};
        for (const char* name : {"sphere", "knot", "plane"})
            if (name != first) names.emplace_back(name);
        return names;
    }

    void drawFrame();
    void followState();
    void drawWithRuntime(GlfwWindow::Size size);
    void drawWithCpu(const Shown& shown);
    void saveScreenshot();
    void finishStats();
    scene::Image picture();

    gl::View view(int width, int height) const
    {
        return viewOf(world_, state_.camera, static_cast<double>(width) / height);
    }
    scene::Instance instance() const { return {&world_.mesh, glm::mat4(1.0f), state_.material}; }
    void remember(double milliseconds)
    {
        std::vector<double>& times = stats_.milliseconds;
        if (!options_.frames && times.size() == kKeptTimes) times.erase(times.begin());
        times.push_back(milliseconds);
        facts_.milliseconds = scene::spreadOf(times).median;
    }

    const Options& options_;
    World& world_;
    scene::ViewState state_;
    GlfwWindow window_;
    Panel panel_;
    FrameTimer timer_;
    ToneMapper toneMapper_;
    GlScene scene_;
    scene::Stats stats_;
    PanelFacts facts_;
    int mesh_ = 0, screenshots_ = 0;
    std::optional<Shown> drawn_;  ///< what the CPU's picture shows
    bool coarse_ = false;
    std::unique_ptr<CpuDrawing> cpu_;
};

/// Brings mesh and lights in line with what keys and panel chose.
void WindowLoop::followState()
{
    if (state_.mesh != mesh_) {
        mesh_ = state_.mesh;
        world_.mesh = scene::meshFromName(facts_.meshes[static_cast<size_t>(mesh_)]);
        scene_.replaceMesh(world_.mesh);
    }
    if (state_.madeLights && state_.lightCount != static_cast<int>(world_.lights.size()))
        world_.lights.lights = spreadAround(scene::makeLights(state_.lightCount, options_.seed),
                                            scene::boundsOf(world_.mesh));
    facts_.triangles = static_cast<int>(world_.mesh.indices.size() / 3);
}

void WindowLoop::drawFrame()
{
    followState();
    const GlfwWindow::Size size = window_.framebufferSize();
    if (state_.frame)
        state_.camera = framed(state_.camera, scene::boundsOf(world_.mesh),
                               static_cast<double>(size.width) / size.height);
    state_.frame = false;
    const Shown shown{state_.camera,
                      state_.technique,
                      state_.material,
                      mesh_,
                      static_cast<int>(world_.lights.size()),
                      size.width,
                      size.height};
    if (isOnCpu(state_.technique))
        drawWithCpu(shown);
    else
        drawWithRuntime(size);
    toneMapper_.show(size.width, size.height, state_.exposure);
    panel_.draw(state_, facts_);
    if (state_.screenshot) saveScreenshot();
    window_.present();
}

void WindowLoop::drawWithRuntime(GlfwWindow::Size size)
{
    drawn_.reset();
    stats_.path.reset();
    timer_.begin();
    const gl::Target target = toneMapper_.clearedTarget(size.width, size.height);
    const gl::DrawStats drawn = scene_.draw(target, {runtimeTechnique(state_.technique),
                                                     {instance()},
                                                     view(size.width, size.height),
                                                     &world_.lights,
                                                     world_.ground.get()});
    remember(timer_.end());
    addDrawStats(drawn, scene_.renderer(), stats_);
    facts_.passes = drawn.passes;
    facts_.maxLookups = drawn.maxLookups;
}

/// Draws coarsely while things change, in full once they stand still, sample by sample where there
/// are some, and then not at all.
void WindowLoop::drawWithCpu(const Shown& shown)
{
    const bool changed = !drawn_ || !(*drawn_ == shown);
    if (!changed && !coarse_ && cpu_->isFinished()) return;
    const bool isCounted = options_.frames.has_value();  // a counted frame is worth its full size
    const auto start = std::chrono::steady_clock::now();
    if (changed || coarse_) {
        coarse_ = changed && !isCounted;
        const int step = coarse_ ? kCoarseStep : 1;
        cpu_ = std::make_unique<CpuDrawing>(options_, world_,
                                            CpuRequest{state_.technique,
                                                       {instance()},
                                                       view(shown.width, shown.height),
                                                       std::max(1, shown.width / step),
                                                       std::max(1, shown.height / step)});
    }
    do cpu_->goOn();
    while (isCounted && !cpu_->isFinished());
    toneMapper_.upload(cpu_->image());
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    remember(time.count());
    stats_.accumulation = "double";
    stats_.path = cpu_->pathStats();
    facts_.samples = stats_.path ? stats_.path->samples : 0;
    drawn_ = shown;
}

scene::Image WindowLoop::picture()
{
    if (!isOnCpu(state_.technique)) return toneMapper_.readTarget();
    if (coarse_) drawWithCpu(*drawn_);
    return cpu_ ? cpu_->image() : scene::Image();
}

void WindowLoop::saveScreenshot()
{
    state_.screenshot = false;
    const std::string path = fmt::format("fbrdf-viewer-{:03}.png", ++screenshots_);
    try {
        writeImage(picture(), path, state_.exposure);
        facts_.message = "wrote " + path;
    } catch (const Error& error) {
        facts_.message = error.what();
    }
}

void WindowLoop::finishStats()
{
    stats_.backend = "window";
    stats_.technique = viewTechniqueName(state_.technique);
    stats_.mesh = facts_.meshes[static_cast<size_t>(mesh_)];
    stats_.lightsGiven = static_cast<int>(world_.lights.size());
}

}  // namespace

Picture runWindow(const Options& options, World& world)
{
    return WindowLoop(options, world).run();
}

}  // namespace fbrdf::viewer
