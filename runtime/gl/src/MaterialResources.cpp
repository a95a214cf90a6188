#include "MaterialResources.h"

#include "FilterProbe.h"
#include "TextureUpload.h"
#include "UploadGuard.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/PackedParameters.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::gl {
namespace {

/// GLSL ES 1.00 cannot index uniforms by a value that varies: there knots become a texture, which
/// costs one more look-up.
Form drawnForm(Form form, const Capabilities& capabilities)
{
    for (TableSpec& table : form.tables)
        if (capabilities.glsl == 100) table.uniform = false;
    return form;
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
      scales_(material.scales),
      lobes_(material)
{
    // Validated before the first upload, so that a refusal leaves nothing behind.
    validate(material, "material '" + name_ + "'");
    validate(material.lobes, "material '" + name_ + "'");
    raisePeaks(material);
    std::vector<TextureImage> images(material.tables.size());
    for (size_t i = 0; i < images.size(); ++i) {
        if (form_.tables[i].uniform) continue;
        images[i] = imageOf(material.tables[i], static_cast<int>(i), options);
        // Recombined texels may exceed those of the table by as much as the error.
        peaks_.tables[i] *= std::exp2(images[i].error);
        raiseFilterError(i, images[i], targetOf(material.tables[i], images[i]));
    }
    setLookUpError(images);
    const UploadGuard guard(*device_);
    for (size_t i = 0; i < images.size(); ++i) {
        const Table& table = material.tables[i];
        if (!form_.tables[i].uniform) {
            addTexture(table, images[i]);
            continue;
        }
        encodings_.push_back({isLog(table.storage), false});
        tables_.emplace_back();
        tables_.back().knots = uniformKnots(table);
    }
    checkErrors(*device_, "material '" + name_ + "'");
}

TextureImage MaterialResources::imageOf(const Table& table, int index,
                                        const MaterialOptions& options)
{
    const Capabilities& c = device_->capabilities;
    const auto filtered = [&options](TextureImage image) {
        image.encoding.precise = options.precise;
        return image;
    };
    // Recombining would only add an error to a map that is what was asked for.
    const bool asAsked =
        options.lookUp == LookUp::parabolic && options.mapSize == 0 && isParabolic(table);
    if (options.lookUp == LookUp::native || asAsked) return filtered(textureImage(table, c));
    const std::string why =
        options.precise && options.lookUp == LookUp::cube
            ? "a shader that filters by itself does not know the edges of a cube"
            : fbrdf::whyNotRecombined(form_, index, table.storage);
    if (why.empty())
        return filtered(textureImage(
            recombined(table, {options.lookUp, options.mapSize,
                               options.lookUp == LookUp::cube ? c.maxCubeSize : c.maxTextureSize,
                               c.seamlessCubes}),
            c));
    if (whyNotRecombined_.find(why) == std::string::npos)
        whyNotRecombined_ += (whyNotRecombined_.empty() ? "" : "; ") + why;
    return filtered(textureImage(table, c));
}

void MaterialResources::raisePeaks(const Material& material)
{
    const Peaks found = peaksOf(material);
    const auto raise = [](std::vector<double>& peaks, const std::vector<double>& values) {
        peaks.resize(values.size(), 0.0);
        for (size_t i = 0; i < values.size(); ++i) peaks[i] = std::max(peaks[i], values[i]);
    };
    exponent_ = std::max(exponent_, largestExponent(material));
    raise(peaks_.tables, found.tables);
    raise(peaks_.scales, found.scales);
}

/// The error of a product is at most the sum of its factors'; that of a sum of positive products is
/// at most the largest of theirs.
void MaterialResources::setLookUpError(const std::vector<TextureImage>& images)
{
    for (const Term& term : form_.terms) {
        double sum = 0.0;
        for (const Factor& factor : term.factors)
            sum += images[static_cast<size_t>(factor.table)].error;
        lookUpError_ = std::max(lookUpError_, sum);
    }
}

/// A packed table has the largest error of its layers.
void MaterialResources::raiseFilterError(size_t table, const TextureImage& image, GLenum target)
{
    filterErrors_.resize(form_.tables.size(), 0.0);
    if (image.encoding.precise) return;
    filterErrors_[table] =
        std::max(filterErrors_[table],
                 fbrdf::filterError(image, filterPrecision(device_, image.type, target)));
}

bool MaterialResources::isAnisotropic() const
{
    return !isIsotropic(form_) || lobes_.areBent() ||
           (packedLobes_.lobes > 0 && packedLobes_.axes == LobeAxes::bent);
}

Filter MaterialResources::filter() const
{
    const bool precise = std::any_of(encodings_.begin(), encodings_.end(),
                                     [](const TableEncoding& e) { return e.precise; });
    return precise ? Filter::shader : Filter::hardware;
}

MapErrors MaterialResources::mapErrors(double irradiance) const
{
    MapErrors errors{lookUpError_, 0.0, 0.0, exponent_};
    if (filterErrors_.empty()) return errors;
    double radiance = 0.0;
    for (size_t t = 0; t < form_.terms.size(); ++t) {
        // Logs add up; where values multiply, the product moves by at most
        // prod(peak + error) - prod(peak).
        double logs = 0.0, exact = peaks_.scales[t], moved = exact;
        bool multiplies = false;
        for (const Factor& factor : form_.terms[t].factors) {
            const auto k = static_cast<size_t>(factor.table);
            const bool isLog = encodings_[k].logarithmic;
            if (isLog) logs += filterErrors_[k];
            multiplies = multiplies || !isLog;
            exact *= peaks_.tables[k];
            moved *= peaks_.tables[k] + (isLog ? 0.0 : filterErrors_[k]);
        }
        errors.filtering = std::max(errors.filtering, logs);
        if (multiplies) radiance += std::isfinite(moved) ? moved - exact : moved;
    }
    // Neither factor need be finite, and 0 times infinity would be no number.
    if (radiance > 0.0 && irradiance > 0.0) errors.absolute = radiance * irradiance;
    return errors;
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
    setSampling(gl, result.target, !image.encoding.precise);
    upload(gl, result.target, image);
    label(*device_, ObjectKind::texture, result.texture, name_ + ":" + table.name);
    encodings_.push_back(image.encoding);
    tables_.push_back(std::move(result));
}

MaterialResources::MaterialResources(DevicePtr device, const std::vector<const Material*>& layers,
                                     bool precise)
    : device_(std::move(device)),
      id_(device_->nextMaterial++),
      name_("library of " + layers.front()->form.name),
      form_(layers.front()->form),
      hasSigns_(fbrdf::hasSigns(*layers.front())),
      packed_(layers.size() * static_cast<size_t>(parameterLayout(form_).stride)),
      parameters_(device_, GL_RGBA32F, "material parameters"),
      packedLobes_(layoutOf(layers.front()->lobes)),
      packedRows_(layers.size() * static_cast<size_t>(packedLobeStride(packedLobes_))),
      lobeRows_(device_, GL_RGBA32F, "lobes")
{
    FBRDF_ASSERT(parameterLayout(form_).stride, >, 0);
    measureFilters(*layers.front());
    const UploadGuard guard(*device_);
    for (const Table& table : layers.front()->tables) addArray(table, layers.size(), precise);
    for (size_t i = 0; i < layers.size(); ++i) setLayer(i, *layers[i]);
    uploadParameters();
    checkErrors(*device_, name_);
}

/// Measures before the upload begins, for measuring draws.
void MaterialResources::measureFilters(const Material& material) const
{
    for (size_t i = 0; i < material.tables.size(); ++i)
        if (!form_.tables[i].uniform)
            filterPrecision(device_, textureImage(material.tables[i], device_->capabilities).type,
                            GL_TEXTURE_2D_ARRAY);
}

void MaterialResources::addArray(const Table& table, size_t layers, bool precise)
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
    image.encoding.precise = precise;
    encodings_.push_back(image.encoding);
    GpuTable& made = tables_.back();
    made.texture = createObject(device_, ObjectKind::texture);
    made.target = GL_TEXTURE_2D_ARRAY;
    gl.BindTexture(made.target, made.texture.name());
    setSampling(gl, made.target, !precise);
    const UploadFormat format = formatOf(image.type, gl);
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
        TextureImage image = textureImage(table, device_->capabilities);
        image.encoding.precise = encodings_[k].precise;
        raiseFilterError(k, image, GL_TEXTURE_2D_ARRAY);
        *parameter(layout.tables[k]) = opaque(image.lower);
        *parameter(layout.tables[k] + 1) = opaque(image.extent);
        gl.BindTexture(GL_TEXTURE_2D_ARRAY, tables_[k].texture.name());
        gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, static_cast<GLint>(layer), image.size[0],
                         image.size[1], 1, GL_RGB, formatOf(image.type, gl).type, texelsOf(image));
    }
    std::transform(material.scales.begin(), material.scales.end(), parameter(layout.scales),
                   opaque);
    if (packedLobes_.lobes == 0) return;
    const std::vector<glm::vec4> rows = packedLobeRows(material.lobes);
    FBRDF_ASSERT((layer + 1) * rows.size(), <=, packedRows_.size());
    std::copy(rows.begin(), rows.end(),
              packedRows_.begin() + static_cast<std::ptrdiff_t>(layer * rows.size()));
    lobeError_ = std::max(lobeError_, material.lobes.error);
}

void MaterialResources::uploadParameters()
{
    parameters_.update(packed_.size(), packed_.size() * sizeof packed_[0], packed_.data());
    if (!packedRows_.empty())
        lobeRows_.update(packedRows_.size(), packedRows_.size() * sizeof packedRows_[0],
                         packedRows_.data());
}

void MaterialResources::replaceLayer(size_t layer, const Material& material)
{
    const UploadGuard guard(*device_);
    setLayer(layer, material);
    uploadParameters();
    checkErrors(*device_, "material '" + material.name + "'");
}

}  // namespace fbrdf::gl
