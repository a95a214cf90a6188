// StorageGuard.h - puts back the storage buffers that the host has bound.
#pragma once
#include "Device.h"

#include <vector>

namespace fbrdf::gl {

/// Saves the first bindings of storage buffers (StateMode::restore). The destructor puts back what
/// was saved, GL's defaults, or nothing, as StateMode demands. Needs OpenGL 4.3.
class StorageGuard {
public:
    StorageGuard(const Device& device, int bindings);
    ~StorageGuard();
    StorageGuard(const StorageGuard&) = delete;
    StorageGuard& operator=(const StorageGuard&) = delete;

private:
    struct Binding {
        GLint buffer = 0;
        GLint64 start = 0, size = 0;  ///< size 0: all of the buffer
    };
    const Device& device_;
    const Functions& gl_;
    GLint general_ = 0;
    std::vector<Binding> bindings_;
};

}  // namespace fbrdf::gl
