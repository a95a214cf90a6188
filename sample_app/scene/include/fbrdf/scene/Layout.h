// Layout.h - where the objects stand when there is one for each material, and lights to match.
#pragma once
#include <fbrdf/plan/Light.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Raster.h>

#include <vector>

namespace fbrdf::scene {

/// One copy of the mesh for each material: a single one where the mesh is, several in rows from the
/// top left, as wide as suits a picture of `aspect` = width / height, each row centred on the
/// mesh's place. `mesh` must outlive the result.
std::vector<Instance> arranged(const Mesh& mesh, int materials, double aspect);

/// The instance turned about the vertical through the middle of its mesh: radians,
/// counter-clockwise seen from above.
Instance turned(Instance instance, double angle);

/// The ball around all instances. Expects matrices without scale.
Bounds boundsOf(const std::vector<Instance>& instances);

/// A camera that looks along -z and sees the ball of every instance, as near as it can be; its
/// field of view is the standard one.
Camera facing(const std::vector<Instance>& instances, double aspect);

/// Lights made for a scene of radius 1.2 at the origin (makeLights), moved and spread about a
/// larger one; intensities grow so that irradiance stays. Scenes that fit are left as they are.
std::vector<Light> spreadAround(std::vector<Light> lights, const Bounds& bounds);

}  // namespace fbrdf::scene
