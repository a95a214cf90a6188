#include "InheritedState.h"

#include <osgUtil/CullVisitor>

#include <algorithm>

namespace osgFbrdf {
namespace {

using Override = osg::StateAttribute::OverrideValue;
using Sets = std::vector<const osg::StateSet*>;

/// An overriding value stays unless the next is protected, as in osg::State::pushModeList and
/// pushAttributeList.
bool replaces(Override next, Override last)
{
    return !(last & osg::StateAttribute::OVERRIDE) || (next & osg::StateAttribute::PROTECTED);
}

/// valueIn(set): of the mode in one state set.
template <class ValueIn>
std::optional<bool> modeOf(const Sets& sets, const ValueIn& valueIn)
{
    std::optional<Override> found;
    for (const osg::StateSet* set : sets) {
        const Override value = valueIn(*set);
        if (value & osg::StateAttribute::INHERIT) continue;
        if (!found || replaces(value, *found)) found = value;
    }
    if (!found) return std::nullopt;
    return (*found & osg::StateAttribute::ON) != 0;
}

/// pairIn(set): of the attribute in one state set.
template <class PairIn>
const osg::StateAttribute* attributeOf(const Sets& sets, const PairIn& pairIn)
{
    const osg::StateSet::RefAttributePair* found = nullptr;
    for (const osg::StateSet* set : sets) {
        const osg::StateSet::RefAttributePair* pair = pairIn(*set);
        if (pair && (!found || replaces(pair->second, found->second))) found = pair;
    }
    return found ? found->first.get() : nullptr;
}

}  // namespace

InheritedState::InheritedState(osgUtil::CullVisitor& visitor)
    : InheritedState(visitor.getCurrentStateGraph(), nullptr, nullptr)
{
}

InheritedState::InheritedState(const osgUtil::StateGraph* graph, const osgUtil::StateGraph* root,
                               const osg::StateSet* own)
{
    if (own) sets_.push_back(own);
    for (; graph && graph != root; graph = graph->_parent)
        if (graph->getStateSet()) sets_.push_back(graph->getStateSet());
    std::reverse(sets_.begin(), sets_.end());
}

std::optional<bool> InheritedState::mode(osg::StateAttribute::GLMode mode) const
{
    return modeOf(sets_, [&](const osg::StateSet& set) { return set.getMode(mode); });
}

const osg::StateAttribute* InheritedState::attribute(osg::StateAttribute::Type type) const
{
    return attributeOf(sets_, [&](const osg::StateSet& set) { return set.getAttributePair(type); });
}

int InheritedState::textureUnits() const
{
    size_t units = 0;
    for (const osg::StateSet* set : sets_)
        units = std::max(units, set->getTextureAttributeList().size());
    return static_cast<int>(units);
}

std::optional<bool> InheritedState::textureMode(int unit, osg::StateAttribute::GLMode mode) const
{
    return modeOf(sets_, [&](const osg::StateSet& set) {
        return set.getTextureMode(static_cast<unsigned int>(unit), mode);
    });
}

const osg::StateAttribute* InheritedState::textureAttribute(int unit,
                                                            osg::StateAttribute::Type type) const
{
    return attributeOf(sets_, [&](const osg::StateSet& set) {
        return set.getTextureAttributePair(static_cast<unsigned int>(unit), type);
    });
}

}  // namespace osgFbrdf
