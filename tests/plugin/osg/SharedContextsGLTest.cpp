// Two windows whose contexts share objects: OSG gives both one number, by which it keeps programs,
// textures and buffers, but framebuffers and array pointers belong to one context. One thread draws
// both: with a draw thread for each, OSG 3.6.5 loses or crashes on an ordinary sphere too, as it
// keeps objects by that number without locks.
#include "EffectTest.h"
#include "EglWindow.h"

#include "support/gl/Scenes.h"

#include <osgViewer/CompositeViewer>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

constexpr size_t kWindows = 2;

/// A sum of terms, in surfaces, seen by two windows.
class SharedContexts : public OsgTest {
protected:
    void SetUp() override
    {
        OsgTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        effect_ = osgEffect(testMaterials()[4], sphereMesh(12));
        effect_->setFloatTarget(false);
        effect_->selectTechnique(osgFbrdf::kTwoLookups);
        root_->addChild(effect_);
        root_->addChild(osgLights(testLights(3)));
        viewer_ = new osgViewer::CompositeViewer;
        viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        for (size_t i = 0; i < kWindows; ++i) {
            windows_.emplace_back(new EglWindow(kSize, i > 0 ? windows_.front().get() : nullptr));
            views_.push_back(viewIn(*windows_.back(), root_));
            viewer_->addView(views_.back());
        }
        viewer_->realize();
        expected_ = draw(0);
        EXPECT_GT(meanOf(expected_, 3), 0.3);
        EXPECT_TRUE(windows_[1]->picture(0) == expected_);
    }
    void TearDown() override
    {
        viewer_ = nullptr;
        EXPECT_EQ(notices_.text(), "");
    }

    /// Draws the next frame; returns what the window shows.
    std::vector<float> draw(size_t window)
    {
        viewer_->frame();
        return windows_[window]->picture(frames_++);
    }
    void close(size_t window)
    {
        windows_[window]->close();
        viewer_->removeView(views_[window]);
        views_[window] = nullptr;
    }

    const Notices notices_;
    osg::ref_ptr<FactorizedBrdf> effect_;
    osg::ref_ptr<osg::Group> root_ = new osg::Group;
    osg::ref_ptr<osgViewer::CompositeViewer> viewer_;
    std::vector<osg::ref_ptr<EglWindow>> windows_;
    std::vector<osg::ref_ptr<osgViewer::View>> views_;
    std::vector<float> expected_;
    size_t frames_ = 0;
};

TEST_F(SharedContexts, ShowTheSame)
{
    ASSERT_EQ(windows_[0]->getState()->getContextID(), windows_[1]->getState()->getContextID());
    for (int frame = 0; frame < 3; ++frame)
        for (size_t window = 0; window < kWindows; ++window)
            EXPECT_TRUE(draw(window) == expected_) << "window " << window;
}

TEST_F(SharedContexts, AreWholeWhenTheFirstIsClosed)
{
    close(0);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(draw(1) == expected_);
    EXPECT_EQ(effect_->lastReport().reason, "");
}

TEST_F(SharedContexts, AreWholeWhenTheSecondIsClosed)
{
    close(1);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(draw(0) == expected_);
    EXPECT_EQ(effect_->lastReport().reason, "");
}

// Surfaces of sizes that are no longer seen are thrown away, and OSG deletes a framebuffer by its
// number in whichever of the two contexts draws next.
TEST_F(SharedContexts, AreWholeWhileTheOtherChangesItsSize)
{
    for (size_t window = 0; window < kWindows; ++window) {
        osg::Camera* camera = views_[window]->getCamera();
        for (int size = 20; size < 32; ++size) {
            camera->setViewport(0, 0, size, size);
            EXPECT_TRUE(draw(1 - window) == expected_) << size;
        }
        camera->setViewport(0, 0, kSize, kSize);
        EXPECT_TRUE(draw(window) == expected_);
    }
    EXPECT_EQ(effect_->lastReport().reason, "");
}

TEST_F(SharedContexts, AreWholeAfterObjectsWereReleased)
{
    for (size_t window = 0; window < kWindows; ++window) {
        draw(window);
        root_->releaseGLObjects();
        EXPECT_TRUE(draw(window) == expected_) << "window " << window;
        EXPECT_TRUE(draw(1 - window) == expected_) << "window " << 1 - window;
    }
}

// The camera takes its cull visitor along, but not its surfaces: framebuffers belong to one
// context.
TEST_F(SharedContexts, ACameraMovesToAnotherWindowAndBack)
{
    const osg::ref_ptr<EglWindow> third = new EglWindow(kSize, windows_[0]);
    third->realize();
    views_[0]->getCamera()->setGraphicsContext(third);
    for (size_t frame = 0; frame < 3; ++frame) {
        viewer_->frame();
        EXPECT_TRUE(third->picture(frame) == expected_) << frame;
    }
    views_[0]->getCamera()->setGraphicsContext(windows_[0]);
    viewer_->frame();
    EXPECT_TRUE(windows_[0]->picture(1) == expected_);
    EXPECT_EQ(effect_->lastReport().reason, "");
}

// Where names of framebuffers belong to a context, as in OpenGL 3, the one that OSG deletes for the
// other may have been ours. In Mesa the names are common, so this imitates such a driver.
TEST_F(SharedContexts, SurfacesOutliveTheirFramebuffers)
{
    windows_[1]->makeCurrent();
    const auto* gl = osg::GLExtensions::Get(windows_[1]->getState()->getContextID(), true);
    for (GLuint name = 1; name < 50; ++name)
        if (name != windows_[0]->getDefaultFboId() && name != windows_[1]->getDefaultFboId())
            gl->glDeleteFramebuffers(1, &name);
    for (size_t window = 0; window < kWindows; ++window)
        EXPECT_TRUE(draw(window) == expected_) << "window " << window;
    EXPECT_EQ(effect_->lastReport().reason, "");
}

}  // namespace
}  // namespace fbrdf::test
