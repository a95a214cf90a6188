// MaterialOptions.h - how a material is uploaded.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>

namespace fbrdf::gl {

struct MaterialOptions {
    /// How maps over one direction are looked up. Parabolic and cube maps cost a shader less
    /// arithmetic and more memory, and differ from the tables between their texels:
    /// GpuMaterial::lookUpError says how far, and every error bound includes it. Maps that cannot
    /// be recombined stay native, see GpuMaterial::whyNotRecombined.
    LookUp lookUp = LookUp::native;
    /// Texels on a side, as DirectionMapRequest::size; 0: as its error asks for.
    int mapSize = 0;
    /// Filters in the shader instead of in the texture unit, which may know as few as 256 places
    /// between two texels: a highlight is then off by up to a percent, see DrawStats::error. A
    /// look-up becomes 4 fetches, or 8 of a volume. Cube maps stay native then.
    bool precise = false;
};

}  // namespace fbrdf::gl
