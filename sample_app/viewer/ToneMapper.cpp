#include "ToneMapper.h"

#include "GlProgram.h"

#include <cmath>

namespace fbrdf::viewer {

ToneMapper::ToneMapper(gl::LoadFunction load)
    : gl_(loadGlFunctions(load)), program_(linkedProgram(gl_, "window.vert", "tonemap.frag"))
{
    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.GenTextures(1, &uploaded_);
    gl_.GenTextures(1, &panorama_);
}

ToneMapper::~ToneMapper()
{
    gl_.DeleteTextures(1, &panorama_);
    gl_.DeleteTextures(1, &uploaded_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteProgram(program_);
}

void ToneMapper::setPanorama(const Panorama& panorama)
{
    std::vector<float> rgba;
    rgba.reserve(4 * panorama.texels.size());
    for (const Vec3f& texel : panorama.texels)
        rgba.insert(rgba.end(), {texel.x, texel.y, texel.z, 1.0f});
    setFloatTexture(gl_, panorama_, panorama.width, panorama.height, rgba.data());
    gl_.BindTexture(GL_TEXTURE_2D, panorama_);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void ToneMapper::upload(const scene::Image& image)
{
    setFloatTexture(gl_, uploaded_, image.width, image.height, image.rgba.data());
}

void ToneMapper::show(const gl::Target& target, const SampleSum& samples, const Look& look)
{
    gl_.UseProgram(program_);
    gl_.Uniform1f(uniform("topDown"), 0.0f);
    gl_.Uniform1f(uniform("share"), 1.0f / static_cast<float>(samples.count()));
    fill(target, samples.texture(), look);
}

void ToneMapper::showUploaded(const gl::Target& target, const Look& look)
{
    gl_.UseProgram(program_);
    gl_.Uniform1f(uniform("topDown"), 1.0f);
    gl_.Uniform1f(uniform("share"), 1.0f);
    fill(target, uploaded_, look);
}

void ToneMapper::setBackground(const Look& look)
{
    const bool isEnvironment = look.background.environment && look.environment;
    const Vec3f colour = look.background.colour.value_or(Vec3f(0.0f));
    gl_.Uniform1i(uniform("behind"), isEnvironment ? 2 : look.background.colour ? 1 : 0);
    gl_.Uniform3fv(uniform("colour"), 1, &colour[0]);
    if (!isEnvironment) return;
    const double rotation = look.environment->rotation;
    const Vec3f turn(Vec3d(std::cos(rotation), std::sin(rotation), look.environment->intensity));
    const glm::mat4 worldFromClip(
        glm::inverse(glm::dmat4(look.view.projection) * glm::dmat4(look.view.view)));
    gl_.Uniform3fv(uniform("turn"), 1, &turn[0]);
    gl_.UniformMatrix4fv(uniform("worldFromClip"), 1, GL_FALSE, &worldFromClip[0][0]);
}

void ToneMapper::fill(const gl::Target& target, GLuint radiance, const Look& look)
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Viewport(0, 0, target.width, target.height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Uniform1i(uniform("radiance"), 0);
    gl_.Uniform1i(uniform("panorama"), 1);
    gl_.Uniform1f(uniform("exposure"), look.exposure);
    gl_.Uniform1i(uniform("curved"), look.toneMap);
    setBackground(look);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, panorama_);
    drawCorners(gl_, vertexArray_, radiance, 3);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace fbrdf::viewer
