#include "LightEditor.h"

#include <algorithm>
#include <utility>

namespace fbrdf::viewer {
namespace {

constexpr double kGripRadius = 12.0;  // pixels around a handle that take hold of it
constexpr size_t kMostHandles = 256;  // more cannot be told apart
constexpr double kStep = 0.1;         // of a key, in radii of the objects

}  // namespace

/// -1 where there is no such light any more: in the world, or in the document, which the world
/// follows once a frame while keys and drops may come in between.
int LightEditor::selected() const
{
    const scene::SceneLights& lights = state_.document.lights;
    const auto inDocument = lights.made > 0 ? static_cast<size_t>(lights.made) : lights.list.size();
    const size_t count = std::min(world_.lights.size(), inDocument);
    return state_.light < static_cast<int>(count) ? state_.light : -1;
}

/// The lights of the document as a list; those that are made become one.
scene::LightSet& LightEditor::listed()
{
    scene::SceneLights& lights = state_.document.lights;
    if (lights.made > 0) {
        lights.list = lightsOf(lights, scene::boundsOf(world_.mesh));
        lights.made = 0;
    }
    return lights.list;
}

void LightEditor::see(const gl::View& view, int width, int height)
{
    view_ = view;
    width_ = width;
    height_ = height;
    handles_.clear();
    if (state_.showsLights && world_.lights.size() <= kMostHandles)
        handles_ = handlesOf(world_.lights, scene::boundsOf(world_.mesh), view, width, height);
}

bool LightEditor::press(const glm::dvec2& pixel)
{
    const int light = lightAt(handles_, pixel, kGripRadius);
    if (light < 0) return false;
    state_.light = light;
    for (const scene::LightHandle& handle : handles_)
        if (handle.light == light) grip_ = pixel - handle.at;
    return true;
}

void LightEditor::drag(const glm::dvec2& pixel)
{
    const int light = selected();
    if (light < 0) return;
    const Vec3d place = placeOf(world_.lights, light, scene::boundsOf(world_.mesh));
    move(light, scene::draggedTo(place, pixel - grip_, view_, width_, height_));
}

/// Moves the light of the document so that the one that is drawn, which may have been turned on, is
/// at a place.
void LightEditor::move(int light, const Vec3d& place)
{
    scene::Document& document = state_.document;
    const scene::Bounds objects = scene::boundsOf(world_.mesh);
    const double angle = document.moment.lightsDegrees * kDegree;
    const Vec3d centre(objects.centre);
    scene::LightSet drawn = orbited(std::move(listed()), centre, angle);
    moveLight(drawn, light, place, objects);
    document.lights.list = orbited(std::move(drawn), centre, -angle);
}

/// Moves the selected light to the right, up and away from the camera.
void LightEditor::push(const Vec3d& steps)
{
    const int light = selected();
    if (light < 0) return;
    const scene::Bounds objects = scene::boundsOf(world_.mesh);
    const glm::dmat3 worldFromEye = glm::transpose(glm::dmat3(glm::dmat4(view_.view)));
    const Vec3d moved(steps.x, steps.y, -steps.z);
    const double step = kStep * static_cast<double>(objects.radius);
    move(light, placeOf(world_.lights, light, objects) + worldFromEye * (step * moved));
}

void LightEditor::follow()
{
    scene::LightWishes wishes = std::exchange(state_.lightWishes, {});
    const scene::Bounds objects = scene::boundsOf(world_.mesh);
    const auto count = static_cast<int>(world_.lights.size());
    if (wishes.next && count > 0) {
        state_.light = (selected() + 1) % count;
        state_.showsLights = true;
    }
    if (wishes.push != Vec3d(0.0)) push(wishes.push);
    if (wishes.remove && selected() >= 0) {
        removeLight(listed(), selected());
        state_.light = -1;
    }
    if (wishes.add >= 0 && wishes.add < scene::kLightKinds) {
        state_.light = addLight(listed(), static_cast<scene::LightKind>(wishes.add),
                                *state_.document.camera, objects);
        state_.showsLights = true;
    }
}

}  // namespace fbrdf::viewer
