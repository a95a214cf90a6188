#include "MaterialStates.h"

#include "EmbeddedShaders.h"
#include "FogPass.h"
#include "PassState.h"
#include "PlainLights.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/shaders/TextureImage.h>

#include <osg/BlendFunc>
#include <osg/Texture2D>
#include <osg/Texture3D>

#include <OpenThreads/ScopedLock>

#include <cstring>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

struct Format {
    GLint internal;
    GLenum type;
};

Format formatOf(fbrdf::TexelType type)
{
    switch (type) {
        case fbrdf::TexelType::unorm16: return {GL_RGB16, GL_UNSIGNED_SHORT};
        case fbrdf::TexelType::half: return {GL_RGB16F_ARB, GL_HALF_FLOAT};
        case fbrdf::TexelType::float32: return {GL_RGB32F_ARB, GL_FLOAT};
    }
    return {};
}

osg::ref_ptr<osg::Image> imageOf(const fbrdf::TextureImage& texels)
{
    const Format format = formatOf(texels.type);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    // Rows are packed: RGB of 16 bits need not end on a multiple of four bytes.
    image->allocateImage(texels.size[0], texels.size[1], texels.size[2], GL_RGB, format.type, 1);
    image->setInternalTextureFormat(format.internal);
    if (texels.type == fbrdf::TexelType::float32)
        std::memcpy(image->data(), texels.floats.data(), texels.floats.size() * sizeof(float));
    else
        std::memcpy(image->data(), texels.words.data(), texels.words.size() * sizeof(uint16_t));
    return image;
}

/// Linear filtering between texel centres, nothing beyond the border, one level.
osg::ref_ptr<osg::Texture> textureOf(const fbrdf::TextureImage& texels, bool volume)
{
    osg::ref_ptr<osg::Texture> texture;
    if (volume)
        texture = new osg::Texture3D(imageOf(texels));
    else
        texture = new osg::Texture2D(imageOf(texels));
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    for (const auto axis : {osg::Texture::WRAP_S, osg::Texture::WRAP_T, osg::Texture::WRAP_R})
        texture->setWrap(axis, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setUnRefImageDataAfterApply(false);  // another context may come
    return texture;
}

osg::Vec3f toOsg(const fbrdf::Vec3f& v)
{
    return {v.x, v.y, v.z};
}

std::string keyOf(const fbrdf::Pass& pass, const fbrdf::ProgramSpec& spec, const PassPlace& place)
{
    std::string key = std::string(place.derivedTangents ? "t" : "") + (place.laws ? "w" : "") +
                      std::to_string(place.bin) + '@' + std::to_string(place.firstTextureUnit) +
                      'b' + std::to_string(static_cast<int>(pass.blend)) + 'd' +
                      std::to_string(static_cast<int>(pass.depth)) + (spec.reads ? 'r' : '-') +
                      (spec.lit ? 'l' : 'u') + std::to_string(spec.lightSlots) + 'o' +
                      std::to_string(static_cast<int>(spec.transfer));
    for (const fbrdf::Part& part : spec.parts) {
        key += ';' + std::to_string(part.term) + (part.scaled ? "s" : "");
        for (const int factor : part.factors) key += ',' + std::to_string(factor);
    }
    return key;
}

// Alpha: 1 where the first pass drew, then left alone.
void setBlend(osg::StateSet& state, fbrdf::Blend blend)
{
    if (blend == fbrdf::Blend::replace) return state.setMode(GL_BLEND, kOff);
    const bool add = blend == fbrdf::Blend::add;
    state.setAttributeAndModes(
        new osg::BlendFunc(add ? GL_ONE : GL_DST_COLOR, add ? GL_ONE : GL_ZERO, GL_ZERO, GL_ONE),
        kOurs);
}

osg::Shader* vertexShader(bool derivesTangents)
{
    return new osg::Shader(osg::Shader::VERTEX, fbrdf::vertexSource(assumedCapabilities().glsl,
                                                                    {true, derivesTangents}));
}

}  // namespace

fbrdf::Capabilities assumedCapabilities(bool laws)
{
    fbrdf::Capabilities assumed;
    assumed.maxTextureUnits = 16;
    assumed.maxUniformVectors = 1024;
    // The laws, and of each light which one it has: a quarter of what lights can have, as an int of
    // an array may fill a vector.
    if (laws)
        assumed.maxUniformVectors -= kVectorsPerLaw * kMostLaws + assumed.maxUniformVectors / 4;
    assumed.floatTextures = true;
    assumed.framebufferObjects = assumed.floatTargets = true;
    return assumed;
}

