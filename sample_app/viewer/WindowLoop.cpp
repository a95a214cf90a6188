#include "WindowLoop.h"

#include "FrameTimer.h"
#include "GlfwWindow.h"
#include "GlScene.h"
#include "Headless.h"
#include "Panel.h"
#include "Progressive.h"
#include "ToneMapper.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/io/MaterialFile.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace fbrdf::viewer {
namespace {

constexpr size_t kKeptTimes = 240;    ///< frames whose times a window remembers
constexpr double kTurnRate = 20.0;    ///< of the turntable, degrees a second
constexpr double kLongestStep = 0.1;  ///< seconds that one frame turns it by, at most

/// A file without its folders; a model as it is.
std::string shortName(const std::string& spec)
{
    const std::filesystem::path path(spec);
    return std::filesystem::exists(path) ? path.filename().string() : spec;
}

/// The one asked for, then the others.
std::vector<std::string> startingWith(const std::string& first, std::vector<std::string> names)
{
    names.erase(std::remove(names.begin(), names.end(), first), names.end());
    names.insert(names.begin(), first);
    return names;
}

class WindowLoop {
public:
    WindowLoop(const Options& options, World& world)
        : options_(options),
          world_(world),
          environments_(startingWith(options.environment, environmentNames())),
          state_(initialState(options, world)),
          window_(options.width, options.height, "fbrdf", state_),
          panel_(window_.handle()),
          toneMapper_(GlfwWindow::loader()),
          scene_(GlfwWindow::loader(), world, options),
          progressive_(GlfwWindow::loader(), options, world, scene_),
          editor_(world, [this](size_t slot) { showMaterial(slot); }),
          stats_(statsOf(options, world))
    {
        window_.setFilter(
            {[this] { return panel_.wantsMouse(); }, [this] { return panel_.wantsKeys(); }});
        facts_.meshes = startingWith(options.mesh, {"sphere", "knot", "plane"});
        state_.meshCount = static_cast<int>(facts_.meshes.size());
        for (const MaterialSlot& slot : world.materials)
            facts_.materials.push_back(shortName(slot.name()));
        for (const std::string& name : environments_)
            facts_.environments.push_back(name.empty() ? "none" : shortName(name));
        state_.environmentCount = static_cast<int>(environments_.size());
        facts_.renderer = scene_.renderer().glRenderer();
        if (world_.environment) toneMapper_.setPanorama(world_.environment->panorama);
    }

    Picture run()
    {
        const int frames = options_.frames.value_or(0);
        for (int frame = 0; !window_.shouldClose() && (frames == 0 || frame < frames); ++frame)
            drawFrame();
        finishStats();
        return {progressive_.finishedImage(), stats_, progressive_.shown().view};
    }

private:
    static std::vector<std::string> environmentNames()
    {
        std::vector<std::string> names = proceduralEnvironments();
        names.emplace_back();  // none
        return names;
    }
    static scene::ViewState initialState(const Options& options, const World& world)
    {
        scene::ViewState state;
        state.camera = state.home = world.camera;
        state.technique = options.technique;
        state.materialCount = static_cast<int>(world.materials.size());
        state.lightCount = static_cast<int>(world.lights.size());
        state.madeLights = options.lights.empty();
        state.exposure = options.exposure;
        state.environmentDegrees = static_cast<float>(options.environmentRotation);
        state.environmentIntensity = static_cast<float>(options.environmentIntensity);
        state.environmentLobes = options.environmentLobes;
        state.turning = options.full && !options.frames;
        return state;
    }

    void followState();
    void followMaterials();
    void followDrops();
    void open(const std::string& path);
    void followEnvironment();
    void followMesh();
    void turn();
    void drawFrame();
    Shown wanted(GlfwWindow::Size size) const;
    void show(GlfwWindow::Size size);
    void showMaterial(size_t slot);
    void saveScreenshot();
    void finishStats();

