#include "MaterialStates.h"

#include "EmbeddedShaders.h"
#include "FogPass.h"
#include "LightLists.h"
#include "OsgLights.h"
#include "PassState.h"
#include "SeamlessCubes.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/plan/LightVectors.h>
#include <fbrdf/shaders/LobeRows.h>
#include <fbrdf/shaders/TextureImage.h>

#include <osg/BlendFunc>
#include <osg/Texture2D>
#include <osg/Texture3D>

#include <OpenThreads/ScopedLock>

#include <algorithm>
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

/// Filtering between texel centres, nothing beyond the border, one level.
osg::ref_ptr<osg::Texture> textureOf(osg::Image* image, bool volume,
                                     osg::Texture::FilterMode filter)
{
    osg::ref_ptr<osg::Texture> texture;
    if (volume)
        texture = new osg::Texture3D(image);
    else
        texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, filter);
    texture->setFilter(osg::Texture::MAG_FILTER, filter);
    for (const auto axis : {osg::Texture::WRAP_S, osg::Texture::WRAP_T, osg::Texture::WRAP_R})
        texture->setWrap(axis, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setUnRefImageDataAfterApply(false);  // another context may come
    return texture;
}

osg::Vec3f toVec3f(const fbrdf::Vec3f& v)
{
    return {v.x, v.y, v.z};
}

// Numbers of lights vary as lights come into reach and go: so many plans of a material are kept.
constexpr size_t kMostPlans = 32;

/// The key of what vertex shaders depend on.
std::string vertexKeyOf(const PassInputs& inputs)
{
    const bool coordinates = inputs.textures.any() || inputs.derivedTangents;
    std::string key = std::string(inputs.derivedTangents ? "t" : "") + (coordinates ? "c" : "");
    for (const auto& [name, index] : inputs.vertexHook.attributes)
        key += name + std::to_string(index) + ',';
    return key + inputs.vertexHook.glsl;
}

std::string keyOf(const PassInputs& inputs)
{
    return inputs.units.key() + (inputs.preciseFiltering ? "p" : "") + (inputs.blended ? "b" : "") +
           (inputs.listed ? "l" : "") + inputs.hooks.key() + keyOf(inputs.textures) +
           vertexKeyOf(inputs);
}

std::string keyOf(const fbrdf::LobeLayout& layout)
{
    return std::to_string(static_cast<int>(layout.axes)) + '/' + std::to_string(layout.lobes) +
           '/' + std::to_string(layout.thetas) + '/' + std::to_string(layout.azimuths);
}

/// The key of all that PassTechnique sets in a request. Tables of one material that have the same
/// layout are the same.
std::string keyOf(const fbrdf::PlanRequest& request, const PassInputs& inputs)
{
    std::string key = keyOf(inputs);
    for (const int value :
         {static_cast<int>(request.technique), request.lights, request.lightsPerPass,
          request.maxLookups, static_cast<int>(request.target), static_cast<int>(request.offscreen),
          static_cast<int>(request.transfer), static_cast<int>(request.signs),
          static_cast<int>(inputs.surfaces)})
        key += ',' + std::to_string(value);
    const fbrdf::LobeLight& light = request.lobeLight;
    return light.isEmpty() ? key
                           : key + (light.environment ? 'e' : 'a') +
                                 std::to_string(light.areaLights) + '/' + keyOf(request.lobes);
}

std::string keyOf(const fbrdf::Pass& pass, const fbrdf::ProgramSpec& spec, int bin,
                  const PassInputs& inputs)
{
    std::string key = keyOf(inputs) + '@' + std::to_string(bin) + 'b' +
                      std::to_string(static_cast<int>(pass.blend)) + 'd' +
                      std::to_string(static_cast<int>(pass.depth)) + (spec.reads ? 'r' : '-') +
                      (spec.gained ? "g" : "") + (spec.lit ? 'l' : 'u') +
                      std::to_string(spec.lightSlots) + 'o' +
                      std::to_string(static_cast<int>(spec.transfer));
    for (const fbrdf::Part& part : spec.parts) {
        key += ';' + std::to_string(part.term) + (part.scaled ? "s" : "");
        for (const int factor : part.factors) key += ',' + std::to_string(factor);
    }
    const fbrdf::LobeShare& share = pass.lobes;
    if (!share.isEmpty())
        key += (share.environment ? 'e' : 'a') + std::to_string(share.areaSlots) + '/' +
               keyOf(share.table) + (share.cosine ? "c" : "-") + std::to_string(share.first) + '+' +
               std::to_string(share.count);
    return key;
}

