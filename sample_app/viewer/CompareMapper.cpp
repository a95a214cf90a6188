#include "CompareMapper.h"

#include "GlProgram.h"
#include "HeatScale.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::viewer {
namespace {

using scene::CompareMode;

/// What compare.frag calls it.
int shaderMode(const CompareLayout& layout)
{
    switch (layout.mode) {
        case CompareMode::flip: return layout.showsB ? 2 : 1;
        case CompareMode::difference: return 3;
        case CompareMode::heat: return 4;
        case CompareMode::split:
        case CompareMode::wipe: break;
    }
    return 0;
}

}  // namespace

CompareMapper::CompareMapper(gl::LoadFunction load)
    : gl_(loadGlFunctions(load)), program_(linkedProgram(gl_, "window.vert", "compare.frag"))
{
    gl_.GenVertexArrays(1, &vertexArray_);
    for (Seat& seat : seats_) {
        gl_.GenFramebuffers(1, &seat.framebuffer);
        gl_.GenTextures(1, &seat.colour);
    }
}

CompareMapper::~CompareMapper()
{
    for (const Seat& seat : seats_) {
        gl_.DeleteTextures(1, &seat.colour);
        gl_.DeleteFramebuffers(1, &seat.framebuffer);
    }
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteProgram(program_);
}

void CompareMapper::resize(Seat& seat, int width, int height)
{
    gl_.BindTexture(GL_TEXTURE_2D, seat.colour);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, seat.framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, seat.colour, 0);
    const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorKind::gl, "window", Found("no RGBA8 framebuffer").expected("one"));
    seat.width = width;
    seat.height = height;
}

gl::Target CompareMapper::seat(int side, int width, int height)
{
    Seat& seat = seats_[static_cast<size_t>(side)];
    if (seat.width != width || seat.height != height) resize(seat, width, height);
    return {seat.framebuffer, width, height};
}

void CompareMapper::show(const gl::Target& target, const CompareLayout& layout)
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Viewport(0, 0, target.width, target.height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.UseProgram(program_);
    gl_.Uniform1i(uniform("a"), 0);
    gl_.Uniform1i(uniform("b"), 1);
    gl_.Uniform1i(uniform("mode"), shaderMode(layout));
    gl_.Uniform1f(uniform("line"), static_cast<float>(lineColumn(target.width, layout.at)));
    gl_.Uniform1f(uniform("gain"), layout.gain);
    gl_.Uniform1f(uniform("hottest"), kHottest);
    gl_.Uniform3fv(uniform("stops"), kHeatStopCount, &kHeatStops[0].x);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, seats_[1].colour);
    drawCorners(gl_, vertexArray_, seats_[0].colour, 3);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace fbrdf::viewer