    const Options& options_;
    World& world_;
    std::vector<std::string> environments_;  ///< names and files; "": none
    scene::ViewState state_;
    GlfwWindow window_;
    Panel panel_;
    ToneMapper toneMapper_;
    GlScene scene_;
    Progressive progressive_;
    MaterialEditor editor_;
    scene::Stats stats_;
    PanelFacts facts_;
    int mesh_ = 0, environment_ = 0, screenshots_ = 0;
    int revision_ = 0;    ///< of materials and lights that were replaced
    double angle_ = 0.0;  ///< of the turntable, radians
    std::chrono::steady_clock::time_point lastFrame_ = std::chrono::steady_clock::now();
};

/// A material of the world that is new, or another than before.
void WindowLoop::showMaterial(size_t slot)
{
    const bool isNew = slot == facts_.materials.size();
    scene_.setMaterial(slot, world_.materials[slot].material());
    if (isNew) facts_.materials.emplace_back();
    facts_.materials[slot] = shortName(world_.materials[slot].name());
    state_.materialCount = static_cast<int>(facts_.materials.size());
    if (isNew) state_.material = static_cast<int>(slot);
    ++revision_;
}

void WindowLoop::followMaterials()
{
    if (std::exchange(state_.cancel, false)) editor_.cancel();
    editor_.follow(static_cast<size_t>(state_.material));
    facts_.fit = editor_.facts();
}

/// Opens what was dropped: a mesh, lights, an environment, or else a material or what one is fitted
/// to.
void WindowLoop::open(const std::string& path)
{
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".obj") {
        scene::meshFromName(path);  // before anything changes
        facts_.meshes.push_back(path);
        state_.meshCount = static_cast<int>(facts_.meshes.size());
        state_.mesh = state_.meshCount - 1;
    } else if (extension == ".json" && !readIfMaterial(path)) {
        world_.lights = scene::readLights(path);
        state_.lightCount = static_cast<int>(world_.lights.size());
        state_.madeLights = false;
        ++revision_;
    } else if (extension == ".hdr") {
        environmentFrom(path, options_);
        environments_.push_back(path);
        facts_.environments.push_back(shortName(path));
        state_.environmentCount = static_cast<int>(environments_.size());
        state_.environment = state_.environmentCount - 1;
    } else {
        editor_.open(path);
    }
}

void WindowLoop::followDrops()
{
    for (const std::string& path : std::exchange(state_.dropped, {})) try {
            open(path);
            facts_.message = "opened " + shortName(path);
        } catch (const Error& error) {
            facts_.message = error.what();
        }
}

void WindowLoop::followMesh()
{
    if (state_.mesh == mesh_) return;
    mesh_ = state_.mesh;
    world_.mesh = scene::meshFromName(facts_.meshes[static_cast<size_t>(mesh_)]);
    world_.instances = {{&world_.mesh}};
    scene_.replaceMesh(world_.mesh);
    makeGround(options_, world_);
    if (world_.ground) scene_.replaceGround(*world_.ground);
}

void WindowLoop::followEnvironment()
{
    if (state_.environment != environment_) {
        environment_ = state_.environment;
        world_.environment =
            environmentFrom(environments_[static_cast<size_t>(environment_)], options_);
        scene_.replaceEnvironment(world_.environment ? &*world_.environment : nullptr);
        if (world_.environment) toneMapper_.setPanorama(world_.environment->panorama);
    }
    if (!world_.environment) return;
    world_.environment->rotation = static_cast<double>(state_.environmentDegrees) * kDegree;
    world_.environment->intensity = static_cast<double>(state_.environmentIntensity);
    scene_.turnEnvironment(*world_.environment, state_.environmentLobes);
}

/// Turns objects and ground on, as long as the runtime draws: the CPU needs pictures that stand.
void WindowLoop::turn()
{
    const auto now = std::chrono::steady_clock::now();
    const double step = std::min(
        kLongestStep, std::chrono::duration<double>(now - std::exchange(lastFrame_, now)).count());
    if (state_.turning && !isOnCpu(state_.technique)) angle_ += kTurnRate * kDegree * step;
    if (world_.ground) world_.ground->turnTo(angle_);
}

