#include "BrdfState.h"

#include "EmbeddedShaders.h"
#include "FbrdfResourceManager.h"
#include "GlslArchive.h"
#include "LogLine.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <OgreRenderSystem.h>
#include <OgreRoot.h>
#include <OgreSceneManager.h>
#include <OgreShaderFFPRenderState.h>
#include <OgreShaderFunction.h>
#include <OgreShaderGenerator.h>
#include <OgreShaderProgram.h>
#include <OgreShaderProgramSet.h>
#include <OgreTechnique.h>

namespace ogreFbrdf {
namespace {

namespace shader = Ogre::RTShader;
using shader::In;
using shader::InOut;
using shader::Out;
using shader::Parameter;

// After the stage in which OGRE's integrated shadows (FFP_PS_COLOUR_BEGIN + 2) compute their
// factor, and before textures (FFP_PS_TEXTURING) multiply what is lit.
constexpr int kShade = shader::FFP_PS_COLOUR_BEGIN + 3;
// After what OGRE adds to the colour, and before fog.
constexpr int kFinish = shader::FFP_PS_COLOUR_END + 1;
// The name that OGRE's integrated shadows give their factor.
const char kShadowFactor[] = "lShadowFactor";

Ogre::String materialNameOf(const Ogre::Pass& pass)
{
    return pass.getParent()->getParent()->getName();
}

bool isGlsl()
{
    return shader::ShaderGenerator::getSingleton().getTargetLanguage() == "glsl";
}

void addTexture(Ogre::Pass& pass, const Ogre::TexturePtr& texture, Ogre::FilterOptions filter)
{
    Ogre::TextureUnitState* unit = pass.createTextureUnitState();
    unit->setTexture(texture);
    unit->setTextureAddressingMode(Ogre::TextureUnitState::TAM_CLAMP);
    unit->setTextureFiltering(filter, filter, Ogre::FO_NONE);
}

/// OGRE has bound the textures of a pass before it asks for the pass's uniforms.
void bindAgain(const Ogre::Pass& pass)
{
    Ogre::RenderSystem* system = Ogre::Root::getSingleton().getRenderSystem();
    for (size_t unit = 0; unit < pass.getNumTextureUnitStates(); ++unit)
        system->_setTexture(unit, true, pass.getTextureUnitStates()[unit]->_getTexturePtr());
}

}  // namespace

const Ogre::String& BrdfState::typeName()
{
    static const Ogre::String name = "Fbrdf";
    return name;
}

BrdfState::BrdfState(Services& services) : services_(services) {}

BrdfState::~BrdfState() = default;

const Ogre::String& BrdfState::getType() const
{
    return typeName();
}

int BrdfState::getExecutionOrder() const
{
    return shader::FFP_LIGHTING;
}

void BrdfState::copyFrom(const shader::SubRenderState& other)
{
    options_ = static_cast<const BrdfState&>(other).options_;
}

bool BrdfState::setParameter(const Ogre::String& name, const Ogre::String& value)
{
    const std::string problem = setOption(options_, name, value);
    if (!problem.empty())
        warn(options_.material.empty() ? "a state without a material" : options_.material, problem);
    return problem.empty();
}

std::string BrdfState::whyNot(const Ogre::Pass& pass) const
{
    const Ogre::String& language = shader::ShaderGenerator::getSingleton().getTargetLanguage();
    if (!isGlsl()) return fbrdf::Found("shader language '" + language + "'").expected("glsl");
    const fbrdf::Capabilities has = capabilitiesOfRenderSystem();
    if (!has.floatTextures) return fbrdf::Found("no float textures").expected("those, for lights");
    int units = pass.getNumTextureUnitStates() + 1 + (options_.normalMap.empty() ? 0 : 1);
    for (const TableTexture& table : material_->tables()) units += table.texture ? 1 : 0;
    if (units > has.maxTextureUnits)
        return "texture units: " + fbrdf::Found(std::to_string(has.maxTextureUnits))
                                       .expected("at least " + std::to_string(units));
    try {
        fragmentText();
    } catch (const fbrdf::Error& error) {
        return error.what();
    }
    return "";
}

bool BrdfState::preAddToRenderState(const shader::RenderState*, Ogre::Pass* sourcePass,
                                    Ogre::Pass* pass)
{
    const Ogre::Technique& technique = *pass->getParent();
    const Ogre::String name = materialNameOf(*pass), group = technique.getParent()->getGroup();
    std::string reason = "no material";
    if (!options_.material.empty()) {
        material_ = services_.materials.loaded(options_.material, group);
        material_->addUser({technique.getSchemeName(), name, group});
        reason = material_->problem();
        if (material_->isGood()) reason = options_.diffuse ? "" : whyNot(*pass);
        if (reason.empty() && !options_.diffuse) {
            addTextures(*pass);
            return true;
        }
        if (material_->isGood()) reason = options_.material + ": " + reason;
    }
    const std::string line = "diffuse fallback is drawn: " + reason;
    const bool isWanted = options_.diffuse && material_ && material_->isGood();
    if (!isWanted && services_.warned.insert(name + line).second) warn("'" + name + "'", line);
    drawDiffuse(*pass);
    // Without shaders OGRE draws the pass that this one was made of.
    if (!isGlsl()) drawDiffuse(*sourcePass);
    return false;
}

void BrdfState::drawDiffuse(Ogre::Pass& pass) const
{
    const fbrdf::Vec3f albedo =
        (material_ ? material_->albedo() : fbrdf::Vec3f(0.5f)) * options_.exposure;
    pass.setDiffuse(albedo.x, albedo.y, albedo.z, pass.getDiffuse().a);
    pass.setAmbient(albedo.x, albedo.y, albedo.z);
    pass.setSpecular(0.0f, 0.0f, 0.0f, 0.0f);
}

void BrdfState::addTextures(Ogre::Pass& pass)
{
    units_.tables = pass.getNumTextureUnitStates();
    const Ogre::FilterOptions filter = options_.preciseFiltering ? Ogre::FO_POINT : Ogre::FO_LINEAR;
    for (const TableTexture& table : material_->tables())
        if (table.texture) addTexture(pass, table.texture, filter);
    units_.lights = pass.getNumTextureUnitStates();
    addTexture(pass, services_.lights.texture(), Ogre::FO_POINT);
    units_.normalMap = pass.getNumTextureUnitStates();
    if (!options_.normalMap.empty()) pass.createTextureUnitState(options_.normalMap);
}

std::string BrdfState::fragmentText() const
{
    std::vector<fbrdf::TableEncoding> encodings;
    for (const TableTexture& table : material_->tables()) {
        encodings.push_back(table.encoding);
        encodings.back().precise = options_.preciseFiltering && table.texture;
    }
    return fbrdf::materialFunctions(material_->material().form, encodings,
                                    capabilitiesOfRenderSystem().glsl, fbrdf::HostLights{}) +
           std::string(fbrdf::ogreFbrdfShader("ogre_lights.glsl")) +
           std::string(fbrdf::ogreFbrdfShader("ogre_shade.glsl"));
}

bool BrdfState::needsTangents() const
{
    return !options_.normalMap.empty() || !fbrdf::isIsotropic(material_->material().form);
}

bool BrdfState::createCpuSubPrograms(shader::ProgramSet* programs)
{
    shader::Program& vertex = *programs->getCpuProgram(Ogre::GPT_VERTEX_PROGRAM);
    shader::Program& fragment = *programs->getCpuProgram(Ogre::GPT_FRAGMENT_PROGRAM);
    vertex.addDependency(
        services_.texts.dependencyOf(std::string(fbrdf::ogreFbrdfShader("ogre_surface.glsl"))));
    fragment.addDependency(services_.texts.dependencyOf(fragmentText()));
    if (!options_.normalMap.empty()) fragment.addPreprocessorDefines("FBRDF_NORMAL_MAP=1");
    if (options_.transfer == fbrdf::Transfer::toneMap)
        fragment.addPreprocessorDefines("FBRDF_TONE_MAP=1");
    if (fbrdf::isCurved(options_.transfer)) fragment.addPreprocessorDefines("FBRDF_SRGB=1");
    shader::Function& main = *fragment.getEntryPointFunction();
    addVertexStage(*vertex.getEntryPointFunction(), main, vertex);
    addFragmentStages(main);
    areMaterialConstantsSet_ = false;
    return true;
}

void BrdfState::addVertexStage(shader::Function& vertex, shader::Function& fragment,
                               shader::Program& program)
{
    const auto stage = vertex.getStage(shader::FFP_VS_LIGHTING);
    const auto matrix = program.resolveParameter(Ogre::GpuProgramParameters::ACT_WORLDVIEW_MATRIX);
    const auto eyePosition = vertex.resolveOutputParameter(Parameter::SPC_POSITION_VIEW_SPACE),
               eyeNormal = vertex.resolveOutputParameter(Parameter::SPC_NORMAL_VIEW_SPACE);
    stage.callFunction(
        "fbrdfSurface",
        {In(matrix), In(vertex.resolveInputParameter(Parameter::SPC_POSITION_OBJECT_SPACE)),
         In(vertex.resolveInputParameter(Parameter::SPC_NORMAL_OBJECT_SPACE)), Out(eyePosition),
         Out(eyeNormal)});
    position_ = fragment.resolveInputParameter(eyePosition);
    normal_ = fragment.resolveInputParameter(eyeNormal);
    tangent_ = coordinate_ = nullptr;
    if (!needsTangents()) return;
    const auto tangent = vertex.resolveInputParameter(Parameter::SPC_TANGENT_OBJECT_SPACE,
                                                      Ogre::GCT_FLOAT4),
               eyeTangent = vertex.resolveOutputParameter(Parameter::SPC_TANGENT_VIEW_SPACE,
                                                          Ogre::GCT_FLOAT4);
    stage.callFunction("fbrdfTangentFrame", {In(matrix), In(tangent), Out(eyeTangent)});
    tangent_ = fragment.resolveInputParameter(eyeTangent);
    if (options_.normalMap.empty()) return;
    const auto coordinate = vertex.resolveInputParameter(Parameter::SPC_TEXTURE_COORDINATE0,
                                                         Ogre::GCT_FLOAT2),
               passed = vertex.resolveOutputParameter(Parameter::SPC_TEXTURE_COORDINATE0,
                                                      Ogre::GCT_FLOAT2);
    stage.assign(coordinate, passed);
    coordinate_ = fragment.resolveInputParameter(passed);
}

void BrdfState::addFragmentStages(shader::Function& fragment)
{
    const auto colour = fragment.resolveOutputParameter(Parameter::SPC_COLOR_DIFFUSE);
    auto diffuse = fragment.getInputParameter(Parameter::SPC_COLOR_DIFFUSE);
    if (!diffuse) diffuse = fragment.resolveLocalParameter(Parameter::SPC_COLOR_DIFFUSE);
    const auto shadow = fragment.resolveLocalParameter(Ogre::GCT_FLOAT1, kShadowFactor);
    fragment.getStage(shader::FFP_PS_COLOUR_BEGIN).assign(1.0f, shadow);
    const auto stage = fragment.getStage(kShade);
    const Ogre::Vector4 noTangent(0.0f, 0.0f, 0.0f, 1.0f);
    if (coordinate_)
        stage.callFunction("fbrdfBump", {InOut(normal_), InOut(tangent_), In(coordinate_)});
    stage.callFunction("fbrdfShade",
                       {In(position_), In(normal_), tangent_ ? In(tangent_) : In(noTangent),
                        In(shadow), Out(colour)});
    stage.assign(colour, diffuse);
    fragment.getStage(kFinish).callFunction("fbrdfFinish", InOut(colour));
}

void BrdfState::updateGpuProgramsParams(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                        const Ogre::AutoParamDataSource* source,
                                        const Ogre::LightList* lights)
{
    Ogre::SceneManager* scene = shader::ShaderGenerator::getSingleton().getActiveSceneManager();
    const Ogre::Camera* camera = source->getCurrentCamera();
    if (!scene || !camera || !material_) return;
    if (!material_->isLoaded()) material_->load();
    if (services_.lights.use(*scene, *camera)) bindAgain(*pass);
    const ObjectConstants constants =
        objectConstants(lights ? *lights : renderable->getLights(), services_.lights, *pass,
                        scene->isShadowTechniqueTextureBased());
    if (areMaterialConstantsSet_ && constants == last_) return;
    if (!areMaterialConstantsSet_) {
        setMaterialConstants(*pass, *material_, options_, units_);
        for (const auto type : {Ogre::GPT_VERTEX_PROGRAM, Ogre::GPT_FRAGMENT_PROGRAM})
            services_.kept[pass->getGpuProgram(type)->getName()] = pass->getGpuProgram(type);
    }
    setObjectConstants(*pass, constants);
    // OGRE uploads what it takes for global once a pass, unless it is told otherwise.
    scene->_markGpuParamsDirty(Ogre::GPV_GLOBAL);
    areMaterialConstantsSet_ = true;
    last_ = constants;
}

}  // namespace ogreFbrdf
