// Hooks.h - a loader that stands between the renderer and GL: counts objects, hides functions,
// breaks things on request. One at a time in a process.
#pragma once
#include "Gl.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace fbrdf::test {

class Hooks {
public:
    explicit Hooks(HeadlessContext::Load real);
    ~Hooks();
    Hooks(const Hooks&) = delete;
    Hooks& operator=(const Hooks&) = delete;

    /// Fits gl::LoadFunction, with the Hooks as user.
    static void* load(void* hooks, const char* name);

    std::set<std::string> hidden;      ///< functions for which null is returned
    std::set<std::string> asked;       ///< functions that were asked for
    std::map<std::string, int> alive;  ///< objects made less objects deleted, by kind
    int made = 0, deleted = 0;         ///< objects of all kinds
    bool corruptShaders = false;       ///< sources no longer compile
    bool spoilPrograms = false;        ///< shaders compile, programs do not link
    bool refuseFramebuffers = false;   ///< framebuffers with a texture are never complete
    GLint refusedFormat = 0;           ///< nor are those with one of this internal format
    GLenum nextError = GL_NO_ERROR;    ///< what glGetError returns once
    int errorAfter = 0;                ///< calls of glGetError that are still answered by GL
    bool errorStays = false;           ///< nextError is returned for ever, as of a lost context
    int errorsAsked = 0;               ///< calls of glGetError
    bool loseContext = false;          ///< no name is given to a new object
    GLint unfilteredFormat = 0;        ///< textures of this internal format are not filtered
    bool countSamples = false;         ///< measure every draw call
    std::vector<GLuint> samples;       ///< samples that passed, one for each draw call

    /// Queries without an index answer as NVIDIA's compatibility contexts do: for all draw buffers
    /// and viewports together, and the depth range in float.
    bool coarseQueries = false;

    bool refusedIsBound = false;  ///< the texture that was made last is of that format
    GladGLContext real{};
};

}  // namespace fbrdf::test
