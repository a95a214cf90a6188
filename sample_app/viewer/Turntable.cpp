#include "Turntable.h"

#include "NewFolder.h"
#include "SceneDrawing.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/codecs/AnimationFile.h>

#include <fmt/core.h>
#include <unistd.h>

#include <functional>

namespace fbrdf::viewer {
namespace {

constexpr int kFramesPerSecond = 20;  // a GIF knows hundredths of a second alone: 5 of them

/// Draws all frames in turn; `take` gets each.
void drawTurn(const Options& options, World& world,
              const std::function<void(int frame, const scene::Image&)>& take)
{
    SceneDrawing drawing(options, world);
    const int frames = options.frames.value_or(kTurntableFrames);
    const bool onTerminal = isatty(STDERR_FILENO);
    for (int frame = 0; frame < frames; ++frame) {
        const double angle = 2.0 * kPi * frame / frames;
        if (world.ground) world.ground->turnTo(angle);
        take(frame, drawing.draw(scene::turned({&world.mesh}, angle)));
        if (onTerminal) fmt::print(stderr, "\rframe {} of {}", frame + 1, frames);
    }
    if (onTerminal) fmt::print(stderr, "\n");
}

void writeAnimation(const Options& options, World& world)
{
    requireWritable(options.out);
    Animation animation{options.width, options.height, kFramesPerSecond, {}};
    drawTurn(options, world, [&](int, const scene::Image& image) {
        animation.frames.push_back(
            srgbCodes(image, options.document.exposure, transferOf(options.document)));
    });
    writeFile(options.out, encodeAnimation(animation, options.out));
}

void writeFolder(const Options& options, World& world)
{
    NewFolder folder(options.out);
    OutputFiles files;
    drawTurn(options, world, [&](int frame, const scene::Image& image) {
        const std::string path = fmt::format("{}/frame-{:03}.png", options.out, frame);
        files.add(path, encodeImage(image, path, options.document.exposure,
                                    transferOf(options.document)));
    });
    files.commit();
    folder.keep();
}

}  // namespace

void writeTurntable(const Options& options, World& world)
{
    if (isAnimationPath(options.out))
        writeAnimation(options, world);
    else
        writeFolder(options, world);
}

}  // namespace fbrdf::viewer
