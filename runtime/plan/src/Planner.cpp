// Derivation. Let v look-ups not depend on the light and l depend on it, with k lights in a pass:
//   whole:    all factors in every light pass      v + k l <= limit    ceil(N / k) passes
//   leaving:  p(wo) and its like leave the sum     k l <= limit        ceil(N / k) + 1 passes
//   chained:  where even l > limit, the scratch surface builds up the product of one light
// A term takes whichever of the first two needs fewer passes. The first leaving term multiplies in
// place. That would multiply other terms too, so every further leaving term adds up in the
// accumulation surface and is composited with its factors. So is everything where the target is too
// coarse to add up in.
#include "Planner.h"

#include "PassList.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/plan/LightVectors.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr int kUnlimited = Limits::kUnlimited;

struct TermFactors {
    int term = 0;
    std::vector<int> view, light, all;
    int viewLookups = 0, lightLookups = 0;
};

/// Terms whose light passes run together, all factors in every pass.
struct Group {
    std::vector<Part> parts;
    int viewLookups = 0, lightLookups = 0;
};

TermFactors termFactors(const Form& form, int term)
{
    TermFactors result;
    result.term = term;
    const auto& factors = form.terms[static_cast<size_t>(term)].factors;
    for (int i = 0; i < static_cast<int>(factors.size()); ++i) {
        const bool repeats = dependsOnLight(factors[static_cast<size_t>(i)]);
        (repeats ? result.light : result.view).push_back(i);
        result.all.push_back(i);
    }
    result.viewLookups = lookupsOf(form, term, result.view);
    result.lightLookups = lookupsOf(form, term, result.light);
    return result;
}

/// The number of lights that fit into a pass; 0 when not even one does.
int lightsFitting(int viewLookups, int lightLookups, const Limits& limits)
{
    if (viewLookups > limits.lookups) return 0;
    if (lightLookups == 0) return limits.lights;
    return std::min(limits.lights, (limits.lookups - viewLookups) / lightLookups);
}

int passesFor(int lights, int lightsPerPass)
{
    return lightsPerPass < 1 ? kUnlimited - 1 : (lights + lightsPerPass - 1) / lightsPerPass;
}

/// What passes add of lobes; or directions of the environment that are drawn by all of them, and
/// the lobes for area lights alone.
std::vector<LobeShare> sharesOf(const Form& form, const PlanRequest& request, const Limits& limits)
{
    const LobeRoom room{limits.lookups, std::max(0, limits.vectors), limits.areaLights};
    if (request.environmentSamples == 0) return lobeShares(request.lobes, request.lobeLight, room);
    LobeShare share = wholeShare(request.lobes);
    share.samples = request.environmentSamples;
    share.perSample = 1;
    for (int t = 0; t < static_cast<int>(form.terms.size()); ++t)
        share.perSample += lookupsOf(form, t, termFactors(form, t).all);
    if (share.vectors() > limits.vectors) return {};
    std::vector<LobeShare> shares{share};
    const int areaLights = request.lobeLight.areaLights;
    if (areaLights == 0) return shares;
    const auto lit = lobeShares(request.lobes, {false, areaLights}, room);
    if (lit.empty()) return {};
    shares.insert(shares.end(), lit.begin(), lit.end());
    return shares;
}

class Planner {
public:
    Planner(const Form& form, const PlanRequest& request, const Limits& limits)
        : form_(form),
          request_(request),
          limits_(limits),
          list_(form),
          lobes_(sharesOf(form, request, limits))
    {
    }

    /// Plans lobes without point lights.
    bool planLobes()
    {
        addUp({}, {});
        return reason_.empty();
    }

    /// Puts every term into every light pass.
    bool planTogether()
    {
        Group group;
        for (const TermFactors& term : terms()) join(group, term);
        if (lightsFitting(group.viewLookups, group.lightLookups, limits_) < 1) return false;
        addUp({group}, {});
        return reason_.empty();
    }

    bool planApart()
    {
        std::vector<Group> groups;
        std::vector<TermFactors> leaving;
        for (const TermFactors& term : terms()) {
            if (shouldLeave(term))
                leaving.push_back(term);
            else
                place(groups, term);
        }
        addUp(groups, leaving);
        return reason_.empty();
    }

    const std::vector<Pass>& passes() const { return list_.passes(); }
    const std::string& reason() const { return reason_; }

private:
    std::vector<TermFactors> terms() const
    {
        std::vector<TermFactors> result;
        for (int t = 0; t < static_cast<int>(form_.terms.size()); ++t)
            result.push_back(termFactors(form_, t));
        return result;
    }

    bool shouldLeave(const TermFactors& term) const
    {
        if (term.viewLookups == 0) return false;
        const int whole =
            passesFor(request_.lights, lightsFitting(term.viewLookups, term.lightLookups, limits_));
        const int left =
            passesFor(request_.lights, lightsFitting(0, term.lightLookups, limits_)) + 1;
        return left < whole || whole >= kUnlimited - 1;
    }

