// ClusterBuffers.h - lights and their lists as buffer textures; needs OpenGL 3.1.
#pragma once
#include "Objects.h"
#include "StateGuard.h"

#include <fbrdf/plan/LightClusters.h>

namespace fbrdf::gl {

class ClusterBuffers {
public:
    explicit ClusterBuffers(DevicePtr device) : device_(std::move(device)) {}

    /// Uploads; storage grows where it must and is never made anew otherwise. Leaves the array
    /// buffer bound. Throws Error(gl) where GL cannot hold the lists.
    void update(const LightClusters& clusters);

    enum Which { lights, indices, lists, count };
    GLuint texture(Which which) const { return buffers_[which].texture.name(); }

private:
    struct One {
        Object buffer, texture;
        size_t bytes = 0;
    };
    void upload(Which which, GLenum format, size_t texels, size_t bytes, const void* data);
    void create(One& one, GLenum format, const char* name);

    DevicePtr device_;
    One buffers_[count];
};

}  // namespace fbrdf::gl
