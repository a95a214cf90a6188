// ReadGuard.h - puts back what reading pixels touches.
#pragma once
#include "Device.h"

#include <array>

namespace fbrdf::gl {

/// Puts the framebuffer to read from back where it is bound apart (StateMode::restore), or leaves
/// GL's default, or nothing.
class ReadFramebufferGuard {
public:
    explicit ReadFramebufferGuard(const Device& device) : gl_(device.gl), state_(device.state)
    {
        if (isApart() && state_ == StateMode::restore)
            framebuffer_ = integer(gl_, GL_READ_FRAMEBUFFER_BINDING);
    }
    ~ReadFramebufferGuard()
    {
        if (isApart() && state_ != StateMode::leave)
            gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, unsignedOf(framebuffer_));
    }
    ReadFramebufferGuard(const ReadFramebufferGuard&) = delete;
    ReadFramebufferGuard& operator=(const ReadFramebufferGuard&) = delete;

private:
    bool isApart() const { return gl_.drawFramebuffer() == GL_DRAW_FRAMEBUFFER; }

    const Functions& gl_;
    StateMode state_;
    GLint framebuffer_ = 0;
};

/// Pixels are packed without gaps into memory of the caller meanwhile. The destructor puts back
/// what was there (StateMode::restore), leaves GL's defaults, or nothing.
class ReadGuard {
public:
    explicit ReadGuard(const Device& device)
        : gl_(device.gl), state_(device.state), framebuffer_(device)
    {
        if (state_ == StateMode::restore) {
            if (gl_.hasUnpackBuffer()) packBuffer_ = integer(gl_, GL_PIXEL_PACK_BUFFER_BINDING);
            for (size_t i = 0; i < packStates(); ++i) pack_[i] = integer(gl_, kPack[i]);
        }
        if (gl_.hasUnpackBuffer()) gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        for (size_t i = 0; i < packStates(); ++i) gl_.PixelStorei(kPack[i], i == 0 ? 1 : 0);
    }
    ~ReadGuard()
    {
        if (state_ == StateMode::leave) return;
        if (gl_.hasUnpackBuffer()) gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, unsignedOf(packBuffer_));
        for (size_t i = 0; i < packStates(); ++i) gl_.PixelStorei(kPack[i], pack_[i]);
    }
    ReadGuard(const ReadGuard&) = delete;
    ReadGuard& operator=(const ReadGuard&) = delete;

private:
    static constexpr std::array<GLenum, 6> kPack{GL_PACK_ALIGNMENT,  GL_PACK_ROW_LENGTH,
                                                 GL_PACK_SKIP_ROWS,  GL_PACK_SKIP_PIXELS,
                                                 GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST};
    /// ES 2.0 has the alignment, 3.0 all but the order of bytes and bits.
    size_t packStates() const { return !gl_.es ? kPack.size() : gl_.es < 30 ? 1 : 4; }

    const Functions& gl_;
    StateMode state_;
    ReadFramebufferGuard framebuffer_;
    std::array<GLint, 6> pack_{4};  // alignment, then zeros: GL's defaults
    GLint packBuffer_ = 0;
};

}  // namespace fbrdf::gl
