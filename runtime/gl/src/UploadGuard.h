// UploadGuard.h - puts back what making textures, buffers and framebuffers touches.
#pragma once
#include "Device.h"

#include <vector>

namespace fbrdf::gl {

/// Saves what an upload touches and sets GL's defaults: unpacking, pixel transfer, the bindings of
/// the active unit and of buffers.
class UploadGuard {
public:
    explicit UploadGuard(const Device& device);
    ~UploadGuard();
    UploadGuard(const UploadGuard&) = delete;
    UploadGuard& operator=(const UploadGuard&) = delete;

private:
    const Functions& gl_;
    bool fixedFunction_, vertexArrays_, framebuffers_;
    std::vector<GLint> unpack_;
    std::vector<GLfloat> transfer_;
    GLint unpackBuffer_ = 0, texture2d_ = 0, texture3d_ = 0, arrayBuffer_ = 0, elementBuffer_ = 0,
          vertexArray_ = 0, framebuffer_ = 0, renderbuffer_ = 0;
};

}  // namespace fbrdf::gl