MaterialStates::MaterialStates(const fbrdf::Material& material)
    : form_(material.form),
      hasSigns_(fbrdf::hasSigns(material)),
      name_(material.name.empty() ? material.form.name : material.name),
      vertex_(vertexShader(false)),
      derivingVertex_(vertexShader(true))
{
    for (size_t i = 0; i < material.tables.size(); ++i) {
        form_.tables[i].domain = material.tables[i].domain;
        maps_.push_back(mapOf(static_cast<int>(i), material.tables[i]));
        if (maps_.back().texture) textures_.push_back(i);
    }
}

MaterialStates::Map MaterialStates::mapOf(int index, const fbrdf::Table& table)
{
    Map map;
    const std::string k = std::to_string(index);
    if (form_.tables[static_cast<size_t>(index)].uniform) {
        const auto knots = fbrdf::uniformKnots(table);
        osg::ref_ptr<osg::Uniform> uniform = new osg::Uniform(
            osg::Uniform::FLOAT_VEC3, "fbrdfKnots" + k, static_cast<int>(knots.size()));
        for (size_t i = 0; i < knots.size(); ++i)
            uniform->setElement(static_cast<unsigned int>(i), toOsg(knots[i]));
        map.uniforms = {uniform};
        encodings_.push_back({fbrdf::isLog(table.storage), false});
        return map;
    }
    const fbrdf::TextureImage texels = fbrdf::textureImage(table, assumedCapabilities());
    map.texture = textureOf(texels, fbrdf::dimensionCount(table.domain) == 3);
    map.texture->setName(name_ + ":" + table.name);
    if (texels.encoding.ranged)
        map.uniforms = {new osg::Uniform(("fbrdfLower" + k).c_str(), toOsg(texels.lower)),
                        new osg::Uniform(("fbrdfExtent" + k).c_str(), toOsg(texels.extent))};
    encodings_.push_back(texels.encoding);
    return map;
}

osg::ref_ptr<osg::Program> MaterialStates::programOf(const fbrdf::ProgramSpec& spec,
                                                     const PassPlace& place)
{
    fbrdf::SurfaceInputs inputs{true, place.derivedTangents};
    if (place.laws) inputs.shadowHook = fbrdf::osgFbrdfShader("laws.glsl");
    const std::string fragment =
        fbrdf::fragmentSource(form_, encodings_, spec, assumedCapabilities().glsl, inputs);
    osg::ref_ptr<osg::Program>& program = programs_[fragment + (place.derivedTangents ? "t" : "")];
    if (program) return program;
    program = new osg::Program;
    program->setName("fbrdf " + name_);
    program->addShader(place.derivedTangents ? derivingVertex_ : vertex_);
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));
    program->addBindAttribLocation("fbrdfVertexTangent", kTangentAttribute);
    return program;
}

void MaterialStates::addMaps(osg::StateSet& state, int firstTextureUnit) const
{
    for (size_t i = 0; i < textures_.size(); ++i) {
        const int unit = firstTextureUnit + static_cast<int>(i);
        state.setTextureAttribute(static_cast<unsigned int>(unit), maps_[textures_[i]].texture,
                                  kOurs);
        const std::string name = "fbrdfTable" + std::to_string(textures_[i]);
        state.addUniform(new osg::Uniform(name.c_str(), unit), kOurs);
    }
    for (const Map& map : maps_)
        for (const auto& uniform : map.uniforms) state.addUniform(uniform, kOurs);
}

osg::ref_ptr<osg::StateSet> MaterialStates::stateOf(const fbrdf::Pass& pass, const PassPlace& place)
{
    const auto spec = fbrdf::programSpec(
        pass, fbrdf::maxLightsInUniforms(form_, assumedCapabilities(place.laws)));
    const Lock lock(mutex_);
    osg::ref_ptr<osg::StateSet>& state = states_[keyOf(pass, spec, place)];
    if (state) return state;
    state = new osg::StateSet;
    state->setAttributeAndModes(programOf(spec, place), kOurs);
    addMaps(*state, place.firstTextureUnit);
    setBlend(*state, pass.blend);
    setPlace(*state, pass.depth, place.bin);
    return state;
}

osg::ref_ptr<osg::StateSet> MaterialStates::fogStateOf(int bin)
{
    const Lock lock(mutex_);
    osg::ref_ptr<osg::StateSet>& state = states_["fog" + std::to_string(bin)];
    if (!fog_) fog_ = fogProgram(vertex_);
    if (!state) state = fogState(fog_, bin);
    return state;
}

void MaterialStates::resizeGLObjectBuffers(unsigned int maxSize)
{
    const Lock lock(mutex_);
    for (const auto& [key, state] : states_) state->resizeGLObjectBuffers(maxSize);
}

void MaterialStates::releaseGLObjects(osg::State* state)
{
    const Lock lock(mutex_);
    for (const auto& [key, pass] : states_) pass->releaseGLObjects(state);
}

}  // namespace osgFbrdf
