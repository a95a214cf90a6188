// TextureUpload.h - how the texels of an image become a texture of GL.
#pragma once
#include "Functions.h"

#include <fbrdf/shaders/TextureImage.h>

namespace fbrdf::gl {

struct UploadFormat {
    GLint internal;
    GLenum type;
};
UploadFormat formatOf(TexelType type, const Functions& gl);
const void* texelsOf(const TextureImage& image);

/// Sets filtering between texel centres, or none, clamping at the border, and a single level.
void setSampling(const Functions& gl, GLenum target, bool linear);
/// Fills the texture that is bound to the target. Expects the state that UploadGuard sets.
void upload(const Functions& gl, GLenum target, const TextureImage& image);

}  // namespace fbrdf::gl
