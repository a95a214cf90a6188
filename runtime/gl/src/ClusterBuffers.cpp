#include "ClusterBuffers.h"

#include "UploadGuard.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

constexpr const char* kNames[] = {"lights", "light indices", "light lists"};

}  // namespace

void ClusterBuffers::update(const LightClusters& clusters)
{
    upload(lights, GL_RGBA32F, clusters.lights.size() * kVectorsPerLight,
           clusters.lights.size() * sizeof(LightVectors), clusters.lights.data());
    upload(indices, GL_R32I, clusters.indices.size(), clusters.indices.size() * sizeof(int32_t),
           clusters.indices.data());
    upload(lists, GL_RG32I, clusters.lists.size() / 2, clusters.lists.size() * sizeof(int32_t),
           clusters.lists.data());
}

void ClusterBuffers::upload(Which which, GLenum format, size_t texels, size_t bytes,
                            const void* data)
{
    const Functions& gl = device_->gl;
    if (texels > static_cast<size_t>(device_->maxBufferTexels))
        throw Error(ErrorKind::gl, std::string("clusters: ") + kNames[which],
                    "found " + std::to_string(texels) + " texels, expected at most " +
                        std::to_string(device_->maxBufferTexels));
    One& one = buffers_[which];
    if (!one.texture) create(one, format, kNames[which]);
    gl.BindBuffer(GL_ARRAY_BUFFER, one.buffer.name());
    if (bytes > one.bytes) {
        one.bytes = std::max(bytes, 2 * one.bytes);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(one.bytes), nullptr,
                      GL_DYNAMIC_DRAW);
    }
    if (bytes > 0) gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
}

void ClusterBuffers::create(One& one, GLenum format, const char* name)
{
    const Functions& gl = device_->gl;
    const UploadGuard guard(*device_);
    one.buffer = createObject(device_, ObjectKind::buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, one.buffer.name());
    one.bytes = 4 * sizeof(glm::vec4);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(one.bytes), nullptr, GL_DYNAMIC_DRAW);
    one.texture = createObject(device_, ObjectKind::texture);
    gl.BindTexture(GL_TEXTURE_BUFFER, one.texture.name());
    gl.TexBuffer(GL_TEXTURE_BUFFER, format, one.buffer.name());
    label(*device_, ObjectKind::buffer, one.buffer, name);
    label(*device_, ObjectKind::texture, one.texture, name);
}

}  // namespace fbrdf::gl
