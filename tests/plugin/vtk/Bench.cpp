// fbrdf-vtk-bench prints how many milliseconds a vtkRenderer takes to cull and draw an actor with a
// material under 64 lights, beside the plain runtime, in turns in one process and context; and how
// long the first frame of a scene with 100 materials takes. glFinish ends each frame. What the
// window does for a frame, such as asking the X server for its size, is not in the first.
#include "VtkScene.h"

#include "support/FrameTimes.h"
#include "support/gl/Gl.h"
#include "support/gl/Scenes.h"

#include <fbrdf/headless/Offscreen.h>

#include <vtkCommand.h>

#include <chrono>
#include <cstdio>
#include <exception>

namespace {

using namespace fbrdf;
using namespace fbrdf::test;

constexpr int kLights = 64, kFrames = 31, kMaterials = 100;

/// Milliseconds that the last frame of a renderer took, from its StartEvent to its EndEvent.
class FrameTimer {
public:
    FrameTimer(vtkRenderer& renderer, const GladGLContext& gl) : gl_(gl)
    {
        renderer.AddObserver(vtkCommand::StartEvent, this, &FrameTimer::begin);
        renderer.AddObserver(vtkCommand::EndEvent, this, &FrameTimer::end);
    }
    double last() const { return last_; }

private:
    void begin() { start_ = std::chrono::steady_clock::now(); }
    void end()
    {
        gl_.Finish();
        last_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_)
                    .count();
    }

    const GladGLContext& gl_;
    std::chrono::steady_clock::time_point start_;
    double last_ = 0.0;
};

void compareFrames(const Material& material, int size)
{
    const auto lights = vtkTestLights(kLights);
    const gl::MeshData mesh = sphereMesh(24);
    VtkView view(size);
    const auto actor = vtkActorOf(vtkMesh(mesh));
    vtkMaterial(material)->ApplyTo(actor);
    view.renderer().AddActor(actor);
    view.setLights(lights);
    view.window().Render();
    const GladGLContext gl = loadGl(glxFunction);
    gl::RendererOptions options;
    options.load = glxFunction;
    gl::Renderer renderer(options);
    const auto gpuMaterial = renderer.createMaterial(material);
    const auto gpuMesh = renderer.createMesh(mesh);
    Offscreen target(glxFunction, {size, size, OffscreenFormat::rgba8, true});
    const FrameTimer timer(view.renderer(), gl);
    std::vector<double> vtk, runtime;
    for (int i = -3; i < kFrames; ++i) {  // three to warm up
        view.window().Render();
        const double a = timer.last(),
                     b = milliseconds(gl.Finish, [&] {
                         target.clear();
                         renderer.draw({target.framebuffer(), size, size}, view.view,
                                       {{gpuMaterial.get(), gpuMesh.get(), glm::mat4(1.0f)}},
                                       lights);
                     });
        if (i < 0) continue;
        vtk.push_back(a);
        runtime.push_back(b);
    }
    std::printf("%-12s %d lights, %d x %d: VTK %.2f ms, runtime %.2f ms, ratio %.2f\n",
                material.form.name.c_str(), kLights, size, size, median(vtk), median(runtime),
                median(vtk) / median(runtime));
}

/// Materials of three forms, each on an actor of its own; and the same scene without materials.
double firstFrame(bool hasMaterials)
{
    VtkView view(256);
    view.setLights(vtkTestLights(4));
    view.window().Render();
    const GladGLContext gl = loadGl(glxFunction);
    return milliseconds(gl.Finish, [&] {
        for (int i = 0; i < kMaterials; ++i) {
            const auto actor = vtkActorOf(vtkMesh(sphereMesh(12)));
            actor->SetScale(0.1);
            actor->SetPosition(0.22 * (i % 10) - 1.0, 0.22 * (i / 10) - 1.0, 0.0);
            if (hasMaterials) {
                const Form forms[] = {formHdio({32, 16, 16}), formPqp(32, 0.5),
                                      sumOf(formIo(), formPqp(16, 0.5))};
                vtkMaterial(noiseMaterial(forms[i % 3], Storage::log8, static_cast<unsigned>(i)))
                    ->ApplyTo(actor);
            }
            view.renderer().AddActor(actor);
        }
        view.window().Render();
    });
}

}  // namespace

int main()
try {
    const auto materials = testMaterials();
    for (const int size : {64, 256})
        for (const size_t i : {size_t{0}, size_t{2}}) compareFrames(materials[i], size);
    const double without = firstFrame(false), with = firstFrame(true);
    std::printf("start-up, %d materials: first frame %.0f ms, without materials %.0f ms\n",
                kMaterials, with, without);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 6;
}
