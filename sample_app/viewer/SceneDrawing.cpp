#include "SceneDrawing.h"

#include "CpuDrawing.h"

namespace fbrdf::viewer {
namespace {

scene::Image drawnByCpu(const Options& options, World& world, const scene::Instance& instance)
{
    CpuDrawing drawing(options, world,
                       {options.document.technique,
                        {instance},
                        viewOf(options, world),
                        options.width,
                        options.height});
    while (!drawing.isFinished()) drawing.goOn();
    return drawing.image();
}

}  // namespace

SceneDrawing::SceneDrawing(const Options& options, World& world) : options_(options), world_(world)
{
    if (isOnCpu(options.document.technique)) return;
    runtime_.emplace(options, world);
    runtime_->scene().prepare(runtimeTechnique(options.document.technique), world);
}

void SceneDrawing::followLights()
{
    if (!runtime_) return;
    runtime_->scene().replaceEnvironment(world_.environment ? &*world_.environment : nullptr);
    runtime_->scene().prepare(runtimeTechnique(options_.document.technique), world_);
}

scene::Image SceneDrawing::draw(const scene::Instance& instance)
{
    const gl::View view = viewOf(options_, world_);
    scene::Image image =
        runtime_ ? runtime_->draw({runtimeTechnique(options_.document.technique),
                                   {instance},
                                   view,
                                   &world_.lights,
                                   world_.ground.get()},
                                  samplesOf(options_.document, options_.document.technique))
                 : drawnByCpu(options_, world_, instance);
    addBackground(options_, world_, view, image);
    return image;
}

}  // namespace fbrdf::viewer
