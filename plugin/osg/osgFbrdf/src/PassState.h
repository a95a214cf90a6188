// PassState.h - what the state sets of all passes have in common.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <osg/StateSet>

namespace osgFbrdf {

// Stronger than the model's state, and safe from the host's: osgShadow puts its map over a unit of
// ours.
constexpr auto kStrong = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
constexpr auto kOurs = osg::StateAttribute::ON | kStrong;
constexpr auto kOff = osg::StateAttribute::OFF | kStrong;

/// The bin with that number within the current one, for all that is below: bins of the model would
/// tear passes apart, and an overriding bin above would make them one.
void setBin(osg::StateSet& state, int number);

/// Depth, bin, and no alpha test.
void setPlace(osg::StateSet& state, fbrdf::Depth depth, int bin);

}  // namespace osgFbrdf
