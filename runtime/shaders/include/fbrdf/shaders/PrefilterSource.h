// PrefilterSource.h - the programs that turn an environment into the cube map of Prefilter.h on the
// GPU. Each draws one face of one level: attribute fbrdfVertex (vec3, in clip space), uniforms
// fbrdfFace (mat3: directions of increasing s and t, and the centre of the face), fbrdfFaceSize
// (float: texels on a side), fbrdfLargest (float: what the face can store).
#pragma once
#include <string>

namespace fbrdf {

std::string prefilterVertexSource(int glsl);
/// Level 0 of the cube that is convolved: from fbrdfRadiance, a samplerCube, or a sampler2D laid
/// out as a Panorama, whose texels on its sides are in fbrdfSourceSize (vec2) in GLSL 1.20. glsl:
/// not ES 1.00; 1.20 needs GL_ARB_shader_texture_lod.
std::string prefilterSourceFragment(int glsl, bool fromCube);
/// A level of a lobe: from fbrdfRadiance, that cube with all its levels, and fbrdfCells (sampler2D
/// of one row of fbrdfCellRoom texels, of which fbrdfCellCount are cells: x, y, weight, and the
/// level of the cell at the centre of a face).
std::string prefilterLobeFragment(int glsl);

}  // namespace fbrdf
