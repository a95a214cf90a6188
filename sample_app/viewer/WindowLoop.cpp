#include "WindowLoop.h"

#include "Browser.h"
#include "CompareStage.h"
#include "CursorInspector.h"
#include "DocumentFiles.h"
#include "FrameTimer.h"
#include "GlfwWindow.h"
#include "Headless.h"
#include "LightEditor.h"
#include "MaterialEditor.h"
#include "Motion.h"
#include "Panel.h"
#include "Progressive.h"
#include "WindowSaver.h"
#include "WindowState.h"
#include "WindowTimes.h"
#include "WorldUpdate.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/scene/History.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace fbrdf::viewer {
namespace {

constexpr size_t kKeptTimes = 240;   ///< frames whose times a window remembers
constexpr double kMostRest = 0.025;  ///< seconds between two frames while something is fitted

class WindowLoop {
public:
    WindowLoop(const Options& options, World& world)
        : options_(options),
          world_(world),
          state_(initialState(options, world)),
          window_(options.width, options.height, "fbrdf", state_),
          panel_(window_.handle()),
          toneMapper_(GlfwWindow::loader()),
          scene_(GlfwWindow::loader(), world, options_),
          progressive_(GlfwWindow::loader(), options_, world, scene_),
          editor_(world, [this](size_t slot) { showMaterial(slot); }),
          compare_(GlfwWindow::loader(), options_, world, scene_),
          inspector_(GlfwWindow::loader()),
          update_(world, scene_, toneMapper_, state_.document),
          lightEditor_(state_, world),
          history_(state_.document),
          files_(state_, editor_, update_, options.scene),
          browser_(GlfwWindow::loader(), browsedFolder(options), ThumbnailCache(thumbnailFolder())),
          stats_(statsOf(options, world))
    {
        window_.setFilter({[this] { return panel_.wantsMouse(); },
                           [this] { return panel_.wantsKeys(); },
                           [this](const glm::dvec2& pixel) { return lightEditor_.press(pixel); },
                           [this](const glm::dvec2& pixel) { lightEditor_.drag(pixel); },
                           [this] {
                               followWishes();
                               followHistory();
                           }});
        compare_.sync(state_.compare, state_.document.compare);
        facts_.compare = &compare_.facts();
        facts_.cursor = &inspector_.facts();
        facts_.renderer = scene_.renderer().glRenderer();
        facts_.passRows = &scene_.passes().rows();
        facts_.stats = &stats_;
        browser_.follow(state_.document);
        state_.browser.on = browser_.items().size() > 1;
    }

    Picture run()
    {
        const int frames = options_.frames.value_or(0);
        for (int frame = 0; !window_.shouldClose() && (frames == 0 || frame < frames); ++frame)
            drawFrame();
        saver_.savePictures(motion_.seconds(), stats_,
                            facts_.message);  // asked for in the frame that closed the window
        finishStats();
        if (state_.compare.on) {
            scene::Image image = saver_.compared(motion_.seconds(), stats_);
            return {std::move(image), stats_, {}, true};
        }
        return {progressive_.finishedImage(), stats_, progressive_.shown().view};
    }

private:
    void followDrops();
    void followWishes();
    void syncComparison();
    void followFits();
    void followState();
    void followHistory();
    void drawFrame();
    Shown wanted(GlfwWindow::Size size) const;
    bool drawMaterial(GlfwWindow::Size size);
    bool drawComparison(GlfwWindow::Size size);
    void inspect(GlfwWindow::Size size);
    void browse();
    Look lookOf(const gl::View& view) const;
    void show(GlfwWindow::Size size);
    void showMaterial(size_t slot);
    void finishStats();

