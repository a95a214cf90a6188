// EglWindow.h - a window of osgViewer without a display: a context of its own and an RGBA32F
// framebuffer, bound whenever the context is made current. osgViewer runs every threading model in
// it, and keeps what each frame showed when buffers were swapped.
#pragma once
#include <fbrdf/headless/Context.h>
#include <fbrdf/headless/Offscreen.h>

#include <osgViewer/GraphicsWindow>
#include <osgViewer/View>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace fbrdf::test {

class EglWindow : public osgViewer::GraphicsWindow {
public:
    using Profile = HeadlessOptions::Profile;
    /// sharedWith: the window whose OpenGL objects and OSG context number this one has too.
    explicit EglWindow(int size, EglWindow* sharedWith = nullptr,
                       Profile profile = Profile::compatibility);

    /// The picture of the frame-th swap, counted from 0: RGBA, rows from the bottom. Waits for it.
    std::vector<float> picture(size_t frame);

    bool valid() const override { return _state.valid(); }
    bool realizeImplementation() override;
    bool isRealizedImplementation() const override { return context_ != nullptr; }
    void closeImplementation() override;
    bool makeCurrentImplementation() override;
    bool makeContextCurrentImplementation(osg::GraphicsContext*) override { return makeCurrent(); }
    bool releaseContextImplementation() override;
    void bindPBufferToTextureImplementation(GLenum) override {}
    void swapBuffersImplementation() override;
    void grabFocusIfPointerInWindow() override {}

protected:
    ~EglWindow() override { close(true); }

private:
    osg::observer_ptr<EglWindow> sharedWith_;
    Profile profile_;
    std::unique_ptr<HeadlessContext> context_;
    std::unique_ptr<Offscreen> offscreen_;
    std::mutex mutex_;
    std::condition_variable shown_;
    std::vector<std::vector<float>> pictures_;  ///< guarded by mutex_
};

/// A view that fills the window: perspectiveView(), black, no headlight.
osg::ref_ptr<osgViewer::View> viewIn(EglWindow& window, osg::Node* scene);

}  // namespace fbrdf::test
