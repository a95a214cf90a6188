#include "TextureUpload.h"

namespace fbrdf::gl {
namespace {

constexpr GLenum kHalfFloatOes = 0x8D61;  // OES_texture_half_float: not GL_HALF_FLOAT

}  // namespace

// ES 2.0 has no sized formats, and ES stores three channels where three are uploaded.
UploadFormat formatOf(TexelType type, const Functions& gl)
{
    const bool old = gl.es != 0 && gl.es < 30;
    switch (type) {
        case TexelType::unorm16: return {GL_RGB16, GL_UNSIGNED_SHORT};
        case TexelType::half:
            return {old ? GL_RGB : GL_RGB16F, old ? kHalfFloatOes : GL_HALF_FLOAT};
        case TexelType::float32: return {old ? GL_RGB : gl.es ? GL_RGB32F : GL_RGBA32F, GL_FLOAT};
    }
    return {};
}

const void* texelsOf(const TextureImage& image)
{
    return image.type == TexelType::float32 ? static_cast<const void*>(image.floats.data())
                                            : static_cast<const void*>(image.words.data());
}

void setSampling(const Functions& gl, GLenum target, bool linear)
{
    const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    // ES 2.0 knows neither the third axis nor a largest level.
    if (!gl.hasVolumes()) return;
    gl.TexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

void upload(const Functions& gl, GLenum target, const TextureImage& image)
{
    // Formats without a size (OpenGL ES 2.0) take theirs from the type of what is uploaded.
    const UploadFormat format = formatOf(image.type, gl);
    const GLsizei width = image.size[0], height = image.size[1];
    const auto* texels = static_cast<const unsigned char*>(texelsOf(image));
    const auto upload2d = [&](GLenum face, const void* from) {
        gl.TexImage2D(face, 0, format.internal, width, height, 0, GL_RGB, format.type, from);
    };
    if (target == GL_TEXTURE_3D)
        return gl.TexImage3D(target, 0, format.internal, width, height, image.size[2], 0, GL_RGB,
                             format.type, texels);
    if (target == GL_TEXTURE_2D) return upload2d(target, texels);
    // The faces follow each other in the image in the order of GL's enumerators.
    const size_t channel = image.type == TexelType::float32 ? sizeof(float) : sizeof(uint16_t);
    for (GLenum face = 0; face < 6; ++face)
        upload2d(
            GL_TEXTURE_CUBE_MAP_POSITIVE_X + face,
            texels + face * 3 * channel * static_cast<size_t>(width) * static_cast<size_t>(height));
}

}  // namespace fbrdf::gl
