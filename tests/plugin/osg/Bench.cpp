// fbrdf-osg-bench prints how many milliseconds OpenSceneGraph takes to cull and draw the effect
// under 64 lights, beside the plain runtime. Both take turns in one process and context; glFinish
// ends each frame.
#include "OsgScene.h"

#include "support/FrameTimes.h"
#include "support/gl/Scenes.h"

#include <cstdio>

namespace {

using namespace fbrdf;
using namespace fbrdf::test;

constexpr int kLights = 64, kFrames = 31;

}  // namespace

int main()
try {
    const HeadlessContext context(
        {Backend::egl, HeadlessOptions::Profile::compatibility, 2, 1, false});
    const Material material = testMaterials()[2];
    const auto lights = testLights(kLights);
    OsgView view(context.loader());
    view.setView(perspectiveView());
    const auto effect = osgEffect(material, sphereMesh(24));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect);
    root->addChild(osgLights(lights));
    view.setScene(root);
    gl::RendererOptions options;
    options.load = context.loader();
    gl::Renderer renderer(options);
    const auto gpuMaterial = renderer.createMaterial(material);
    const auto gpuMesh = renderer.createMesh(sphereMesh(24));
    Offscreen target(context.loader(), {kSize, kSize, OffscreenFormat::rgba32f, true});
    for (const int technique : {0, 1, 2}) {
        gl::DrawOptions draw;
        draw.technique = static_cast<Technique>(technique);
        effect->selectTechnique(technique);
        std::vector<double> osg, runtime;
        for (int i = -3; i < kFrames; ++i) {  // three to warm up
            const double a = milliseconds(glFinish, [&] { view.draw(); }),
                         b = milliseconds(glFinish, [&] {
                             target.clear();
                             renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(),
                                           {{gpuMaterial.get(), gpuMesh.get(), glm::mat4(1.0f)}},
                                           lights, draw);
                         });
            if (i < 0) continue;
            osg.push_back(a);
            runtime.push_back(b);
        }
        std::printf(
            "%-10s %d lights, %d x %d: OpenSceneGraph %.2f ms, runtime %.2f ms, ratio %.2f\n",
            techniqueName(draw.technique), kLights, kSize, kSize, median(osg), median(runtime),
            median(osg) / median(runtime));
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 6;
}