    static void join(Group& group, const TermFactors& term)
    {
        group.parts.push_back({term.term, term.all, true});
        group.viewLookups += term.viewLookups;
        group.lightLookups += term.lightLookups;
    }

    void place(std::vector<Group>& groups, const TermFactors& term) const
    {
        for (Group& group : groups)
            if (lightsFitting(group.viewLookups + term.viewLookups,
                              group.lightLookups + term.lightLookups, limits_) >= 1)
                return join(group, term);
        groups.emplace_back();
        join(groups.back(), term);
    }

    void addUp(const std::vector<Group>& groups, const std::vector<TermFactors>& leaving)
    {
        if (!request_.lobeLight.isEmpty() && lobes_.empty())
            return refuse(Found("lobes of " + std::to_string(request_.lobes.knots()) + " knots")
                              .expected("fewer: the uniforms of a pass have room for " +
                                        std::to_string(std::max(0, limits_.vectors)) + " vectors"));
        if (accumulatesInTarget(groups, leaving))
            addUpInTarget(groups, leaving);
        else
            addUpOffscreen(groups, leaving);
    }

    bool accumulatesInTarget(const std::vector<Group>& groups,
                             const std::vector<TermFactors>& leaving) const
    {
        if (request_.target == ColourFormat::rgba32f || !limits_.offscreen) return true;
        if (!leaving.empty() || groups.size() > 1 || lobes_.size() > 1) return false;
        if (groups.empty()) return true;
        const int fitting = lightsFitting(groups[0].viewLookups, groups[0].lightLookups, limits_);
        if (fitting < request_.lights) return false;
        if (lobes_.empty()) return true;  // one pass: nothing adds up
        Pass pass = lightPass(groups[0], 0, request_.lights);
        pass.lookups = groups[0].viewLookups + groups[0].lightLookups * request_.lights;
        return joins(pass);
    }

    /// True where the pass can add all lobes beside what it does.
    bool joins(const Pass& pass) const
    {
        if (lobes_.size() != 1 || pass.blend == Blend::multiply) return false;
        if (lobes_[0].samples > 0) return false;  // its program evaluates the whole material
        if (request_.technique == Technique::batched && pass.lit) return false;
        return pass.lookups + lobes_[0].lookups() <= limits_.lookups &&
               kVectorsPerLight * pass.lightCount + lobes_[0].vectors() <= limits_.vectors;
    }

    /// Adds the lobes to what the last pass has left in the surface, or lays the surface.
    void addLobes(Surface surface)
    {
        if (lobes_.empty()) return;
        if (!list_.passes().empty() && joins(list_.passes().back()))
            return list_.addToLast(lobes_[0]);
        for (const LobeShare& share : lobes_) {
            Pass pass;
            pass.lobes = share;
            pass.writes = surface;
            list_.append(std::move(pass));
        }
    }

    /// The lobes after everything else, in a target too coarse to add them up in.
    void addLobesOffscreen()
    {
        const bool together =
            lobes_.size() < 2 || (!list_.passes().empty() && joins(list_.passes().back()));
        if (together) return addLobes(Surface::target);
        list_.restart(Surface::accumulation);
        addLobes(Surface::accumulation);
        composite({{0, {}, false}});
    }

    void addUpInTarget(const std::vector<Group>& groups, const std::vector<TermFactors>& leaving)
    {
        const bool mayClamp =
            request_.target != ColourFormat::rgba32f && request_.target != ColourFormat::rgba16f;
        if (!leaving.empty() && mayClamp)
            return refuse(std::string("a sum before its last factor does not fit into ") +
                          colourFormatName(request_.target));
        for (size_t i = 0; i < leaving.size(); ++i) {
            if (i == 0)
                addLeavingInPlace(leaving[i]);
            else
                addLeavingThroughAccumulation(leaving[i]);
            if (i == 0)
                for (const Group& group : groups) addLights(group, Surface::target);
        }
        if (leaving.empty())
            for (const Group& group : groups) addLights(group, Surface::target);
        addLobes(Surface::target);
    }

    void addUpOffscreen(const std::vector<Group>& groups, const std::vector<TermFactors>& leaving)
    {
        if (!groups.empty()) {
            list_.restart(Surface::accumulation);
            for (const Group& group : groups) addLights(group, Surface::accumulation);
            // The composite reads one texel only: lobes that fit beside that wait for it.
            Pass reading;
            reading.lookups = 1;
            const bool wait = joins(reading);
            if (!wait) addLobes(Surface::accumulation);
            composite({{0, {}, false}});
            if (wait) addLobes(Surface::target);
        }
        for (const TermFactors& term : leaving) addLeavingThroughAccumulation(term);
        if (groups.empty()) addLobesOffscreen();
    }

    void addLeavingInPlace(const TermFactors& term)
    {
        addLights(lightGroup(term), Surface::target);
        for (const Part& part : chunks(term.term, term.view, limits_.lookups))
            multiply(part, Surface::target);
    }

