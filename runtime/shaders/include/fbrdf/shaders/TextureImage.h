// TextureImage.h - a table as the texels of a texture. Filtering hardware may be as coarse as its
// texels (llvmpipe mixes 8-bit texels with 8-bit weights), so 8-bit tables become 16-bit ones,
// which hold them exactly (unorm16Of, Table.h), or floats where a CPU samples.
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
    std::array<int, 3> size{1, 1, 1};  ///< width, height, depth; a 3D texture where depth > 1, or
                                       ///< the six faces of a cube (encoding.lookUp)
    TexelType type = TexelType::unorm16;
    /// RGB, x fastest: 16-bit words (unorm16, half), or floats in `floats` (float32).
    std::vector<uint16_t> words;
    std::vector<float> floats;
    TableEncoding encoding;
    Vec3f lower{0.0f}, extent{1.0f};  ///< where encoding.ranged
    double error = 0.0;               ///< of a recombined map, and of its texels' rounding, |log2|
};

/// Without float textures, half and float tables become 16-bit ones over their range.
TextureImage textureImage(const Table& table, const Capabilities& capabilities);

/// A recombined map: floats where a CPU samples, else 16 bits over its range, or halves without
/// them.
TextureImage textureImage(const DirectionMap& map, const Capabilities& capabilities);

/// Knots of a uniform table, decoded: one RGB triple each.
std::vector<Vec3f> uniformKnots(const Table& table);

}  // namespace fbrdf
