// CubeSample.h - filtering a CubeImage at a place that is already known.
#pragma once
#include <fbrdf/brdf/CubeFaces.h>
#include <fbrdf/environment/CubeImage.h>

namespace fbrdf {

/// sampleCube for the direction of a place. level: any number; NaN reads level 0.
Vec3f sampleCubeAt(const CubeImage& cube, const CubePlace& place, double level);

}  // namespace fbrdf
