// StateList.h - reads GL state as a host may have set it, all that the runtime could touch and
// more.
#pragma once
#include "support/gl/Gl.h"

#include <map>
#include <string>
#include <vector>

namespace fbrdf::test {

/// A state by its name in GL.
struct NamedState {
    const char* name;
    GLenum value;
    int since = 21;    ///< first version that knows it
    int sinceEs = 99;  ///< first version of OpenGL ES that knows it; 99: none
};
/// True in a context of OpenGL ES, which must be 3.0 or newer.
bool isEs(const GladGLContext& gl);

/// Capabilities of glEnable that exist in this context.
std::vector<NamedState> switches(const GladGLContext& gl, bool core);

/// State by name; far more than the runtime claims to touch.
using StateSnapshot = std::map<std::string, std::vector<double>>;
StateSnapshot snapshot(const GladGLContext& gl, bool core);

/// Names and values that differ, a line each; empty where nothing does.
std::string difference(const StateSnapshot& before, const StateSnapshot& after);

/// How many of each indexed state are read.
constexpr GLuint kUnits = 6, kViewports = 4, kBuffers = 4, kAttributes = 8, kStorageBindings = 4;

}  // namespace fbrdf::test
