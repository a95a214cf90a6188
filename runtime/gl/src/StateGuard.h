// StateGuard.h - what becomes of the state that a draw touches (StateMode). Renderer.h lists it,
// and a test randomises it.
#pragma once
#include "Device.h"

#include <fbrdf/plan/LightClusters.h>

#include <vector>

namespace fbrdf::gl {

/// Saves the draw state (StateMode::restore) and sets it to GL's defaults, less what passes set:
/// blend, depth, program, textures. The destructor puts back what was saved, GL's defaults where
/// nothing was, or does nothing but unbind the vertex array (StateMode::leave): a host that binds
/// an element buffer would change the mesh.
class StateGuard {
public:
    explicit StateGuard(const Device& device);
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

    /// Binds the target's framebuffer and makes the viewport all of it.
    void setTarget(const Target& target);
    /// Sets depth range, clear value and clip control; the depth function is a pass's.
    void setDepth(const DepthOptions& depth);
    /// Limits drawing to the pixels given; null: to the viewport only.
    void setScissor(const PixelRect* rect);
    /// Binds to a unit (counted from the device's first), saving what was there at first touch.
    void bindTexture(int unit, GLenum target, GLuint texture);
    /// Makes cube maps be filtered across the edges of their faces, where the context can.
    void filterAcrossEdges();

private:
    struct SavedUnit {
        GLenum unit = 0;
        GLint texture2d = 0, texture3d = 0, textureBuffer = 0, sampler = 0, textureArray = 0,
              textureCube = 0;
    };
    void saveBindings();
    void saveFixed();
    void saveDepths();
    void restoreBindings() const;
    void disableAll();
    void setFixed();
    void restoreFixed() const;
    void setDepthRange(double low, double high) const;
    void restoreDepthRangeAndViewport() const;
    void setScissorBox(const PixelRect& box) const;
    SavedUnit savedUnit(GLenum name) const;  ///< of the active unit
    void restoreTextures() const;

    const Device& device_;
    const Functions& gl_;
    const StateMode mode_;
    std::vector<GLenum> switches_;  ///< capabilities to turn on in the end
    std::vector<SavedUnit> units_;
    std::vector<GLboolean> colourMasks_;  ///< four a draw buffer
    // GL's defaults, overwritten by what is saved.
    GLint program_ = 0, activeTexture_ = GL_TEXTURE0, arrayBuffer_ = 0, vertexArray_ = 0,
          framebuffer_ = 0;
    GLint blendFunctions_[4] = {GL_ONE, GL_ZERO, GL_ONE, GL_ZERO},
          blendEquations_[2] = {GL_FUNC_ADD, GL_FUNC_ADD};
    GLint depthFunction_ = GL_LESS, polygonMode_[2] = {GL_FILL, GL_FILL},
          clampColour_ = GL_FIXED_ONLY, clipOrigin_ = GL_LOWER_LEFT,
          clipDepth_ = GL_NEGATIVE_ONE_TO_ONE;
    GLfloat viewport_[4] = {};
    GLint scissorBox_[4] = {};
    bool scissorSet_ = false;  ///< the box was changed
    bool seamlessSet_ = false, seamless_ = false;
    GLdouble depthRange_[2] = {0.0, 1.0}, clearDepth_ = 1.0;
    GLboolean depthMask_ = GL_TRUE;
    bool blend_ = false, depthTest_ = false, scissor_ = false;
};

}  // namespace fbrdf::gl
