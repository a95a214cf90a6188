// A plan consists of the passes that add up the form (Planner.h) and of what follows the sum: a
// curve, or the scaling back of a sum that had to be scaled down.
#include "CurvedPlan.h"
#include "PassList.h"
#include "Planner.h"
#include "ScaledPlan.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/plan/LightVectors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// vec4 uniforms of a program beside lights, knots and ranges: the eye, one scale for each term, the
// gain and the like. 24 leaves room for sums of more than a dozen terms.
constexpr int kReservedUniformVectors = 24;

Limits limitsOf(const Form& form, const PlanRequest& request, const Capabilities& capabilities)
{
    Limits limits;
    limits.offscreen = request.offscreen && capabilities.framebufferObjects &&
                       (capabilities.floatTargets || capabilities.halfTargets);
    limits.lights = maxLightsInUniforms(form, capabilities);
    limits.vectors = freeUniformVectors(form, capabilities);
    const TechniqueInfo& technique = techniqueInfo(request.technique);
    if (technique.lightsPerPass == LightsPerPass::asRequested)
        limits.areaLights = request.lightsPerPass;
    if (technique.lightsPerPass == LightsPerPass::one) limits.areaLights = 1;
    limits.lights = std::min(limits.lights, limits.areaLights);
    for (const int lookups : {request.maxLookups, technique.maxLookups})
        if (lookups > 0) limits.lookups = std::min(limits.lookups, lookups);
    return limits;
}

bool isUnorm(ColourFormat format)
{
    return format != ColourFormat::rgba32f && format != ColourFormat::rgba16f;
}

/// The format of surfaces that can be drawn to without scaling.
ColourFormat floatFormat(const Capabilities& capabilities)
{
    return capabilities.floatTargets || !capabilities.halfTargets ? ColourFormat::rgba32f
                                                                  : ColourFormat::rgba16f;
}

Plan finished(std::vector<Pass> passes, const PlanRequest& request, ColourFormat surfaces)
{
    Plan plan;
    plan.passes = std::move(passes);
    plan.surfaces = surfaces;
    plan.accumulation = request.target;
    for (const Pass& pass : plan.passes) {
        plan.maxLookups = std::max(plan.maxLookups, pass.lookups);
        if (pass.writes == Surface::accumulation) plan.accumulation = surfaces;
    }
    return plan;
}

/// The plan for a transfer that is no curve; the lights include the exposure.
Plan planStraight(const Form& form, const PlanRequest& request, const Capabilities& capabilities)
{
    const ColourFormat surfaces = floatFormat(capabilities);
    if (request.lights == 0 && request.lobeLight.isEmpty()) {
        PassList black(form);
        black.append({});
        return finished(black.passes(), request, surfaces);
    }
    ListedPasses listed = listPasses(form, request, limitsOf(form, request, capabilities));
    if (listed.reason.empty()) return finished(std::move(listed.passes), request, surfaces);
    Plan none;
    none.reason = std::move(listed.reason);
    return none;
}

/// Why the lobes of a request cannot be drawn in such a context; "" where they can.
std::string whyNoLobes(const PlanRequest& request, const Capabilities& capabilities)
{
    if (request.lobeLight.areaLights > 0 && capabilities.glsl == 100)
        return Found("area lights in GLSL ES 1.00").expected("uniforms with an index that varies");
    if (!request.lobeLight.environment || capabilities.choosesLevels()) return "";
    return Found(std::string("an environment in ") +
                 (capabilities.glsl == 120 ? "GLSL 1.20 without GL_ARB_shader_texture_lod"
                                           : "GLSL ES 1.00"))
        .expected("fragment shaders that choose the level of a cube map");
}

/// Why directions of an environment cannot be drawn in such a plan; "" where they can.
std::string whyNotSampled(const PlanRequest& request)
{
    if (request.environmentSamples == 0 ||
        (request.technique == Technique::single && request.maxLookups == 0))
        return "";
    return Found(std::to_string(request.environmentSamples) +
                 " directions of an environment with " +
                 (request.maxLookups > 0
                      ? "a limit of look-ups"
                      : std::string("technique ") + techniqueName(request.technique)))
        .expected("single without a limit");
}

/// The plan of a material with signs, or a reason. A UNORM target clamps the output of every pass
/// to 0, so it can take the sum of such terms but not the terms one by one.
Plan withSigns(Plan plan, const PlanRequest& request)
{
    plan.error.relative = std::numeric_limits<double>::infinity();
    if (!isUnorm(request.target)) return plan;
    const auto writes = std::count_if(plan.passes.begin(), plan.passes.end(),
                                      [](const Pass& p) { return p.writes == Surface::target; });
    if (writes <= 1) return plan;
    Plan none;
    none.reason = std::string("terms with signs do not add up in ") +
                  colourFormatName(request.target) + ", which has no negative values";
    return none;
}

