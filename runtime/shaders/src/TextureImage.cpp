#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/shaders/TextureImage.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr float kWords = 65535.0f;

/// RGB of every texel; a table of one channel gives it three times.
template <class Convert>
auto converted(const Table& table, Convert convert)
{
    const int count = texelCount(table.domain);
    std::vector<decltype(convert(0, 0))> result;
    result.reserve(3 * static_cast<size_t>(count));
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c) result.push_back(convert(i, c));
    return result;
}

void setRange(TextureImage& image, const Table& table)
{
    Vec3f upper(table.texel(0, 0));
    for (int c = 0; c < 3; ++c) {
        image.lower[c] = upper[c] = table.texel(0, c);
        for (int i = 1; i < texelCount(table.domain); ++i) {
            image.lower[c] = std::min(image.lower[c], table.texel(i, c));
            upper[c] = std::max(upper[c], table.texel(i, c));
        }
    }
    image.extent = upper - image.lower;
}

void encodeUnorm16(TextureImage& image, const Table& table)
{
    const auto last = [&table](int c) { return table.channels == 1 ? 0 : c; };
    for (int c = 0; c < 3; ++c) {
        image.lower[c] = table.lower[last(c)];
        image.extent[c] = table.upper[last(c)] - table.lower[last(c)];
    }
    image.encoding.ranged = image.lower != Vec3f(0.0f) || image.extent != Vec3f(1.0f);
    image.words = converted(
        table, [&](int i, int c) { return static_cast<uint16_t>(unorm16Of(table, i, last(c))); });
}

void encodeOverRange(TextureImage& image, const Table& table)
{
    setRange(image, table);
    image.encoding.ranged = true;
    image.words = converted(table, [&](int i, int c) {
        const float extent = image.extent[c];
        const float unit = extent > 0.0f ? (table.texel(i, c) - image.lower[c]) / extent : 0.0f;
        return static_cast<uint16_t>(std::lround(std::clamp(unit, 0.0f, 1.0f) * kWords));
    });
}

void encodeHalf(TextureImage& image, const Table& table)
{
    image.type = TexelType::half;
    image.words = converted(table, [&](int i, int c) { return halfFromFloat(table.texel(i, c)); });
}

void setMagnitude(TextureImage& image, const Table& table)
{
    image.magnitude =
        static_cast<double>(std::max({image.extent.x, image.extent.y, image.extent.z}));
    if (image.type == TexelType::unorm16) return;
    image.magnitude = 0.0;
    for (const float texel : table.texels)
        image.magnitude = std::max(image.magnitude, static_cast<double>(std::abs(texel)));
}

void encodeFloat(TextureImage& image, const Table& table)
{
    image.type = TexelType::float32;
    image.floats = converted(table, [&](int i, int c) { return table.texel(i, c); });
}

}  // namespace

TextureImage textureImage(const Table& table, const Capabilities& capabilities)
{
    TextureImage image;
    image.size = domainSize(table.domain);
    image.encoding.logarithmic = isLog(table.storage);
    if (capabilities.softwareSampling && capabilities.floatTextures) {
        encodeFloat(image, table);
    } else if (capabilities.unorm16Textures &&
               (table.storage == Storage::log8 || table.storage == Storage::linear8)) {
        encodeUnorm16(image, table);
    } else if (!capabilities.floatTextures) {
        encodeOverRange(image, table);
    } else if (bytesPerChannel(table.storage) <= 2 || !capabilities.unorm16Textures) {
        encodeHalf(image, table);
    } else {
        encodeFloat(image, table);
    }
    image.contrast = contrast(table);
    setMagnitude(image, table);
    return image;
}

TextureImage textureImage(const DirectionMap& map, const Capabilities& capabilities)
{
    TextureImage image;
    image.size = domainSize(map.table.domain);
    image.encoding.lookUp = map.lookUp;
    image.encoding.mapSize = map.size();
    image.error = map.error;
    if (capabilities.softwareSampling && capabilities.floatTextures) {
        encodeFloat(image, map.table);
    } else if (capabilities.unorm16Textures || !capabilities.floatTextures) {
        encodeOverRange(image, map.table);
        image.error +=
            double(std::max({image.extent.x, image.extent.y, image.extent.z})) / double(kWords) / 2;
    } else {
        encodeHalf(image, map.table);
    }
    image.contrast = contrast(map);
    setMagnitude(image, map.table);
    if (image.type == TexelType::half) image.error += image.magnitude * 0x1p-11;
    return image;
}

double filterError(const TextureImage& image, const FilterPrecision& filter)
{
    return filter.weight * image.contrast + filter.rounding * image.magnitude;
}

std::vector<Vec3f> uniformKnots(const Table& table)
{
    FBRDF_ASSERT(dimensionCount(table.domain), ==, 1);
    std::vector<Vec3f> knots;
    for (int i = 0; i < texelCount(table.domain); ++i)
        knots.emplace_back(table.texel(i, 0), table.texel(i, 1), table.texel(i, 2));
    return knots;
}

}  // namespace fbrdf