    void addLeavingThroughAccumulation(const TermFactors& term)
    {
        if (!limits_.offscreen)
            return refuse("term " + std::to_string(term.term) +
                          " needs an accumulation surface, which this target cannot have");
        list_.restart(Surface::accumulation);
        addLights(lightGroup(term), Surface::accumulation);
        // The composite reads the surface, so it has room for one factor less.
        auto parts = chunks(term.term, term.view, limits_.lookups - 1);
        const Part last = parts.back();
        parts.pop_back();
        for (const Part& part : parts) multiply(part, Surface::accumulation);
        composite({last});
    }

    static Group lightGroup(const TermFactors& term)
    {
        return {{{term.term, term.light, false}}, 0, term.lightLookups};
    }

    void addLights(const Group& group, Surface surface)
    {
        const int k = lightsFitting(group.viewLookups, group.lightLookups, limits_);
        if (k < 1) return chain(group.parts.front(), surface);
        for (int first = 0; first < request_.lights; first += k) {
            Pass pass = lightPass(group, first, std::min(k, request_.lights - first));
            pass.writes = surface;
            list_.append(std::move(pass));
        }
    }

    static Pass lightPass(const Group& group, int first, int count)
    {
        Pass pass;
        pass.parts = group.parts;
        pass.firstLight = first;
        pass.lightCount = count;
        pass.lit = true;
        return pass;
    }

    /// Builds up the product of each light in the scratch surface, then adds it.
    void chain(const Part& whole, Surface surface)
    {
        if (!limits_.offscreen)
            return refuse("term " + std::to_string(whole.term) + ": " +
                          Found(std::to_string(lookupsOf(form_, whole.term, whole.factors)) +
                                " look-ups a light")
                              .expected("at most " + std::to_string(limits_.lookups) +
                                        " without an offscreen surface"));
        auto parts = chunks(whole.term, whole.factors, limits_.lookups - 1);
        for (Part& part : parts) part.scaled = false;
        parts.back().scaled = whole.scaled;
        for (int light = 0; light < request_.lights; ++light) {
            list_.restart(Surface::scratch);
            for (size_t i = 0; i < parts.size(); ++i) {
                Pass pass;
                pass.parts = {parts[i]};
                pass.firstLight = light;
                pass.lightCount = 1;
                pass.lit = i == 0;
                const bool last = i + 1 == parts.size();
                pass.writes = last ? surface : Surface::scratch;
                pass.blend = last ? Blend::add : Blend::multiply;
                if (last) pass.reads = Surface::scratch;
                list_.append(std::move(pass));
            }
        }
    }

    void multiply(const Part& part, Surface surface)
    {
        Pass pass;
        pass.parts = {part};
        pass.writes = surface;
        pass.blend = Blend::multiply;
        list_.append(std::move(pass));
    }

    void composite(std::vector<Part> parts)
    {
        Pass pass;
        pass.parts = std::move(parts);
        pass.reads = Surface::accumulation;
        pass.blend = Blend::add;
        list_.append(std::move(pass));
    }

    /// Splits factors so that no chunk exceeds the limit and the last chunk does not exceed
    /// `lastLimit`. The last chunk has the scale.
    std::vector<Part> chunks(int term, const std::vector<int>& factors, int lastLimit) const
    {
        std::vector<Part> parts;
        std::vector<int> rest = factors, last;
        int lastLookups = 0;
        while (!rest.empty() && lastLookups + lookupsOf(form_, term, rest.back()) <= lastLimit) {
            lastLookups += lookupsOf(form_, term, rest.back());
            last.insert(last.begin(), rest.back());
            rest.pop_back();
        }
        Part part{term, {}, false};
        for (const int factor : rest) {
            if (lookupsOf(form_, term, part.factors) + lookupsOf(form_, term, factor) >
                limits_.lookups) {
                parts.push_back(part);
                part.factors.clear();
            }
            part.factors.push_back(factor);
        }
        if (!part.factors.empty()) parts.push_back(part);
        parts.push_back({term, last, true});
        return parts;
    }

    void refuse(const std::string& reason) { reason_ = reason; }

    const Form& form_;
    const PlanRequest& request_;
    const Limits& limits_;
    PassList list_;
    std::vector<LobeShare> lobes_;
    std::string reason_;
};

}  // namespace

ListedPasses listPasses(const Form& form, const PlanRequest& request, const Limits& limits)
{
    FBRDF_ASSERT(limits.lights, >, 0);
    if (request.lights == 0) {
        Planner alone(form, request, limits);
        alone.planLobes();
        return {alone.reason().empty() ? alone.passes() : std::vector<Pass>{}, alone.reason()};
    }
    Planner together(form, request, limits), apart(form, request, limits);
    const bool canTogether = together.planTogether(), canApart = apart.planApart();
    if (!canTogether && !canApart) return {{}, apart.reason()};
    const bool chooseTogether =
        canTogether && (!canApart || together.passes().size() <= apart.passes().size());
    return {(chooseTogether ? together : apart).passes(), ""};
}

}  // namespace fbrdf