Plan planCurved(const Form& form, const PlanRequest& request, const Capabilities& capabilities)
{
    const bool offscreen = limitsOf(form, request, capabilities).offscreen;
    PlanRequest straight = request;
    if (offscreen) straight.target = floatFormat(capabilities);
    Plan plan = planStraight(form, straight, capabilities);
    return plan.feasible() ? curvedPlan(std::move(plan), request.transfer, offscreen) : plan;
}

/// True when sums may be scaled by their peaks.
bool mayScale(const PlanRequest& request, const Capabilities& capabilities)
{
    return request.peaks && request.offscreen && !request.resolves && !request.signs &&
           request.lights > 0 && request.lobeLight.isEmpty() && isUnorm(request.target) &&
           capabilities.framebufferObjects;
}

bool hasFloatSurfaces(const Capabilities& capabilities)
{
    return capabilities.floatTargets || capabilities.halfTargets;
}

bool writesSurfaces(const Plan& plan)
{
    return std::any_of(plan.passes.begin(), plan.passes.end(),
                       [](const Pass& pass) { return pass.writes != Surface::target; });
}

/// True when the error bound is too large for the result to be useful (kCoarsestSum).
bool isCoarse(const ErrorBound& error)
{
    return !(std::max(error.relative, error.absolute) <= kCoarsestSum);
}

void checkPeaks(const Form& form, const PlanRequest& request)
{
    const Peaks& peaks = *request.peaks;
    const auto isKnown = [](const std::vector<double>& values, size_t count) {
        return values.size() == count &&
               std::all_of(values.begin(), values.end(), [](double v) { return v >= 0.0; });
    };
    if (!isKnown(peaks.tables, form.tables.size()) || !isKnown(peaks.scales, form.terms.size()) ||
        !isKnown(peaks.lights, static_cast<size_t>(request.lights)))
        throw Error(ErrorKind::usage, "plan",
                    Found("peaks of another form or number of lights, or below 0")
                        .expected("one of each table, term and light"));
}

/// Plans as if RGBA32F could be drawn to, then scales the sums for a smaller format.
Plan planScaled(const Form& form, const PlanRequest& request, Capabilities capabilities,
                ColourFormat surfaces)
{
    checkPeaks(form, request);
    capabilities.floatTargets = true;
    Plan plan = planStraight(form, request, capabilities);
    if (plan.feasible() && isCurved(request.transfer))
        plan = curvedPlan(std::move(plan), request.transfer, true);
    if (!plan.feasible()) return plan;
    plan = scaledPlan(std::move(plan), form, *request.peaks, surfaces);
    const ErrorBound error =
        errorBound(plan, request.target, {}, request.roundings, request.otherUnit);
    if (!isCoarse(error)) return plan;
    Plan none;
    none.reason = Found("a sum of " + std::to_string(request.lights) + " lights in " +
                        colourFormatName(surfaces) + " surfaces that is off by up to " +
                        numberText(double(error.absolute)))
                      .expected("at most " + numberText(double(kCoarsestSum)));
    return none;
}

Plan betterOf(Plan plan, Plan scaled, const PlanRequest& request)
{
    const auto errorOf = [&](const Plan& of) {
        return errorBound(of, request.target, {}, request.roundings, request.otherUnit).absolute;
    };
    if (!scaled.feasible()) {
        if (!plan.feasible()) plan.reason += "; " + scaled.reason;
        return plan;
    }
    return plan.feasible() && errorOf(plan) <= errorOf(scaled) ? plan : scaled;
}

Plan planUnscaled(const Form& form, const PlanRequest& request, const Capabilities& capabilities)
{
    Plan plan = isCurved(request.transfer) ? planCurved(form, request, capabilities)
                                           : planStraight(form, request, capabilities);
    // A UNORM target clamps, and no peak of what lobes reflect is known by which it could be
    // scaled.
    if (!request.lobeLight.isEmpty() && plan.passes.size() > 1 && isUnorm(request.target) &&
        !limitsOf(form, request, capabilities).offscreen) {
        plan = {};
        plan.reason = std::string("lights and lobes of several passes do not add up in ") +
                      colourFormatName(request.target) + " without float surfaces";
    }
    return plan;
}

/// In halves while their error is that of a picture, else without them.
Plan planUnscaledOrNot(const Form& form, const PlanRequest& request, Capabilities capabilities)
{
    Plan plan = planUnscaled(form, request, capabilities);
    if (plan.surfaces != ColourFormat::rgba16f ||
        !isCoarse(errorBound(plan, request.target, {}, request.roundings, request.otherUnit)))
        return plan;
    capabilities.halfTargets = false;
    plan = planUnscaled(form, request, capabilities);
    if (!plan.feasible())
        plan.reason += "; a sum of " + std::to_string(request.lights) +
                       " lights in RGBA16F surfaces is off by more than an eighth";
    return plan;
}

