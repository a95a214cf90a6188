#include "PassTechnique.h"

#include "Accumulation.h"
#include "BoundsInEye.h"
#include "DiffuseTechnique.h"
#include "EffectInternals.h"
#include "FogPass.h"
#include "ForgetArrays.h"
#include "FrameStates.h"
#include "InheritedState.h"
#include "NestedBin.h"
#include "PassState.h"
#include "SurfaceRuns.h"
#include "Vectors.h"
#include "ViewState.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Found.h>
#include <fbrdf/plan/LightVectors.h>

#include <osg/GLExtensions>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <optional>
#include <set>

namespace osgFbrdf {
namespace {

// Room for all uniforms but lights, attenuations and knots: as many as the planner leaves.
constexpr int kOtherUniformVectors = 24;
constexpr const char* kNoSurfaces = "found no RGBA32F surface that can be drawn to: ";

int uniformVectorsNeeded(const FactorizedBrdf& effect, fbrdf::Technique kind)
{
    const fbrdf::LightsPerPass perPass = fbrdf::techniqueInfo(kind).lightsPerPass;
    if (perPass == fbrdf::LightsPerPass::all) return assumedCapabilities().maxUniformVectors;
    const int lights = perPass == fbrdf::LightsPerPass::asRequested ? effect.getLightsPerPass() : 1;
    const fbrdf::Form& form = effect.getMaterial()->material().form;
    int vectors = kOtherUniformVectors + kVectorsPerAttenuation * kMostAttenuations +
                  (fbrdf::kVectorsPerLight + 1) * lights + 2 * static_cast<int>(form.tables.size());
    for (const fbrdf::TableSpec& table : form.tables)
        if (table.uniform) vectors += fbrdf::texelCount(table.domain);
    return std::min(vectors, assumedCapabilities().maxUniformVectors);
}

/// Leaves out what may be why nothing can be drawn; false where nothing is left to leave out.
bool leavesOut(const EffectCull& cull, const InheritedState& inherited, Illumination& light,
               const std::string& reason)
{
    if (light.lists)
        light.lists = nullptr;
    else if (!light.lobes.light().isEmpty())
        light.lobes.leaveOut(reason);
    else if (!light.shadows.maps.empty())
        light.shadows = withoutShadows(reason);
    else
        return false;
    light.lights = lightsOf(cull.view.lights(), worldToEye(cull.visitor), light.bounds, inherited,
                            light.lobes.isMissing());
    return true;
}

/// What is drawn by the plan; without the name of the technique.
DrawReport reportOf(const EffectCull& cull, const fbrdf::Plan& plan, const Illumination& light)
{
    const SceneLights& scene = cull.view.lights();
    DrawReport report;
    report.passes = static_cast<int>(plan.passes.size());
    const bool listed = light.lists.valid();
    const int lights = listed ? light.lists->lights : static_cast<int>(light.lights.lights.size());
    report.lightsUsed = lights + light.lobes.areaLights;
    report.lightsDropped = scene.dropped + light.lights.dropped;
    report.lightsCulled = (listed ? light.lists->culled : light.lights.culled) + light.lobes.culled;
    report.longestLightList = listed ? light.lists->longest : 0;
    report.whyLightsInvalid = scene.whyInvalid;
    report.maxLookups = plan.maxLookups;
    report.accumulation = fbrdf::colourFormatName(plan.accumulation);
    report.whyNoEnvironment = light.lobes.whyNot;
    report.environmentsLeftOut = scene.environment.leftOut;
    report.shadowMaps = static_cast<int>(light.hooks().shadows.units.size());
    report.whyNoShadows = light.shadows.whyNot;
    const int stray = cull.internals.strayShadowMap;
    if (report.shadowMaps > 0 && stray >= 0)
        report.whyNoShadows = fbrdf::Found("no light where the shadow map of texture unit " +
                                           std::to_string(stray) + " is drawn from")
                                  .expected("one of the scene");
    return report;
}

/// Null where no shadows fall on lights of the effect.
osg::ref_ptr<ShadowPlacement> placementOf(const EffectCull& cull, const Illumination& light)
{
    const ShadowMaps maps = light.hooks().shadows;
    if (maps.empty()) return nullptr;
    const osg::ref_ptr<ShadowPlacement> placement =
        new ShadowPlacement(maps, light.lights.lights, toOsg(light.bounds.centre),
                            *cull.visitor.getCurrentRenderBin()->getStage(), cull.internals);
    cull.visitor.addPositionedAttribute(nullptr, placement);
    return placement;
}

unsigned int contextOf(osgUtil::CullVisitor& visitor)
{
    return visitor.getState() ? visitor.getState()->getContextID() : 0;
}

}  // namespace

PassTechnique::PassTechnique(FactorizedBrdf& effect, EffectInternals& internals,
                             fbrdf::Technique kind)
    : effect_(effect), internals_(internals), kind_(kind)
{
}

const char* PassTechnique::techniqueName()
{
    return fbrdf::techniqueInfo(kind_).title;
}

const char* PassTechnique::techniqueDescription()
{
    return fbrdf::techniqueInfo(kind_).description;
}

bool PassTechnique::validate(osg::State& state) const
{
    return refusalBy(state, needs()).empty();
}

bool PassTechnique::mayDraw(osg::State& state) const
{
    const auto* extensions = state.get<osg::GLExtensions>();
    if (extensions && !extensions->isGlslSupported) {
        internals_.choice->refuse(noGlsl());
        return false;
    }
    // OSG reports 1 before its first query: the minimum that every context has decides until the
    // next frame, which has a reason.
    const int known = static_cast<int>(state.getMaxTextureUnits());
    const int limit = known > 1 ? known : assumedCapabilities().maxTextureUnits;
    const TextureUnits units = textureUnits();
    const int needed = units.needed(effect_.getMaterial()->states()->textureUnits());
    if (needed <= limit) return true;
    internals_.choice->refuse(known > 1 ? tooFew(units.description(), needed, limit) : "");
    return false;
}

ContextNeeds PassTechnique::needs() const
{
    ContextNeeds needs;
    if (!effect_.getMaterial() || !effect_.getMaterial()->valid()) {
        needs.refusal = kNoMaterial;
        return needs;
    }
    // Two lights are the fewest whose passes add up.
    const MaterialStates& states = *effect_.getMaterial()->states();
    const fbrdf::Plan several = states.plan(request(2, true, {}), {});
    const bool reads = std::any_of(several.passes.begin(), several.passes.end(),
                                   [](const fbrdf::Pass& pass) { return pass.reads.has_value(); });
    needs.refusal = several.reason;
    needs.withoutSurfaces = states.plan(request(2, false, {}), {}).reason;
    const TextureUnits units = textureUnits();
    needs.textureUnits = units.needed(states.textureUnits() + (reads ? 1 : 0));
    for (const int unit : effect_.getModelTextures().units())
        needs.textureUnits = std::max(needs.textureUnits, unit + 1);
    needs.unitsDescription = units.description();
    needs.uniformComponents = 4 * uniformVectorsNeeded(effect_, kind_);
    return needs;
}

fbrdf::PlanRequest PassTechnique::request(int lights, bool offscreen, const EyeLobes& lobes) const
{
    fbrdf::PlanRequest request;
    request.technique = kind_;
    request.lights = lights;
    request.lightsPerPass = effect_.getLightsPerPass();
    request.maxLookups = effect_.getLookupsPerPass();
    request.target =
        effect_.getFloatTarget() ? fbrdf::ColourFormat::rgba32f : fbrdf::ColourFormat::rgba8;
    request.offscreen = offscreen;
    request.transfer = effect_.getTransfer();
    request.signs = effect_.getMaterial()->states()->hasSigns();
    if (lobes.lobes) request.lobes = fbrdf::layoutOf(*lobes.lobes);
    request.lobeLight = lobes.light();
    return request;
}

TextureUnits PassTechnique::textureUnits(const ReceivedShadows& shadows) const
{
    std::set<int> kept = shadows.unitsTaken;
    kept.insert(effect_.getFreeTextureUnits().begin(), effect_.getFreeTextureUnits().end());
    kept.merge(effect_.getModelTextures().units());
    return TextureUnits(effect_.getFirstTextureUnit(), std::move(kept));
}

PassInputs PassTechnique::inputs(const Illumination& light) const
{
    PassInputs inputs;
    inputs.units = textureUnits(light.shadows);
    inputs.derivedTangents = effect_.getDerivedTangents();
    inputs.preciseFiltering = effect_.getPreciseFiltering();
    inputs.hooks = light.hooks();
    inputs.listed = light.lists.valid();
    inputs.textures = effect_.getModelTextures();
    inputs.vertexHook = effect_.getVertexHook();
    return inputs;
}

void PassTechnique::cull(const EffectCull& cull)
{
    osgUtil::CullVisitor& visitor = cull.visitor;
    if (!effect_.getMaterial() || !effect_.getMaterial()->valid())
        return cullDiffuse(cull, kNoMaterial);
    if (visitor.getState() && !mayDraw(*visitor.getState()))
        return cullDiffuse(cull, internals_.choice->refusal());
    const InheritedState inherited(visitor);
    Illumination light = illuminationOf(cull, inherited);
    Drawing drawing = drawingOfMost(cull, light);
    std::string reason = reasonAgainst(drawing);
    while (!reason.empty() && leavesOut(cull, inherited, light, reason)) {
        drawing = drawingOfMost(cull, light);
        reason = reasonAgainst(drawing);
    }
    if (!reason.empty()) return cullDiffuse(cull, reason);
    const osg::ref_ptr<osg::StateSet> fog = fogOfScene(inherited);
    DrawReport report = reportOf(cull, drawing.passes->plan, light);
    report.technique = techniqueName();
    report.passes += fog ? 1 : 0;
    std::shared_ptr<const PlannedPasses> blended;
    Illumination blendedLight = light;
    if (cull.cullBlended) blended = blendedPass(blendedLight, report.whyOpaque);
    internals_.log.report(effect_, report);
    if (blended) cullBlended(cull, *blended, blendedLight);
    cullPasses(cull, drawing, light, fog);
}

Illumination PassTechnique::illuminationOf(const EffectCull& cull,
                                           const InheritedState& inherited) const
{
    const SceneLights& scene = cull.view.lights();
    const osg::Matrixd toEye = worldToEye(cull.visitor);
    Illumination light;
    light.bounds = boundsInEye(cull.model, *cull.visitor.getModelViewMatrix());
    light.lobes = lobesOf(scene, toEye, light.bounds, effect_, contextOf(cull.visitor));
    light.shadows = shadowsOf(cull, inherited);
    light.lists = listsOf(cull, inherited, light.shadows);
    if (light.lists)
        light.lights.attenuations = light.lists->attenuations;
    else
        light.lights = lightsOf(scene, toEye, light.bounds, inherited, light.lobes.isMissing());
    return light;
}

osg::ref_ptr<const LightLists> PassTechnique::listsOf(const EffectCull& cull,
                                                      const InheritedState& inherited,
                                                      const ReceivedShadows& shadows) const
{
    // Lists are for all objects of the view, and have no numbers of shadow maps.
    const auto& sources = cull.view.lights().sources;
    const bool areOn =
        std::all_of(sources.begin(), sources.end(),
                    [&](const PlacedOsgLight& source) { return isOn(source, inherited); });
    // Contexts answer when they first draw; until then it is known what they have at least.
    const osg::State* state = cull.visitor.getState();
    int texels = internals_.choice->limits().bufferTexels;
    if (state && !internals_.choice->asked(state->getContextID()))
        texels = readsBuffers(*state) ? kFewestBufferTexels : 0;
    if (kind_ != fbrdf::Technique::single || effect_.getLookupsPerPass() > 0 ||
        !shadows.maps.empty() || !areOn || texels == 0)
        return nullptr;
    const LightLists* lists = cull.view.lightLists(cull.visitor, worldToEye(cull.visitor));
    return lists && lists->texels <= static_cast<size_t>(texels) ? lists : nullptr;
}

ReceivedShadows PassTechnique::shadowsOf(const EffectCull& cull,
                                         const InheritedState& inherited) const
{
    ReceivedShadows shadows = shadowsOver(cull.visitor, inherited, cull.view.lights());
    if (shadows.maps.empty()) return shadows;
    const osg::State* state = cull.visitor.getState();
    const auto* extensions = state ? state->get<osg::GLExtensions>() : nullptr;
    if (extensions && !extensions->isShadowSupported && shadows.maps.filter != ShadowFilter::colour)
        return withoutShadows(
            fbrdf::Found("no textures that compare depths").expected("a compatibility profile"));
    // A pass that reads a surface has a texture beside the maps.
    const TextureUnits units = textureUnits(shadows);
    const int needed = std::max(units.needed(effect_.getMaterial()->states()->textureUnits() + 1),
                                *shadows.unitsTaken.rbegin() + 1),
              limit = internals_.choice->limits().textureUnits;
    return needed <= limit ? shadows : withoutShadows(tooFew(units.description(), needed, limit));
}

int PassTechnique::lightsInOnePass(const Illumination& light) const
{
    const EyeLobes& lobes = light.lobes;
    fbrdf::LobeShare share;
    if (lobes.lobes) {
        share = fbrdf::wholeShare(fbrdf::layoutOf(*lobes.lobes));
        share.environment = lobes.cube.valid();
        share.areaSlots = static_cast<int>(lobes.areas.size());
    }
    return fbrdf::maxLightsInUniforms(effect_.getMaterial()->states()->form(),
                                      assumedCapabilities(light.hooks()), share);
}

std::string PassTechnique::reasonAgainst(const Drawing& drawing) const
{
    const fbrdf::Plan& plan = drawing.passes->plan;
    if (!plan.feasible()) return (drawing.surfacesFailed ? kNoSurfaces : "") + plan.reason;
    const ContextLimits& needed = drawing.passes->needed;
    return needed.textureUnits > 0 ? refusalBy(internals_.choice->limits(), needed) : "";
}

PassTechnique::Drawing PassTechnique::drawingOfMost(const EffectCull& cull,
                                                    Illumination& light) const
{
    const Drawing drawing = drawingOf(cull, light);
    if (drawing.passes->plan.feasible() || light.lights.lights.empty() ||
        fbrdf::techniqueInfo(kind_).lightsPerPass != fbrdf::LightsPerPass::all)
        return drawing;
    // Passes cannot add up here, but the strongest lights are better than the fallback's eight.
    light.lights = strongest(light.lights, light.bounds, lightsInOnePass(light));
    return drawingOf(cull, light);
}

PassTechnique::Drawing PassTechnique::drawingOf(const EffectCull& cull,
                                                const Illumination& light) const
{
    MaterialStates& states = *effect_.getMaterial()->states();
    PassInputs inputs = this->inputs(light);
    const auto passes = [&](bool offscreen) {
        fbrdf::PlanRequest wanted = request(light.planned(), offscreen, light.lobes);
        if (inputs.surfaces == fbrdf::ColourFormat::rgba8) wanted.peaks = peaksOf(effect_, light);
        return states.passes(wanted, inputs, light.lobes.lobes.get());
    };
    const ContextLimits limits = internals_.choice->limits();
    SurfaceFormats drawable = limits.surfaces;
    const bool multisampled = isMultisampled(cull.visitor);
    // A mean of few samples out of many would lose most of its codes.
    if (multisampled) drawable.rgba8 = false;
    Drawing drawing;
    drawing.passes = passes(!multisampled || limits.resolvesSamples);
    if (!needsSurfaces(drawing.passes->plan)) return drawing;
    for (const fbrdf::ColourFormat format : formatsFrom(effect_.getAccumulation())) {
        if (!drawable.has(format)) continue;
        inputs.surfaces = format;
        const auto planned = passes(true);
        if (!needsSurfaces(planned->plan) || planned->plan.surfaces != format) continue;
        Surfaces* surfaces = cull.view.surfaces(cull.visitor, format);
        // Where a context promised a format and refuses its size, no other is tried.
        if (!surfaces || !surfaces->usable()) break;
        internals_.objects.use(*surfaces);
        return {planned, surfaces, false};
    }
    inputs.surfaces = fbrdf::ColourFormat::rgba32f;
    drawing.passes = passes(false);
    drawing.surfacesFailed = true;
    return drawing;
}

std::shared_ptr<const PlannedPasses> PassTechnique::blendedPass(Illumination& light,
                                                                std::string& whyNot) const
{
    const auto planned = [&] {
        fbrdf::PlanRequest one = request(light.planned(), false, light.lobes);
        one.technique = fbrdf::Technique::single;
        one.maxLookups = 0;
        one.target = fbrdf::ColourFormat::rgba8;  // in which passes do not add up
        PassInputs inputs = this->inputs(light);
        inputs.blended = true;
        return effect_.getMaterial()->states()->passes(one, inputs, light.lobes.lobes.get());
    };
    auto pass = planned();
    if (!pass->plan.feasible() && !light.lights.lights.empty()) {
        light.lights = strongest(light.lights, light.bounds, lightsInOnePass(light));
        pass = planned();
    }
    if (pass->plan.feasible() && pass->plan.passes.size() == 1) return pass;
    whyNot = pass->plan.feasible() ? "found several passes, expected one" : pass->plan.reason;
    return nullptr;
}

void PassTechnique::cullBlended(const EffectCull& cull, const PlannedPasses& pass,
                                const Illumination& light)
{
    const osg::ref_ptr<ShadowPlacement> shadows = placementOf(cull, light);
    const FrameStates frame(effect_, *cull.visitor.getProjectionMatrix(), light, nullptr,
                            textureUnits(light.shadows), shadows);
    const auto varying = frame.stateOf(pass.plan.passes.front());
    cull.visitor.pushStateSet(pass.states.front());
    cull.visitor.pushStateSet(varying);
    cull.cullBlended();
    cull.visitor.popStateSet();
    cull.visitor.popStateSet();
}

void PassTechnique::cullPasses(const EffectCull& cull, const Drawing& drawing,
                               const Illumination& light, osg::StateSet* fog)
{
    osgUtil::CullVisitor& visitor = cull.visitor;
    const osg::ref_ptr<ShadowPlacement> shadows = placementOf(cull, light);
    const FrameStates frame(effect_, *visitor.getProjectionMatrix(), light, drawing.surfaces,
                            textureUnits(light.shadows), shadows);
    const auto& passes = drawing.passes->plan.passes;
    const auto cullPass = [&](size_t i) {
        cullUnder(cull, drawing.passes->states[i], frame.stateOf(passes[i]));
    };

    NestedBin effectBin(visitor, kEffectBin);
    if (visitor.getState() && internals_.objects.arraysReleased(visitor.getState()->getContextID()))
        effectBin.setDrawCallback(new ForgetArrays(internals_));
    std::optional<NestedBin> own;
    if (drawing.surfaces) own.emplace(visitor, cull.view.nextSurfaceBin());
    if (drawing.surfaces)
        cullRuns(visitor, drawing.passes->plan, *drawing.surfaces, cullPass);
    else
        for (size_t i = 0; i < passes.size(); ++i) cullPass(i);
    const int fogBin = static_cast<int>(passes.size()) + 1;
    if (fog)
        cullUnder(cull, effect_.getMaterial()->states()->fogStateOf(fogBin, inputs(light)), fog);
}

}  // namespace osgFbrdf
