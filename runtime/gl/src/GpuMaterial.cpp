#include "GpuMaterial.h"

#include "UploadGuard.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

struct Format {
    GLint internal;
    GLenum type;
};

Format formatOf(TexelType type)
{
    switch (type) {
        case TexelType::unorm16: return {GL_RGB16, GL_UNSIGNED_SHORT};
        case TexelType::half: return {GL_RGB16F, GL_HALF_FLOAT};
        case TexelType::float32: return {GL_RGBA32F, GL_FLOAT};
    }
    return {};
}

void checkSize(const Capabilities& c, const Table& table, const TextureImage& image, bool volume)
{
    const int limit = volume ? c.max3dTextureSize : c.maxTextureSize;
    const int largest = *std::max_element(image.size.begin(), image.size.end());
    if (largest > limit)
        throw Error(ErrorKind::gl, "table '" + table.name + "'",
                    "found " + std::to_string(largest) + " texels on a side, expected at most " +
                        std::to_string(limit));
}

/// Linear filtering between texel centres, nothing beyond the border, one level.
void setSampling(const Functions& gl, GLenum target)
{
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.TexParameteri(target, axis, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

}  // namespace

GpuMaterial::GpuMaterial(DevicePtr device, const Material& material)
    : device_(std::move(device)),
      id_(device_->nextMaterial++),
      name_(material.name.empty() ? material.form.name : material.name),
      form_(material.form),
      scales_(material.scales)
{
    validate(material, "material '" + name_ + "'");
    const UploadGuard guard(*device_);
    for (size_t i = 0; i < material.tables.size(); ++i) {
        const Table& table = material.tables[i];
        if (form_.tables[i].uniform) {
            encodings_.push_back({isLog(table.storage), false});
            tables_.emplace_back();
            tables_.back().knots = uniformKnots(table);
        } else {
            addTexture(table);
        }
    }
    checkErrors(*device_, "material '" + name_ + "'");
}

void GpuMaterial::addTexture(const Table& table)
{
    const Functions& gl = device_->gl;
    const TextureImage image = textureImage(table, device_->capabilities);
    const bool volume = dimensionCount(table.domain) == 3;
    checkSize(device_->capabilities, table, image, volume);
    GpuTable result;
    result.texture = createObject(device_, ObjectKind::texture);
    result.target = volume ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    result.lower = image.lower;
    result.extent = image.extent;
    gl.BindTexture(result.target, result.texture.name());
    setSampling(gl, result.target);
    const Format format = formatOf(image.type);
    const void* texels = image.type == TexelType::float32
                             ? static_cast<const void*>(image.floats.data())
                             : static_cast<const void*>(image.words.data());
    if (volume)
        gl.TexImage3D(GL_TEXTURE_3D, 0, format.internal, image.size[0], image.size[1],
                      image.size[2], 0, GL_RGB, format.type, texels);
    else
        gl.TexImage2D(GL_TEXTURE_2D, 0, format.internal, image.size[0], image.size[1], 0, GL_RGB,
                      format.type, texels);
    label(*device_, ObjectKind::texture, result.texture, name_ + ":" + table.name);
    encodings_.push_back(image.encoding);
    tables_.push_back(std::move(result));
}

}  // namespace fbrdf::gl
