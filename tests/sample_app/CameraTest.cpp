// CameraTest.cpp - the camera's text, its matrices and its orbits; no GL.
#include <fbrdf/base/Error.h>
#include <fbrdf/scene/Camera.h>
#include <gtest/gtest.h>

#include <glm/vec4.hpp>

#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr double kTight = 1e-6;  // the matrices are float

/// Normalised device coordinates of a point.
Vec3d projected(const gl::View& view, const Vec3d& point)
{
    const glm::dvec4 clip =
        glm::dmat4(view.projection) * (glm::dmat4(view.view) * glm::dvec4(point, 1.0));
    return Vec3d(clip) / clip.w;
}

std::string errorOf(const std::string& text)
{
    try {
        cameraFromText(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        return error.what();
    }
    return {};
}

TEST(CameraText, IsSevenNumbers)
{
    const Camera camera = cameraFromText("1,2.5,-3,0,1e-1,0,60");
    EXPECT_EQ(camera.eye, Vec3d(1.0, 2.5, -3.0));
    EXPECT_EQ(camera.centre, Vec3d(0.0, 0.1, 0.0));
    EXPECT_NEAR(camera.fovy, kPi / 3.0, 1e-15);
    const Camera standard = cameraFromText("0,0,4,0,0,0,35");
    EXPECT_EQ(standard.eye, Camera().eye);
    EXPECT_EQ(standard.fovy, Camera().fovy);
}

TEST(CameraText, RefusesEverythingElse)
{
    for (const char* text :
         {"", "1", "0,0,4,0,0,0", "0,0,4,0,0,0,35,", "0,0,4,0,0,0,35,1", "0,0,x,0,0,0,35",
          "0,0,4 ,0,0,0,35", "0,0,nan,0,0,0,35", "0,0,4,0,0,0,0", "0,0,4,0,0,0,180",
          "0,0,4,0,0,0,-35", "1,1,1,1,1,1,35", "0,0,inf,0,0,0,35", ",,,,,,"})
        EXPECT_EQ(errorOf(text).substr(0, 16), "--camera: found ") << text;
}

TEST(View, PutsTheEdgesOfTheFieldOfViewAtTheEdgesOfThePicture)
{
    const Camera camera;
    const Bounds bounds{Vec3f(0.0f), 1.0f};
    const gl::View view = viewFromCamera(camera, 2.0, bounds);
    const double top = 4.0 * std::tan(0.5 * camera.fovy);
    EXPECT_NEAR(projected(view, {0.0, top, 0.0}).y, 1.0, kTight);
    EXPECT_NEAR(projected(view, {2.0 * top, 0.0, 0.0}).x, 1.0, kTight);
    EXPECT_NEAR(glm::length(Vec2<double>(projected(view, {0.0, 0.0, 0.0}))), 0.0, kTight);
}

TEST(View, PlanesEncloseTheBounds)
{
    for (const double distance : {0.5, 1.5, 4.0, 1e3}) {
        Camera camera;
        camera.eye = {0.0, 0.0, distance};
        const Bounds bounds{Vec3f(0.0f), 1.0f};
        const gl::View view = viewFromCamera(camera, 1.0, bounds);
        EXPECT_LT(projected(view, {0.0, 0.0, -1.0}).z, 1.0);
        EXPECT_GT(projected(view, {0.0, 0.0, std::min(1.0, 0.9 * distance)}).z, -1.0);
    }
}

TEST(View, LooksStraightDown)
{
    Camera camera;
    camera.eye = {0.0, 3.0, 0.0};
    const gl::View view = viewFromCamera(camera, 1.0, {Vec3f(0.0f), 1.0f});
    EXPECT_GT(projected(view, {0.0, 0.0, -0.5}).y, 0.1) << "-z is up";
    EXPECT_GT(projected(view, {0.5, 0.0, 0.0}).x, 0.1);
}

TEST(Orbit, KeepsDistanceAndCentreAndTurnsTheDocumentedWay)
{
    Camera camera;
    camera.centre = {1.0, 2.0, 3.0};
    camera.eye = camera.centre + Vec3d(0.0, 0.0, 4.0);
    const Camera right = orbited(camera, 0.5 * kPi, 0.0, 1.0);
    EXPECT_NEAR(glm::distance(right.eye, camera.centre + Vec3d(4.0, 0.0, 0.0)), 0.0, 1e-12);
    const Camera up = orbited(camera, 0.0, 0.25 * kPi, 0.5);
    EXPECT_NEAR(glm::distance(up.eye, up.centre), 2.0, 1e-12);
    EXPECT_NEAR(up.eye.y - up.centre.y, 2.0 * std::sqrt(0.5), 1e-12);
    const Camera pole = orbited(camera, 0.3, 10.0, 1.0);
    EXPECT_GT(std::hypot(pole.eye.x - 1.0, pole.eye.z - 3.0), 0.01) << "stops before the pole";
    const Camera back = orbited(orbited(camera, 1.0, 0.4, 2.0), -1.0, -0.4, 0.5);
    EXPECT_NEAR(glm::distance(back.eye, camera.eye), 0.0, 1e-12);
}

TEST(Framed, ShowsTheWholeBall)
{
    const Bounds bounds{Vec3f(5.0f, -2.0f, 1.0f), 30.0f};
    for (const double aspect : {0.5, 1.0, 2.0}) {
        const Camera camera = framed(Camera(), bounds, aspect);
        const gl::View view = viewFromCamera(camera, aspect, bounds);
        const double halfAngle = std::asin(30.0 / glm::distance(camera.eye, camera.centre));
        const double limit =
            std::min(0.5 * camera.fovy, std::atan(std::tan(0.5 * camera.fovy) * aspect));
        EXPECT_NEAR(halfAngle, limit, 1e-9);
        EXPECT_NEAR(projected(view, Vec3d(bounds.centre)).x, 0.0, 1e-5);
    }
}

}  // namespace
}  // namespace fbrdf::scene
