// fbrdf-ogre-bench prints, for each render system, how many milliseconds OGRE takes to cull and
// draw an object under 64 lights beside the plain runtime (both take turns in one process and
// context, and glFinish ends each frame), and how long a scene of 100 materials takes from its
// scripts to the end of its first frame.
#include "OgreHost.h"
#include "XServer.h"

#include "support/FrameTimes.h"
#include "support/gl/Gl.h"
#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/headless/Offscreen.h>
#include <fbrdf/io/MaterialFile.h>

#include <cstdio>

namespace {

using namespace fbrdf;
using namespace fbrdf::test;

constexpr int kLights = 64, kFrames = 31, kSize = 64, kMaterials = 100;

std::string script(const std::string& name)
{
    return "material " + name +
           "\n{\n technique\n {\n  pass\n  {\n   rtshader_system\n   {\n    fbrdf " + name +
           ".fbrdf\n   }\n  }\n }\n}\n";
}

void compareFrames(const char* system, OgreHost& host, const GladGLContext& gl)
{
    const gl::MeshData mesh = sphereMesh(24);
    std::vector<Light> lights = testLights(kLights);
    for (Light& light : lights) {
        light.radius = 0.0f;
        host.addLight(light);
    }
    host.addScript(script("m"));
    host.addMesh("sphere", mesh);
    host.addEntity("sphere", "m");
    host.setView(perspectiveView());
    gl::RendererOptions options;
    options.load = OgreHost::load;
    gl::Renderer renderer(options);
    const auto material = renderer.createMaterial(testMaterials()[2]);
    const auto gpuMesh = renderer.createMesh(mesh);
    Offscreen target(OgreHost::load, {kSize, kSize, OffscreenFormat::rgba32f, true});
    std::vector<double> ogre, runtime;
    for (int i = -3; i < kFrames; ++i) {  // three to warm up
        const double a = milliseconds(gl.Finish, [&] { host.draw(); }),
                     b = milliseconds(gl.Finish, [&] {
                         target.clear();
                         renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(),
                                       {{material.get(), gpuMesh.get(), glm::mat4(1.0f)}}, lights);
                     });
        if (i < 0) continue;
        ogre.push_back(a);
        runtime.push_back(b);
    }
    std::printf("%-8s %d lights, %d x %d: OGRE %.2f ms, runtime %.2f ms, ratio %.2f\n", system,
                kLights, kSize, kSize, median(ogre), median(runtime),
                median(ogre) / median(runtime));
}

void startUp(const char* system, OgreHost& host, const GladGLContext& gl)
{
    host.addMesh("sphere", sphereMesh(8));
    host.setView(perspectiveView());
    host.addLight(testLights(1)[0]);
    const double time = milliseconds(gl.Finish, [&] {
        for (int i = 0; i < kMaterials; ++i) {
            const std::string name = "m" + std::to_string(i);
            host.addScript(script(name));
            host.addEntity("sphere", name);
        }
        host.draw();
    });
    std::printf("%-8s %d materials: %.0f ms from scripts to the first frame\n", system, kMaterials,
                time);
}

}  // namespace

int main()
try {
    XServer server;
    const TemporaryDir folder;
    const std::vector<Material> kinds = testMaterials();
    writeMaterial(kinds[2], folder.file("m.fbrdf"));
    for (int i = 0; i < kMaterials; ++i) {
        const Form& form = kinds[static_cast<size_t>(i) % kinds.size()].form;
        writeMaterial(noiseMaterial(form, Storage::log8, static_cast<unsigned>(i)),
                      folder.file("m" + std::to_string(i) + ".fbrdf"));
    }
    for (const char* system : {"GL3Plus", "GL"}) {
        for (const auto& figure : {compareFrames, startUp}) {
            OgreHost host(system, folder.file("."), kSize);
            figure(system, host, loadGl(OgreHost::load));
        }
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 6;
}
