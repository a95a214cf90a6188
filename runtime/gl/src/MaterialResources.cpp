#include "MaterialResources.h"

#include "UploadGuard.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/PackedParameters.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::gl {
namespace {

struct Format {
    GLint internal;
    GLenum type;
};

constexpr GLenum kHalfFloatOes = 0x8D61;  // OES_texture_half_float: not GL_HALF_FLOAT

/// ES 2.0 has no sized formats, and ES stores three channels where three are uploaded.
Format formatOf(TexelType type, const Functions& gl)
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

/// GLSL ES 1.00 cannot index uniforms by a value that varies: there knots become a texture, which
/// costs one more look-up.
Form drawnForm(Form form, const Capabilities& capabilities)
{
    for (TableSpec& table : form.tables)
        if (capabilities.glsl == 100) table.uniform = false;
    return form;
}

const void* texelsOf(const TextureImage& image)
{
    return image.type == TexelType::float32 ? static_cast<const void*>(image.floats.data())
                                            : static_cast<const void*>(image.words.data());
}

GLenum targetOf(const Table& table, const TextureImage& image)
{
    if (image.encoding.lookUp == LookUp::cube) return GL_TEXTURE_CUBE_MAP;
    return dimensionCount(table.domain) == 3 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
}

int largestSide(const Capabilities& c, GLenum target)
{
    if (target == GL_TEXTURE_CUBE_MAP) return c.maxCubeSize;
    return target == GL_TEXTURE_3D ? c.max3dTextureSize : c.maxTextureSize;
}

// Asked before the upload: GL would only set an error, without the limit.
void checkTexels(const Capabilities& c, const Table& table, const TextureImage& image)
{
    const GLenum target = targetOf(table, image);
    if (image.type == TexelType::unorm16 && !c.unorm16Textures)
        throw Error(ErrorKind::gl, "table '" + table.name + "'",
                    Found("neither half float nor 16-bit textures")
                        .expected("OES_texture_half_float and OES_texture_half_float_linear"));
    if (target == GL_TEXTURE_3D && c.max3dTextureSize == 0)
        throw Error(ErrorKind::gl, "table '" + table.name + "'",
                    Found("three dimensions").expected("two: OpenGL ES 2.0 has no volumes"));
    const int limit = largestSide(c, target);
    const int largest = *std::max_element(image.size.begin(), image.size.end());
    if (largest > limit)
        throw Error(ErrorKind::gl, "table '" + table.name + "'",
                    Found(std::to_string(largest) + " texels on a side")
                        .expected("at most " + std::to_string(limit)));
}

/// Sets linear filtering between texel centres, clamping at the border, and a single level.
void setSampling(const Functions& gl, GLenum target)
{
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
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
    const Format format = formatOf(image.type, gl);
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

/// A disc of gamma 1 is a parabolic map already.
bool isParabolic(const Table& table)
{
    const auto* disc = std::get_if<DiscDomain>(&table.domain);
    return disc && disc->gamma == 1.0;
}

}  // namespace

MaterialResources::MaterialResources(DevicePtr device, const Material& material,
                                     const MaterialOptions& options)
    : device_(std::move(device)),
      id_(device_->nextMaterial++),
      name_(material.name.empty() ? material.form.name : material.name),
      form_(drawnForm(material.form, device_->capabilities)),
      hasSigns_(fbrdf::hasSigns(material)),
      scales_(material.scales)
{
    // Validated before the first upload, so that a refusal leaves nothing behind.
    validate(material, "material '" + name_ + "'");
    const UploadGuard guard(*device_);
    std::vector<double> errors(material.tables.size(), 0.0);
    for (size_t i = 0; i < material.tables.size(); ++i) {
        const Table& table = material.tables[i];
        if (form_.tables[i].uniform) {
            encodings_.push_back({isLog(table.storage), false});
            tables_.emplace_back();
            tables_.back().knots = uniformKnots(table);
        } else {
            const TextureImage image = imageOf(table, static_cast<int>(i), options);
            errors[i] = image.error;
            addTexture(table, image);
        }
    }
    raisePeaks(material);
    // Recombined texels may exceed those of the table by as much as the error.
    for (size_t i = 0; i < errors.size(); ++i) peaks_.tables[i] *= std::exp2(errors[i]);
    setLookUpError(errors);
    checkErrors(*device_, "material '" + name_ + "'");
}

TextureImage MaterialResources::imageOf(const Table& table, int index,
                                        const MaterialOptions& options)
{
    const Capabilities& c = device_->capabilities;
    // Recombining would only add an error to a map that is what was asked for.
    const bool asAsked =
        options.lookUp == LookUp::parabolic && options.mapSize == 0 && isParabolic(table);
    if (options.lookUp == LookUp::native || asAsked) return textureImage(table, c);
    const std::string why = fbrdf::whyNotRecombined(form_, index, table.storage);
    if (why.empty())
        return textureImage(
            recombined(table, {options.lookUp, options.mapSize,
                               options.lookUp == LookUp::cube ? c.maxCubeSize : c.maxTextureSize,
                               c.seamlessCubes}),
            c);
    whyNotRecombined_ += (whyNotRecombined_.empty() ? "" : "; ") + why;
    return textureImage(table, c);
}

/// Filtering mixes texels, so none of its results is larger than the largest of them.
void MaterialResources::raisePeaks(const Material& material)
{
    peaks_.tables.resize(material.tables.size(), 0.0);
    peaks_.scales.resize(material.scales.size(), 0.0);
    for (size_t i = 0; i < material.tables.size(); ++i) {
        const Table& table = material.tables[i];
        const auto largest =
            static_cast<double>(*std::max_element(table.texels.begin(), table.texels.end()));
        peaks_.tables[i] =
            std::max(peaks_.tables[i], isLog(table.storage) ? std::exp2(largest) : largest);
    }
    for (size_t t = 0; t < material.scales.size(); ++t)
        for (int c = 0; c < 3; ++c)
            peaks_.scales[t] = std::max(peaks_.scales[t], double(material.scales[t][c]));
}

/// The error of a product is at most the sum of its factors'; that of a sum of positive products is
/// at most the largest of theirs.
void MaterialResources::setLookUpError(const std::vector<double>& tableErrors)
{
    for (const Term& term : form_.terms) {
        double sum = 0.0;
        for (const Factor& factor : term.factors)
            sum += tableErrors[static_cast<size_t>(factor.table)];
        lookUpError_ = std::max(lookUpError_, sum);
    }
}

void MaterialResources::addTexture(const Table& table, const TextureImage& image)
{
    const Functions& gl = device_->gl;
    // Refused by size first: some drivers report success for textures that do not exist.
    checkTexels(device_->capabilities, table, image);
    GpuTable result;
    result.texture = createObject(device_, ObjectKind::texture);
    result.target = targetOf(table, image);
    result.lower = image.lower;
    result.extent = image.extent;
    gl.BindTexture(result.target, result.texture.name());
    setSampling(gl, result.target);
    upload(gl, result.target, image);
    label(*device_, ObjectKind::texture, result.texture, name_ + ":" + table.name);
    encodings_.push_back(image.encoding);
    tables_.push_back(std::move(result));
}

MaterialResources::MaterialResources(DevicePtr device, const std::vector<const Material*>& layers)
    : device_(std::move(device)),
      id_(device_->nextMaterial++),
      name_("library of " + layers.front()->form.name),
      form_(layers.front()->form),
      hasSigns_(fbrdf::hasSigns(*layers.front())),
      packed_(layers.size() * static_cast<size_t>(parameterLayout(form_).stride)),
      parameters_(device_, GL_RGBA32F, "material parameters")
{
    FBRDF_ASSERT(parameterLayout(form_).stride, >, 0);
    const UploadGuard guard(*device_);
    for (const Table& table : layers.front()->tables) addArray(table, layers.size());
    for (size_t i = 0; i < layers.size(); ++i) setLayer(i, *layers[i]);
    uploadParameters();
    checkErrors(*device_, name_);
}

void MaterialResources::addArray(const Table& table, size_t layers)
{
    tables_.emplace_back();
    if (form_.tables[tables_.size() - 1].uniform) {
        encodings_.push_back({isLog(table.storage), false});
        return;
    }
    const Functions& gl = device_->gl;
    TextureImage image = textureImage(table, device_->capabilities);
    checkTexels(device_->capabilities, table, image);
    // One layer may span [0, 1] and the next something else: all take their range from parameters.
    image.encoding.ranged = image.type == TexelType::unorm16;
    encodings_.push_back(image.encoding);
    GpuTable& made = tables_.back();
    made.texture = createObject(device_, ObjectKind::texture);
    made.target = GL_TEXTURE_2D_ARRAY;
    gl.BindTexture(made.target, made.texture.name());
    setSampling(gl, made.target);
    const Format format = formatOf(image.type, gl);
    // Layers are filled one by one, as when a material is replaced later.
    gl.TexImage3D(made.target, 0, format.internal, image.size[0], image.size[1],
                  static_cast<GLsizei>(layers), 0, GL_RGB, format.type, nullptr);
    label(*device_, ObjectKind::texture, made.texture, name_ + ":" + table.name);
}

void MaterialResources::setLayer(size_t layer, const Material& material)
{
    FBRDF_ASSERT(material.tables.size(), ==, tables_.size());
    raisePeaks(material);
    const Functions& gl = device_->gl;
    const ParameterLayout layout = parameterLayout(form_);
    FBRDF_ASSERT((layer + 1) * static_cast<size_t>(layout.stride), <=, packed_.size());
    const auto parameter = [&](int index) {
        return packed_.begin() + static_cast<std::ptrdiff_t>(layer) * layout.stride + index;
    };
    const auto opaque = [](const Vec3f& v) { return glm::vec4(v, 1.0f); };
    for (size_t k = 0; k < tables_.size(); ++k) {
        const Table& table = material.tables[k];
        if (form_.tables[k].uniform) {
            const auto knots = uniformKnots(table);
            std::transform(knots.begin(), knots.end(), parameter(layout.tables[k]), opaque);
            continue;
        }
        const TextureImage image = textureImage(table, device_->capabilities);
        *parameter(layout.tables[k]) = opaque(image.lower);
        *parameter(layout.tables[k] + 1) = opaque(image.extent);
        gl.BindTexture(GL_TEXTURE_2D_ARRAY, tables_[k].texture.name());
        gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(layer), image.size[0],
                         image.size[1], 1, GL_RGB, formatOf(image.type, gl).type, texelsOf(image));
    }
    std::transform(material.scales.begin(), material.scales.end(), parameter(layout.scales),
                   opaque);
}

void MaterialResources::uploadParameters()
{
    parameters_.update(packed_.size(), packed_.size() * sizeof packed_[0], packed_.data());
}

void MaterialResources::replaceLayer(size_t layer, const Material& material)
{
    const UploadGuard guard(*device_);
    setLayer(layer, material);
    uploadParameters();
    checkErrors(*device_, "material '" + material.name + "'");
}

}  // namespace fbrdf::gl