    Options options_;  ///< its document is that of the state
    World& world_;
    scene::ViewState state_;
    GlfwWindow window_;
    Panel panel_;
    ToneMapper toneMapper_;
    GlScene scene_;
    Progressive progressive_;
    MaterialEditor editor_;
    CompareStage compare_;
    CursorInspector inspector_;
    WorldUpdate update_;
    LightEditor lightEditor_;
    scene::History history_;
    DocumentFiles files_;
    Browser browser_;
    scene::Stats stats_;
    WindowTimes times_;
    PanelFacts facts_;
    int lastShown_ = 0;  ///< of the document, in the frame before
    int drawnSlot_ = 0;  ///< of the world's materials
    Motion motion_;
    WindowSaver saver_{options_, world_, state_, progressive_, compare_, files_};
};

/// A material of the world that is new, or another than before.
void WindowLoop::showMaterial(size_t slot)
{
    scene_.setMaterial(slot, world_.materials[slot].material());
    browser_.forget(slot);
    update_.countChange();
    times_.made(world_.materials[slot].name());
}

void WindowLoop::followDrops()
{
    for (const std::string& path : std::exchange(state_.dropped, {})) try {
            times_.dropped(path);
            files_.open(path);
            facts_.message = "opened " + shortName(path);
        } catch (const Error& error) {
            facts_.message = error.what();
            times_.refused(path, facts_.message);
        }
}

/// What keys and panel chose becomes a part of the document; what undo or a scene did is shown.
void WindowLoop::syncComparison()
{
    try {
        compare_.sync(state_.compare, state_.document.compare);
    } catch (const Error& error) {
        facts_.message = error.what();
    }
}

void WindowLoop::followWishes()
{
    syncComparison();
    if (std::exchange(state_.cancel, false)) {
        editor_.cancel();
        compare_.cancel();
    }
    if (std::exchange(state_.undo, false))
        facts_.message = history_.undo(state_.document) ? "undone" : "nothing to undo";
    if (std::exchange(state_.redo, false))
        facts_.message = history_.redo(state_.document) ? "redone" : "nothing to redo";
    const GlfwWindow::Size size = window_.framebufferSize();
    saver_.saveScene(size.width, size.height, facts_.message);
    lightEditor_.follow();
    if (std::exchange(state_.frame, false)) {
        state_.document.camera = framed(*state_.document.camera, scene::boundsOf(world_.mesh),
                                        static_cast<double>(size.width) / size.height);
    }
}

void WindowLoop::followFits()
{
    editor_.follow(state_.document);
    facts_.fit = editor_.facts();
    times_.refused(facts_.fit.failed, facts_.fit.problem);
    const scene::SceneMaterial* const shown = shownMaterial(state_.document);
    if (shown && shown->slot >= 0) drawnSlot_ = shown->slot;
    facts_.isFitted =
        shown && shown->slot >= 0 && world_.materials[static_cast<size_t>(shown->slot)].source();
}

/// Brings the world in line with what keys and panel chose.
void WindowLoop::followState()
{
    followDrops();
    followWishes();
    followFits();
    // The CPU needs pictures that stand.
    motion_.follow(state_.document, state_.compare.on ? compare_.isOnCpu(state_.document.technique)
                                                      : isOnCpu(state_.document.technique));
    scene::Document& document = state_.document;
    try {
        update_.follow(document);
    } catch (const Error& error) {
        facts_.message = error.what();
    }
    // Each pixel would take the sum over all texels: minutes, in which the window stands still.
    if (!options_.frames && world_.environment &&
        document.technique == scene::ViewTechnique::vertex) {
        facts_.message = fmt::format("path instead of {}, which takes minutes with an environment",
                                     viewTechniqueName(document.technique));
        document.technique = scene::ViewTechnique::path;
    }
    if (world_.ground) world_.ground->turnTo(document.moment.tableDegrees * kDegree);
    followHistory();
    options_.document = document;
    facts_.triangles = static_cast<int>(world_.mesh.indices.size() / 3);
    facts_.lights = static_cast<int>(world_.lights.size());
}

/// A drag is one change: what it does is followed when it ends.
void WindowLoop::followHistory()
{
    syncComparison();
    if (!window_.isHeld() && !panel_.isHeld()) history_.follow(state_.document);
    facts_.canUndo = history_.canUndo();
    facts_.canRedo = history_.canRedo();
}

Shown WindowLoop::wanted(GlfwWindow::Size size) const
{
    const double aspect = static_cast<double>(size.width) / size.height;
    const scene::Document& document = state_.document;
    return {viewOf(world_, *document.camera, aspect),
            document.technique,
            scene::turned({&world_.mesh, glm::mat4(1.0f), drawnSlot_},
                          document.moment.tableDegrees * kDegree),
            size.width,
            size.height,
            update_.revision()};
}

void WindowLoop::drawFrame()
{
    const bool isFitting = !facts_.fit.doing.empty();
    times_.begin(isFitting, panel_.isHeld());
    followState();
    const GlfwWindow::Size size = window_.framebufferSize();
    const bool moved = state_.compare.on ? drawComparison(size) : drawMaterial(size);
    if (state_.cursor.on) inspect(size);
    lightEditor_.see(wanted(size).view, size.width, size.height);
    facts_.handles = lightEditor_.handles();
    facts_.drawnLights = &world_.lights;
    browse();
    facts_.isDrawing = moved || (scene_.isRefining() && !isOnCpu(state_.document.technique));
    panel_.draw(state_, facts_);
    saver_.savePictures(motion_.seconds(), stats_, facts_.message);
    window_.present();
    const double seconds = 1e-3 * times_.presented();
    if (times_.stats().frames == 1 && !options_.frames) editor_.warm(state_.document);
    const bool isBusy = isFitting && moved && progressive_.isSlow();
    const bool madeThumbnail = state_.browser.on && !options_.frames &&
                               browser_.makeOne(state_.document, world_, isFitting);
    // Where the processor draws, some of it is left to the fit.
    window_.takeInput(!moved, isBusy && !madeThumbnail ? std::min(kMostRest, 0.5 * seconds) : 0.0);
}

/// Returns whether anything was drawn.
bool WindowLoop::drawMaterial(GlfwWindow::Size size)
{
    const auto milliseconds = progressive_.draw(wanted(size), !facts_.fit.doing.empty(), stats_);
    if (milliseconds) {
        std::vector<double>& times = stats_.milliseconds;
        if (!options_.frames && times.size() == kKeptTimes) times.erase(times.begin());
        times.push_back(*milliseconds);
        facts_.milliseconds = scene::spreadOf(times).median;
    }
    facts_.passes = stats_.passes;
    facts_.maxLookups = stats_.maxLookups;
    facts_.passesLeft = scene_.passes().left();
    facts_.samples = progressive_.samples();
    facts_.samplesWanted = samplesOf(options_, options_.document.technique);
    show(size);
    return milliseconds.has_value();
}

/// The same of both sides of a comparison.
bool WindowLoop::drawComparison(GlfwWindow::Size size)
{
    const size_t slot = static_cast<size_t>(drawnSlot_);
    compare_.follow(state_.compare, world_.materials[slot]);
    if (options_.frames) compare_.wait();
    const Shown shown = wanted(size);
    return compare_.draw(state_.compare,
                         {shown,
                          lookOf(shown.view),
                          {0, size.width, size.height},
                          !facts_.fit.doing.empty(),
                          window_.isHeld(),
                          motion_.seconds()},
                         toneMapper_);
}

void WindowLoop::inspect(GlfwWindow::Size size)
{
    MaterialSlot& material = world_.materials[static_cast<size_t>(drawnSlot_)];
    const Shown shown = wanted(size);
    inspector_.answer({{state_.cursor.x, state_.cursor.y},
                       {shown.instance},
                       shown.view,
                       &world_.lights,
                       compare_.subjects(state_.compare, material, shown.revision),
                       material.source()});
}

/// Shows or opens what was chosen.
void WindowLoop::browse()
{
    scene::BrowserView& view = state_.browser;
    if (!options_.frames) browser_.follow(state_.document);
    facts_.browser = &browser_.items();
    view.count = static_cast<int>(browser_.items().size());
    if (std::exchange(lastShown_, state_.document.shown) != state_.document.shown)
        view.chosen = state_.document.shown;
    view.chosen = std::clamp(view.chosen, 0, std::max(0, view.count - 1));
    if (!std::exchange(view.open, false) || view.count == 0) return;
    const BrowserItem item = browser_.items()[static_cast<size_t>(view.chosen)];
    if (item.place >= 0)
        state_.document.shown = item.place;
    else
        state_.dropped.push_back(item.source);
}

Look WindowLoop::lookOf(const gl::View& view) const
{
    const scene::Document& document = options_.document;
    return {document.exposure, document.toneMap, document.background,
            world_.environment ? &*world_.environment : nullptr, view};
}

void WindowLoop::show(GlfwWindow::Size size)
{
    const scene::Document& document = options_.document;
    const Look look = lookOf(progressive_.shown().view);
    const gl::Target target{0, size.width, size.height};
    if (isOnCpu(document.technique)) {
        if (progressive_.tookNewImage()) toneMapper_.upload(progressive_.image());
        toneMapper_.showUploaded(target, look);
    } else {
        toneMapper_.show(target, progressive_.sum(), look);
    }
}

void WindowLoop::finishStats()
{
    const scene::Document& document = state_.document;
    stats_.backend = "window";
    stats_.window = times_.stats();
    stats_.technique = viewTechniqueName(document.technique);
    stats_.samples = samplesOf(options_, document.technique);
    stats_.mesh = document.mesh;
    stats_.lightsGiven = static_cast<int>(world_.lights.size());
}

}  // namespace

Picture runWindow(const Options& options, World& world)
{
    return WindowLoop(options, world).run();
}

}  // namespace fbrdf::viewer
