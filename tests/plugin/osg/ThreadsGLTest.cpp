// osgViewer's threading models without a display draw one scene in two contexts, while the update
// traversal changes it and the last frame may still be being drawn.
#include "EffectTest.h"
#include "EglWindow.h"
#include "EnvironmentTest.h"

#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <osg/Fog>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osgViewer/CompositeViewer>

#include <functional>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using Model = osgViewer::ViewerBase::ThreadingModel;
using Picture = std::vector<float>;

/// Calls a step of a script in each update traversal.
class Script : public osg::NodeCallback {
public:
    explicit Script(std::vector<std::function<void()>> steps) : steps_(std::move(steps)) {}
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        steps_[next_++ % steps_.size()]();
        traverse(node, visitor);
    }
    size_t size() const { return steps_.size(); }

private:
    std::vector<std::function<void()>> steps_;
    size_t next_ = 0;
};

osg::ref_ptr<osg::MatrixTransform> at(double x, osg::Node* node)
{
    osg::ref_ptr<osg::MatrixTransform> place =
        new osg::MatrixTransform(osg::Matrixd::translate(x, 0.0, 0.0));
    place->addChild(node);
    return place;
}

Material material(size_t i)
{
    return withLobes(testMaterials()[i], testLobes(LobeAxes::tilted, 2));
}

/// An effect with its lights, another effect that comes and goes, and a script that changes them.
struct Stage {
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<FactorizedBrdf> effect = osgEffect(material(0), sphereMesh(12)), guest;
    osg::ref_ptr<osgFbrdf::PointLights> lights = osgLights(testLights(9));
    osg::ref_ptr<osgFbrdf::EnvironmentLight> environment;
    osg::ref_ptr<Script> script;

    Stage()
    {
        root->addChild(at(-0.7, effect));
        root->addChild(lights);
        addEnvironment();
        environment->setNodeMask(0);
        script = new Script({
            [] {},
            [this] {
                lights->setLights(testLights(20));
                effect->setExposure(2.0f);
            },
            [this] { setMaterial(2); },
            [this] { setMaterial(0); },  // while contexts are asked about the last one
            [this] {
                effect->setFloatTarget(false);
                effect->selectTechnique(osgFbrdf::kTwoLookups);
            },
            [this] { setMaterial(4); },  // a sum: in surfaces
            [this] { addGuest(); },
            [this] { guest->setLightsPerPass(3); },
            [this] {
                effect->selectTechnique(osgFX::Effect::AUTO_DETECT);
                guest->selectTechnique(osgFbrdf::kBatched);
            },
            [this] { effect->setFirstTextureUnit(2); },
            [this] { addLightSource(); },
            [this] { environment->setNodeMask(~0u); },
            [this] {
                environment->setRotation(2.0f);
                environment->setIntensity({0.5f, 1.0f, 0.3f});
                environment->setLobes(1);
            },
            [this] { addEnvironment(); },  // the last one may still be being drawn
            [this] { addFog(); },
            [this] {
                root->setStateSet(nullptr);
                environment->setNodeMask(0);
                root->removeChildren(2, 2);
                guest = nullptr;  // it may still be being drawn
                setMaterial(0);
            },
            [this] {
                lights->setLights(testLights(9));
                effect->setExposure(1.0f);
                effect->setFloatTarget(true);
                effect->setFirstTextureUnit(0);
            },
        });
        root->setUpdateCallback(script);
    }

    void setMaterial(size_t i) { effect->setMaterial(new osgFbrdf::MaterialObject(material(i))); }

    /// In place of the one that there was.
    void addEnvironment()
    {
        root->removeChild(environment);
        environment = osgEnvironment(testPanorama(16));
        environment->setFaceSize(8);
        root->addChild(environment);
    }

    /// A light whose attenuation is not the runtime's.
    void addLightSource()
    {
        osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
        source->getLight()->setPosition({1.0f, 2.0f, 3.0f, 1.0f});
        source->getLight()->setLinearAttenuation(0.5f);
        root->addChild(source);
    }

    /// The fog is in a new state set, as the last one may still be being drawn with.
    void addFog()
    {
        osg::ref_ptr<osg::Fog> fog = new osg::Fog;
        fog->setDensity(0.2f);
        osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
        state->setAttributeAndModes(fog);
        root->setStateSet(state);
    }

    void addGuest()
    {
        guest = osgEffect(material(1), sphereMesh(12));
        guest->setFloatTarget(false);
        root->addChild(at(0.9, guest));
    }
};

constexpr size_t kViews = 2, kRounds = 2;

