#include "SampleSum.h"

#include "GlProgram.h"
#include "Headless.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::viewer {
namespace {

GLint storedAs(ColourFormat format)
{
    if (format == ColourFormat::rgba8) return GL_RGBA8;
    return format == ColourFormat::rgba16f ? GL_RGBA16F : GL_RGBA32F;
}

}  // namespace

SampleSum::SampleSum(gl::LoadFunction load)
    : gl_(loadGlFunctions(load)), program_(linkedProgram(gl_, "window.vert", "sum.frag"))
{
    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.GenRenderbuffers(1, &depth_);
    for (Surface* surface : {&drawn_, &sum_}) {
        gl_.GenFramebuffers(1, &surface->framebuffer);
        gl_.GenTextures(1, &surface->colour);
    }
}

SampleSum::~SampleSum()
{
    for (const Surface* surface : {&drawn_, &sum_}) {
        gl_.DeleteTextures(1, &surface->colour);
        gl_.DeleteFramebuffers(1, &surface->framebuffer);
    }
    gl_.DeleteRenderbuffers(1, &depth_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteProgram(program_);
}

void SampleSum::resize(int width, int height, ColourFormat format)
{
    if (width == width_ && height == height_ && format == format_) return;
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    for (const Surface* surface : {&drawn_, &sum_}) {
        setFloatTexture(gl_, surface->colour, width, height, nullptr,
                        surface == &drawn_ ? storedAs(format) : GL_RGBA32F);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, surface->framebuffer);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                 surface->colour, 0);
        if (surface == &drawn_)
            gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                        depth_);
        const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        if (status != GL_FRAMEBUFFER_COMPLETE)
            throw Error(ErrorKind::gl, "window",
                        Found("no " + std::string(colourFormatName(format)) + " framebuffer")
                            .expected("one"));
    }
    width_ = width;
    height_ = height;
    format_ = format;
}

void SampleSum::clear(const Surface& surface) const
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, surface.framebuffer);
    gl_.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void SampleSum::restart(int width, int height, ColourFormat format)
{
    resize(width, height, format);
    clear(sum_);
    count_ = 0;
}

gl::Target SampleSum::clearedTarget()
{
    clear(drawn_);
    return {drawn_.framebuffer, width_, height_};
}

void SampleSum::add()
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sum_.framebuffer);
    gl_.Viewport(0, 0, width_, height_);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE);
    gl_.UseProgram(program_);
    gl_.Uniform1i(gl_.GetUniformLocation(program_, "drawn"), 0);
    drawCorners(gl_, vertexArray_, drawn_.colour, 3);
    gl_.Disable(GL_BLEND);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    ++count_;
}

scene::Image SampleSum::mean() const
{
    std::vector<float> rgba(4 * static_cast<size_t>(width_) * static_cast<size_t>(height_));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sum_.framebuffer);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, rgba.data());
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return meanOf(imageFromBottomRows(rgba, width_, height_), count_);
}

}  // namespace fbrdf::viewer
