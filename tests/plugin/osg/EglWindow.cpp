#include "EglWindow.h"

#include "OsgScene.h"

#include "support/gl/Scenes.h"

#include <osg/GLExtensions>
#include <osg/State>

namespace fbrdf::test {

EglWindow::EglWindow(int size, EglWindow* sharedWith, Profile profile)
    : sharedWith_(sharedWith), profile_(profile)
{
    _traits = new osg::GraphicsContext::Traits;
    _traits->width = _traits->height = size;
    _traits->sharedContext = sharedWith;
    osg::ref_ptr<osg::State> state = new osg::State;
    state->setGraphicsContext(this);
    state->setContextID(sharedWith ? sharedWith->getState()->getContextID()
                                   : osg::GraphicsContext::createNewContextID());
    if (sharedWith) osg::GraphicsContext::incrementContextIDUsageCount(state->getContextID());
    setState(state);
}

bool EglWindow::realizeImplementation()
{
    const bool core = profile_ == Profile::core;
    HeadlessOptions options{Backend::egl, profile_, core ? 3 : 2, core ? 3 : 1, false};
    options.sharedWith = sharedWith_.valid() ? sharedWith_->context_.get() : nullptr;
    context_ = std::make_unique<HeadlessContext>(options);
    offscreen_ = std::make_unique<Offscreen>(
        context_->loader(),
        OffscreenOptions{_traits->width, _traits->height, OffscreenFormat::rgba32f, true});
    setDefaultFboId(offscreen_->framebuffer());
    context_->release();
    return true;
}

void EglWindow::closeImplementation()
{
    if (!context_) return;
    context_->makeCurrent();
    offscreen_.reset();
    context_.reset();
}

bool EglWindow::makeCurrentImplementation()
{
    context_->makeCurrent();
    osg::GLExtensions::Get(getState()->getContextID(), true)
        ->glBindFramebuffer(GL_FRAMEBUFFER_EXT, offscreen_->framebuffer());
    return true;
}

bool EglWindow::releaseContextImplementation()
{
    context_->release();
    return true;
}

void EglWindow::swapBuffersImplementation()
{
    auto picture = offscreen_->readPixels();
    const std::lock_guard lock(mutex_);
    pictures_.push_back(std::move(picture));
    shown_.notify_all();
}

std::vector<float> EglWindow::picture(size_t frame)
{
    std::unique_lock lock(mutex_);
    shown_.wait(lock, [&] { return pictures_.size() > frame; });
    return pictures_[frame];
}

osg::ref_ptr<osgViewer::View> viewIn(EglWindow& window, osg::Node* scene)
{
    osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
    setUpView(*view);
    osg::Camera* camera = view->getCamera();
    camera->setGraphicsContext(&window);
    camera->setViewport(0, 0, window.getTraits()->width, window.getTraits()->height);
    camera->setProjectionMatrix(osgMatrix(perspectiveView().projection));
    camera->setViewMatrix(osgMatrix(perspectiveView().view));
    view->setSceneData(scene);
    return view;
}

}  // namespace fbrdf::test
