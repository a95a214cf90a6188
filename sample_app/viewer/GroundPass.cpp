#include "GroundPass.h"

#include "GlProgram.h"

namespace fbrdf::viewer {

GroundPass::GroundPass(gl::LoadFunction load)
    : gl_(loadGlFunctions(load)), program_(linkedProgram(gl_, "ground.vert", "ground.frag"))
{
    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.GenTextures(1, &visibility_);
}

GroundPass::~GroundPass()
{
    gl_.DeleteTextures(1, &visibility_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteProgram(program_);
}

void GroundPass::setVisibility(const scene::SkyVisibility& visibility)
{
    gl_.BindTexture(GL_TEXTURE_2D, visibility_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, visibility.size, visibility.size, 0, GL_RED, GL_FLOAT,
                   visibility.texels.data());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void GroundPass::draw(const gl::Target& target, const gl::View& view, const scene::Ground& ground,
                      const Vec3d& irradiance)
{
    const glm::mat4 clipFromGround = view.projection * view.view * ground.placement();
    const Vec3f openSky(irradiance * (scene::Ground::kAlbedo / kPi));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Viewport(0, 0, target.width, target.height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_SRC_ALPHA);
    gl_.UseProgram(program_);
    gl_.UniformMatrix4fv(gl_.GetUniformLocation(program_, "clipFromGround"), 1, GL_FALSE,
                         &clipFromGround[0][0]);
    gl_.Uniform1i(gl_.GetUniformLocation(program_, "visibility"), 0);
    gl_.Uniform3fv(gl_.GetUniformLocation(program_, "openSky"), 1, &openSky[0]);
    gl_.Uniform1f(gl_.GetUniformLocation(program_, "opaque"),
                  static_cast<float>(scene::Ground::kOpaque));
    drawCorners(gl_, vertexArray_, visibility_, 4);
    gl_.Disable(GL_BLEND);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace fbrdf::viewer
