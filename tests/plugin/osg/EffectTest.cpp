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
                                            const std::vector<glm::mat4>& places,
                                            const RuntimeEnvironment* environment,
                                            const std::vector<AreaLight>& areaLights)
{
    gl::Renderer& renderer = this->renderer();
    const auto gpuMaterial =
        renderer.createMaterial(material, {LookUp::native, 0, filtersCoarsely()});
    const auto gpuMesh = renderer.createMesh(mesh);
    std::vector<gl::Item> items;
    for (const glm::mat4& place : places)
        items.push_back({gpuMaterial.get(), gpuMesh.get(), place});
    Offscreen target(context().loader(), {kSize, kSize, OffscreenFormat::rgba32f, true});
    target.clear();
    gl::DrawOptions options;
    options.areaLights = areaLights;
    if (environment)
        options.environment = {&mapOf(*environment), gl::environmentRotation(environment->rotation),
                               environment->intensity, environment->lobes};
    renderer.prepare(*gpuMaterial, options, static_cast<int>(lights.size()));
    const auto stats = renderer.draw({target.framebuffer(), kSize, kSize}, perspectiveView(), items,
                                     lights, options);
    EXPECT_EQ(stats.itemsWithoutEnvironment, 0) << stats.whyNoEnvironment;
    return target.readPixels();
}

gl::Renderer& EffectTest::renderer()
{
    if (!renderer_) {
        gl::RendererOptions options;
        options.load = context().loader();
        renderer_ = std::make_unique<gl::Renderer>(options);
    }
    return *renderer_;
}

gl::GpuEnvironment& EffectTest::mapOf(const RuntimeEnvironment& environment)
{
    if (!map_ || map_->size() != environment.faceSize ||
        panorama_.texels != environment.panorama.texels)
        map_ = renderer().createEnvironment(environment.panorama, {environment.faceSize, false});
    panorama_ = environment.panorama;
    return *map_;
}

bool EffectTest::filtersCoarsely()
{
    constexpr double kCoarse = 1e-4;  // octaves: float arithmetic is a hundred times finer
    try {
        gl::Renderer& renderer = this->renderer();
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

osg::ref_ptr<osgFbrdf::FactorizedBrdf> EffectTest::effectOver(osg::Node* model,
                                                              const Material& material)
{
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
    effect->setFloatTarget(true);
    effect->setPreciseFiltering(filtersCoarsely());
    effect->setMaterial(new osgFbrdf::MaterialObject(material));
    effect->addChild(model);
    return effect;
}

std::vector<float> EffectTest::pictureOf(osg::Node* node, osg::Node* lights)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(node);
    root->addChild(lights);
    view_->setScene(root);
    view_->frame();
    return view_->frame();
}

}  // namespace fbrdf::test
