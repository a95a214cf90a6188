#include "EffectTest.h"

#include <fbrdf/base/Error.h>

#include "support/gl/Scenes.h"

namespace fbrdf::test {

void EffectTest::SetUp()
{
    OsgTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    view_ = std::make_unique<OsgView>(context().loader());
    view_->setView(perspectiveView());
}

std::vector<float> EffectTest::runtimeImage(const Material& material, const gl::MeshData& mesh,
                                            const std::vector<Light>& lights,
                                            const std::vector<glm::mat4>& places)
{
    gl::Renderer renderer = this->renderer();
    const auto gpuMaterial =
        renderer.createMaterial(material, {LookUp::native, 0, filtersCoarsely()});
    const auto gpuMesh = renderer.createMesh(mesh);
    std::vector<gl::Item> items;
    for (const glm::mat4& place : places)
        items.push_back({gpuMaterial.get(), gpuMesh.get(), place});
    Offscreen target(context().loader(), {kSize, kSize, OffscreenFormat::rgba32f, true});
    target.clear();
    renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(), items, lights, {});
    return target.readPixels();
}

gl::Renderer EffectTest::renderer()
{
    gl::RendererOptions options;
    options.load = context().loader();
    return gl::Renderer(options);
}

bool EffectTest::filtersCoarsely()
{
    constexpr double kCoarse = 1e-4;  // octaves: float arithmetic is a hundred times finer
    try {
        gl::Renderer renderer = this->renderer();
        const auto noise = renderer.createMaterial(noiseMaterial(formIo(), Storage::half));
        return noise->filterError() > kCoarse;
    } catch (const Error&) {
        return false;  // contexts that have no shaders draw the fallback
    }
}

osg::ref_ptr<osg::Group> EffectTest::scene(osgFbrdf::FactorizedBrdf* effect, osg::Node* lights)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    if (filtersCoarsely()) effect->setPreciseFiltering(true);
    root->addChild(effect);
    if (lights) root->addChild(lights);
    view_->setScene(root);
    return root;
}

}  // namespace fbrdf::test
