// Waterloo.h - the layout in which the authors of 2001 published their factor maps.
// NAME.txt has four lines: title, kind, alpha as three numbers, a gain that only their viewer used.
//   kind 0  f = alpha p(wo) q(h) p(wi)            NAME_0.png = p, NAME_1.png = q
//   kind 1  f = alpha p(wo) q(h) p(wi) + s(h)     and NAME_2.png = s
//   kind 2  f = s(h)                              NAME_0.png = s; its alpha has no effect
// Instead there may be a file `alpha` of three lines beside NAMEp.png, NAMEq.png. Alpha multiplies
// the product only: the authors' shader (Sh's SatinShader and its garnet red sibling, 2003 to 2005)
// adds the specular map afterwards, and the published kind 2 files repeat the alpha of kind 0
// beside a map that equals that of kind 1 byte for byte.
//
// Maps are 8-bit linear, parabolic, shrunk to leave a border: u = 1/2 + (7/16) x / (1 + z), and v
// likewise from y, with v = 0 at the top of the picture. All that was published is mirror-symmetric
// (|map - flipped map| averages below 0.0007), so the sense of y cannot be seen in it; this reads
// the formula as it stands: the first row is y = -8/7.
// NAME_0_0.png ... NAME_0_5.png are cube faces of NAME_0.png in OpenGL's order (+x, -x, +y, -y, +z,
// -z) and orientation. They are written but not read: the parabolic maps contain all of it.
// Reference: McCool, Ang, Ahmad 2001, "Homomorphic Factorization of BRDFs for High-Performance
// Rendering".
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// Domain of a published map of size x size texels.
inline DiscDomain waterlooDomain(int size)
{
    return {size, 1.0, 0.4375 * size};
}

/// In the smallest map the border of 1/16 is half a texel wide: in a smaller one filtering would
/// read outside.
constexpr int kMinWaterlooSize = 8;

/// A description is four short lines; what is longer is something else.
constexpr size_t kMaxWaterlooDescription = 4096;

/// True for the bytes of a description. `beginning`: the file's first bytes, at least
/// kMaxWaterlooDescription + 1 of them where it is longer.
bool looksLikeWaterloo(const std::string& beginning);

/// True for a folder with a description in it.
bool holdsWaterloo(const std::string& folder);

/// Reads NAME.txt, `alpha`, or a folder with exactly one of them in it. Throws Error(input).
Material readWaterloo(const std::string& path);

/// Writes NAME.txt, the parabolic maps and their cube faces. Maps in another domain are resampled
/// to at least 64 x 64 texels. Throws Error(usage) for a form or a specular map that the layout
/// cannot represent, and Error(output).
void writeWaterloo(const Material& material, const std::string& path);

}  // namespace fbrdf
