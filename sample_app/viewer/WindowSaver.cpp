#include "WindowSaver.h"

#include "FreeName.h"

#include <fbrdf/base/Error.h>

#include <utility>

namespace fbrdf::viewer {

WindowSaver::WindowSaver(const Options& options, World& world, scene::ViewState& state,
                         Progressive& progressive, CompareStage& compare, DocumentFiles& files)
    : options_(options),
      world_(world),
      state_(state),
      progressive_(progressive),
      compare_(compare),
      files_(files)
{
}

scene::Image WindowSaver::compared(double seconds, scene::Stats& stats)
{
    const scene::Document& document = options_.document;
    return compare_.composedNow(state_.compare, {document.exposure, transferOf(document)}, seconds,
                                stats);
}

void WindowSaver::savePicture(const std::string& path, double seconds, scene::Stats& stats)
{
    if (state_.compare.on) return writeImage(compared(seconds, stats), path, 1.0f);
    scene::Image image = progressive_.finishedImage();
    addBackground(options_, world_, progressive_.shown().view, image);
    writeImage(image, path, options_.document.exposure, transferOf(options_.document));
}

void WindowSaver::savePictures(double seconds, scene::Stats& stats, std::string& message)
{
    const bool png = std::exchange(state_.screenshot, false);
    const bool exr = std::exchange(state_.screenshotExr, false);
    for (const auto& [isWished, ending] : {std::pair(png, ".png"), std::pair(exr, ".exr")}) {
        if (!isWished) continue;
        const std::string path = freeName("fbrdf-viewer", ending);
        try {
            savePicture(path, seconds, stats);
            message = "wrote " + path;
        } catch (const Error& error) {
            message = error.what();
        }
    }
}

void WindowSaver::saveScene(int width, int height, std::string& message)
{
    if (!std::exchange(state_.save, false)) return;
    try {
        message = "wrote " + files_.save(width, height);
    } catch (const Error& error) {
        message = error.what();
    }
}

}  // namespace fbrdf::viewer
