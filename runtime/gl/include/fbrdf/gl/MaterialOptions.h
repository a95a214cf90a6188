// MaterialOptions.h - how a material is uploaded, and what became of that.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>

#include <string>

namespace fbrdf::gl {

class GpuMaterial;

/// How a material is uploaded.
struct MaterialOptions {
    /// Of the maps over one direction. Others stay native, which whyNative tells: cube and
    /// parabolic maps cost a shader less arithmetic and more memory, and differ from the tables
    /// between their texels, which lookUpError and every error bound include.
    LookUp lookUp = LookUp::native;
    int mapSize = 0;  ///< as DirectionMapRequest::size
};

/// Why maps of a material are looked up natively although options said otherwise; empty where none
/// are.
const std::string& whyNative(const GpuMaterial& material);
/// How far its products may be from those of its tables because maps are recombined, |log2|; 0
/// where none are.
double lookUpError(const GpuMaterial& material);

}  // namespace fbrdf::gl
