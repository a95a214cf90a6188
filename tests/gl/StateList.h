// StateList.h - GL state as a host may have set it: read all of it, scramble it, set it to
// defaults.
#pragma once
#include "support/gl/Gl.h"

#include <map>
#include <random>
#include <string>
#include <vector>

namespace fbrdf::test {

/// State by name; far more than the runtime says it touches.
using StateSnapshot = std::map<std::string, std::vector<double>>;
StateSnapshot snapshot(const GladGLContext& gl, bool core);

/// Names and values that differ, a line each; empty where nothing does.
std::string difference(const StateSnapshot& before, const StateSnapshot& after);

/// Objects to bind, and setting state at random or to what a new context has.
class StateScrambler {
public:
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
    void setAttributes(Source& source);

    const GladGLContext& gl_;
    bool core_;
    GLuint textures2d_[4] = {}, textures3d_[4] = {}, samplers_[2] = {}, buffers_[4] = {},
           arrays_[2] = {}, framebuffers_[2] = {}, renderbuffers_[3] = {}, program_ = 0;
};

}  // namespace fbrdf::test
