#include "InheritedState.h"

#include <osgUtil/CullVisitor>

#include <algorithm>

namespace osgFbrdf {
namespace {

using Override = osg::StateAttribute::OverrideValue;

/// An overriding value stays unless the next is protected, as in osg::State::pushModeList and
/// pushAttributeList.
bool replaces(Override next, Override last)
{
    return !(last & osg::StateAttribute::OVERRIDE) || (next & osg::StateAttribute::PROTECTED);
}

}  // namespace

InheritedState::InheritedState(osgUtil::CullVisitor& visitor)
{
    for (const osgUtil::StateGraph* graph = visitor.getCurrentStateGraph(); graph;
         graph = graph->_parent)
        if (graph->getStateSet()) sets_.push_back(graph->getStateSet());
    std::reverse(sets_.begin(), sets_.end());
}

std::optional<bool> InheritedState::mode(osg::StateAttribute::GLMode mode) const
{
    std::optional<Override> found;
    for (const osg::StateSet* set : sets_) {
        const Override value = set->getMode(mode);
        if (value & osg::StateAttribute::INHERIT) continue;
        if (!found || replaces(value, *found)) found = value;
    }
    if (!found) return std::nullopt;
    return (*found & osg::StateAttribute::ON) != 0;
}

const osg::StateAttribute* InheritedState::attribute(osg::StateAttribute::Type type) const
{
    const osg::StateSet::RefAttributePair* found = nullptr;
    for (const osg::StateSet* set : sets_) {
        const auto* pair = set->getAttributePair(type);
        if (pair && (!found || replaces(pair->second, found->second))) found = pair;
    }
    return found ? found->first.get() : nullptr;
}

}  // namespace osgFbrdf
