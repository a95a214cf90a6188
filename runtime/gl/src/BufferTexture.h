// BufferTexture.h - numbers that shaders fetch by index, in a buffer that grows; needs OpenGL 3.1.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

class BufferTexture {
public:
    BufferTexture() = default;
    BufferTexture(DevicePtr device, GLenum format, const char* name)
        : device_(std::move(device)), format_(format), name_(name)
    {
    }

    /// Uploads the data. The storage grows where it is too small and never shrinks. Leaves the
    /// array buffer bound. Throws Error(gl) where a buffer texture cannot have so many texels, or
    /// GL has no memory for them; the next call then begins anew.
    void update(size_t texels, size_t bytes, const void* data);
    /// The same for data that a shader writes.
    void reserve(size_t texels, size_t bytes);
    /// Uploads a part of it, into storage that is reserved and bound to the array buffer.
    void write(size_t first, size_t bytes, const void* data) const
    {
        device_->gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(first),
                                  static_cast<GLsizeiptr>(bytes), data);
    }
    GLuint texture() const { return texture_.name(); }
    GLuint buffer() const { return buffer_.name(); }

private:
    void create();

    DevicePtr device_;
    GLenum format_ = GL_NONE;
    const char* name_ = "";
    Object buffer_, texture_;
    size_t bytes_ = 0;
};

}  // namespace fbrdf::gl
