// Surfaces.h - the accumulation, scratch and sum surfaces: RGBA32F or RGBA8, as large as the
// target, one depth buffer for all.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

class Surfaces {
public:
    explicit Surfaces(DevicePtr device) : device_(std::move(device)) {}

    /// Makes all as said; nothing where they are. False, and a warning, where the driver cannot
    /// draw to them; it is not asked again for this size and format.
    bool prepare(int width, int height, ColourFormat format);

    /// Framebuffer of any but the target.
    GLuint framebuffer(Surface surface) const;
    GLuint texture(Surface surface) const;

private:
    struct One {
        Object texture, framebuffer;
    };
    bool create(One& one, const std::string& name);
    const One& of(Surface surface) const
    {
        if (surface == Surface::sum) return sum_;
        return surface == Surface::scratch ? scratch_ : accumulation_;
    }

    DevicePtr device_;
    One accumulation_, scratch_, sum_;
    Object depth_;
    int width_ = 0, height_ = 0;
    ColourFormat format_ = ColourFormat::rgba32f;
    bool usable_ = false;
};

}  // namespace fbrdf::gl
