#include "PassTechnique.h"

#include "DiffuseTechnique.h"
#include "EffectInternals.h"
#include "FogPass.h"
#include "FrameStates.h"
#include "InheritedState.h"
#include "NestedBin.h"
#include "PassState.h"
#include "Vectors.h"
#include "ViewState.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/plan/LightVectors.h>

#include <osg/GLExtensions>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <cmath>
#include <optional>

namespace osgFbrdf {
namespace {

// Room for all uniforms but lights, attenuations and knots: as many as the planner leaves.
constexpr int kOtherUniformVectors = 24;
constexpr const char* kNoSurfaces = "found no RGBA32F surface that can be drawn to: ";

/// Makes OSG dispatch the arrays of the model anew (GlObjectsInUse::arraysReleased).
class ForgetArrays : public osgUtil::RenderBin::DrawCallback {
public:
    explicit ForgetArrays(EffectInternals& internals) : internals_(&internals) {}
    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& info,
                            osgUtil::RenderLeaf*& previous) override
    {
        osg::State& state = *info.getState();
        state.disableAllVertexArrays();
        // State's own function of this name disables one.
        state.getCurrentVertexArrayState()->disableVertexAttribArrayAboveAndIncluding(state, 0);
        state.unbindVertexBufferObject();
        state.unbindElementBufferObject();
        internals_->objects.arraysForgotten(state.getContextID());
        bin->drawImplementation(info, previous);
    }

private:
    osg::ref_ptr<EffectInternals> internals_;
};

bool isOffscreen(const fbrdf::Pass& pass)
{
    return pass.writes != fbrdf::Surface::target;
}

bool needsSurfaces(const fbrdf::Plan& plan)
{
    return std::any_of(plan.passes.begin(), plan.passes.end(), isOffscreen);
}

/// Passes in runs that write the same surface; cullPass(i) culls one.
template <class CullPass>
void cullRuns(osgUtil::CullVisitor& visitor, const fbrdf::Plan& plan, Surfaces& surfaces,
              CullPass cullPass)
{
    bool cleared = false;
    for (size_t i = 0; i < plan.passes.size();) {
        const fbrdf::Surface writes = plan.passes[i].writes;
        NestedBin run(visitor, static_cast<int>(i) + 1);
        if (isOffscreen(plan.passes[i])) {
            run.setDrawCallback(new SurfaceDraw(surfaces, writes, !cleared));
            cleared = true;
        }
        for (; i < plan.passes.size() && plan.passes[i].writes == writes; ++i) cullPass(i);
    }
}

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

/// How much longer a matrix can make a vector, at most: the square root of the largest row sum of
/// M M^T, exact where rows are at right angles.
double largestScale(const osg::Matrixd& matrix)
{
    const auto row = [&](int i) { return osg::Vec3d(matrix(i, 0), matrix(i, 1), matrix(i, 2)); };
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(row(i) * row(0)) + std::abs(row(i) * row(1)) +
                                        std::abs(row(i) * row(2)));
    return std::sqrt(largest);
}

