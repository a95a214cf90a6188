#include "RoundingProbe.h"

#include "Blending.h"
#include "CubePainter.h"
#include "MeshResources.h"
#include "ProbeTarget.h"
#include "ReadGuard.h"
#include "UploadGuard.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace fbrdf::gl {
namespace {

constexpr int kSide = 64;  // rounding_probe.frag

/// A format as it is drawn to and read back.
struct ProbedFormat {
    ColourFormat format;
    GLint internal;
    GLenum type;
    double steps;  ///< of 1; 0: floats, whose last place is 2^-10 of the value
};

constexpr ProbedFormat kBytes{ColourFormat::rgba8, GL_RGBA8, GL_UNSIGNED_BYTE, 255.0},
    kHalves{ColourFormat::rgba16f, GL_RGBA16F, GL_FLOAT, 0.0},
    kWords{ColourFormat::rgba16, GL_RGBA16, GL_UNSIGNED_SHORT, 65535.0};

/// The values of rounding_probe.frag.
struct ValueRamp {
    double first, extent;
    double at(size_t pixel, size_t channel) const
    {
        return first + extent * 511.0 * static_cast<double>(4 * pixel + channel + 1) / 0x1p23;
    }
};

using Pixels = std::vector<double>;  ///< RGBA, row by row

template <class T>
Pixels readAs(const Functions& gl, GLenum type, double steps)
{
    std::vector<T> texels(4 * kSide * kSide);
    gl.ReadPixels(0, 0, kSide, kSide, GL_RGBA, type, texels.data());
    Pixels pixels;
    for (const T texel : texels) pixels.push_back(static_cast<double>(texel) / steps);
    return pixels;
}

class RoundingProbe {
public:
    RoundingProbe(const DevicePtr& device, StateGuard& state, const MeshResources& triangle,
                  const ProbedFormat& format)
        : device_(device),
          gl_(device->gl),
          triangle_(triangle),
          format_(format),
          probed_(device, state, kSide, format.internal, format.type, "rounding")
    {
        probed_.use(roundingProbeFragmentSource(device->capabilities.glsl));
    }

    StoreRounding measured()
    {
        constexpr ValueRamp kWhole{0.0, 1.0}, kHalf{0.0, 0.5}, kRest{0.25, 0.25},
            kTiny{0.0, 0x1p-14};
        StoreRounding rounding;
        const Pixels black(4 * kSide * kSide, 0.0);
        const auto one = [](double, double value) { return value; };
        rounding.write = worst(black, kWhole, Blend::replace, one);
        // What is blended with is what was stored before, whatever that was rounded by.
        const Pixels half = drawn(kHalf, Blend::replace);
        rounding.blend = worst(half, kRest, Blend::add, std::plus<>());
        const Pixels whole = drawn(kWhole, Blend::replace);
        rounding.blend =
            std::max(rounding.blend, worst(whole, kRest, Blend::multiply, std::multiplies<>()));
        // Beyond the last place of what halves can express so near 0, numbers are dropped.
        const double loss = format_.steps > 0.0 ? 0.0 : largestLoss(kTiny);
        rounding.tiny = loss > 0x1p-23 ? 0x1p-14 : loss;
        return rounding;
    }

private:
    /// Throws Error(gl) where nothing was drawn.
    Pixels drawn(const ValueRamp& ramp, Blend blend) const
    {
        setBlend(gl_, blend);
        gl_.Uniform2f(probed_.uniform("fbrdfRamp"), static_cast<GLfloat>(ramp.first),
                      static_cast<GLfloat>(ramp.extent));
        triangle_.draw(0);
        Pixels pixels =
            format_.type == GL_UNSIGNED_BYTE    ? readAs<GLubyte>(gl_, format_.type, format_.steps)
            : format_.type == GL_UNSIGNED_SHORT ? readAs<GLushort>(gl_, format_.type, format_.steps)
                                                : readAs<GLfloat>(gl_, format_.type, 1.0);
        checkErrors(*device_, "rounding");
        if (pixels.back() != 1.0)
            throw Error(ErrorKind::gl, "rounding", Found("nothing drawn").expected("pixels"));
        return pixels;
    }

    /// The largest error of what is stored, in the last place. exact: of what was there before and
    /// of what is drawn.
    template <class Exact>
    double worst(const Pixels& before, const ValueRamp& ramp, Blend blend, const Exact& exact) const
    {
        const Pixels after = drawn(ramp, blend);
        double worst = 0.0;
        for (size_t i = 0; i < after.size(); ++i) {
            if (i % 4 == 3) continue;
            const double value = exact(before[i], ramp.at(i / 4, i % 4));
            // Below the smallest normal half the error is absolute: StoreRounding::tiny.
            if (format_.steps == 0.0 && value < 0x1p-14) continue;
            const double unit = format_.steps > 0.0 ? 1.0 / format_.steps : 0x1p-10 * value;
            worst = std::max(worst, std::abs(after[i] - value) / unit);
        }
        return worst;
    }

    /// The largest absolute error of what is stored.
    double largestLoss(const ValueRamp& ramp) const
    {
        const Pixels after = drawn(ramp, Blend::replace);
        double largest = 0.0;
        for (size_t i = 0; i < after.size(); ++i)
            if (i % 4 != 3) largest = std::max(largest, std::abs(after[i] - ramp.at(i / 4, i % 4)));
        return largest;
    }

    const DevicePtr& device_;
    const Functions& gl_;
    const MeshResources& triangle_;
    ProbedFormat format_;
    ProbeTarget probed_;
};

StoreRounding measuredRounding(const DevicePtr& device, const ProbedFormat& format)
{
    const MeshResources triangle(device, coveringTriangle());
    const UploadGuard upload(*device);
    const ReadGuard reading(*device);
    StateGuard state(*device);
    const MeshBinding binding(triangle);
    StoreRounding rounding = RoundingProbe(device, state, triangle, format).measured();
    // Values fall on 4096 places between two halves: the worst may lie between two of them.
    constexpr double kBetween = 1.001;
    rounding.write *= kBetween;
    rounding.blend *= kBetween;
    return rounding;
}

StoreRoundings measuredRoundings(const DevicePtr& device)
{
    StoreRoundings roundings{};
    const Capabilities& c = device->capabilities;
    if (!c.framebufferObjects) return roundings;
    const std::pair<ProbedFormat, bool> formats[] = {
        {kBytes, true}, {kHalves, c.halfTargets || c.floatTargets}, {kWords, c.unorm16Targets}};
    for (const auto& [format, exists] : formats) {
        if (!exists) continue;
        try {
            roundings[static_cast<size_t>(format.format)] = measuredRounding(device, format);
        } catch (const Error&) {
            // What OpenGL grants is true of every context, so nothing has to be reported.
            discardErrors(*device);
        }
    }
    return roundings;
}

}  // namespace

const StoreRoundings& storeRoundings(const DevicePtr& device)
{
    if (!device->roundings) {
        if (const std::optional<StoreRounding>& known = device->capabilities.rounding) {
            device->roundings.emplace();
            device->roundings->fill(*known);
        } else {
            device->roundings = measuredRoundings(device);
        }
    }
    return *device->roundings;
}

}  // namespace fbrdf::gl
