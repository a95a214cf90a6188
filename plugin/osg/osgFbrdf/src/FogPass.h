// FogPass.h - OpenGL's fog over an effect: one more pass that blends the fog of the scene over what
// the passes of the plan left, whatever their number and transfer. So fog is applied once, and
// last, as it is for objects beside the effect.
#pragma once
#include "VersionedProgram.h"

#include <osg/StateSet>

namespace osgFbrdf {

class InheritedState;

/// State of the pass: the program, blending and depth. bin: after those of the plan.
osg::ref_ptr<osg::StateSet> fogState(osg::Program* program, int bin);

/// vertex: the shader of the other passes, so that depths are equal.
osg::ref_ptr<VersionedProgram> fogProgram(const VersionedShader& vertex);

/// What depends on the fog of the scene; null where there is none.
osg::ref_ptr<osg::StateSet> fogOfScene(const InheritedState& state);

}  // namespace osgFbrdf