// Alpha is 1 where the first pass drew; later passes leave it alone.
void setBlend(osg::StateSet& state, fbrdf::Blend blend)
{
    if (blend == fbrdf::Blend::replace) return state.setMode(GL_BLEND, kOff);
    const bool add = blend == fbrdf::Blend::add;
    state.setAttributeAndModes(
        new osg::BlendFunc(add ? GL_ONE : GL_DST_COLOR, add ? GL_ONE : GL_ZERO, GL_ZERO, GL_ONE),
        kOurs);
}

void bindAttributes(VersionedProgram& program, const PassInputs& inputs)
{
    program.bindAttribute("fbrdfVertexTangent", kTangentAttribute);
    for (const auto& [name, index] : inputs.vertexHook.attributes)
        program.bindAttribute(name, index);
}

}  // namespace

fbrdf::Capabilities assumedCapabilities(const LightHooks& hooks, fbrdf::ColourFormat surfaces)
{
    fbrdf::Capabilities assumed;
    assumed.maxTextureUnits = 16;
    assumed.maxUniformVectors = 1024;
    // Taken off are those of the hooks, and for each light its number: a quarter of all, as an int
    // of an array may fill a vector and a light has three vectors beside it.
    if (hooks.any())
        assumed.maxUniformVectors -= hooks.uniformVectors() + assumed.maxUniformVectors / 4;
    assumed.floatTextures = assumed.textureLod = assumed.framebufferObjects = true;
    assumed.floatTargets = surfaces == fbrdf::ColourFormat::rgba32f;
    assumed.halfTargets = assumed.floatTargets || surfaces == fbrdf::ColourFormat::rgba16f;
    return assumed;
}

MaterialStates::MaterialStates(const fbrdf::Material& material)
    : form_(material.form),
      hasSigns_(fbrdf::hasSigns(material)),
      peaks_(fbrdf::peaksOf(material)),
      lobes_(material),
      name_(material.name.empty() ? material.form.name : material.name)
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
            uniform->setElement(static_cast<unsigned int>(i), toVec3f(knots[i]));
        map.uniforms = {uniform};
        encodings_.push_back({fbrdf::isLog(table.storage), false});
        return map;
    }
    const fbrdf::TextureImage texels = fbrdf::textureImage(table, assumedCapabilities());
    const bool volume = fbrdf::dimensionCount(table.domain) == 3;
    const osg::ref_ptr<osg::Image> image = imageOf(texels);
    map.texture = textureOf(image, volume, osg::Texture::LINEAR);
    map.unfiltered = textureOf(image, volume, osg::Texture::NEAREST);
    for (const auto& texture : {map.texture, map.unfiltered})
        texture->setName(name_ + ":" + table.name);
    if (texels.encoding.ranged)
        map.uniforms = {new osg::Uniform(("fbrdfLower" + k).c_str(), toVec3f(texels.lower)),
                        new osg::Uniform(("fbrdfExtent" + k).c_str(), toVec3f(texels.extent))};
    encodings_.push_back(texels.encoding);
    return map;
}

fbrdf::SurfaceInputs MaterialStates::surfaceOf(const PassInputs& inputs, int glsl) const
{
    fbrdf::SurfaceInputs surface = surfaceInputs(glsl);
    surface.derivedTangent = inputs.derivedTangents;
    surface.shadowHook = shadowHook(inputs.hooks);
    surface.vertexHook = inputs.vertexHook.glsl;
    addSurface(surface, inputs.textures, form_);
    return surface;
}

/// The caller has the lock.
const VersionedShader& MaterialStates::vertexOf(const PassInputs& inputs)
{
    VersionedShader& vertex = vertices_[vertexKeyOf(inputs)];
    if (!vertex.front())
        vertex = versionedShader(osg::Shader::VERTEX, [&](int glsl) {
            return fbrdf::vertexSource(glsl, surfaceOf(inputs, glsl));
        });
    return vertex;
}

