// Scene.h - a function as a picture and against physics: the errors that belong to no sample set.
#pragma once
#include "Errors.h"

#include <optional>

namespace fbrdf::tool {

struct Scene {
    PhysicsErrors physics;
    SphereImage picture, reference;    ///< of size 0 where there is no reference function
    std::optional<ImageErrors> image;  ///< likewise
};

/// Renders standard spheres of `brdf` and of `reference` (which may be empty), and measures the
/// physics of `brdf`.
Scene measureScene(const BrdfFunction& brdf, const BrdfFunction& reference, int threads);

/// The errors of a scene by name, as far as they are finite.
ErrorMap errorMap(const Scene& scene);

}  // namespace fbrdf::tool
