#include "SeamlessCubes.h"

#include <osg/GLExtensions>
#include <osg/State>

// OpenGL 3.2 defines it, and headers of OpenGL 2 lack it.
#ifndef GL_TEXTURE_CUBE_MAP_SEAMLESS
#define GL_TEXTURE_CUBE_MAP_SEAMLESS 0x884F
#endif

namespace osgFbrdf {

int SeamlessCubes::compare(const osg::StateAttribute& other) const
{
    COMPARE_StateAttribute_Types(SeamlessCubes, other);
    COMPARE_StateAttribute_Parameter(on_);
    return 0;
}

void SeamlessCubes::apply(osg::State& state) const
{
    const auto& gl = *state.get<osg::GLExtensions>();
    if (gl.glVersion < 3.2f &&
        !osg::isGLExtensionSupported(state.getContextID(), "GL_ARB_seamless_cube_map"))
        return;
    // OSG applies modes before attributes, so it knows by now what the host wants.
    if (on_ || state.getLastAppliedMode(GL_TEXTURE_CUBE_MAP_SEAMLESS))
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    else
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

}  // namespace osgFbrdf
