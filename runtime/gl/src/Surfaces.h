// Surfaces.h - the accumulation, scratch and sum surfaces of one target: as large as the target,
// with one depth buffer for all. Where the target has several samples a pixel, passes draw to
// buffers with as many, and the mean of the samples is what later passes read.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

struct SurfaceFormat {
    int width = 0, height = 0;
    ColourFormat colour = ColourFormat::rgba32f;
    bool floatDepth = false;  ///< as the target's: coarser depths would let fragments coincide
    int samples = 1;          ///< of a pixel of the target

    bool operator==(const SurfaceFormat& other) const
    {
        return fitsTargetOf(other) && colour == other.colour;
    }
    /// The same but for the colour, which the plan chooses.
    bool fitsTargetOf(const SurfaceFormat& other) const
    {
        return width == other.width && height == other.height && floatDepth == other.floatDepth &&
               samples == other.samples;
    }
};

class Surfaces {
public:
    /// Creates all three. Where the driver cannot draw to them it warns, and isUsable() is false.
    Surfaces(DevicePtr device, const SurfaceFormat& format);

    const SurfaceFormat& format() const { return format_; }
    bool isUsable() const { return usable_; }
    /// What passes draw to. surface: not the target.
    GLuint framebuffer(Surface surface) const
    {
        const One& one = of(surface);
        return (isMultisampled() ? one.drawn : one.framebuffer).name();
    }
    bool isMultisampled() const { return format_.samples > 1; }
    /// Brings the mean of the samples into the texture; leaves framebuffers bound. Expects no
    /// scissor.
    void resolve(Surface surface) const;
    GLuint texture(Surface surface) const { return of(surface).texture.name(); }

private:
    struct One {
        Object texture, framebuffer;
        Object buffer, drawn;  ///< of several samples: a renderbuffer and its framebuffer
    };
    void refuse() const;
    void createDepth();
    void storage(GLenum internal) const;
    void allocate() const;
    bool createSamples(One& one, const std::string& name);
    bool create(One& one, const std::string& name);
    const One& of(Surface surface) const;

    DevicePtr device_;
    SurfaceFormat format_;
    One accumulation_, scratch_, sum_;
    Object depth_;
    bool usable_ = false;
};

}  // namespace fbrdf::gl
