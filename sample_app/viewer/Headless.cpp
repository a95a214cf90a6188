#include "Headless.h"

#include "HeadlessDrawing.h"

#include <algorithm>

namespace fbrdf::viewer {

scene::Image imageFromBottomRows(const std::vector<float>& rgba, int width, int height)
{
    scene::Image image(width, height);
    const std::ptrdiff_t row = 4 * std::ptrdiff_t(width);
    for (int y = 0; y < height; ++y)
        std::copy_n(rgba.begin() + row * (height - 1 - y), row, image.rgba.begin() + row * y);
    return image;
}

int coveredPixels(const scene::Image& image)
{
    int count = 0;
    for (size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] > 0.0f;
    return count;
}

void addDrawStats(const gl::DrawStats& drawn, const gl::Renderer& renderer, scene::Stats& stats)
{
    stats.glRenderer = renderer.glRenderer();
    stats.glVersion = renderer.glVersion();
    stats.passes = drawn.passes;
    stats.drawCalls = drawn.drawCalls;
    stats.lightsGiven = drawn.lightsGiven;
    stats.lightsUsed = drawn.lightsUsed;
    stats.lightsDropped = drawn.lightsDropped;
    stats.maxLookups = drawn.maxLookups;
    stats.accumulation = drawn.accumulation;
    stats.techniqueDrawn = techniqueName(drawn.technique);
    stats.whyReplaced = drawn.whyReplaced;
    stats.errorRelative = drawn.error.relative;
    stats.errorAbsolute = drawn.error.absolute;
    stats.environmentError = drawn.environmentError;
    stats.whyNoEnvironment = drawn.whyNoEnvironment;
    stats.whyNotSampled = drawn.whyNotSampled;
}

Picture drawHeadless(const Options& options, World& world)
{
    Picture picture{{}, statsOf(options, world), viewOf(options, world)};
    HeadlessDrawing drawing(options, world);
    drawing.scene().prepare(runtimeTechnique(options.document.technique), world);
    // Frame 0 is not timed: drivers compile what they need while they draw it.
    for (int frame = 0; frame <= options.frames.value_or(1); ++frame) {
        const int samples =
            frame == 0 ? 1 : samplesOf(options.document, options.document.technique);
        picture.image = drawing.draw(requestOf(options, world), samples);
        if (frame > 0) picture.stats.milliseconds.push_back(drawing.milliseconds());
    }
    addDrawStats(drawing.drawn(), drawing.scene().renderer(), picture.stats);
    picture.stats.backend = backendName(options.backend);
    return picture;
}

}  // namespace fbrdf::viewer
