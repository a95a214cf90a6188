// TextureImage.h - a table as the texels of a texture. Filtering hardware may be as coarse as its
// texels (llvmpipe mixes 8-bit texels with 8-bit weights), so 8-bit tables become 16-bit ones,
// which represent them exactly (unorm16Of, Table.h), or floats where a CPU samples.
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
};

/// Without float textures, half and float tables become 16-bit ones over their range.
TextureImage textureImage(const Table& table, const Capabilities& capabilities);

/// The texels of a recombined map: floats where a CPU samples, else 16 bits over its range, or
/// halves where the context has no 16-bit textures.
TextureImage textureImage(const DirectionMap& map, const Capabilities& capabilities);

/// The decoded knots of a uniform table, one RGB triple each.
std::vector<Vec3f> uniformKnots(const Table& table);

}  // namespace fbrdf
