// ReadGuard.h - puts back what reading pixels touches.
#pragma once
#include "Device.h"

#include <array>

namespace fbrdf::gl {

/// Pixels are packed without gaps into memory of the caller meanwhile. The destructor puts back
/// what was there (StateMode::restore), leaves GL's defaults, or nothing.
class ReadGuard {
public:
    explicit ReadGuard(const Device& device) : gl_(device.gl), state_(device.state)
    {
        if (state_ == StateMode::restore) {
            if (hasReadFramebuffer()) framebuffer_ = integer(gl_, GL_READ_FRAMEBUFFER_BINDING);
            if (gl_.hasUnpackBuffer()) packBuffer_ = integer(gl_, GL_PIXEL_PACK_BUFFER_BINDING);
            for (size_t i = 0; i < packStates(); ++i) pack_[i] = integer(gl_, kPack[i]);
        }
        if (gl_.hasUnpackBuffer()) gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        for (size_t i = 0; i < packStates(); ++i) gl_.PixelStorei(kPack[i], i == 0 ? 1 : 0);
    }
    ~ReadGuard()
    {
        if (state_ == StateMode::leave) return;
        if (hasReadFramebuffer())
            gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, unsignedOf(framebuffer_));
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
    bool hasReadFramebuffer() const { return gl_.drawFramebuffer() == GL_DRAW_FRAMEBUFFER; }

    const Functions& gl_;
    StateMode state_;
    std::array<GLint, 6> pack_{4};  // alignment, then zeros: GL's defaults
    GLint framebuffer_ = 0, packBuffer_ = 0;
};

}  // namespace fbrdf::gl
