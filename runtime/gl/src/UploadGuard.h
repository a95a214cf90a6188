// UploadGuard.h - puts back what making textures, buffers and framebuffers touches.
#pragma once
#include "Device.h"

#include <vector>

namespace fbrdf::gl {

/// Saves what an upload touches (StateMode::restore) and sets what it needs: unpacking, pixel
/// transfer, the unpack buffer. The destructor puts back what was saved, GL's defaults, or nothing,
/// as StateMode demands.
class UploadGuard {
public:
    explicit UploadGuard(const Device& device);
    ~UploadGuard();
    UploadGuard(const UploadGuard&) = delete;
    UploadGuard& operator=(const UploadGuard&) = delete;

    static constexpr size_t kUnpackStates = 8;

private:
    void save();
    size_t unpackStates() const;
    bool hasTransfer() const;
    void setTransfer() const;

    const Device& device_;
    const Functions& gl_;
    GLint unpack_[kUnpackStates] = {4};  // alignment, then zeros: GL's defaults
    std::vector<GLfloat> transfer_;      // as saved; GL's defaults are set meanwhile
    GLint unpackBuffer_ = 0, texture2d_ = 0, texture3d_ = 0, textureCube_ = 0, textureArray_ = 0,
          textureBuffer_ = 0, arrayBuffer_ = 0, elementBuffer_ = 0, vertexArray_ = 0,
          framebuffer_ = 0, renderbuffer_ = 0;
};

}  // namespace fbrdf::gl
