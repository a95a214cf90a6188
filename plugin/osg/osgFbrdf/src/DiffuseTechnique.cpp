#include "DiffuseTechnique.h"

#include "GlLights.h"
#include "InheritedState.h"
#include "PassState.h"
#include "SceneLights.h"
#include "Vectors.h"

#include <osg/LightModel>
#include <osg/Material>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <array>

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
        if (n != scene.viewNumber &&
            std::none_of(scene.plain.begin(), scene.plain.end(),
                         [n](const PlainLight& plain) { return plain.light->getLightNum() == n; }))
            numbers.push_back(n);
    return numbers;
}

/// Lights of PointLights become GL's, once a view and frame: GL has one set for all objects.
void placeLights(osgUtil::CullVisitor& visitor, SceneLights& scene, const osg::Vec3d& centre)
{
    if (scene.fallbackPlaced) return;
    scene.fallbackPlaced = true;
    auto lights = pointLightsInEye(scene, worldToEye(visitor));
    const fbrdf::Vec3f place = toVec3(centre);
    std::stable_sort(lights.begin(), lights.end(), [&](const auto& a, const auto& b) {
        return irradianceAt(a, place) > irradianceAt(b, place);
    });
    const auto numbers = freeNumbers(scene);
    for (size_t i = 0; i < std::min(numbers.size(), lights.size()); ++i)
        visitor.addPositionedAttribute(nullptr, glLight(lights[i], numbers[i]).get());
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
    state->setAttributeAndModes(material, kOurs);
    state->setMode(GL_LIGHTING, kOurs);
    const auto numbers = freeNumbers(scene);
    for (size_t i = 0; i < std::min(numbers.size(), scene.lights.size()); ++i)
        state->setMode(GL_LIGHT0 + static_cast<GLenum>(numbers[i]), kOurs);
    for (const PlainLight& plain : scene.plain)
        if (plain.light->getLightNum() < kMostGlLights && isOn(plain, inherited))
            state->setMode(GL_LIGHT0 + static_cast<GLenum>(plain.light->getLightNum()), kOurs);
    return state;
}

}  // namespace

void cullDiffuse(osgUtil::CullVisitor& visitor, FactorizedBrdf& effect, const std::string& reason)
{
    SceneLights& scene = sceneLights(visitor);
    placeLights(visitor, scene,
                osg::Vec3d(effect.getBound().center()) * *visitor.getModelViewMatrix());
    const int given = static_cast<int>(scene.lights.size());
    const int used = std::min(given, static_cast<int>(freeNumbers(scene).size()));
    const InheritedState inherited(visitor);
    const auto plain =
        std::count_if(scene.plain.begin(), scene.plain.end(),
                      [&](const PlainLight& light) { return isOn(light, inherited); });
    effect.report({"diffuse fallback", reason, 1, used + static_cast<int>(plain),
                   scene.dropped + given - used});
    const auto state = diffuseState(effect, scene, inherited);
    visitor.pushStateSet(state);
    effect.inherited_traverse(visitor);
    visitor.popStateSet();
}

void DiffuseTechnique::traverse(osg::NodeVisitor& visitor, osgFX::Effect* effect)
{
    auto* cull = visitor.asCullVisitor();
    if (!cull) return effect->inherited_traverse(visitor);
    const bool missing = !effect_.getMaterial() || !effect_.getMaterial()->valid();
    const bool forced = effect_.getSelectedTechnique() == kDiffuseFallback;
    cullDiffuse(*cull, effect_, missing ? "no material" : forced ? "" : effect_.refusal());
}

}  // namespace osgFbrdf
