// Two views of one scene, one with several samples a pixel and one without: passes add up for both,
// in buffers of their own.
#include "EffectTest.h"
#include "EglWindow.h"

#include "support/gl/Scenes.h"

#include <osg/Image>
#include <osgViewer/CompositeViewer>

#include <algorithm>

namespace fbrdf::test {
namespace {

using Model = osgViewer::ViewerBase::ThreadingModel;

class MixedSamples : public OsgTest, public ::testing::WithParamInterface<Model> {};

TEST_P(MixedSamples, ShowTheSameButForTheirEdges)
{
    const osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect =
        osgEffect(testMaterials()[0], sphereMesh(12));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect);
    root->addChild(osgLights(testLights(3)));
    const osg::ref_ptr<EglWindow> window = new EglWindow(kSize);
    const osg::ref_ptr<osg::Image> seen = new osg::Image;
    seen->allocateImage(kSize, kSize, 1, GL_RGBA, GL_FLOAT);
    seen->setInternalTextureFormat(GL_RGBA32F_ARB);
    const auto plain = viewIn(*window, root), sampled = viewIn(*window, root);
    sampled->getCamera()->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    sampled->getCamera()->attach(osg::Camera::COLOR_BUFFER0, seen, 4, 4);

    const Notices notices;
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(GetParam());
    for (const auto& view : {sampled, plain}) viewer.addView(view);
    viewer.realize();
    window->makeCurrent();
    haveSamples(*window);
    window->releaseContext();
    constexpr size_t kFrames = 6;
    for (size_t frame = 0; frame < kFrames; ++frame) viewer.frame();
    const auto shown = window->picture(kFrames - 1);
    viewer.stopThreading();
    EXPECT_EQ(notices.text(), "");
    EXPECT_EQ(effect->lastReport().technique, "two look-ups per pass");
    const auto* pixels = reinterpret_cast<const float*>(seen->data());
    const std::vector<float> smooth(pixels, pixels + 4 * kSize * kSize);
    // OpenSceneGraph gives the image samples of RGBA8.
    size_t edges = 0;
    double smoothSum = 0.0, shownSum = 0.0;
    for (size_t i = 0; i < smooth.size(); i += 4) {
        if (smooth[i + 3] > 0.1f && smooth[i + 3] < 0.9f) ++edges;
        if (smooth[i + 3] < 1.0f) continue;
        smoothSum += static_cast<double>(smooth[i]);
        shownSum += static_cast<double>(std::min(shown[i], 1.0f));
    }
    EXPECT_GT(edges, 20u);
    EXPECT_GT(smoothSum, 20.0);
    EXPECT_NEAR(smoothSum, shownSum, 0.05 * shownSum);

    const osg::ref_ptr<EglWindow> other = new EglWindow(kSize);
    osgViewer::CompositeViewer alone;
    alone.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    alone.addView(viewIn(*other, root));
    alone.realize();
    alone.frame();
    EXPECT_TRUE(shown == other->picture(0));
}

std::string modelName(const ::testing::TestParamInfo<Model>& model)
{
    return model.param == Model::SingleThreaded ? "OneThread" : "CullThreadPerCamera";
}

INSTANTIATE_TEST_SUITE_P(Models, MixedSamples,
                         ::testing::Values(Model::SingleThreaded,
                                           Model::CullThreadPerCameraDrawThreadPerContext),
                         modelName);

}  // namespace
}  // namespace fbrdf::test
