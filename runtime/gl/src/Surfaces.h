// Surfaces.h - the accumulation, scratch and sum surfaces: RGBA32F or RGBA8, as large as the
// target, one depth buffer for all.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

class Surfaces {
public:
    explicit Surfaces(DevicePtr device) : device_(std::move(device)) {}

    /// What the surfaces of a target have to be.
    struct Format {
        int width = 0, height = 0;
        ColourFormat colour = ColourFormat::rgba32f;
        bool floatDepth = false;  ///< as the target's: coarser depths would let fragments coincide
        bool operator==(const Format& other) const
        {
            return width == other.width && height == other.height && colour == other.colour &&
                   floatDepth == other.floatDepth;
        }
    };

    /// Creates the surfaces, or does nothing if they already match. Returns false, after a warning,
    /// where the driver cannot draw to them; it is not asked again for the same format.
    bool prepare(const Format& format);

    /// Framebuffer of any but the target.
    GLuint framebuffer(Surface surface) const;
    GLuint texture(Surface surface) const;

private:
    struct One {
        Object texture, framebuffer;
    };
    void createDepth();
    bool create(One& one, const std::string& name);
    const One& of(Surface surface) const
    {
        if (surface == Surface::sum) return sum_;
        return surface == Surface::scratch ? scratch_ : accumulation_;
    }

    DevicePtr device_;
    One accumulation_, scratch_, sum_;
    Object depth_;
    Format format_;
    bool usable_ = false;
};

}  // namespace fbrdf::gl