osg::ref_ptr<osg::Program> MaterialStates::programOf(const fbrdf::ProgramSpec& spec,
                                                     const PassInputs& inputs)
{
    std::vector<fbrdf::TableEncoding> encodings = encodings_;
    for (const size_t i : textures_) encodings[i].precise = inputs.preciseFiltering;
    const auto fragment = versionedShader(osg::Shader::FRAGMENT, [&](int contexts) {
        // A program may have shaders of several versions.
        const int glsl = spec.clustered ? kShaderVersions.back() : contexts;
        return fbrdf::fragmentSource(form_, encodings, spec, glsl, surfaceOf(inputs, glsl));
    });
    osg::ref_ptr<VersionedProgram>& program =
        programs_[fragment[0]->getShaderSource() + vertexKeyOf(inputs)];
    if (program) return program;
    program = new VersionedProgram("fbrdf " + name_, vertexOf(inputs), fragment);
    bindAttributes(*program, inputs);
    return program;
}

void MaterialStates::addMaps(osg::StateSet& state, const PassInputs& inputs) const
{
    for (size_t i = 0; i < textures_.size(); ++i) {
        const int unit = inputs.units[static_cast<int>(i)];
        const Map& map = maps_[textures_[i]];
        state.setTextureAttribute(static_cast<unsigned int>(unit),
                                  inputs.preciseFiltering ? map.unfiltered : map.texture, kOurs);
        const std::string name = "fbrdfTable" + std::to_string(textures_[i]);
        state.addUniform(new osg::Uniform(name.c_str(), unit), kOurs);
    }
    for (const Map& map : maps_)
        for (const auto& uniform : map.uniforms) state.addUniform(uniform, kOurs);
    const std::vector<int>& shadows = inputs.hooks.shadows.units;
    for (size_t k = 0; k < shadows.size(); ++k) {
        const std::string name = "osgFbrdfShadowMap" + std::to_string(k);
        state.addUniform(new osg::Uniform(name.c_str(), shadows[k]), kOurs);
    }
}

void MaterialStates::addLists(osg::StateSet& state, const fbrdf::Pass& pass,
                              const PassInputs& inputs) const
{
    for (size_t i = 0; i < kListSamplers.size(); ++i)
        state.addUniform(new osg::Uniform(kListSamplers[i], listUnit(pass, inputs.units, i)),
                         kOurs);
}

void MaterialStates::addLobes(osg::StateSet& state, const fbrdf::Pass& pass,
                              const PassInputs& inputs, const fbrdf::LobeTable& lobes) const
{
    const auto rows = fbrdf::lobeRows(lobes, pass.lobes);
    const osg::ref_ptr<osg::Uniform> uniform =
        new osg::Uniform(osg::Uniform::FLOAT_VEC4, "fbrdfLobes", static_cast<int>(rows.size()));
    unsigned int at = 0;
    for (const glm::vec4& row : rows)
        uniform->setElement(at++, osg::Vec4f(row.x, row.y, row.z, row.w));
    state.addUniform(uniform, kOurs);
    const glm::vec2 bend = fbrdf::lobeBend(lobes);
    if (lobes.axes == fbrdf::LobeAxes::bent)
        state.addUniform(new osg::Uniform("fbrdfLobeBend", osg::Vec2f(bend.x, bend.y)), kOurs);
    if (!pass.lobes.environment) return;
    state.addUniform(new osg::Uniform("fbrdfEnvironment", environmentUnit(pass, inputs.units)),
                     kOurs);
    state.setAttribute(new SeamlessCubes(true), kOurs);
}

