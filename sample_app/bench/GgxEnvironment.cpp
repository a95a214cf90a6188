#include "bench/GgxEnvironment.h"

#include "bench/Materials.h"

#include "EmbeddedShaders.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/shaders/ShaderSource.h>
#include <fbrdf/sources/OpenSource.h>
#include <fbrdf/truth/Program.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace fbrdf {

std::string_view peerShader(std::string_view name);

namespace bench {
namespace {

constexpr int kPeerGlsl = 330;
constexpr int kCosines = 32, kAlphas = 32;

/// The integral of f cos theta_i of one GGX over a grid.
double albedoOf(const Source& source, double cosine)
{
    constexpr int kSteps = 24;
    const Vec3d wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            // Cosine-distributed, so that every step counts the same.
            const double r = std::sqrt((i + 0.5) / kSteps), phi = 2.0 * kPi * (j + 0.5) / kSteps;
            sum +=
                source.evaluate(wo, {r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0 - r * r)})
                    .x;
        }
    return kPi * sum / (kSteps * kSteps);
}

Vec2<double> albedosOf(double alpha, double cosine)
{
    const auto ggx = [alpha](const char* f0) {
        return openSource("ggx:alpha=" + fixedText(alpha) + ",kd=0,f0=" + f0);
    };
    const double black = albedoOf(ggx("0"), cosine);
    return {albedoOf(ggx("1"), cosine) - black, black};
}

std::string fragmentOf()
{
    std::string text = "#version " + std::to_string(kPeerGlsl) + "\n";
    for (const char* file : {"version.glsl", "surface.glsl"}) text += embeddedShader(file);
    return text + std::string(peerShader("ggx_environment.glsl"));
}

/// The lobe whose width is that of GGX: tan of the half angle at half of the peak.
double levelOfAlpha(double alpha)
{
    return kCosineLevel + std::log2(std::min(1.0, alpha));
}

}  // namespace

Vec2<double> GgxEnvironment::albedo(double cosine)
{
    return albedosOf(kAlpha, cosine);
}

GgxEnvironment::GgxEnvironment(const GladGLContext& gl, const Stage& stage,
                               std::shared_ptr<gl::GpuEnvironment> environment)
    : gl_(gl),
      environment_(std::move(environment)),
      mesh_(gl, stage.mesh),
      program_(truth::linkProgram(gl, vertexSource(kPeerGlsl), fragmentOf()))
{
    uploadAlbedo();
    setUniforms(stage.view);
}

GgxEnvironment::~GgxEnvironment()
{
    gl_.DeleteTextures(1, &albedo_);
    gl_.DeleteProgram(program_);
}

void GgxEnvironment::uploadAlbedo()
{
    std::vector<Vec2<float>> texels;
    for (int a = 0; a < kAlphas; ++a)
        for (int c = 0; c < kCosines; ++c)
            texels.emplace_back(albedosOf((a + 0.5) / kAlphas, (c + 0.5) / kCosines));
    gl_.GenTextures(1, &albedo_);
    gl_.BindTexture(GL_TEXTURE_2D, albedo_);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, kCosines, kAlphas, 0, GL_RG, GL_FLOAT,
                   texels.data());
    gl_.BindTexture(GL_TEXTURE_2D, 0);
}

void GgxEnvironment::setUniforms(const gl::View& view) const
{
    const int size = environment_->size();
    const auto level = [size](double lobe) { return static_cast<float>(cubeLevelOf(lobe, size)); };
    const glm::vec4 eye(eyeFromProjection(glm::dmat4(view.projection)));
    const glm::mat3 toEnvironment = glm::transpose(glm::mat3(view.view));
    const glm::vec4 parameters[] = {
        {Vec3f(kF0), level(levelOfAlpha(kAlpha))},
        {Vec3f(kDiffuse), level(kCosineLevel)},
        {static_cast<float>(kAlpha), static_cast<float>(kAlpha * kAlpha), 0.0f, 0.0f}};
    gl_.UseProgram(program_);
    gl_.UniformMatrix4fv(location("fbrdfModelView"), 1, GL_FALSE, glm::value_ptr(view.view));
    gl_.UniformMatrix4fv(location("fbrdfProjection"), 1, GL_FALSE, glm::value_ptr(view.projection));
    gl_.Uniform4fv(location("fbrdfEye"), 1, glm::value_ptr(eye));
    gl_.UniformMatrix3fv(location("peerToEnvironment"), 1, GL_FALSE, glm::value_ptr(toEnvironment));
    gl_.Uniform4fv(location("peerParameters"), 3, glm::value_ptr(parameters[0]));
    gl_.Uniform1i(location("peerEnvironment"), 0);
    gl_.Uniform1i(location("peerAlbedo"), 1);
    gl_.UseProgram(0);
}

void GgxEnvironment::draw(const gl::Target& target) const
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Viewport(0, 0, target.width, target.height);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl_.UseProgram(program_);
    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, albedo_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment_->texture());
    mesh_.bind();
    mesh_.draw();
    gl_.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    gl_.BindVertexArray(0);
    gl_.UseProgram(0);
    gl_.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl_.Disable(GL_DEPTH_TEST);
}

}  // namespace bench
}  // namespace fbrdf
