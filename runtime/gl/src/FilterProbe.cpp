#include "FilterProbe.h"

#include "CubePainter.h"
#include "MeshResources.h"
#include "ProbeTarget.h"
#include "ReadGuard.h"
#include "TextureUpload.h"
#include "UploadGuard.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::gl {
namespace {

// Weights of 8 bits (what Direct3D 10 asks for) that are cut off instead of rounded, and values
// rounded to half floats.
constexpr FilterPrecision kCoarsest{0x1p-8, 0x1p-11};
// The ramp is looked up at 1021 places, so its largest error may lie between two of them.
constexpr double kBetweenPlaces = 1.03;
// The range of the second ramp: what then remains of the error does not depend on the weights.
constexpr float kLow = 0.5f, kHigh = 0.5f + 0.015625f;

ProbedTexture kindOf(GLenum target)
{
    switch (target) {
        case GL_TEXTURE_3D: return ProbedTexture::volume;
        case GL_TEXTURE_CUBE_MAP: return ProbedTexture::cube;
        case GL_TEXTURE_2D_ARRAY: return ProbedTexture::array;
        default: return ProbedTexture::plane;
    }
}

/// Two texels along each axis; red rises along x, green along y, blue along z.
struct Ramp {
    TextureImage image;
    double low, high;  ///< the values of the texels as the type stores them
};

Ramp rampOf(TexelType type, GLenum target, float low, float high)
{
    const auto stored = [type](float value) {
        if (type == TexelType::half) return static_cast<unsigned>(halfFromFloat(value));
        return static_cast<unsigned>(std::lround(value * 65535.0f));
    };
    const auto valueOf = [&](float value) {
        return type == TexelType::unorm16 ? stored(value) / 65535.0 : static_cast<double>(value);
    };
    Ramp ramp{{}, valueOf(low), valueOf(high)};
    ramp.image.type = type;
    const int depth = target == GL_TEXTURE_3D ? 2 : 1,
              faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
    ramp.image.size = {2, 2, depth * faces};
    for (int i = 0; i < 4 * depth * faces; ++i) {
        const int x = i & 1, y = i >> 1 & 1, z = depth == 2 ? i >> 2 & 1 : x;
        for (const int step : {x, y, z}) {
            const float value = step ? high : low;
            if (type == TexelType::float32)
                ramp.image.floats.push_back(value);
            else
                ramp.image.words.push_back(static_cast<uint16_t>(stored(value)));
        }
    }
    return ramp;
}

/// A target of one pixel, a program and a texture.
class Probe {
public:
    Probe(const DevicePtr& device, StateGuard& guard, TexelType type, GLenum target)
        : device_(device),
          gl_(device->gl),
          state_(guard),
          type_(type),
          target_(target),
          probed_(device, guard, 1, GL_RGBA8, GL_UNSIGNED_BYTE, "filter")
    {
        probed_.use(filterProbeFragmentSource(device->capabilities.glsl, kindOf(target)));
        gl_.Uniform1i(probed_.uniform("fbrdfMap"), device->firstTextureUnit);
    }

    double largestError(const MeshResources& triangle, float low, float high)
    {
        const Ramp ramp = rampOf(type_, target_, low, high);
        const Object texture = createObject(device_, ObjectKind::texture);
        state_.bindTexture(0, target_, texture.name());
        setSampling(gl_, target_, true);
        if (target_ == GL_TEXTURE_2D_ARRAY)
            gl_.TexImage3D(target_, 0, formatOf(type_, gl_).internal, 2, 2, 1, 0, GL_RGB,
                           formatOf(type_, gl_).type, texelsOf(ramp.image));
        else
            upload(gl_, target_, ramp.image);
        gl_.Uniform2f(probed_.uniform("fbrdfRamp"), static_cast<GLfloat>(ramp.low),
                      static_cast<GLfloat>(ramp.high));
        triangle.draw(0);
        return read();
    }

private:
    /// Throws Error(gl) where nothing was drawn or what was drawn is no number.
    double read() const
    {
        std::array<GLubyte, 4> pixel{};
        gl_.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        if (pixel[2] != 255)
            throw Error(ErrorKind::gl, "filter", Found("nothing drawn").expected("a pixel"));
        const double bytes = pixel[0] + pixel[1] / 255.0;
        return std::exp2(-32.0 * bytes / 255.0);
    }

    const DevicePtr& device_;
    const Functions& gl_;
    StateGuard& state_;
    TexelType type_;
    GLenum target_;
    ProbeTarget probed_;
};

FilterPrecision measured(const DevicePtr& device, TexelType type, GLenum target)
{
    const MeshResources triangle(device, coveringTriangle());
    const UploadGuard upload(*device);
    const ReadGuard reading(*device);
    StateGuard state(*device);
    const MeshBinding binding(triangle);
    Probe probe(device, state, type, target);
    const double weight = kBetweenPlaces * probe.largestError(triangle, 0.0f, 1.0f);
    // Of the small ramp's error the weights explain a 64th of theirs; the rest is rounding.
    const double rest =
        kBetweenPlaces * probe.largestError(triangle, kLow, kHigh) - weight * double(kHigh - kLow);
    checkErrors(*device, "filter");
    return {weight, std::max(0.0, rest) / (type == TexelType::unorm16 ? 1.0 : double(kLow))};
}

}  // namespace

FilterPrecision filterPrecision(const DevicePtr& device, TexelType type, GLenum target)
{
    if (device->capabilities.filter) return *device->capabilities.filter;
    const auto known = device->filters.find({type, target});
    if (known != device->filters.end()) return known->second;
    try {
        if (!device->capabilities.framebufferObjects)
            throw Error(ErrorKind::gl, "filter", Found("no framebuffer objects").expected("them"));
        return device->filters[{type, target}] = measured(device, type, target);
    } catch (const Error& error) {
        // Not kept: what failed once, for want of memory perhaps, is tried for the next material.
        device->whyFilterAssumed = error.what();
        discardErrors(*device);
    }
    return kCoarsest;
}

}  // namespace fbrdf::gl