/// Brings the world in line with what keys and panel chose.
void WindowLoop::followState()
{
    followDrops();
    followMaterials();
    followMesh();
    followEnvironment();
    if (state_.madeLights && state_.lightCount != static_cast<int>(world_.lights.size()))
        world_.lights.lights = spreadAround(scene::makeLights(state_.lightCount, options_.seed),
                                            scene::boundsOf(world_.mesh));
    // Each pixel would take the sum over all texels: minutes, in which the window stands still.
    if (!options_.frames && world_.environment && isOnCpu(state_.technique) &&
        state_.technique != scene::ViewTechnique::path) {
        facts_.message = fmt::format("path instead of {}, which takes minutes with an environment",
                                     viewTechniqueName(state_.technique));
        state_.technique = scene::ViewTechnique::path;
    }
    turn();
    facts_.triangles = static_cast<int>(world_.mesh.indices.size() / 3);
}

Shown WindowLoop::wanted(GlfwWindow::Size size) const
{
    const double aspect = static_cast<double>(size.width) / size.height;
    return {viewOf(world_, state_.camera, aspect),
            state_.technique,
            scene::turned({&world_.mesh, glm::mat4(1.0f), state_.material}, angle_),
            mesh_,
            static_cast<int>(world_.lights.size()),
            size.width,
            size.height,
            environment_,
            state_.environmentLobes,
            revision_,
            state_.environmentDegrees,
            state_.environmentIntensity};
}

void WindowLoop::drawFrame()
{
    followState();
    const GlfwWindow::Size size = window_.framebufferSize();
    if (state_.frame)
        state_.camera = framed(state_.camera, scene::boundsOf(world_.mesh),
                               static_cast<double>(size.width) / size.height);
    state_.frame = false;
    bool isStill = true;
    if (const auto milliseconds =
            progressive_.draw(wanted(size), !facts_.fit.doing.empty(), stats_)) {
        std::vector<double>& times = stats_.milliseconds;
        if (!options_.frames && times.size() == kKeptTimes) times.erase(times.begin());
        times.push_back(*milliseconds);
        facts_.milliseconds = scene::spreadOf(times).median;
        isStill = false;
    }
    facts_.passes = stats_.passes;
    facts_.maxLookups = stats_.maxLookups;
    facts_.samples = progressive_.samples();
    facts_.samplesWanted = samplesOf(options_, state_.technique);
    show(size);
    panel_.draw(state_, facts_, editor_.fields(static_cast<size_t>(state_.material)));
    if (state_.screenshot) saveScreenshot();
    window_.present(isStill);
}

void WindowLoop::show(GlfwWindow::Size size)
{
    const Look look{state_.exposure, options_.toneMap, options_.background,
                    world_.environment ? &*world_.environment : nullptr, progressive_.shown().view};
    const gl::Target target{0, size.width, size.height};
    if (isOnCpu(state_.technique)) {
        if (progressive_.tookNewImage()) toneMapper_.upload(progressive_.image());
        toneMapper_.showUploaded(target, look);
    } else {
        toneMapper_.show(target, progressive_.sum(), look);
    }
}

void WindowLoop::saveScreenshot()
{
    state_.screenshot = false;
    const std::string path = fmt::format("fbrdf-viewer-{:03}.png", ++screenshots_);
    try {
        scene::Image image = progressive_.finishedImage();
        addBackground(options_, world_, progressive_.shown().view, image);
        writeImage(image, path, state_.exposure, transferOf(options_));
        facts_.message = "wrote " + path;
    } catch (const Error& error) {
        facts_.message = error.what();
    }
}

void WindowLoop::finishStats()
{
    stats_.backend = "window";
    stats_.technique = viewTechniqueName(state_.technique);
    stats_.samples = samplesOf(options_, state_.technique);
    stats_.mesh = facts_.meshes[static_cast<size_t>(mesh_)];
    stats_.lightsGiven = static_cast<int>(world_.lights.size());
}

}  // namespace

Picture runWindow(const Options& options, World& world)
{
    return WindowLoop(options, world).run();
}

}  // namespace fbrdf::viewer
