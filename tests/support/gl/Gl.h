// Gl.h - GL functions for tests: glad's table of one context.
#pragma once
#include <glad/gl.h>

#include <fbrdf/headless/Context.h>
#include <fbrdf/truth/Program.h>

namespace fbrdf::test {

/// Table of the context that is current. Throws std::runtime_error where there is none.
GladGLContext loadGl(HeadlessContext::Load load);

using truth::linkProgram;

}  // namespace fbrdf::test