/// The bounds of the model, in eye coordinates.
fbrdf::Sphere boundsInEye(const FactorizedBrdf& model, const osg::Matrixd& toEye)
{
    const osg::BoundingSphere& bound = model.getBound();
    const osg::Vec3d centre = osg::Vec3d(bound.center()) * toEye;
    const double radius = std::max(0.0, static_cast<double>(bound.radius()));
    return {toVec3(centre), static_cast<float>(largestScale(toEye) * radius)};
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
    const fbrdf::Plan several = states.plan(request(2, true, {}), false);
    const bool reads = std::any_of(several.passes.begin(), several.passes.end(),
                                   [](const fbrdf::Pass& pass) { return pass.reads.has_value(); });
    needs.refusal = several.reason;
    needs.withoutSurfaces = states.plan(request(2, false, {}), false).reason;
    const TextureUnits units = textureUnits();
    needs.textureUnits = units.needed(states.textureUnits() + (reads ? 1 : 0));
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

TextureUnits PassTechnique::textureUnits() const
{
    return TextureUnits(effect_.getFirstTextureUnit(), effect_.getFreeTextureUnits());
}

PassInputs PassTechnique::inputs(bool attenuated) const
{
    PassInputs inputs;
    inputs.units = textureUnits();
    inputs.derivedTangents = effect_.getDerivedTangents();
    inputs.preciseFiltering = effect_.getPreciseFiltering();
    inputs.attenuated = attenuated;
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
    const fbrdf::Sphere bounds = boundsInEye(cull.model, *visitor.getModelViewMatrix());
    const SceneLights& scene = cull.view.lights();
    const osg::Matrixd toEye = worldToEye(visitor);
    EyeLobes lobes = lobesOf(scene, toEye, bounds, effect_, contextOf(visitor));
    EyeLights lights = lightsOf(scene, toEye, bounds, inherited, lobes.isMissing());
    Drawing drawing = drawingOfMost(cull, lights, bounds, lobes);
    std::string reason = reasonAgainst(drawing);
    while (!reason.empty() && !lobes.light().isEmpty()) {
        lobes.leaveOut(reason);
        lights = lightsOf(scene, toEye, bounds, inherited, lobes.isMissing());
        drawing = drawingOfMost(cull, lights, bounds, lobes);
        reason = reasonAgainst(drawing);
    }
    if (!reason.empty()) return cullDiffuse(cull, reason);
    const fbrdf::Plan& plan = drawing.passes->plan;
    const osg::ref_ptr<osg::StateSet> fog = fogOfScene(inherited);
    DrawReport report;
    report.technique = techniqueName();
    report.passes = static_cast<int>(plan.passes.size()) + (fog ? 1 : 0);
    report.lightsUsed = static_cast<int>(lights.lights.size()) + lobes.areaLights;
    report.lightsDropped = scene.dropped + lights.dropped;
    report.lightsCulled = lights.culled + lobes.culled;
    report.whyLightsInvalid = scene.whyInvalid;
    report.maxLookups = plan.maxLookups;
    report.whyNoEnvironment = lobes.whyNot;
    report.environmentsLeftOut = scene.environment.leftOut;
    internals_.log.report(effect_, report);
    cullPasses(cull, drawing, std::move(lights), lobes, fog);
}

int PassTechnique::lightsInOnePass(const EyeLights& lights, const EyeLobes& lobes) const
{
    fbrdf::LobeShare share;
    if (lobes.lobes) {
        share = fbrdf::wholeShare(fbrdf::layoutOf(*lobes.lobes));
        share.environment = lobes.cube.valid();
        share.areaSlots = static_cast<int>(lobes.areas.size());
    }
    return fbrdf::maxLightsInUniforms(effect_.getMaterial()->states()->form(),
                                      assumedCapabilities(!lights.attenuations.empty()), share);
}

std::string PassTechnique::reasonAgainst(const Drawing& drawing) const
{
    const fbrdf::Plan& plan = drawing.passes->plan;
    if (!plan.feasible()) return (drawing.surfacesFailed ? kNoSurfaces : "") + plan.reason;
    const ContextLimits& needed = drawing.passes->needed;
    return needed.textureUnits > 0 ? refusalBy(internals_.choice->limits(), needed) : "";
}

PassTechnique::Drawing PassTechnique::drawingOfMost(const EffectCull& cull, EyeLights& lights,
                                                    const fbrdf::Sphere& bounds,
                                                    const EyeLobes& lobes) const
{
    const Drawing drawing = drawingOf(cull, lights, lobes);
    if (drawing.passes->plan.feasible() || lights.lights.empty() ||
        fbrdf::techniqueInfo(kind_).lightsPerPass != fbrdf::LightsPerPass::all)
        return drawing;
    // Passes cannot add up here, but the strongest lights are better than the fallback's eight.
    lights = strongest(lights, bounds, lightsInOnePass(lights, lobes));
    return drawingOf(cull, lights, lobes);
}

PassTechnique::Drawing PassTechnique::drawingOf(const EffectCull& cull, const EyeLights& lights,
                                                const EyeLobes& lobes) const
{
    MaterialStates& states = *effect_.getMaterial()->states();
    const int count = static_cast<int>(lights.lights.size());
    const PassInputs inputs = this->inputs(!lights.attenuations.empty());
    Drawing drawing;
    const auto passes = [&](bool offscreen) {
        return states.passes(request(count, offscreen, lobes), inputs, lobes.lobes.get());
    };
    drawing.passes = passes(!isMultisampled(cull.visitor));
    if (!needsSurfaces(drawing.passes->plan)) return drawing;
    Surfaces* surfaces = cull.view.surfaces(cull.visitor);
    if (!surfaces || !surfaces->usable()) {
        drawing.passes = passes(false);
        drawing.surfacesFailed = true;
        return drawing;
    }
    drawing.surfaces = surfaces;
    internals_.objects.use(*surfaces);
    return drawing;
}

void PassTechnique::cullPasses(const EffectCull& cull, const Drawing& drawing, EyeLights lights,
                               const EyeLobes& lobes, osg::StateSet* fog)
{
    osgUtil::CullVisitor& visitor = cull.visitor;
    const FrameStates frame(effect_, *visitor.getProjectionMatrix(), std::move(lights), lobes,
                            drawing.surfaces, textureUnits());
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
    if (fog) cullUnder(cull, effect_.getMaterial()->states()->fogStateOf(fogBin), fog);
}

}  // namespace osgFbrdf