/// The plan with surfaces of the format that was asked for; nothing where there is none.
std::optional<Plan> planAsked(const Form& form, const PlanRequest& request,
                              Capabilities capabilities)
{
    if (!request.accumulation || *request.accumulation == ColourFormat::rgba32f) return {};
    Plan plan;
    if (*request.accumulation == ColourFormat::rgba16f) {
        if (!hasFloatSurfaces(capabilities)) return {};
        capabilities.floatTargets = false;
        capabilities.halfTargets = true;
        plan = planUnscaledOrNot(form, request, capabilities);
    } else {
        const bool exists =
            *request.accumulation == ColourFormat::rgba8 ||
            (*request.accumulation == ColourFormat::rgba16 && capabilities.unorm16Targets);
        if (!exists || !mayScale(request, capabilities)) return {};
        plan = planScaled(form, request, capabilities, *request.accumulation);
    }
    if (!plan.feasible() || (writesSurfaces(plan) && plan.surfaces != *request.accumulation))
        return {};
    plan.whyAccumulation = std::string(colourFormatName(*request.accumulation)) + " was asked for";
    return plan;
}

/// With surfaces in the format that the request allows and that costs least.
Plan planSums(const Form& form, const PlanRequest& request, const Capabilities& capabilities)
{
    if (std::optional<Plan> asked = planAsked(form, request, capabilities))
        return std::move(*asked);
    Plan plan = planUnscaledOrNot(form, request, capabilities);
    if (!mayScale(request, capabilities)) return plan;
    if (!hasFloatSurfaces(capabilities))
        return betterOf(std::move(plan),
                        planScaled(form, request, capabilities, ColourFormat::rgba8), request);
    const bool maySave = plan.feasible() && plan.surfaces == ColourFormat::rgba32f &&
                         writesSurfaces(plan) && !request.accumulation &&
                         !capabilities.softwareSampling;
    if (!maySave) return plan;
    checkPeaks(form, request);
    return withSmallestSum(std::move(plan), form, request, capabilities);
}

}  // namespace

Peaks peaksOf(const Material& material)
{
    Peaks peaks;
    for (const Table& table : material.tables) {
        const auto largest =
            static_cast<double>(*std::max_element(table.texels.begin(), table.texels.end()));
        peaks.tables.push_back(std::max(0.0, isLog(table.storage) ? std::exp2(largest) : largest));
    }
    for (const Vec3f& scale : material.scales)
        peaks.scales.push_back(
            std::max(0.0, static_cast<double>(std::max({scale.x, scale.y, scale.z}))));
    return peaks;
}

double largestExponent(const Material& material)
{
    double largest = 0.0;
    for (const Term& term : material.form.terms) {
        double sum = 0.0;
        for (const Factor& factor : term.factors) {
            const Table& table = material.tables[static_cast<size_t>(factor.table)];
            if (!isLog(table.storage)) continue;
            float most = 0.0f;
            for (const float texel : table.texels) most = std::max(most, std::abs(texel));
            sum += static_cast<double>(most);
        }
        largest = std::max(largest, sum);
    }
    return largest;
}

const char* filterName(Filter filter)
{
    return filter == Filter::shader ? "shader" : "hardware";
}

int freeUniformVectors(const Form& form, const Capabilities& capabilities)
{
    int vectors = capabilities.maxUniformVectors - kReservedUniformVectors;
    for (const TableSpec& table : form.tables) {
        vectors -= 2;  // fbrdfLower and fbrdfExtent
        if (table.uniform) vectors -= texelCount(table.domain);
    }
    return vectors;
}

int maxLightsInUniforms(const Form& form, const Capabilities& capabilities, const LobeShare& lobes)
{
    return std::max(1,
                    (freeUniformVectors(form, capabilities) - lobes.vectors()) / kVectorsPerLight);
}

Plan planPasses(const Form& form, const PlanRequest& request, const Capabilities& capabilities)
{
    validate(request);
    Plan none;
    none.reason = whyNoLobes(request, capabilities);
    if (none.feasible()) none.reason = whyNotSampled(request);
    if (!none.feasible()) return none;
    Plan plan = planSums(form, request, capabilities);
    plan.resolves = request.resolves;
    plan.technique = request.technique;
    plan.filter = request.filter;
    plan.error =
        errorBound(plan, request.target, request.maps, request.roundings, request.otherUnit);
    const bool sampledAlone = request.environmentSamples > 0 && request.lobeLight.areaLights == 0;
    if (!request.lobeLight.isEmpty() && !sampledAlone) plan.lobeError = request.lobeError;
    return request.signs && plan.feasible() ? withSigns(std::move(plan), request) : plan;
}

}  // namespace fbrdf