/// The picture of each window in each frame of the script, which is repeated. Two views in one
/// window have half of it each.
std::vector<std::vector<Picture>> shownBy(Model model, size_t windowCount)
{
    Stage stage;
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(model);
    std::vector<osg::ref_ptr<EglWindow>> windows;
    for (size_t i = 0; i < windowCount; ++i) windows.emplace_back(new EglWindow(kSize));
    for (size_t i = 0; i < kViews; ++i) {
        const auto view = viewIn(*windows[i % windowCount], stage.root);
        osg::Camera* camera = view->getCamera();
        camera->setViewMatrix(osg::Matrixd::rotate(0.5 * static_cast<double>(i), 0.0, 0.0, 1.0) *
                              osgMatrix(perspectiveView().view));
        if (windowCount < kViews)
            camera->setViewport(static_cast<int>(i) * kSize / 2, 0, kSize / 2, kSize);
        viewer.addView(view);
    }
    viewer.realize();
    const size_t frames = kRounds * stage.script->size();
    for (size_t frame = 0; frame < frames; ++frame) viewer.frame();
    std::vector<std::vector<Picture>> shown(windowCount);
    for (size_t i = 0; i < windowCount; ++i)
        for (size_t frame = 0; frame < frames; ++frame)
            shown[i].push_back(windows[i]->picture(frame));
    return shown;
}

class Threads : public OsgTest, public ::testing::WithParamInterface<Model> {
protected:
    void compareWithOneThread(size_t windows)
    {
        const Notices notices;
        const auto expected = shownBy(Model::SingleThreaded, windows),
                   found = shownBy(GetParam(), windows);
        for (size_t i = 0; i < windows; ++i)
            for (size_t frame = 0; frame < expected[i].size(); ++frame) {
                EXPECT_GT(meanOf(expected[i][frame], 3), 0.1) << frame;
                EXPECT_TRUE(found[i][frame] == expected[i][frame])
                    << "window " << i << ", frame " << frame;
            }
        for (const size_t frame : std::initializer_list<size_t>{
                 1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15})  // what the script did is to be seen
            EXPECT_FALSE(expected[0][frame] == expected[0][frame - 1]) << frame;
        EXPECT_EQ(notices.text(), "");
    }
};

TEST_P(Threads, ShowWhatOneThreadShowsInEveryFrame)
{
    compareWithOneThread(kViews);
}

TEST_P(Threads, ShowTwoViewsInOneWindow)
{
    compareWithOneThread(1);
}

std::string modelName(const ::testing::TestParamInfo<Model>& model)
{
    switch (model.param) {
        case Model::SingleThreaded: return "OneThread";
        case Model::CullDrawThreadPerContext: return "CullDrawThreadPerContext";
        case Model::DrawThreadPerContext: return "DrawThreadPerContext";
        default: return "CullThreadPerCamera";
    }
}

INSTANTIATE_TEST_SUITE_P(Models, Threads,
                         ::testing::Values(Model::SingleThreaded, Model::CullDrawThreadPerContext,
                                           Model::DrawThreadPerContext,
                                           Model::CullThreadPerCameraDrawThreadPerContext),
                         modelName);

// The viewer waits for as many dynamic leaves as were culled: those of a pass that cannot be drawn
// must not be missing.
TEST_P(Threads, DoNotWaitForWhatASurfaceRefuses)
{
    const auto effect = osgEffect(testMaterials()[4], sphereMesh(12));
    effect->setFloatTarget(false);
    effect->selectTechnique(osgFbrdf::kTwoLookups);
    effect->getChild(0)->setDataVariance(osg::Object::DYNAMIC);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(effect);
    root->addChild(osgLights(testLights(3)));
    const osg::ref_ptr<EglWindow> window = new EglWindow(kSize);
    osgViewer::CompositeViewer viewer;
    viewer.setThreadingModel(GetParam());
    viewer.addView(viewIn(*window, root));
    viewer.realize();
    viewer.frame();
    EXPECT_GT(meanOf(window->picture(0), 3), 0.3);
    auto* gl = osg::GLExtensions::Get(window->getState()->getContextID(), true);
    gl->isFrameBufferObjectSupported = false;
    const Notices notices;
    for (int frame = 0; frame < 3; ++frame) viewer.frame();
    EXPECT_GT(meanOf(window->picture(3), 3), 0.3);
    gl->isFrameBufferObjectSupported = true;
    EXPECT_EQ(effect->lastReport().technique, "diffuse fallback");
    EXPECT_NE(notices.text(), "");
}

// osgFX chooses while it draws: what is added would be missing for a frame.
TEST_P(Threads, ShowWhatWasAddedInTheNextFrame)
{
    const auto shown = shownBy(GetParam(), kViews);
    constexpr size_t kAdded = 6;
    for (const auto& view : shown)
        EXPECT_GT(meanOf(view[kAdded], 3), 1.3 * meanOf(view[kAdded - 1], 3));
}

}  // namespace
}  // namespace fbrdf::test
