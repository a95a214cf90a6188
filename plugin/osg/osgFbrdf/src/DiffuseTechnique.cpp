#include "DiffuseTechnique.h"

#include "EffectInternals.h"
#include "EyeLights.h"
#include "FogPass.h"
#include "GlLights.h"
#include "InheritedState.h"
#include "NestedBin.h"
#include "PassState.h"
#include "Vectors.h"
#include "VersionedProgram.h"
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

/// Lights of PointLights and AreaLights as OpenGL's in eye space, those that are the strongest at
/// `centre`, as many as there are free numbers.
std::vector<osg::ref_ptr<osg::Light>> strongestLights(const SceneLights& scene,
                                                      const osg::Matrixd& toEye,
                                                      const osg::Vec3d& centre)
{
    auto lights = pointLightsInEye(scene, toEye);
    for (const fbrdf::AreaLight& light : scene.areaLights)
        lights.push_back(pointLightOf(moved(light, toEye)));
    const fbrdf::Vec3f place = toVec3(centre);
    std::stable_sort(lights.begin(), lights.end(), [&](const auto& a, const auto& b) {
        return irradianceAt(a, place) > irradianceAt(b, place);
    });
    const auto numbers = freeNumbers(scene);
    std::vector<osg::ref_ptr<osg::Light>> found;
    for (size_t i = 0; i < std::min(numbers.size(), lights.size()); ++i)
        found.push_back(glLight(lights[i], numbers[i]));
    return found;
}

/// The sources that are on and have one of OpenGL's numbers.
std::vector<PlacedOsgLight> sourcesThatShine(const SceneLights& scene,
                                             const InheritedState& inherited)
{
    std::vector<PlacedOsgLight> shining;
    for (const PlacedOsgLight& source : scene.sources)
        if (source.light->getLightNum() < kMostGlLights && isOn(source, inherited))
            shining.push_back(source);
    return shining;
}

DiffuseSurface surfaceOf(const FactorizedBrdf& effect, const SceneLights& scene)
{
    DiffuseSurface surface{{0.5f, 0.5f, 0.5f}, {}, {}};
    if (effect.getMaterial()) surface.albedo = effect.getMaterial()->albedo();
    surface.albedo *= effect.getExposure();
    if (!scene.environment.cube) return surface;
    surface.ambient = surface.albedo;
    surface.surrounding = meanOf(scene.environment);
    return surface;
}

osg::ref_ptr<osg::StateSet> fixedState(const DiffuseSurface& surface, const SceneLights& scene,
                                       const InheritedState& inherited)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setColorMode(osg::Material::OFF);
    material->setAmbient(osg::Material::FRONT_AND_BACK, osg::Vec4f(surface.ambient, 1.0f));
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4f(surface.albedo, 1.0f));
    if (scene.environment.cube) {
        osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
        model->setAmbientIntensity(osg::Vec4f(surface.surrounding, 1.0f));
        state->setAttribute(model, kOurs);
    }
    state->setAttributeAndModes(material, kOurs);
    state->setMode(GL_LIGHTING, kOurs);
    const auto numbers = freeNumbers(scene);
    for (size_t i = 0; i < std::min(numbers.size(), placeableLights(scene)); ++i)
        state->setMode(GL_LIGHT0 + static_cast<GLenum>(numbers[i]), kOurs);
    for (const PlacedOsgLight& source : sourcesThatShine(scene, inherited))
        state->setMode(GL_LIGHT0 + static_cast<GLenum>(source.light->getLightNum()), kOurs);
    return state;
}

/// By fixed function. Lights are OpenGL's: once a frame, as there is one set for all objects.
void cullFixed(const EffectCull& cull, const InheritedState& inherited, const osg::Vec3d& centre)
{
    const SceneLights& scene = cull.view.lights();
    if (cull.view.claimsGlLights())
        for (const auto& light : strongestLights(scene, worldToEye(cull.visitor), centre))
            cull.visitor.addPositionedAttribute(nullptr, light.get());
    const auto state = fixedState(surfaceOf(cull.effect, scene), scene, inherited);
    cull.visitor.pushStateSet(state);
    cull.cullModel();
    cull.visitor.popStateSet();
}

/// By a program.
void cullShaded(const EffectCull& cull, const InheritedState& inherited, const osg::Vec3d& centre)
{
    const SceneLights& scene = cull.view.lights();
    const osg::Matrixd toEye = worldToEye(cull.visitor);
    auto lights = sourcesThatShine(scene, inherited);
    for (const auto& light : strongestLights(scene, toEye, centre))
        lights.push_back({light, osg::Matrixd(), true});
    const auto frame = DiffuseShader::frameState(surfaceOf(cull.effect, scene), lights, toEye);
    const osg::ref_ptr<osg::StateSet> fog = fogOfScene(inherited);
    const DiffuseShader& shader = *cull.internals.diffuse;
    const NestedBin effectBin(cull.visitor, kEffectBin);
    cullUnder(cull, shader.state(), frame);
    if (fog) cullUnder(cull, shader.fogState(), fog);
}

}  // namespace

void cullDiffuse(const EffectCull& cull, const std::string& reason)
{
    osgUtil::CullVisitor& visitor = cull.visitor;
    const FactorizedBrdf& effect = cull.effect;
    const osg::State* context = visitor.getState();
    DrawReport report{"diffuse fallback", reason};
    if (context) report.reason = cull.internals.choice->whyNothing(context->getContextID());
    if (!report.reason.empty()) {
        report.technique = "nothing";
        return cull.internals.log.report(effect, report);
    }
    const SceneLights& scene = cull.view.lights();
    const InheritedState inherited(visitor);
    const int given = static_cast<int>(placeableLights(scene));
    const int used = std::min(given, static_cast<int>(freeNumbers(scene).size()));
    const auto sources =
        std::count_if(scene.sources.begin(), scene.sources.end(),
                      [&](const PlacedOsgLight& source) { return isOn(source, inherited); });
    report.reason = reason;
    report.passes = 1;
    report.lightsUsed = used + static_cast<int>(sources);
    report.lightsDropped = scene.dropped + given - used;
    report.environmentsLeftOut = scene.environment.leftOut;
    report.whyLightsInvalid = scene.whyInvalid;
    cull.internals.log.report(effect, report);
    const osg::Vec3d centre =
        osg::Vec3d(cull.model.getBound().center()) * *visitor.getModelViewMatrix();
    if (context && hasOsgInputs(*context))
        cullShaded(cull, inherited, centre);
    else
        cullFixed(cull, inherited, centre);
}

void DiffuseTechnique::cull(const EffectCull& cull)
{
    const bool missing = !cull.effect.getMaterial() || !cull.effect.getMaterial()->valid();
    const bool forced = cull.selected == kDiffuseFallback;
    cullDiffuse(cull, missing ? kNoMaterial : forced ? "" : cull.internals.choice->refusal());
}

}  // namespace osgFbrdf
