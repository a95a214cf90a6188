#include "bench/Stage.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Lights.h>

#include <cmath>

namespace fbrdf::bench {
namespace {

constexpr double kDistance = 4.0;

gl::MeshData fullScreenTriangle(float aspect)
{
    constexpr float kBend = 0.4f;  // normals lean 30 degrees at the corners of the picture
    gl::MeshData mesh;
    for (const Vec3f corner : {Vec3f(-1, -1, 0), Vec3f(3, -1, 0), Vec3f(-1, 3, 0)}) {
        mesh.positions.emplace_back(corner.x * aspect, corner.y, 0.0f);
        mesh.normals.emplace_back(kBend * corner.x, kBend * corner.y, 1.0f);
        mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f);
    }
    mesh.indices = {0, 1, 2};
    return mesh;
}

/// At the distance sqrt(kDistance^2 - radius^2), half the height of the picture is 1.
scene::Camera cameraFitting(double radius)
{
    scene::Camera camera;
    camera.eye = Vec3d(0.0, 0.0, kDistance);
    camera.fovy = 2.0 * std::atan(1.0 / std::sqrt(kDistance * kDistance - radius * radius));
    return camera;
}

}  // namespace

Stage makeStage(const std::string& mesh, double aspect)
{
    Stage stage;
    const bool isTriangle = mesh == "triangle";
    if (!isTriangle && mesh != "sphere")
        throw Error(ErrorKind::usage, "mesh",
                    Found("'" + mesh + "'").expected("triangle or sphere"));
    stage.mesh =
        isTriangle ? fullScreenTriangle(static_cast<float>(aspect)) : scene::makeSphere(64, 32);
    // The outline of a unit sphere is seen at the tangent distance sqrt(distance^2 - 1).
    stage.view = scene::viewFromCamera(cameraFitting(isTriangle ? 0.0 : 1.0), aspect,
                                       scene::boundsOf(stage.mesh));
    return stage;
}

std::vector<Light> stageLights(int count)
{
    std::vector<Light> lights = scene::makeLights(count);
    for (Light& light : lights) light.position.z = std::abs(light.position.z);
    return lights;
}

}  // namespace fbrdf::bench
