// ProbeTarget.h - a small target for what is measured in a context, with a program that covers it.
#pragma once
#include "Objects.h"
#include "StateGuard.h"

#include <string>

namespace fbrdf::gl {

class ProbeTarget {
public:
    /// side: pixels; internal, type: of the texture that is drawn to. The target is bound for
    /// drawing and for reading, and the program is in use. Throws Error(gl), about `what`.
    ProbeTarget(const DevicePtr& device, StateGuard& state, int side, GLint internal, GLenum type,
                const std::string& what);
    /// Makes the program of the vertices of a covering triangle and a fragment shader, and uses it.
    void use(const std::string& fragment);
    GLint uniform(const char* name) const;

private:
    const DevicePtr& device_;
    std::string what_;
    Object colour_, framebuffer_, program_;
};

}  // namespace fbrdf::gl