ContextLimits MaterialStates::neededBy(const fbrdf::Pass& pass, const PassInputs& inputs) const
{
    const LightHooks& hooks = inputs.hooks;
    const bool listed = inputs.listed && pass.lit;
    if (pass.lobes.isEmpty() && hooks.shadows.empty() && !listed) return {};
    const fbrdf::Capabilities assumed = assumedCapabilities(hooks);
    const int lights =
        fbrdf::programSpec(pass, fbrdf::maxLightsInUniforms(form_, assumed, pass.lobes)).lightSlots;
    // A number of a light may fill a vector.
    const int hooked = hooks.any() ? hooks.uniformVectors() + lights : 0;
    const int vectors = assumed.maxUniformVectors - fbrdf::freeUniformVectors(form_, assumed) +
                        fbrdf::kVectorsPerLight * lights + hooked + pass.lobes.vectors();
    const bool cube = pass.lobes.environment;
    const int lists = listed ? static_cast<int>(kListSamplers.size()) : 0;
    int units = inputs.units.needed(texturesBeforeLists(pass) + lists);
    for (const int unit : hooks.shadows.units) units = std::max(units, unit + 1);
    return {units, 4 * vectors, cube};
}

/// The caller has the lock.
osg::ref_ptr<osg::StateSet> MaterialStates::stateOf(const fbrdf::Pass& pass, int bin,
                                                    const PassInputs& inputs,
                                                    const fbrdf::LobeTable* lobes)
{
    auto spec = fbrdf::programSpec(
        pass, fbrdf::maxLightsInUniforms(form_, assumedCapabilities(inputs.hooks), pass.lobes));
    spec.clustered = inputs.listed && pass.lit;
    spec.resolved = spec.reads;  // the target may be multisampled (Surfaces.h)
    spec.toSurface = false;      // alpha tests of the model leave holes in surfaces as well
    osg::ref_ptr<osg::StateSet>& state = states_[keyOf(pass, spec, bin, inputs)];
    if (state) return state;
    state = new osg::StateSet;
    state->setAttributeAndModes(programOf(spec, inputs), kOurs);
    addMaps(*state, inputs);
    if (!pass.lobes.isEmpty()) addLobes(*state, pass, inputs, *lobes);
    if (spec.clustered) addLists(*state, pass, inputs);
    plainTextures_.addTo(*state, inputs.textures);
    if (inputs.blended) return state;
    setBlend(*state, pass.blend);
    setPlace(*state, pass.depth, bin);
    // Where nothing is left in the first pass, depth differs in later ones.
    if (inputs.textures.hasAlpha() && pass.depth == fbrdf::Depth::write)
        state->setMode(GL_ALPHA_TEST, osg::StateAttribute::OFF);
    return state;
}

fbrdf::Plan MaterialStates::plan(const fbrdf::PlanRequest& request, const PassInputs& inputs) const
{
    return fbrdf::planPasses(form_, request, assumedCapabilities(inputs.hooks, inputs.surfaces));
}

std::shared_ptr<const PlannedPasses> MaterialStates::passes(const fbrdf::PlanRequest& request,
                                                            const PassInputs& inputs,
                                                            const fbrdf::LobeTable* lobes)
{
    const std::string key = keyOf(request, inputs);
    const Lock lock(mutex_);
    const auto known = planned_.find(key);
    if (known != planned_.end() && !request.peaks) return known->second;
    const auto planned = std::make_shared<PlannedPasses>();
    planned->plan = plan(request, inputs);
    for (const fbrdf::Pass& pass : planned->plan.passes) {
        planned->states.push_back(
            stateOf(pass, static_cast<int>(planned->states.size()) + 1, inputs, lobes));
        planned->needed = larger(planned->needed, neededBy(pass, inputs));
    }
    if (request.peaks) return planned;
    if (planned_.size() >= kMostPlans) planned_.clear();
    planned_.emplace(key, planned);
    return planned;
}

osg::ref_ptr<osg::StateSet> MaterialStates::fogStateOf(int bin, const PassInputs& inputs)
{
    const Lock lock(mutex_);
    const std::string key = "fog" + vertexKeyOf(inputs);
    osg::ref_ptr<osg::StateSet>& state = states_[key + '@' + std::to_string(bin)];
    if (state) return state;
    osg::ref_ptr<VersionedProgram>& program = programs_[key];
    if (!program) {
        program = fogProgram(vertexOf(inputs));
        bindAttributes(*program, inputs);
    }
    state = fogState(program, bin);
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
