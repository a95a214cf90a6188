// Camera.h - where the viewer stands: as given on the command line, and as moved with the mouse.
#pragma once
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/scene/Meshes.h>

#include <string>

namespace fbrdf::scene {

/// World space, up = +y. fovy: vertical field of view, radians, in (0, pi).
struct Camera {
    Vec3d eye{0.0, 0.0, 4.0}, centre{0.0};
    double fovy = 35.0 * kPi / 180.0;
};

/// "ex,ey,ez,cx,cy,cz,fovy_degrees". Throws Error(usage) unless these are seven finite numbers, the
/// two points differ and fovy is in (0, 180).
Camera cameraFromText(const std::string& text);

/// Matrices for a picture of `aspect` = width / height. The near and far planes enclose `bounds`.
/// For a camera that looks straight up or down, up in the picture is -z or +z: the limit of tilting
/// towards there.
gl::View viewFromCamera(const Camera& camera, double aspect, const Bounds& bounds);

/// Turns the camera about its centre by radians to the right and up (up stops short of the poles),
/// and scales the distance by `zoom`.
Camera orbited(const Camera& camera, double right, double up, double zoom);

/// The camera moved back or forth along its view direction until the ball fills the picture.
Camera framed(const Camera& camera, const Bounds& bounds, double aspect);

}  // namespace fbrdf::scene
