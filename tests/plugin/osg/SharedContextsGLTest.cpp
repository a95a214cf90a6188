// Two windows whose contexts share objects: OSG gives both one number, by which it keeps programs,
// textures and buffers, but framebuffers and array pointers belong to one context. One thread draws
// both: with a draw thread for each, OSG 3.6.5 loses or crashes on an ordinary sphere too, as it
// keeps objects by that number without locks.
#include "EffectTest.h"
#include "EglWindow.h"

#include "support/gl/Scenes.h"

#include <osg/GLExtensions>
#include <osgViewer/CompositeViewer>

#include <set>

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

/// Refuses to bind a name that glGenFramebuffers did not give, as OpenGL 3 demands and the driver
/// of NVIDIA does; Mesa makes a framebuffer of any name in a compatibility context.
class StrictNames {
public:
    explicit StrictNames(osg::GLExtensions& gl) : gl_(gl), real_(gl.glBindFramebuffer)
    {
        active = this;
        gl_.glBindFramebuffer = bind;
        osg::setGLExtensionFuncPtr(isFramebuffer_, "glIsFramebuffer");
        generate_ = gl_.glGenFramebuffers;
        gl_.glGenFramebuffers = generate;
    }
    ~StrictNames()
    {
        gl_.glBindFramebuffer = real_;
        gl_.glGenFramebuffers = generate_;
        active = nullptr;
    }
    StrictNames(const StrictNames&) = delete;
    StrictNames& operator=(const StrictNames&) = delete;

private:
    static void GL_APIENTRY generate(GLsizei count, GLuint* names)
    {
        active->generate_(count, names);
        active->fresh_.insert(names, names + count);
    }
    static void GL_APIENTRY bind(GLenum target, GLuint name)
    {
        // A fresh name is no framebuffer before it is bound for the first time.
        const bool known = active->fresh_.erase(name) > 0 || active->isFramebuffer_(name);
        constexpr GLenum kNoTarget = 0;  // sets an error
        active->real_(name == 0 || known ? target : kNoTarget, name);
    }

    static inline StrictNames* active = nullptr;  // functions of GL have no user pointer
    osg::GLExtensions& gl_;
    decltype(osg::GLExtensions::glBindFramebuffer) real_;
    decltype(osg::GLExtensions::glGenFramebuffers) generate_ = nullptr;
    GLboolean(GL_APIENTRY* isFramebuffer_)(GLuint) = nullptr;
    std::set<GLuint> fresh_;
};

/// Where names of framebuffers belong to a context, as in OpenGL 3, the one that OSG deletes for
/// the other may have been ours. In Mesa the names are common, so this imitates such a driver.
class LostFramebuffers : public SharedContexts {
protected:
    osg::GLExtensions& extensions()
    {
        windows_[1]->makeCurrent();
        return *osg::GLExtensions::Get(windows_[1]->getState()->getContextID(), true);
    }
    /// Deletes, in the second window, all but what the windows show; returns their names.
    std::vector<GLuint> deleteAll(const osg::GLExtensions& gl)
    {
        GLboolean(GL_APIENTRY * isFramebuffer)(GLuint) = nullptr;
        osg::setGLExtensionFuncPtr(isFramebuffer, "glIsFramebuffer");
        std::vector<GLuint> deleted;
        for (GLuint name = 1; name < 50; ++name) {
            if (!isFramebuffer(name) || name == windows_[0]->getDefaultFboId() ||
                name == windows_[1]->getDefaultFboId())
                continue;
            gl.glDeleteFramebuffers(1, &name);
            deleted.push_back(name);
        }
        EXPECT_FALSE(deleted.empty());
        return deleted;
    }
    void expectTheSamePictures()
    {
        for (int frame = 0; frame < 2; ++frame)
            for (size_t window = 0; window < kWindows; ++window)
                EXPECT_TRUE(draw(window) == expected_) << "window " << window;
        EXPECT_EQ(effect_->lastReport().reason, "");
    }
};

TEST_F(LostFramebuffers, AreMadeAnew)
{
    const osg::GLExtensions& gl = extensions();
    for (int time = 0; time < 3; ++time) {
        windows_[1]->makeCurrent();
        deleteAll(gl);
        expectTheSamePictures();
    }
}

TEST_F(LostFramebuffers, AreMadeAnewWhereADriverRefusesTheirNames)
{
    osg::GLExtensions& gl = extensions();
    deleteAll(gl);
    const StrictNames strict(gl);
    expectTheSamePictures();
}

// The host has got the names that were ours. It takes them by binding them, as Mesa allows.
TEST_F(LostFramebuffers, AreMadeAnewWhereTheirNamesAreAnothersByNow)
{
    const osg::GLExtensions& gl = extensions();
    const std::vector<GLuint> names = deleteAll(gl);
    std::vector<GLuint> textures(names.size());
    glGenTextures(static_cast<GLsizei>(names.size()), textures.data());
    glClearColor(0.25f, 0.5f, 0.75f, 1.0f);
    for (size_t i = 0; i < names.size(); ++i) {
        glBindTexture(GL_TEXTURE_2D, textures[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, names[i]);
        if (glGetError() != GL_NO_ERROR) GTEST_SKIP() << "the driver chooses all names by itself";
        gl.glFramebufferTexture2D(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D,
                                  textures[i], 0);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    expectTheSamePictures();
    windows_[1]->makeCurrent();
    for (const GLuint name : names) {
        gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, name);
        float pixel[4] = {};
        glReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_FLOAT, pixel);
        EXPECT_NEAR(pixel[0], 0.25, 0.01) << "the host's framebuffer " << name;
    }
    glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
}

}  // namespace
}  // namespace fbrdf::test
