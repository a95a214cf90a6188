// TextureImage.h - a table as the texels of a texture. A filter may round what it mixes to as many
// bits as the texels have (llvmpipe does so with 8), so 8-bit tables become 16-bit ones, which
// represent them exactly (unorm16Of, Table.h), or floats where a CPU samples.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>
#include <fbrdf/brdf/Table.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <array>
#include <cstdint>
#include <vector>

namespace fbrdf {

enum class TexelType { unorm16, half, float32 };

struct TextureImage {
    /// Width, height, depth. Depth > 1 means a 3D texture, or the six faces of a cube where
    /// encoding.lookUp is LookUp::cube.
    std::array<int, 3> size{1, 1, 1};
    TexelType type = TexelType::unorm16;
    /// RGB, x fastest: 16-bit words (unorm16, half), or floats in `floats` (float32).
    std::vector<uint16_t> words;
    std::vector<float> floats;
    TableEncoding encoding;
    Vec3f lower{0.0f}, extent{1.0f};  ///< where encoding.ranged
    double error = 0.0;  ///< |log2| error of a recombined map, the rounding of its texels included
    double contrast = 0.0;   ///< of the table or the map, see there
    double magnitude = 0.0;  ///< the largest |texel|, times the extent where ranged
};

/// By how much a filter may change a value of the image, in the unit of its table (log2 F, or F).
double filterError(const TextureImage& image, const FilterPrecision& filter);

/// Without float textures, half and float tables become 16-bit ones over their range.
TextureImage textureImage(const Table& table, const Capabilities& capabilities);

/// The texels of a recombined map: floats where a CPU samples, else 16 bits over its range, or
/// halves where the context has no 16-bit textures.
TextureImage textureImage(const DirectionMap& map, const Capabilities& capabilities);

/// The decoded knots of a uniform table, one RGB triple each.
std::vector<Vec3f> uniformKnots(const Table& table);

}  // namespace fbrdf
