#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/scene/Camera.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr double kPoleMargin = 0.01;  // radians that an orbit keeps from straight up and down
// Near and far planes stay this far apart in ratio, so that depth keeps its precision.
constexpr double kNearestShare = 1e-3;

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::usage, "--camera", what);
}

double numberFromText(const std::string& text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        fail(Found("'" + text + "'").expected("a finite number"));
    return value;
}

Vec3d upOf(const Vec3d& forward)
{
    const bool vertical = std::hypot(forward.x, forward.z) < 1e-9;
    return vertical ? Vec3d(0.0, 0.0, forward.y > 0.0 ? 1.0 : -1.0) : Vec3d(0.0, 1.0, 0.0);
}

}  // namespace

Camera cameraFromText(const std::string& text)
{
    const char* const shape = "seven numbers ex,ey,ez,cx,cy,cz,fovy_degrees";
    std::array<double, 7> value{};
    size_t count = 0, begin = 0;
    for (size_t end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find(',', begin);
        if (count == value.size()) fail(Found("more numbers in '" + text + "'").expected(shape));
        value[count++] = numberFromText(text.substr(begin, end - begin));
    }
    if (count != value.size())
        fail(Found(std::to_string(count) + " in '" + text + "'").expected(shape));
    Camera camera{{value[0], value[1], value[2]}, {value[3], value[4], value[5]}, 0.0};
    if (camera.eye == camera.centre)
        fail(Found("an eye that is the centre").expected("two different points"));
    if (!(value[6] > 0.0 && value[6] < 180.0))
        fail(Found("a field of view of " + numberText(value[6]))
                 .expected("degrees between 0 and 180"));
    camera.fovy = value[6] * kPi / 180.0;
    return camera;
}

gl::View viewFromCamera(const Camera& camera, double aspect, const Bounds& bounds)
{
    const Vec3d forward = glm::normalize(camera.centre - camera.eye);
    const double depth = glm::dot(Vec3d(bounds.centre) - camera.eye, forward);
    const double radius = std::max(1e-6, 1.01 * double(bounds.radius));
    const double far = std::max(depth + radius, radius);
    const double near = std::max(depth - radius, far * kNearestShare);
    gl::View view;
    view.view = glm::mat4(glm::lookAt(camera.eye, camera.centre, upOf(forward)));
    view.projection = glm::mat4(glm::perspective(camera.fovy, aspect, near, far));
    return view;
}

Camera orbited(const Camera& camera, double right, double up, double zoom)
{
    const Vec3d offset = camera.eye - camera.centre;
    const double distance = glm::length(offset);
    const double azimuth = std::atan2(offset.x, offset.z) + right;
    const double limit = 0.5 * kPi - kPoleMargin;
    const double elevation =
        std::clamp(std::asin(std::clamp(offset.y / distance, -1.0, 1.0)) + up, -limit, limit);
    const Vec3d direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                          std::cos(elevation) * std::cos(azimuth));
    Camera moved = camera;
    moved.eye = camera.centre + distance * zoom * direction;
    return moved;
}

Camera framed(const Camera& camera, const Bounds& bounds, double aspect)
{
    const double halfHeight = 0.5 * camera.fovy;
    const double halfWidth = std::atan(std::tan(halfHeight) * aspect);
    const double distance =
        std::max(1e-6, double(bounds.radius)) / std::sin(std::min(halfHeight, halfWidth));
    Camera moved = camera;
    moved.centre = Vec3d(bounds.centre);
    moved.eye = moved.centre + distance * glm::normalize(camera.eye - camera.centre);
    return moved;
}

}  // namespace fbrdf::scene
