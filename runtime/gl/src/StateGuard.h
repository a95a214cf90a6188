// StateGuard.h - puts back what a draw touches. The list is in README.md; a test randomises it.
#pragma once
#include "Device.h"

#include <vector>

namespace fbrdf::gl {

/// Saves the draw state and sets it to GL's defaults, less what passes set: blend, depth, program,
/// textures. The destructor restores it.
class StateGuard {
public:
    explicit StateGuard(const Device& device);
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

    /// Binds the target's framebuffer and makes the viewport all of it.
    void setTarget(const Target& target);
    /// Binds to a unit (counted from the device's first), saving what was there at first touch.
    void bindTexture(int unit, GLenum target, GLuint texture);

private:
    struct SavedUnit {
        GLenum unit = 0;
        GLint texture2d = 0, texture3d = 0, sampler = 0;
    };
    void saveBindings();
    void saveFixed();
    void disableAll();
    void setFixed();
    void restoreFixed() const;
    void restoreTextures() const;

    const Device& device_;
    const Functions& gl_;
    std::vector<GLenum> switches_;  ///< capabilities that were on
    std::vector<SavedUnit> units_;
    std::vector<GLboolean> colourMasks_;  ///< four a draw buffer
    GLint program_ = 0, activeTexture_ = 0, arrayBuffer_ = 0, vertexArray_ = 0, framebuffer_ = 0;
    GLint blendFunctions_[4] = {}, blendEquations_[2] = {};
    GLint depthFunction_ = 0, polygonMode_[2] = {}, clampColour_ = 0, clipOrigin_ = 0,
          clipDepth_ = 0;
    GLfloat viewport_[4] = {};
    GLdouble depthRange_[2] = {}, clearDepth_ = 1.0;
    GLboolean depthMask_ = GL_TRUE;
    bool blend_ = false, depthTest_ = false, scissor_ = false;
};

}  // namespace fbrdf::gl
