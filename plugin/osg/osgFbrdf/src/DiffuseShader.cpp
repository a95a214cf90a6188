#include "DiffuseShader.h"

#include "EmbeddedShaders.h"
#include "FogPass.h"
#include "GlLights.h"
#include "PassState.h"
#include "VersionedProgram.h"

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

constexpr int kVectorsPerDiffuseLight = 5;  // of diffuse.vert
constexpr int kBin = 1;

/// The vectors of one light, in eye space: see diffuse.vert.
std::array<osg::Vec4f, kVectorsPerDiffuseLight> diffuseVectors(const PlacedOsgLight& placed,
                                                               const osg::Matrixd& toEye)
{
    const osg::Light& light = *placed.light;
    const osg::Matrixd matrix = placed.inEye ? placed.toWorld : placed.toWorld * toEye;
    osg::Vec4d place = osg::Vec4d(light.getPosition()) * matrix;
    if (place.w() != 0.0) place /= place.w();
    osg::Vec3d axis = osg::Matrixd::transform3x3(osg::Vec3d(light.getDirection()), matrix);
    axis.normalize();
    const bool aimed = light.getSpotCutoff() <= 90.0f;
    osg::Vec4f diffuse = light.getDiffuse(), ambient = light.getAmbient();
    diffuse.w() = light.getSpotExponent();
    ambient.w() = aimed ? std::cos(osg::DegreesToRadians(light.getSpotCutoff())) : -1.0f;
    return {osg::Vec4f(place), diffuse, ambient,
            osg::Vec4f(light.getConstantAttenuation(), light.getLinearAttenuation(),
                       light.getQuadraticAttenuation(), 0.0f),
            osg::Vec4f(osg::Vec3f(axis), 0.0f)};
}

std::string withHead(int glsl, std::initializer_list<const char*> files)
{
    std::string text = shaderHead(glsl);
    for (const char* file : files) text += fbrdf::osgFbrdfShader(file);
    return text;
}

}  // namespace

DiffuseShader::DiffuseShader()
{
    constexpr int kGlsl = kShaderVersions.back();
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("fbrdf diffuse");
    program->addShader(
        new osg::Shader(osg::Shader::VERTEX, withHead(kGlsl, {"inputs.glsl", "diffuse.vert"})));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, withHead(kGlsl, {"diffuse.frag"})));
    state_->setAttributeAndModes(program, kOurs);
    setBin(*state_, kBin);
    const auto vertex = versionedShader(osg::Shader::VERTEX, [](int glsl) {
        return fbrdf::vertexSource(glsl, surfaceInputs(glsl));
    });
    fog_ = osgFbrdf::fogState(fogProgram(vertex), kBin + 1);
}

osg::ref_ptr<osg::StateSet> DiffuseShader::frameState(const DiffuseSurface& surface,
                                                      const std::vector<PlacedOsgLight>& lights,
                                                      const osg::Matrixd& toEye)
{
    const int count = std::min(static_cast<int>(lights.size()), kMostGlLights);
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->addUniform(new osg::Uniform("osgFbrdfAlbedo", surface.albedo));
    state->addUniform(new osg::Uniform("osgFbrdfAmbient", surface.ambient));
    state->addUniform(new osg::Uniform("osgFbrdfSurrounding", surface.surrounding));
    state->addUniform(new osg::Uniform("osgFbrdfDiffuseLightCount", count));
    if (count == 0) return state;
    const osg::ref_ptr<osg::Uniform> vectors = new osg::Uniform(
        osg::Uniform::FLOAT_VEC4, "osgFbrdfDiffuseLights", kVectorsPerDiffuseLight * count);
    unsigned int at = 0;
    for (int i = 0; i < count; ++i)
        for (const osg::Vec4f& v : diffuseVectors(lights[static_cast<size_t>(i)], toEye))
            vectors->setElement(at++, v);
    state->addUniform(vectors);
    return state;
}

void DiffuseShader::resizeGLObjectBuffers(unsigned int maxSize)
{
    for (const auto& state : {state_, fog_}) state->resizeGLObjectBuffers(maxSize);
}

void DiffuseShader::releaseGLObjects(osg::State* state) const
{
    for (const auto& each : {state_, fog_}) each->releaseGLObjects(state);
}

}  // namespace osgFbrdf
