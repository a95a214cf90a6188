#include "CoreProfile.h"

#include "VersionedProgram.h"

#include <fbrdf/base/Found.h>

#include <osg/GLExtensions>
#include <osg/Notify>
#include <osg/State>

// OpenGL 3.2 defines these, and headers of OpenGL 2 lack them.
#ifndef GL_CONTEXT_PROFILE_MASK
#define GL_CONTEXT_PROFILE_MASK 0x9126
#define GL_CONTEXT_CORE_PROFILE_BIT 0x00000001
#endif

namespace osgFbrdf {
namespace {

/// What osg::State keeps from everybody but classes that are derived from it.
struct StateMembers : public osg::State {
    static bool osg::State::*forcesBuffers() { return &StateMembers::_forceVertexBufferObject; }
    static bool osg::State::*forcesArrays() { return &StateMembers::_forceVertexArrayObject; }
};

}  // namespace

// 3.1 has no profiles, but an extension that brings the fixed function back.
bool isCoreProfile(osg::State& state)
{
    const auto& gl = *state.get<osg::GLExtensions>();
    if (gl.glVersion < 3.2f)
        return gl.glVersion >= 3.1f &&
               !osg::isGLExtensionSupported(state.getContextID(), "GL_ARB_compatibility");
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
}

std::string whyNothingIsDrawn(osg::State& state)
{
    if (!isCoreProfile(state) || hasOsgInputs(state)) return "";
    return fbrdf::Found("a core profile without vertex attribute aliasing")
        .expected(
            "setUseVertexAttributeAliasing(true) and setUseModelViewAndProjectionUniforms(true) of "
            "its osg::State");
}

void prepareCoreProfile(osg::State& state)
{
    if (!isCoreProfile(state)) return;
    state.setModeValidity(GL_ALPHA_TEST, false);  // which our passes turn off
    if (state.useVertexArrayObject(false)) return;
    state.*StateMembers::forcesBuffers() = state.*StateMembers::forcesArrays() = true;
    if (!hasOsgInputs(state)) return;  // nothing is drawn
    OSG_WARN << "osgFbrdf: "
             << fbrdf::Found("a core profile where models are display lists")
                    .expected("OSG_VERTEX_BUFFER_HINT=VERTEX_ARRAY_OBJECT")
             << ": models are drawn as if that was set" << std::endl;
}

}  // namespace osgFbrdf
