// PackedParameters.h - many materials of one layout in one program: the maps of table k are the
// layers of an array fbrdfTable<k> (sampler2DArray), layer m of material m, and what are uniforms
// in a program of one material lies in fbrdfParameters (samplerBuffer, RGB of RGBA32F):
//   texture table   lower, extent (TextureImage)
//   uniform table   its knots, decoded
//   term            its scale
// Instances: fbrdfInstances (samplerBuffer), four texels each, see surface.vert.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/Capabilities.h>

#include <string>
#include <vector>

namespace fbrdf {

/// Texels of one material in fbrdfParameters; material m begins at m x stride.
struct ParameterLayout {
    std::vector<int> tables;  ///< first texel of each table
    int scales = 0;           ///< first texel of the scales
    int stride = 0;
};
ParameterLayout parameterLayout(const Form& form);

/// True where both can be layers of the same arrays: equal but for texels, ranges, scales, names.
bool sameLayout(const Material& a, const Material& b);

/// Why materials of the form cannot be packed here; empty where they can.
std::string whyNotPacked(const Form& form, const Capabilities& capabilities);

}  // namespace fbrdf
