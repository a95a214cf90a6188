#include "FrameStates.h"

#include "MaterialStates.h"
#include "PassState.h"
#include "Vectors.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/plan/LightVectors.h>

#include <string>
#include <utility>

namespace osgFbrdf {
namespace {

osg::Vec4f eyeOf(const osg::Matrixd& projection)
{
    const glm::vec4 eye(fbrdf::eyeFromProjection(toGlm(projection)));
    return {eye.x, eye.y, eye.z, eye.w};
}

osg::ref_ptr<osg::Uniform> lightUniform(const std::vector<fbrdf::Light>& lights,
                                        const fbrdf::Pass& pass)
{
    osg::ref_ptr<osg::Uniform> uniform = new osg::Uniform(
        osg::Uniform::FLOAT_VEC4, "fbrdfLights", fbrdf::kVectorsPerLight * pass.lightCount);
    unsigned int at = 0;
    FBRDF_ASSERT(static_cast<size_t>(pass.firstLight + pass.lightCount), <=, lights.size());
    for (int i = 0; i < pass.lightCount; ++i)
        for (const glm::vec4& v :
             fbrdf::lightVectors(lights[static_cast<size_t>(pass.firstLight + i)], glm::dmat4(1.0)))
            uniform->setElement(at++, osg::Vec4f(v.x, v.y, v.z, v.w));
    return uniform;
}

/// The area lights of the pass, of which there is at least one.
osg::ref_ptr<osg::Uniform> areaUniform(const std::vector<fbrdf::AreaVectors>& areas,
                                       const fbrdf::LobeShare& share)
{
    osg::ref_ptr<osg::Uniform> uniform = new osg::Uniform(
        osg::Uniform::FLOAT_VEC4, "fbrdfAreaLights", fbrdf::kVectorsPerAreaLight * share.areaCount);
    unsigned int at = 0;
    FBRDF_ASSERT(static_cast<size_t>(share.firstArea + share.areaCount), <=, areas.size());
    for (int i = 0; i < share.areaCount; ++i)
        for (const glm::vec4& v : areas[static_cast<size_t>(share.firstArea + i)])
            uniform->setElement(at++, osg::Vec4f(v.x, v.y, v.z, v.w));
    return uniform;
}

osg::ref_ptr<osg::Uniform> attenuationUniform(const std::vector<Attenuation>& attenuations)
{
    osg::ref_ptr<osg::Uniform> uniform =
        new osg::Uniform(osg::Uniform::FLOAT_VEC4, "osgFbrdfAttenuations",
                         static_cast<int>(kVectorsPerAttenuation * attenuations.size()));
    unsigned int at = 0;
    for (const Attenuation& attenuation : attenuations)
        for (const osg::Vec4f& v : attenuation) uniform->setElement(at++, v);
    return uniform;
}

/// The uniform from which the hook knows the attenuation of each light of the pass.
osg::ref_ptr<osg::Uniform> lightNumbers(const std::vector<int>& attenuationOf,
                                        const fbrdf::Pass& pass)
{
    osg::ref_ptr<osg::Uniform> uniform =
        new osg::Uniform(osg::Uniform::INT, "fbrdfLightNumbers", pass.lightCount);
    for (int i = 0; i < pass.lightCount; ++i)
        uniform->setElement(static_cast<unsigned int>(i),
                            attenuationOf[static_cast<size_t>(pass.firstLight + i)]);
    return uniform;
}

}  // namespace

FrameStates::FrameStates(const FactorizedBrdf& effect, const osg::Matrixd& projection,
                         const Illumination& light, Surfaces* surfaces, const TextureUnits& units,
                         ShadowPlacement* shadows)
    : light_(light),
      attenuations_(light.lights.attenuations.empty()
                        ? nullptr
                        : attenuationUniform(light.lights.attenuations)),
      surfaces_(surfaces),
      effect_(effect),
      units_(units),
      eye_(new osg::Uniform("fbrdfEye", eyeOf(projection))),
      shadows_(shadows)
{
    if (light.lobes.cube) {
        toEnvironment_ = new osg::Uniform("fbrdfToEnvironment", light.lobes.fromEye);
        environmentScale_ = new osg::Uniform("fbrdfEnvironmentScale", light.lobes.scale);
    }
    const auto& scales = effect.getMaterial()->material().scales;
    for (size_t t = 0; t < scales.size(); ++t) {
        const fbrdf::Vec3f scale = scales[t] * effect.getExposure();
        const std::string name = "fbrdfScale" + std::to_string(t);
        scales_.push_back(new osg::Uniform(name.c_str(), osg::Vec3f(scale.x, scale.y, scale.z)));
    }
}

osg::ref_ptr<osg::StateSet> FrameStates::stateOf(const fbrdf::Pass& pass) const
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->addUniform(eye_);
    for (const fbrdf::Part& part : pass.parts)
        if (part.scaled) state->addUniform(scales_[static_cast<size_t>(part.term)]);
    if (pass.gain != 1.0)
        state->addUniform(new osg::Uniform("fbrdfGain", static_cast<float>(pass.gain)));
    if (pass.lightCount > 0) addLights(*state, pass);
    if (pass.reads) addSurface(*state, *pass.reads);
    if (!pass.lobes.isEmpty()) addLobes(*state, pass);
    return state;
}

