// CoreProfile.h - contexts without fixed function (macOS, osgEarth): what they need to be told
// before anything is drawn, and what cannot be drawn there.
#pragma once
#include <string>

namespace osg {
class State;
}

namespace osgFbrdf {

/// True where the context, which is current, has no fixed function.
bool isCoreProfile(osg::State& state);

/// Why nothing can be drawn in the context, which is current; empty where something can.
std::string whyNothingIsDrawn(osg::State& state);

/// Does to the state of a core profile, which is current, what OSG_VERTEX_BUFFER_HINT=
/// VERTEX_ARRAY_OBJECT does: drawables then have vertex arrays and no display lists. OSG 3.6 takes
/// no other way to draw there, and reads the variable only while a context is made. The log has it
/// once. Nothing is done to states that need nothing.
void prepareCoreProfile(osg::State& state);

}  // namespace osgFbrdf
