// PassState.h - the state that all passes have in common.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <osg/StateSet>

namespace osgFbrdf {

// Our state overrides that of the model and is protected from that of the host: osgShadow, for one,
// puts its map over a texture unit of ours.
constexpr auto kStrong = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
constexpr auto kOurs = osg::StateAttribute::ON | kStrong;
constexpr auto kOff = osg::StateAttribute::OFF | kStrong;

/// Sets the bin with that number within the current one, for all that is below. Bins of the model
/// would tear passes apart, and an overriding bin above would make them one.
void setBin(osg::StateSet& state, int number);

/// Sets depth and bin, and turns the alpha test off.
void setPlace(osg::StateSet& state, fbrdf::Depth depth, int bin);

}  // namespace osgFbrdf
