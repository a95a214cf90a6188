// Contexts end and begin, the optimizer changes the scene, and the log has each reason once.
#include "DrawLog.h"
#include "EffectTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <osg/ContextData>
#include <osg/MatrixTransform>
#include <osgUtil/Optimizer>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using Lifetime = EffectTest;

/// A viewer that lives on while its windows come and go.
class Host {
public:
    Host() : viewer_(new osgViewer::Viewer)
    {
        viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        setUpView(*viewer_);
        osg::Camera* camera = viewer_->getCamera();
        camera->setViewport(0, 0, kSize, kSize);
        camera->setViewMatrix(osgMatrix(perspectiveView().view));
        camera->setProjectionMatrix(osgMatrix(perspectiveView().projection));
    }

    osgViewer::Viewer& viewer() { return *viewer_; }

    /// A window in the context that is current.
    void open()
    {
        window_ = new osgViewer::GraphicsWindowEmbedded(0, 0, kSize, kSize);
        viewer_->getCamera()->setGraphicsContext(window_);
    }

    std::vector<float> frame(HeadlessContext::Load load)
    {
        Offscreen target(load, {kSize, kSize, OffscreenFormat::rgba32f, true});
        window_->setDefaultFboId(target.framebuffer());
        if (!viewer_->isRealized()) viewer_->realize();
        osg::GLExtensions::Get(contextId(), true)
            ->glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        viewer_->frame();
        return target.readPixels();
    }

    unsigned int contextId() const { return window_->getState()->getContextID(); }

    /// Does what osg::GraphicsContext::close() does, while the context is still current.
    void close()
    {
        viewer_->getSceneData()->releaseGLObjects(window_->getState());
        osg::deleteAllGLObjects(contextId());
        osg::flushAllDeletedGLObjects(contextId());
        osg::discardAllGLObjects(contextId());
        viewer_->getCamera()->setGraphicsContext(nullptr);
        window_ = nullptr;
    }

private:
    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
};

// This happens when a widget is docked elsewhere. OpenSceneGraph gives the next context the number
// of the last, and OpenGL gives the same names to other objects.
TEST_F(Lifetime, AContextAfterAnotherIsDrawnToAnew)
{
    for (const size_t material : {size_t(0), size_t(4)}) {
        const auto effect = osgEffect(testMaterials()[material], sphereMesh(24));
        effect->setFloatTarget(false);
        effect->selectTechnique(osgFbrdf::kTwoLookups);
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(effect);
        root->addChild(osgLights(testLights(3)));
        const Notices notices;
        Host host;
        host.viewer().setSceneData(root);
        std::vector<std::vector<float>> images;
        std::vector<unsigned int> numbers;
        for (int round = 0; round < 3; ++round) {
            const auto context = newContext();
            std::vector<std::unique_ptr<Offscreen>> occupants;  // other names for what comes
            for (int i = 0; i < 5 * round; ++i)
                occupants.push_back(std::make_unique<Offscreen>(
                    context->loader(), OffscreenOptions{8, 8, OffscreenFormat::rgba8, true}));
            host.open();
            for (int frame = 0; frame < 3; ++frame) images.push_back(host.frame(context->loader()));
            numbers.push_back(host.contextId());
            host.close();
        }
        EXPECT_EQ(numbers[2], numbers[1]);
        for (const auto& image : images) EXPECT_EQ(image, images[0]);
        EXPECT_GT(meanOf(images[0], 1), 0.01);
        EXPECT_EQ(effect->lastReport().technique, "two look-ups per pass");
        EXPECT_EQ(notices.text(), "");
    }
    context().makeCurrent();
}

// The optimizer flattens static transforms into vertices and normals, but not into lights or
// tangents.
TEST_F(Lifetime, TheOptimizerKeepsTransformsThatLightsAndTangentsNeed)
{
    const osg::Matrixd turn = osg::Matrixd::rotate(0.7, 0.3, 0.9, 0.1);
    osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(turn),
                                       within = new osg::MatrixTransform(
                                           osg::Matrixd::rotate(0.5, 0.0, 0.0, 1.0));
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    within->addChild(effect->getChild(0));
    effect->removeChildren(0, 1);
    effect->addChild(within);
    above->addChild(effect);
    above->addChild(osgLights(testLights(9)));
    // This one is above neither lights nor tangents, so it may be flattened.
    osg::ref_ptr<osg::MatrixTransform> free =
        new osg::MatrixTransform(osg::Matrixd::translate(0.0, 0.0, -100.0));
    const osg::ref_ptr<osg::Geometry> plain = osgMesh(sphereMesh(4));
    plain->setVertexAttribArray(osgFbrdf::kTangentAttribute, nullptr);
    free->addChild(plain);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(above);
    root->addChild(free);
    for (const auto& transform : {above, within, free})
        transform->setDataVariance(osg::Object::STATIC);
    view_->setScene(root);
    const auto before = view_->frame();
    osgUtil::Optimizer().optimize(root);
    EXPECT_EQ(view_->frame(), before);
    EXPECT_GT(meanOf(before, 0), 0.01);
    EXPECT_LT(plain->getBound().center().z(), -50.0f);
}

size_t countOf(const std::string& text, const std::string& word)
{
    size_t count = 0;
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

TEST_F(Lifetime, TheLogHasEachReasonOnceWithNameAndFile)
{
    osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    effect->setName("statue");
    Notices notices;
    effect->setMaterialFile("gone.fbrdf");
    effect->addChild(osgMesh(sphereMesh(24)));
    auto lights = testLights(4);
    lights.push_back({Light::Type::directional, Vec3f(0.0f), Vec3f(1.0f), 0.0f});
    scene(effect, osgLights(lights));
    for (int i = 0; i < 5; ++i) view_->frame();
    EXPECT_EQ(countOf(notices.text(), "'statue', gone.fbrdf: diffuse fallback is drawn"), 1u)
        << notices.text();
    EXPECT_EQ(countOf(notices.text(), "lights are left out"), 1u) << notices.text();
    // After a property has changed the warning may come again.
    effect->setLightsPerPass(3);
    view_->frame();
    EXPECT_EQ(countOf(notices.text(), "diffuse fallback is drawn"), 2u) << notices.text();
}

TEST_F(Lifetime, TheLogHasReasonsThatTakeTurnsOnce)
{
    const osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
    osgFbrdf::DrawLog log;
    const Notices notices;
    // This is the order in which two views of one scene give them.
    for (int i = 0; i < 5; ++i)
        for (const char* reason : {"one", "", "two"}) log.report(*effect, {"t", reason, 1, 1});
    EXPECT_EQ(countOf(notices.text(), "t is drawn: one"), 1u) << notices.text();
    EXPECT_EQ(countOf(notices.text(), "t is drawn: two"), 1u) << notices.text();
    // Numbers of lights that change.
    for (int dropped = 1; dropped < 5; ++dropped) log.report(*effect, {"t", "", 1, 1, dropped});
    EXPECT_EQ(countOf(notices.text(), "lights are left out"), 1u) << notices.text();
    EXPECT_EQ(log.last().lightsDropped, 4);
}

}  // namespace
}  // namespace fbrdf::test
