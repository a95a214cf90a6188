#include "EnvironmentFormat.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

constexpr int kUsualSize = 512, kSoftwareSize = 256;

bool isPowerOfTwo(int value)
{
    return value > 0 && (value & (value - 1)) == 0;
}

}  // namespace

EnvironmentFormat environmentFormat(const Device& device, const EnvironmentOptions& options)
{
    const Capabilities& c = device.capabilities;
    const int usual = std::min(c.softwareSampling ? kSoftwareSize : kUsualSize, c.maxCubeSize);
    const EnvironmentFormat format{options.size == 0 ? usual : options.size, options.floats,
                                   options.unfiltered, options.gradual};
    if (!isPowerOfTwo(format.size) || format.size < kSmallestFace)
        throw Error(ErrorKind::usage, "environment",
                    Found(std::to_string(format.size) + " texels on a side of a face")
                        .expected("a power of two from " + std::to_string(kSmallestFace) + " on"));
    if (format.size > c.maxCubeSize)
        throw Error(ErrorKind::gl, "environment",
                    Found(std::to_string(format.size) + " texels on a side of a face")
                        .expected("at most " + std::to_string(c.maxCubeSize)));
    if ((options.floats || options.unfiltered) && device.gl.es != 0 &&
        !device.gl.hasExtension("GL_OES_texture_float_linear"))
        throw Error(ErrorKind::gl, "environment",
                    Found("float textures that are not filtered").expected("filtered ones"));
    if (device.gl.es != 0 && device.gl.es < 30)
        throw Error(ErrorKind::gl, "environment", Found("OpenGL ES 2.0").expected("3.0 or newer"));
    if (!c.floatTextures)
        throw Error(ErrorKind::gl, "environment",
                    Found("a context without half float textures").expected("them"));
    return format;
}

}  // namespace fbrdf::gl
