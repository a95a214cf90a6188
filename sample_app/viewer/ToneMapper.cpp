#include "ToneMapper.h"

#include "GlProgram.h"
#include "Headless.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::viewer {
namespace {

/// A floating-point texture without levels; CPU pictures may be coarser than the window.
void setStorage(const GladGLContext& gl, GLuint texture, int width, int height, const float* rgba)
{
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, rgba);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.BindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace

ToneMapper::ToneMapper(gl::LoadFunction load)
    : gl_(loadGlFunctions(load)), program_(linkedProgram(gl_, "tonemap.vert", "tonemap.frag"))
{
    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.GenRenderbuffers(1, &depth_);
    gl_.GenTextures(1, &drawn_);
    gl_.GenTextures(1, &uploaded_);
}

ToneMapper::~ToneMapper()
{
    gl_.DeleteTextures(1, &uploaded_);
    gl_.DeleteTextures(1, &drawn_);
    gl_.DeleteRenderbuffers(1, &depth_);
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteProgram(program_);
}

void ToneMapper::resize(int width, int height)
{
    if (width == width_ && height == height_) return;
    setStorage(gl_, drawn_, width, height, nullptr);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, drawn_, 0);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorKind::gl, "window", Found("no RGBA32F framebuffer").expected("one"));
    width_ = width;
    height_ = height;
}

gl::Target ToneMapper::clearedTarget(int width, int height)
{
    resize(width, height);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    showUploaded_ = false;
    return {framebuffer_, width, height};
}

scene::Image ToneMapper::readTarget()
{
    std::vector<float> rgba(4 * static_cast<size_t>(width_) * static_cast<size_t>(height_));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, rgba.data());
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return imageFromBottomRows(rgba, width_, height_);
}

void ToneMapper::upload(const scene::Image& image)
{
    setStorage(gl_, uploaded_, image.width, image.height, image.rgba.data());
    showUploaded_ = true;
}

void ToneMapper::show(int width, int height, float exposure)
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Viewport(0, 0, width, height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.UseProgram(program_);
    gl_.Uniform1i(gl_.GetUniformLocation(program_, "radiance"), 0);
    gl_.Uniform1f(gl_.GetUniformLocation(program_, "exposure"), exposure);
    gl_.Uniform1f(gl_.GetUniformLocation(program_, "topDown"), showUploaded_ ? 1.0f : 0.0f);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, showUploaded_ ? uploaded_ : drawn_);
    gl_.BindVertexArray(vertexArray_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindVertexArray(0);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.UseProgram(0);
}

}  // namespace fbrdf::viewer