void FrameStates::addLists(osg::StateSet& state, const fbrdf::Pass& pass) const
{
    const LightLists& lists = *light_.lists;
    state.addUniform(new osg::Uniform("fbrdfLightCount", lists.everywhere));
    state.addUniform(new osg::Uniform("fbrdfClusterScale", lists.scale));
    osg::ref_ptr<osg::Uniform> grid = new osg::Uniform(osg::Uniform::INT_VEC3, "fbrdfClusterGrid");
    grid->set(lists.grid.columns, lists.grid.rows, lists.grid.slices);
    state.addUniform(grid);
    const MaterialStates& states = *effect_.getMaterial()->states();
    for (size_t i = 0; i < lists.textures.size(); ++i)
        state.setTextureAttribute(static_cast<unsigned int>(states.listUnit(pass, units_, i)),
                                  lists.textures[i], kOurs);
    if (attenuations_) state.addUniform(attenuations_);
}

void FrameStates::addLights(osg::StateSet& state, const fbrdf::Pass& pass) const
{
    if (light_.lists) return addLists(state, pass);
    state.addUniform(lightUniform(light_.lights.lights, pass));
    state.addUniform(new osg::Uniform("fbrdfLightCount", pass.lightCount));
    if (!attenuations_ && !shadows_) return;
    const auto numbers = lightNumbers(light_.lights.attenuationOf, pass);
    state.addUniform(numbers);
    if (attenuations_) state.addUniform(attenuations_);
    if (!shadows_) return;
    shadows_->place(numbers, pass.firstLight);
    addShadowMaps(state);
}

/// Textures of the model must not take the units of the maps, which are not those of ours.
void FrameStates::addShadowMaps(osg::StateSet& state) const
{
    state.addUniform(shadows_->matrices());
    const ReceivedShadows& shadows = light_.shadows;
    for (size_t k = 0; k < shadows.textures.size(); ++k)
        if (shadows.textures[k])
            state.setTextureAttribute(static_cast<unsigned int>(shadows.maps.units[k]),
                                      shadows.textures[k], kOurs);
}

void FrameStates::addLobes(osg::StateSet& state, const fbrdf::Pass& pass) const
{
    if (pass.lobes.areaSlots > 0)
        state.addUniform(new osg::Uniform("fbrdfAreaLightCount", pass.lobes.areaCount));
    if (pass.lobes.areaCount > 0) state.addUniform(areaUniform(light_.lobes.areas, pass.lobes));
    if (!pass.lobes.environment) return;
    FBRDF_ASSERT(light_.lobes.cube.valid(), ==, true);
    const int unit = effect_.getMaterial()->states()->environmentUnit(pass, units_);
    state.setTextureAttribute(static_cast<unsigned int>(unit), light_.lobes.cube, kOurs);
    state.addUniform(toEnvironment_);
    state.addUniform(environmentScale_);
}

void FrameStates::addSurface(osg::StateSet& state, fbrdf::Surface surface) const
{
    FBRDF_ASSERT(surfaces_.valid(), ==, true);
    const int unit = units_[effect_.getMaterial()->states()->textureUnits()];
    state.setTextureAttribute(static_cast<unsigned int>(unit), surfaces_->texture(surface), kOurs);
    state.addUniform(new osg::Uniform("fbrdfRead", unit));
    state.addUniform(new osg::Uniform("fbrdfReadScale",
                                      osg::Vec2f(1.0f / static_cast<float>(surfaces_->width()),
                                                 1.0f / static_cast<float>(surfaces_->height()))));
}

}  // namespace osgFbrdf
