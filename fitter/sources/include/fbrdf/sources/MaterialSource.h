// MaterialSource.h - a material as a source: a function that is known everywhere.
#pragma once
#include <fbrdf/sources/Source.h>

#include <memory>

namespace fbrdf {

/// Evaluates the material in double. `material` is shared with the source's `evaluate`.
Source sourceOfMaterial(std::shared_ptr<const Material> material);

}  // namespace fbrdf
