#include "TechniqueChoice.h"

#include "CoreProfile.h"

#include <OpenThreads/ScopedLock>

#include <algorithm>
#include <functional>
#include <limits>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

}  // namespace

/// Asks the context in which OSG applies it; the one that OSG makes by itself as a default does
/// nothing.
class TechniqueChoice::Probe : public osg::StateAttribute {
public:
    Probe() = default;
    Probe(TechniqueChoice& choice, unsigned int round, const std::vector<ContextNeeds>& needs)
        : choice_(&choice), round_(round), needs_(needs)
    {
    }
    Probe(const Probe& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY)
        : osg::StateAttribute(other, op),
          choice_(other.choice_),
          round_(other.round_),
          needs_(other.needs_)
    {
    }
    META_StateAttribute(osgFbrdf, Probe, VALIDATOR)

    int compare(const osg::StateAttribute& other) const override
    {
        return this == &other ? 0 : std::less<>()(this, &other) ? -1 : 1;
    }
    void apply(osg::State& state) const override
    {
        if (choice_) choice_->ask(state, round_, needs_);
    }

private:
    osg::ref_ptr<TechniqueChoice> choice_;
    unsigned int round_ = 0;
    std::vector<ContextNeeds> needs_;
};

int TechniqueChoice::index() const
{
    const Lock lock(mutex_);
    int index = 0;
    for (const auto& answer : answers_) index = std::max(index, answer.second.index);
    return index;
}

ContextLimits TechniqueChoice::limits() const
{
    constexpr int kUnlimited = std::numeric_limits<int>::max();
    const Lock lock(mutex_);
    // Nobody knows of buffer textures before a context was asked.
    ContextLimits limits{kUnlimited,         kUnlimited, true, answers_.empty() ? 0 : kUnlimited,
                         {true, true, true}, true};
    for (const auto& answer : answers_) limits = smaller(limits, answer.second.limits);
    return limits;
}

std::string TechniqueChoice::refusal() const
{
    const Lock lock(mutex_);
    return refusal_;
}

void TechniqueChoice::refuse(const std::string& reason)
{
    const Lock lock(mutex_);
    refusal_ = reason;
}

void TechniqueChoice::forget()
{
    const Lock lock(mutex_);
    answers_.clear();
    refusal_.clear();
    ++round_;
}

void TechniqueChoice::forget(unsigned int contextId)
{
    const Lock lock(mutex_);
    answers_.erase(contextId);
}

std::string TechniqueChoice::whyNothing(unsigned int contextId) const
{
    const Lock lock(mutex_);
    const auto answer = answers_.find(contextId);
    return answer == answers_.end() ? "" : answer->second.whyNothing;
}

bool TechniqueChoice::asked(unsigned int contextId) const
{
    const Lock lock(mutex_);
    return answers_.count(contextId) > 0;
}

unsigned int TechniqueChoice::round() const
{
    const Lock lock(mutex_);
    return round_;
}

osg::ref_ptr<osg::StateSet> TechniqueChoice::probe(const std::vector<ContextNeeds>& needs)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttribute(new Probe(*this, round(), needs));
    return state;
}

void TechniqueChoice::ask(osg::State& state, const std::vector<ContextNeeds>& needs)
{
    ask(state, round(), needs);
}

void TechniqueChoice::ask(osg::State& state, unsigned int round,
                          const std::vector<ContextNeeds>& needs)
{
    prepareCoreProfile(state);
    std::string refusal;
    int index = 0;
    for (const ContextNeeds& each : needs) {
        const std::string reason = refusalBy(state, each);
        if (reason.empty()) break;
        refusal = reason;
        ++index;
    }
    const Answer answer{index, limitsOf(state), whyNothingIsDrawn(state)};
    const Lock lock(mutex_);
    if (round != round_) return;
    answers_[state.getContextID()] = answer;
    if (!refusal.empty()) refusal_ = refusal;
}

}  // namespace osgFbrdf
