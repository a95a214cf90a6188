// Two views of one scene, one with several samples a pixel and one without: each draws what it can,
// and the log has the reason once, not in every frame.
#include "EffectTest.h"
#include "EglWindow.h"

#include "support/gl/Scenes.h"

#include <osg/Image>
#include <osgViewer/CompositeViewer>

#include <algorithm>

namespace fbrdf::test {
namespace {

using Model = osgViewer::ViewerBase::ThreadingModel;

size_t countOf(const std::string& word, const std::string& text)
{
    size_t count = 0;
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

class MixedSamples : public OsgTest, public ::testing::WithParamInterface<Model> {};

TEST_P(MixedSamples, DrawWhatTheyCanAndLogTheReasonOnce)
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
    constexpr size_t kFrames = 6;
    for (size_t frame = 0; frame < kFrames; ++frame) viewer.frame();
    const auto shown = window->picture(kFrames - 1);
    viewer.stopThreading();
    EXPECT_EQ(countOf("RGBA8", notices.text()), 1u) << notices.text();
    EXPECT_EQ(countOf("\n", notices.text()), 1u) << notices.text();
    // Colours of the fallback end at 1.
    const auto* pixels = reinterpret_cast<const float*>(seen->data());
    const std::vector<float> fallback(pixels, pixels + 4 * kSize * kSize);
    EXPECT_GT(meanOf(fallback, 3), 0.3);
    EXPECT_LE(*std::max_element(fallback.begin(), fallback.end()), 1.0f);
    EXPECT_GT(*std::max_element(shown.begin(), shown.end()), 1.0f);

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
