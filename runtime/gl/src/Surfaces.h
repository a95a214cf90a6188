// Surfaces.h - the accumulation, scratch and sum surfaces of one target: as large as the target,
// with one depth buffer for all.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

struct SurfaceFormat {
    int width = 0, height = 0;
    ColourFormat colour = ColourFormat::rgba32f;
    bool floatDepth = false;  ///< as the target's: coarser depths would let fragments coincide

    bool operator==(const SurfaceFormat& other) const
    {
        return fitsTargetOf(other) && colour == other.colour;
    }
    /// The same but for the colour, which the plan chooses.
    bool fitsTargetOf(const SurfaceFormat& other) const
    {
        return width == other.width && height == other.height && floatDepth == other.floatDepth;
    }
};

class Surfaces {
public:
    /// Creates all three. Where the driver cannot draw to them it warns, and isUsable() is false.
    Surfaces(DevicePtr device, const SurfaceFormat& format);

    const SurfaceFormat& format() const { return format_; }
    bool isUsable() const { return usable_; }
    /// surface: not the target.
    GLuint framebuffer(Surface surface) const { return of(surface).framebuffer.name(); }
    GLuint texture(Surface surface) const { return of(surface).texture.name(); }

private:
    struct One {
        Object texture, framebuffer;
    };
    void createDepth();
    void allocate() const;
    bool create(One& one, const std::string& name);
    const One& of(Surface surface) const;

    DevicePtr device_;
    SurfaceFormat format_;
    One accumulation_, scratch_, sum_;
    Object depth_;
    bool usable_ = false;
};

}  // namespace fbrdf::gl
