#include "BufferTexture.h"

#include "UploadGuard.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>

namespace fbrdf::gl {

void BufferTexture::update(size_t texels, size_t bytes, const void* data)
{
    reserve(texels, bytes);
    if (bytes > 0) write(0, bytes, data);
}

void BufferTexture::reserve(size_t texels, size_t bytes)
{
    const Functions& gl = device_->gl;
    const auto most = static_cast<size_t>(device_->capabilities.maxBufferTexels);
    if (texels > most)
        throw Error(
            ErrorKind::gl, name_,
            Found(std::to_string(texels) + " texels").expected("at most " + std::to_string(most)));
    FBRDF_ASSERT(device_->capabilities.bufferTextures, ==, true);
    // Made by the first use: most renderers never draw a batch or a list of lights.
    if (!texture_) create();
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    if (bytes <= bytes_) return;
    // Doubling keeps the number of reallocations small while a scene grows.
    const size_t wanted = std::max(bytes, 2 * bytes_);
    bytes_ = 0;  // until GL has given it
    discardHostErrors(*device_);
    // The texture follows: it refers to the buffer by name, not to its storage.
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(wanted), nullptr, GL_DYNAMIC_DRAW);
    checkErrors(*device_, name_);
    bytes_ = wanted;
}

void BufferTexture::create()
{
    constexpr size_t kFirstBytes = 64;
    const Functions& gl = device_->gl;
    const UploadGuard guard(*device_);
    buffer_ = createObject(device_, ObjectKind::buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    bytes_ = kFirstBytes;
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes_), nullptr, GL_DYNAMIC_DRAW);
    texture_ = createObject(device_, ObjectKind::texture);
    gl.BindTexture(GL_TEXTURE_BUFFER, texture_.name());
    // The buffer has storage by now, so that the texture has a texel to read in every case.
    gl.TexBuffer(GL_TEXTURE_BUFFER, format_, buffer_.name());
    label(*device_, ObjectKind::buffer, buffer_, name_);
    label(*device_, ObjectKind::texture, texture_, name_);
}

}  // namespace fbrdf::gl
