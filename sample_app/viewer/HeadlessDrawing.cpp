#include "HeadlessDrawing.h"

#include "Headless.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/scene/SubPixels.h>

namespace fbrdf::viewer {
namespace {

HeadlessOptions contextOptionsOf(const Options& options)
{
    HeadlessOptions context;
    context.backend = options.backend;
    context.device = options.device;
    return context;
}

OffscreenFormat formatOf(ColourFormat target)
{
    if (target == ColourFormat::rgba8) return OffscreenFormat::rgba8;
    return target == ColourFormat::rgba16f ? OffscreenFormat::rgba16f : OffscreenFormat::rgba32f;
}

}  // namespace

HeadlessDrawing::HeadlessDrawing(const Options& options, World& world)
    : context_(contextOptionsOf(options)),
      scene_(context_.loader(), world, options),
      offscreen_(context_.loader(),
                 {options.width, options.height, formatOf(options.document.target)}),
      timer_(context_.loader())
{
}

scene::Image HeadlessDrawing::draw(GlRequest request, int samples)
{
    const int width = offscreen_.width(), height = offscreen_.height();
    const gl::Target target{offscreen_.framebuffer(), width, height};
    const gl::View view = request.view;
    scene::Image sum(width, height);
    milliseconds_ = 0.0;
    for (int sample = 0; sample < samples; ++sample) {
        request.view = scene::movedBy(view, scene::subPixel(sample), width, height);
        request.sample = sample;
        timer_.begin();
        offscreen_.clear();
        drawn_ = scene_.draw(target, request);
        milliseconds_ += timer_.end();
        if (drawn_.itemsFailed > 0)
            throw Error(ErrorKind::gl, "draw",
                        std::to_string(drawn_.itemsFailed) + " objects could not be drawn");
        add(imageFromBottomRows(offscreen_.readPixels(), width, height), sum);
    }
    return meanOf(std::move(sum), samples);
}

GlRequest requestOf(const Options& options, const World& world)
{
    return {runtimeTechnique(options.document.technique), world.instances, viewOf(options, world),
            &world.lights, world.ground.get()};
}

}  // namespace fbrdf::viewer
