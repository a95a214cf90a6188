// PackedParameters.h - many materials of one layout in one program. The maps of table k are the
// layers of an array fbrdfTable<k> (sampler2DArray), where layer m belongs to material m. The
// values that a program of one material reads from uniforms lie in fbrdfParameters (samplerBuffer,
// RGB of RGBA32F):
//   texture table   lower, extent (TextureImage)
//   uniform table   its knots, decoded
//   term            its scale
// The lobes of an environment lie in fbrdfLobeRows (samplerBuffer), packedLobeRows of them for each
// material. fbrdfInstances (samplerBuffer) has four texels an instance: the columns of its
// model-view matrix without the last row; the first column ends with the number of the material.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/plan/Lobes.h>

#include <glm/vec4.hpp>

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

/// The rows of one material in fbrdfLobeRows: those of all lobes (LobeRows.h), of which programs
/// take what their pass adds; and of bent ones one more, x and y of which are lobeBend.
std::vector<glm::vec4> packedLobeRows(const LobeTable& table);
int packedLobeStride(const LobeLayout& table);

/// True where both materials can be layers of the same arrays: they differ in texels, ranges,
/// scales, numbers of lobes and names alone.
bool sameLayout(const Material& a, const Material& b);

/// Why materials of the form cannot be packed in such a context, or "" where they can.
std::string whyNotPacked(const Form& form, const Capabilities& capabilities);

}  // namespace fbrdf
