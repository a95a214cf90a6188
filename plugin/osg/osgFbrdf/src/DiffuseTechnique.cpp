#include "DiffuseTechnique.h"

#include "EffectInternals.h"
#include "EyeLights.h"
#include "GlLights.h"
#include "InheritedState.h"
#include "PassState.h"
#include "Vectors.h"
#include "ViewState.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <osg/LightModel>
#include <osg/Material>
#include <osgUtil/CullVisitor>

#include <algorithm>

namespace osgFbrdf {
namespace {

float irradianceAt(const fbrdf::Light& light, const fbrdf::Vec3f& place)
{
    const fbrdf::Vec3f d = light.position - place;
    const float size = luminance(light.intensity);
    return light.type == fbrdf::Light::Type::directional
               ? size
               : size * fbrdf::falloff(glm::dot(d, d), light.radius);
}

/// Numbers that the osg::LightSources of the scene and the light of the view leave free.
std::vector<int> freeNumbers(const SceneLights& scene)
{
    std::vector<int> numbers;
    for (int n = 0; n < kMostGlLights; ++n)
        if (n != scene.viewNumber && std::none_of(scene.sources.begin(), scene.sources.end(),
                                                  [n](const PlacedOsgLight& source) {
                                                      return source.light->getLightNum() == n;
                                                  }))
            numbers.push_back(n);
    return numbers;
}

/// Those that become OpenGL's as far as there are numbers.
size_t placeableLights(const SceneLights& scene)
{
    return scene.lights.size() + scene.areaLights.size();
}

/// Lights of PointLights and AreaLights become OpenGL's, the strongest at `centre` first: once a
/// frame, as OpenGL has one set for all objects.
void placeLights(const EffectCull& cull, const osg::Vec3d& centre)
{
    if (!cull.view.claimsGlLights()) return;
    const SceneLights& scene = cull.view.lights();
    const osg::Matrixd toEye = worldToEye(cull.visitor);
    auto lights = pointLightsInEye(scene, toEye);
    for (const fbrdf::AreaLight& light : scene.areaLights)
        lights.push_back(pointLightOf(moved(light, toEye)));
    const fbrdf::Vec3f place = toVec3(centre);
    std::stable_sort(lights.begin(), lights.end(), [&](const auto& a, const auto& b) {
        return irradianceAt(a, place) > irradianceAt(b, place);
    });
    const auto numbers = freeNumbers(scene);
    for (size_t i = 0; i < std::min(numbers.size(), lights.size()); ++i)
        cull.visitor.addPositionedAttribute(nullptr, glLight(lights[i], numbers[i]).get());
}

osg::ref_ptr<osg::StateSet> diffuseState(const FactorizedBrdf& effect, const SceneLights& scene,
                                         const InheritedState& inherited)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    osg::Vec3f albedo(0.5f, 0.5f, 0.5f);
    if (effect.getMaterial()) albedo = effect.getMaterial()->albedo();
    albedo *= effect.getExposure();
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setColorMode(osg::Material::OFF);
    material->setAmbient(osg::Material::FRONT_AND_BACK, {0.0f, 0.0f, 0.0f, 1.0f});
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4f(albedo, 1.0f));
    if (scene.environment.cube) {
        material->setAmbient(osg::Material::FRONT_AND_BACK, osg::Vec4f(albedo, 1.0f));
        osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
        model->setAmbientIntensity(osg::Vec4f(meanOf(scene.environment), 1.0f));
        state->setAttribute(model, kOurs);
    }
    state->setAttributeAndModes(material, kOurs);
    state->setMode(GL_LIGHTING, kOurs);
    const auto numbers = freeNumbers(scene);
    for (size_t i = 0; i < std::min(numbers.size(), placeableLights(scene)); ++i)
        state->setMode(GL_LIGHT0 + static_cast<GLenum>(numbers[i]), kOurs);
    for (const PlacedOsgLight& source : scene.sources)
        if (source.light->getLightNum() < kMostGlLights && isOn(source, inherited))
            state->setMode(GL_LIGHT0 + static_cast<GLenum>(source.light->getLightNum()), kOurs);
    return state;
}

}  // namespace

void cullDiffuse(const EffectCull& cull, const std::string& reason)
{
    osgUtil::CullVisitor& visitor = cull.visitor;
    FactorizedBrdf& effect = cull.effect;
    const SceneLights& scene = cull.view.lights();
    placeLights(cull, osg::Vec3d(effect.getBound().center()) * *visitor.getModelViewMatrix());
    const int given = static_cast<int>(placeableLights(scene));
    const int used = std::min(given, static_cast<int>(freeNumbers(scene).size()));
    const InheritedState inherited(visitor);
    const auto sources =
        std::count_if(scene.sources.begin(), scene.sources.end(),
                      [&](const PlacedOsgLight& source) { return isOn(source, inherited); });
    cull.internals.log.report(
        effect,
        {"diffuse fallback", reason, 1, used + static_cast<int>(sources),
         scene.dropped + given - used, 0, 0, "", scene.environment.leftOut, scene.whyInvalid});
    const auto state = diffuseState(effect, scene, inherited);
    visitor.pushStateSet(state);
    effect.inherited_traverse(visitor);
    visitor.popStateSet();
}

void DiffuseTechnique::traverse(osg::NodeVisitor& visitor, osgFX::Effect* effect)
{
    auto* culling = visitor.asCullVisitor();
    if (!culling) return effect->inherited_traverse(visitor);
    const bool missing = !effect_.getMaterial() || !effect_.getMaterial()->valid();
    const bool forced = effect_.getSelectedTechnique() == kDiffuseFallback;
    const EffectCull cull{*culling, ViewState::of(*culling), effect_, internals_};
    cullDiffuse(cull, missing ? "no material" : forced ? "" : internals_.choice->refusal());
}

}  // namespace osgFbrdf
