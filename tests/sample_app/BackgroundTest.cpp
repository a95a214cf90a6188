// BackgroundTest.cpp - what is put behind the objects of a picture; no GL.
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Environment.h>
#include <gtest/gtest.h>

namespace fbrdf::scene {
namespace {

TEST(Background, FillsWhatObjectsLeaveOfEachPixel)
{
    Image image(3, 1);
    image.rgba = {0, 0, 0, 0, 1, 2, 3, 1, 0.5f, 1, 1.5f, 0.5f};
    Background background;
    background.colour = Vec3f(4, 8, 16);
    fillBackground(image, background, nullptr, viewFromCamera({}, 3.0, {Vec3f(0.0f), 1.0f}));
    EXPECT_EQ(image.rgba, (std::vector<float>{4, 8, 16, 0, 1, 2, 3, 1, 2.5f, 5, 9.5f, 0.5f}));
}

TEST(Background, IsTheEnvironmentThatTheEyeLooksAt)
{
    EnvironmentLight light;
    light.panorama = {2, 1, {Vec3f(1.0f), Vec3f(3.0f)}};  // to the left of -z, and to the right
    light.intensity = 2.0;
    Image image(2, 2);
    Background background;
    background.environment = true;
    fillBackground(image, background, &light, viewFromCamera({}, 1.0, {Vec3f(0.0f), 1.0f}));
    EXPECT_LT(image.pixel(0, 0)[0], image.pixel(1, 0)[0]);
    EXPECT_NEAR(image.pixel(0, 0)[0] + image.pixel(1, 0)[0], 8.0f, 1e-4f);
}

TEST(Environment, TurnsThereAndBack)
{
    EnvironmentLight light;
    light.rotation = 0.8;
    const Vec3d w = glm::normalize(Vec3d(0.3, -0.5, 0.7));
    EXPECT_LT(glm::distance(light.fromEnvironment(light.toEnvironment(w)), w), 1e-15);
    EXPECT_GT(glm::distance(light.toEnvironment(w), w), 0.1);
}

}  // namespace
}  // namespace fbrdf::scene
