// fbrdf-osg-bench prints how many milliseconds OpenSceneGraph takes to cull and draw the effect
// under 64 lights, beside the plain runtime; and a model of a thousand parts of four materials,
// beside the same under one material and the same without. All take turns in one process and
// context; glFinish ends each frame. Then it prints how long culling alone takes with one light and
// with many, which stay where they are or change, and how long a scene of 100 materials takes from
// nothing to the frame that shows them all.
#include "OsgScene.h"

#include "support/FrameTimes.h"
#include "support/gl/Scenes.h"

#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Stats>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

using namespace fbrdf;
using namespace fbrdf::test;

constexpr int kLights = 64, kFrames = 31, kWarmUp = 3;
constexpr int kPartsInRow = 10, kMaterials = 4;
constexpr int kPartLights = 4;

/// Median milliseconds of the cull of a frame, by OSG's own statistics. update(): what an update
/// traversal would do.
template <class Update>
double cullTime(OsgView& view, const Update& update)
{
    osg::Stats& stats = *view.viewer().getCamera()->getStats();
    std::vector<double> times;
    for (int i = -kWarmUp; i < kFrames; ++i) {
        update();
        view.draw();
        glFinish();
        double seconds = 0.0;
        const unsigned int frame = view.viewer().getFrameStamp()->getFrameNumber();
        if (i >= 0 && stats.getAttribute(frame, "Cull traversal time taken", seconds))
            times.push_back(1000.0 * seconds);
    }
    return median(times);
}

/// Lights that reach no more than their surroundings.
std::vector<Light> smallLights(int count)
{
    std::vector<Light> lights;
    for (Light light : testLights(4 * count)) {
        if (light.type != Light::Type::point || lights.size() == static_cast<size_t>(count))
            continue;
        light.radius = 0.5f;
        lights.push_back(light);
    }
    return lights;
}

void printCulls(OsgView& view, const Material& material)
{
    view.viewer().getCamera()->setStats(new osg::Stats("camera"));
    view.viewer().getCamera()->getStats()->collectStats("rendering", true);
    for (const int count : {1, 4096}) {
        const auto lights = osgLights(smallLights(count));
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(osgEffect(material, sphereMesh(24)));
        root->addChild(lights);
        view.setScene(root);
        const double still = cullTime(view, [] {});
        const double changing = cullTime(view, [&] {
            auto changed = lights->getLights();
            changed[0].position.x += 1e-3f;
            lights->setLights(changed);
        });
        std::printf("cull       %zu lights: %.3f ms where they stay, %.3f ms where one moves\n",
                    lights->getLights().size(), still, changing);
    }
}

/// A thousand balls, each with a state set and an osg::Material of its own, in four names.
osg::ref_ptr<osg::Group> thousandBalls()
{
    osg::ref_ptr<osg::Group> model = new osg::Group;
    for (int i = 0; i < kPartsInRow * kPartsInRow * kPartsInRow; ++i) {
        const auto place = [](int step) { return (step % kPartsInRow - 4.5) / 5.0; };
        osg::ref_ptr<osg::MatrixTransform> ball =
            new osg::MatrixTransform(osg::Matrixd::scale(0.08, 0.08, 0.08) *
                                     osg::Matrixd::translate(place(i), place(i / kPartsInRow),
                                                             place(i / kPartsInRow / kPartsInRow)));
        const auto mesh = osgMesh(sphereMesh(4));
        osg::ref_ptr<osg::Material> material = new osg::Material;
        material->setName("part" + std::to_string(i % kMaterials));
        mesh->getOrCreateStateSet()->setAttribute(material);
        ball->addChild(mesh);
        model->addChild(ball);
    }
    return model;
}

osg::ref_ptr<osg::Group> withLights(osg::Node* node)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(node);
    root->addChild(osgLights(testLights(kPartLights)));
    return root;
}

void printParts(OsgView& view, const Material& material)
{
    const auto model = thousandBalls();
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> parts = new osgFbrdf::FactorizedBrdf,
                                           one = new osgFbrdf::FactorizedBrdf;
    for (const auto& effect : {parts, one}) {
        effect->setFloatTarget(true);
        effect->addChild(model);
    }
    one->setMaterial(new osgFbrdf::MaterialObject(material));
    for (int i = 0; i < kMaterials; ++i)
        parts->setPartMaterial("part" + std::to_string(i), new osgFbrdf::MaterialObject(material));
    const std::vector<osg::ref_ptr<osg::Group>> scenes{withLights(parts), withLights(one),
                                                       withLights(model)};
    for (const int technique : {0, 2}) {
        parts->selectTechnique(technique);
        one->selectTechnique(technique);
        std::vector<std::vector<double>> times(scenes.size());
        for (int i = -kWarmUp; i < kFrames; ++i)
            for (size_t s = 0; s < scenes.size(); ++s) {
                view.setScene(scenes[s]);
                const double time = milliseconds(glFinish, [&] { view.draw(); });
                if (i >= 0) times[s].push_back(time);
            }
        const double ofParts = median(times[0]), ofOne = median(times[1]), plain = median(times[2]);
        std::printf(
            "%-10s %d lights, 1000 parts: %d materials %.2f ms, one %.2f ms, none %.2f "
            "ms; %.2f times one, %.2f times none\n",
            techniqueName(static_cast<Technique>(technique)), kPartLights, kMaterials, ofParts,
            ofOne, plain, ofParts / ofOne, ofParts / plain);
    }
}

/// Models of materials of three forms; what draws them is asked for in the first frame.
void printStartUp(OsgView& view)
{
    constexpr int kEffects = 100, kMostFrames = 10;
    int frames = 0;
    const double time = milliseconds(glFinish, [&] {
        const Form forms[] = {formHdio({32, 16, 16}), formPqp(32, 0.5),
                              sumOf(formIo(), formPqp(16, 0.5))};
        osg::ref_ptr<osg::Group> models = new osg::Group;
        std::vector<osg::ref_ptr<osgFbrdf::FactorizedBrdf>> effects;
        for (int i = 0; i < kEffects; ++i) {
            effects.push_back(
                osgEffect(noiseMaterial(forms[i % 3], Storage::log8, static_cast<unsigned>(i)),
                          sphereMesh(12)));
            osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(
                osg::Matrixd::scale(0.1, 0.1, 0.1) *
                osg::Matrixd::translate(0.22 * (i % 10) - 1.0, 0.22 * (i / 10) - 1.0, 0.0));
            place->addChild(effects.back());
            models->addChild(place);
        }
        view.setScene(withLights(models));
        const auto waits = [](const osg::ref_ptr<osgFbrdf::FactorizedBrdf>& effect) {
            return effect->lastReport().passes == 0 || !effect->lastReport().reason.empty();
        };
        do view.draw();
        while (++frames < kMostFrames && std::any_of(effects.begin(), effects.end(), waits));
    });
    std::printf("start-up   %d materials: %.0f ms, %d frames\n", kEffects, time, frames);
}

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
        for (int i = -kWarmUp; i < kFrames; ++i) {
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
    printParts(view, material);
    printCulls(view, material);
    printStartUp(view);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 6;
}
