// LightEdit.h - lights that are added, removed and dragged in the view; no window here. Lights are
// numbered as in a picture: those without a shape, then those with one.
#pragma once
#include <fbrdf/scene/Document.h>
#include <fbrdf/scene/Meshes.h>

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::scene {

enum class LightKind { point, spot, directional, sphere, disc, rectangle, tube, polygon };
constexpr int kLightKinds = 8;
const char* lightKindName(LightKind kind);

/// The kind of a light of a set; expects 0 <= index < set.size().
LightKind kindOf(const LightSet& set, int index);
/// Where a light is, or for a directional one where it stands for the eye: its direction from the
/// middle of the ball of objects, twice as far as they reach. World space.
Vec3d placeOf(const LightSet& set, int index, const Bounds& objects);
/// Moves a light, with all of its shape, to another such place.
void moveLight(LightSet& set, int index, const Vec3d& place, const Bounds& objects);
/// Adds a light that sends to the objects about what a key light sends, from beside the camera, and
/// aims at their middle. Returns its index.
int addLight(LightSet& set, LightKind kind, const Camera& camera, const Bounds& objects);
/// Expects 0 <= index < set.size().
void removeLight(LightSet& set, int index);
/// The lights turned about the vertical through a point: radians, counter-clockwise from above.
LightSet orbited(LightSet set, const Vec3d& centre, double angle);
/// The colour of a light, intensity or radiance.
Vec3f& colourOf(LightSet& set, int index);

/// What is drawn of a light over a picture.
struct LightHandle {
    int light = 0;
    glm::dvec2 at{0.0};  ///< pixels, from the top left
    LightKind kind = LightKind::point;
    Vec3f colour{1.0f};  ///< of its light, the largest channel 1
};

/// Pixels of a place in a picture of that size; none for one behind the eye.
std::optional<glm::dvec2> pixelOf(const Vec3d& place, const gl::View& view, int width, int height);
/// Handles of the lights that are in front of the eye.
std::vector<LightHandle> handlesOf(const LightSet& set, const Bounds& objects, const gl::View& view,
                                   int width, int height);
/// The light whose handle is nearest to a pixel and within a radius; -1: none is.
int lightAt(const std::vector<LightHandle>& handles, const glm::dvec2& pixel, double radius);
/// A place moved in the plane that faces the camera, to be seen in another pixel.
Vec3d draggedTo(const Vec3d& place, const glm::dvec2& pixel, const gl::View& view, int width,
                int height);

}  // namespace fbrdf::scene
