#include "CompareDrawing.h"

#include "ComparePicture.h"
#include "CpuDrawing.h"
#include "Headless.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/codecs/AnimationFile.h>
#include <fbrdf/fit/Clock.h>

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace fbrdf::viewer {
namespace {

using scene::CompareMode;

constexpr int kWipeFramesPerSecond = 20;  // a GIF knows hundredths of a second alone

/// What a side needs beside the shown material, fitted now.
std::optional<MaterialSlot> fittedSlot(const CompareSide& side, const MaterialSlot& shown,
                                       bool hasEnvironment, scene::CompareSideStats& stats)
{
    const std::string problem = whyNot(side, shown);
    if (!problem.empty()) throw Error(ErrorKind::usage, "--compare", problem);
    std::optional<fitting::FitOrder> order = orderOf(side, shown);
    if (!order) return std::nullopt;
    if (isatty(STDERR_FILENO)) fmt::print(stderr, "fitting {} ...\n", titleOf(side));
    if (!hasEnvironment) order->lobes = 0;
    const Clock clock;
    if (!order->opened) order->opened = std::make_shared<const Source>(openSource(order->source));
    const fitting::FitReply reply = fitted(*order, order->opened);
    stats.fitSeconds = clock.seconds();
    stats.note = reply.note;
    return slotOf(side, reply);
}

CompareLayout layoutOf(const Options& options)
{
    return {options.compareMode, static_cast<float>(options.compareAt),
            static_cast<float>(options.compareGain)};
}

/// A and B in turn, or the line once to and fro.
Animation filmOf(const Options& options, const ComparePair& pair)
{
    const bool isFlip = options.compareMode == CompareMode::flip;
    const int rate = isFlip ? 1 : kWipeFramesPerSecond;
    const int frames = options.frames.value_or(
        isFlip ? 2 : static_cast<int>(scene::kWipeSeconds * kWipeFramesPerSecond));
    Animation film{options.width, options.height, rate, {}};
    CompareLayout layout = layoutOf(options);
    scene::CompareView view;
    view.mode = options.compareMode;
    for (int frame = 0; frame < frames; ++frame) {
        layout.showsB = frame % 2 == 1;
        layout.at = view.lineAt(frame * scene::kWipeSeconds / frames);
        film.frames.push_back(srgbCodes(composed(pair, layout), 1.0f, Transfer::srgb));
    }
    return film;
}

void writePicture(const Options& options, const ComparePair& pair)
{
    if (isAnimationPath(options.out) && options.comparesMoving())
        return writeFile(options.out, encodeAnimation(filmOf(options, pair), options.out));
    writeImage(options.compareMode == CompareMode::flip ? sideBySide(pair)
                                                        : composed(pair, layoutOf(options)),
               options.out, 1.0f);
}

}  // namespace

DrawnSide drawnSide(const CompareSide& side, Options options, World& world)
{
    DrawnSide drawn;
    scene::CompareSideStats& stats = drawn.stats;
    std::deque<MaterialSlot> made;
    if (auto slot = fittedSlot(side, world.materials.front(), world.environment.has_value(), stats))
        made.push_back(std::move(*slot));
    const bool isMade = !made.empty();
    if (isMade) std::swap(world.materials, made);
    MaterialSlot& slot = world.materials.front();
    const scene::ViewTechnique technique = techniqueOf(side, slot, options.document.technique);
    options.document.technique = technique;
    drawn.picture = isOnCpu(technique) ? drawOnCpu(options, world) : drawHeadless(options, world);
    stats.name = side.name;
    stats.technique = viewTechniqueName(technique);
    stats.samples = samplesOf(options, technique);
    if (!isOnCpu(technique)) {
        stats.bytes = materialBytes(slot.material());
        if (stats.note.empty()) stats.note = describe(slot.material().form);
    } else if (stats.note.empty()) {
        stats.note = noteOf(side, slot);
    }
    if (isMade) std::swap(world.materials, made);
    return drawn;
}

void writeComparison(const Options& options, World& world)
{
    const CompareSide a = compareSideFromName(options.compare[0]),
                      b = compareSideFromName(options.compare[1]);
    DrawnSide drawnA = drawnSide(a, options, world), drawnB = drawnSide(b, options, world);
    const Exposing exposing{options.document.exposure, transferOf(options.document)};
    scene::Stats stats = drawnA.picture.stats;
    stats.coveredPixels = coveredPixels(drawnA.picture.image);
    stats.compare = {drawnA.stats, drawnB.stats, compareModeName(options.compareMode),
                     compareNumbers(drawnA.picture.image, drawnB.picture.image, exposing)};
    for (Picture* picture : {&drawnA.picture, &drawnB.picture})
        addBackground(options, world, picture->view, picture->image);
    if (!options.out.empty())
        writePicture(options,
                     {std::move(drawnA.picture.image), std::move(drawnB.picture.image), exposing,
                      titleOf(a), titleOf(b), numbersText(stats.compare->numbers)});
    if (!options.stats.empty()) writeFile(options.stats, scene::statsToJson(stats));
}

}  // namespace fbrdf::viewer
