// StateScrambler.h - sets GL state as a careless host would have, and back to defaults.
#pragma once
#include "support/gl/Gl.h"

#include <random>

namespace fbrdf::test {

/// Has objects to bind, and sets state at random or to what a new context has.
class StateScrambler {
public:
    /// core: without fixed function, as OpenGL ES is.
    StateScrambler(const GladGLContext& gl, bool core);
    ~StateScrambler();
    StateScrambler(const StateScrambler&) = delete;
    StateScrambler& operator=(const StateScrambler&) = delete;

    void scramble(unsigned seed);
    void setDefaults();

private:
    struct Source;
    void set(Source& source);
    void setSwitches(Source& source);
    void setFixed(Source& source);
    void setIndexed(Source& source);
    void setUnindexed(Source& source);
    void setPixels(Source& source);
    void setBindings(Source& source);
    void setStorage(Source& source);
    void setAttributes(Source& source);

    const GladGLContext& gl_;
    bool core_, es_;
    bool hasSamplers() const { return es_ || gl_.VERSION_3_3; }
    GLuint textures2d_[4] = {}, textures3d_[4] = {}, texturesBuffer_[1] = {},
           texturesArray_[2] = {}, texturesCube_[2] = {}, samplers_[2] = {}, buffers_[4] = {},
           arrays_[2] = {}, framebuffers_[2] = {}, renderbuffers_[3] = {}, program_ = 0;
};

}  // namespace fbrdf::test
