// TestMaterials.h - small materials of every form and storage, filled from a fixed sequence, and
// their comparison field by field.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>
#include <vector>

namespace fbrdf::test {

/// pqp, pqpr, hdio, a sum of two terms, a 3D grid with a single texel along one axis, and one table
/// without a name that is used twice.
std::vector<Form> testForms();

/// Tables of channels 3 and 1 in turn, all of one storage, texels in [-20, 4] (log) or [0, 1].
Material testMaterial(const Form& form, Storage storage, unsigned seed = 1);

/// A table of lobes whose numbers all differ: 2 tilted ones, or 3 about bent normals.
LobeTable testLobes(LobeAxes axes);

/// Empty when every field is equal bit for bit, otherwise the first field that differs.
std::string firstDifference(const Material& a, const Material& b);

constexpr Storage kStorages[] = {Storage::log8, Storage::half, Storage::float32, Storage::linear8,
                                 Storage::signedHalf};

}  // namespace fbrdf::test
