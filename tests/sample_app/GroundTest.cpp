// GroundTest.cpp - the plane below the objects, on the CPU, against closed forms; no GL.
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/KeyLights.h>
#include <fbrdf/scene/Layout.h>
#include <fbrdf/scene/SubPixels.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace fbrdf::scene {
namespace {

/// A sphere, the ground below it, and a camera that looks straight down on the ground beside it.
struct GroundScene {
    Mesh mesh = makeSphere(32, 16);
    std::vector<Instance> objects{{&mesh}};
    Ground ground{objects};
    Scene scene;

    explicit GroundScene(const Vec3d& beside)
    {
        scene.ground = &ground;
        scene.instances = {objects.front(), ground.object(1)};
        scene.brdfs = {Ground::brdf(), Ground::brdf()};
        scene.view =
            viewFromCamera({beside + Vec3d(0.0, 3.0, 0.0), beside, 0.001}, 1.0, ground.bounds());
    }
    const float* pixel(int samples = 1)
    {
        PictureOptions options{1, 1};
        options.samples = samples;
        image = renderReference(scene, options);
        return image.pixel(0, 0);
    }
    Image image;
};

Light overhead()
{
    Light light;
    light.type = Light::Type::directional;
    light.position = {0.0f, 2.0f, 0.0f};
    light.intensity = {3.0f, 2.0f, 1.0f};
    return light;
}

TEST(Ground, LiesBelowTheLowestPointAndBelowTheMiddle)
{
    const Mesh mesh = makeSphere(32, 16);
    const Instance low{&mesh, glm::translate(glm::mat4(1.0f), {4.0f, -2.0f, 1.0f})};
    const Ground ground({{&mesh}, low});
    EXPECT_NEAR(ground.centre().y, -3.0, 1e-6);
    EXPECT_NEAR(ground.centre().x, 2.0, 1e-6);
    EXPECT_NEAR(ground.centre().z, 0.5, 1e-6);
    EXPECT_GT(ground.radius(), 4.0 * 3.2) << "several times the objects";
}

TEST(Ground, FadesFromItsMiddleToItsRim)
{
    const GroundScene s{Vec3d(0.0)};
    const Vec3d centre = s.ground.centre(), x(s.ground.radius(), 0.0, 0.0);
    EXPECT_EQ(s.ground.opacity(centre), 1.0);
    EXPECT_EQ(s.ground.opacity(centre + 0.99 * Ground::kOpaque * x), 1.0);
    EXPECT_NEAR(s.ground.opacity(centre + 0.5 * (1.0 + Ground::kOpaque) * x), 0.5, 1e-9);
    EXPECT_EQ(s.ground.opacity(centre - x), 0.0);
    EXPECT_EQ(s.ground.opacity(centre - 5.0 * x), 0.0);
}

TEST(Ground, IsTheLambertianThatItsMaterialIs)
{
    const Material material = Ground::material();
    validate(material, "ground");
    const Vec3d wo = glm::normalize(Vec3d(0.3, 0.5, 0.6)),
                wi = glm::normalize(Vec3d(-0.7, 0.1, 0.2));
    EXPECT_NEAR(glm::distance(evaluate<double>(material, wo, wi), Ground::brdf()(wo, wi)), 0.0,
                1e-8);
    EXPECT_NEAR(kPi * Ground::brdf()(wo, wi).x, Ground::kAlbedo, 1e-15);
}

TEST(Ground, ReflectsLightsAndAsMuchOfTheSkyAsItSees)
{
    GroundScene s({1.4, -1.0, 0.3});
    s.scene.lights = {overhead()};
    const float lit = s.pixel()[1];
    EXPECT_NEAR(lit, Ground::kAlbedo / kPi * 2.0, 1e-6);
    EXPECT_EQ(s.pixel()[3], 1.0f);
    EnvironmentLight sky;
    sky.panorama = {2, 2, {Vec3f(1.0f), Vec3f(1.0f), Vec3f(0.0f), Vec3f(0.0f)}};
    sky.intensity = 0.5;
    s.scene.environment = &sky;
    // The upper half of the sky, of radiance 1/2, sends pi / 2 to an open plane.
    EXPECT_NEAR(s.pixel()[1], double(lit) + Ground::kAlbedo / 2.0, 1e-6);
    s.ground.setVisibility({1, {0.25f}});
    EXPECT_NEAR(s.pixel()[1], double(lit) + Ground::kAlbedo / 8.0, 1e-6);
    s.scene.shadow = [](size_t light, const SurfacePoint&, const Incident&) { return light == 0; };
    EXPECT_NEAR(s.pixel()[1], Ground::kAlbedo / 8.0, 1e-6);
}

TEST(Ground, VisibilityIsFilteredBetweenTexelCentresAndTurnsWithTheGround)
{
    const SkyVisibility sky{3, {0, 0, 0, 0, 0, 1, 0, 0, 0}};
    EXPECT_NEAR(sky.at(1.0, 0.0), 1.0, 1e-12);
    EXPECT_NEAR(sky.at(0.5, 0.0), 0.5, 1e-12);
    EXPECT_NEAR(sky.at(0.5, 0.5), 0.25, 1e-12);
    EXPECT_NEAR(sky.at(7.0, 0.0), 1.0, 1e-12);
    EXPECT_NEAR(sky.at(-1.0, 0.0), 0.0, 1e-12);
    GroundScene s{Vec3d(0.0)};
    s.ground.setVisibility(sky);
    const auto shown = [&](const Vec3d& direction) {
        const Vec3d place = s.ground.centre() + s.ground.radius() * direction;
        return s.ground.reflectedSky(place, Vec3d(kPi / Ground::kAlbedo)).x;
    };
    EXPECT_NEAR(shown({1.0, 0.0, 0.0}), 1.0, 1e-6);
    s.ground.turnTo(0.5 * kPi);  // +x to -z
    EXPECT_NEAR(shown({0.0, 0.0, -1.0}), 1.0, 1e-6);
    EXPECT_NEAR(shown({1.0, 0.0, 0.0}), 0.0, 1e-6);
}

TEST(Ground, IsNotSeenFromBelow)
{
    const GroundScene s{Vec3d(0.0)};
    const auto seen = [&](double height) {
        return s.ground.isSeenFrom(
            viewFromCamera({{0.0, height, 4.0}, Vec3d(0.0), 0.6}, 1.0, s.ground.bounds()));
    };
    EXPECT_TRUE(seen(-0.99));
    EXPECT_FALSE(seen(-1.01));
    gl::View above = s.scene.view;
    above.projection = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 0.1f, 9.0f);
    EXPECT_TRUE(s.ground.isSeenFrom(above));
    above.view = glm::lookAt(Vec3f(0.0f), Vec3f(0.0f, 1.0f, 0.0f), Vec3f(1.0f, 0.0f, 0.0f));
    EXPECT_FALSE(s.ground.isSeenFrom(above)) << "it looks up";
}

TEST(SubPixels, BeginAtTheCentreAndAreSpreadEvenly)
{
    EXPECT_EQ(subPixel(0), Vec2<double>(0.0));
    int cells[4][4] = {};
    Vec2<double> mean(0.0);
    for (int i = 0; i < 64; ++i) {
        const Vec2<double> place = subPixel(i);
        mean += place / 64.0;
        ++cells[static_cast<int>(4.0 * (place.x + 0.5))][static_cast<int>(4.0 * (place.y + 0.5))];
    }
    EXPECT_LT(glm::length(mean), 0.035) << "of random ones it is 0.05";
    for (const auto& row : cells)
        for (const int count : row) EXPECT_NEAR(count, 4, 2);
}

TEST(SubPixels, AMovedViewSeesInTheMiddleWhatTheViewSeesThere)
{
    const gl::View view = viewFromCamera({}, 2.0, {Vec3f(0.0f), 1.0f});
    const Vec2<double> place(0.3, -0.4);
    const gl::View moved = movedBy(view, place, 40, 20);
    const glm::vec4 point(0.2f, 0.1f, -0.5f, 1.0f);
    const auto pixelOf = [&](const gl::View& v) {
        const glm::dvec4 clip(v.projection * v.view * point);
        return Vec2<double>(20.0 * (clip.x / clip.w + 1.0), 10.0 * (clip.y / clip.w + 1.0));
    };
    EXPECT_LT(glm::length(pixelOf(view) - place - pixelOf(moved)), 1e-5);
}

TEST(Samples, GiveEdgesGradesAndLeaveTheRestAsItIs)
{
    const Mesh mesh = makePlane(1);
    Scene scene;
    scene.instances = {{&mesh}};
    scene.brdfs = {Ground::brdf()};
    Light light = overhead();
    light.position = {0.0f, 0.0f, 1.0f};
    scene.lights = {light};
    // The square is 5 of 10 pixels wide and high, so its edges halve pixels.
    scene.view =
        viewFromCamera({{0.0, 0.0, 2.0}, Vec3d(0.0), 2.0 * std::atan(1.0)}, 1.0, boundsOf(mesh));
    PictureOptions options{10, 10};
    const Image hard = renderReference(scene, options);
    options.samples = 16;
    const Image soft = renderReference(scene, options);
    EXPECT_NEAR(soft.pixel(5, 5)[1], hard.pixel(5, 5)[1], 1e-6);
    EXPECT_NEAR(soft.pixel(5, 2)[3], 0.5, 0.07);
    EXPECT_NEAR(soft.pixel(5, 2)[1], 0.5 * double(hard.pixel(5, 5)[1]), 0.02);
    EXPECT_NEAR(soft.pixel(2, 2)[3], 0.25, 0.07);
    // Samples one by one are the same picture.
    Image sum(10, 10);
    options.samples = 1;
    for (options.firstSample = 0; options.firstSample < 16; ++options.firstSample)
        add(renderReference(scene, options), sum);
    const Image mean = meanOf(sum, 16);
    for (size_t i = 0; i < mean.rgba.size(); ++i) EXPECT_NEAR(mean.rgba[i], soft.rgba[i], 1e-5);
}

TEST(ShadowedLights, AreTheStrongestOutsideOfTheObjects)
{
    const auto lamp = [](const Vec3f& position, float intensity) {
        Light light;
        light.position = position;
        light.intensity = Vec3f(intensity);
        return light;
    };
    std::vector<Light> lights{lamp({0, 0, 4}, 1.0f),    lamp({0, 4, 0}, 9.0f),
                              lamp({0, 0, 0.5f}, 9.0f), lamp({4, 0, 0}, 0.0f),
                              lamp({0, 0, 8}, 8.0f),    overhead(),
                              lamp({9, 0, 0}, 1.0f),    lamp({std::nanf(""), 0, 0}, 9.0f)};
    std::vector<int> places;
    for (const ShadowedLight& light : shadowedLights(lights, {Vec3f(0.0f), 1.0f}, 0)) {
        places.push_back(light.place);
        EXPECT_EQ(light.from.position, lights[static_cast<size_t>(light.place)].position);
    }
    EXPECT_EQ(places, (std::vector<int>{5, 1, 4, 0}));
}

TEST(ShadowedLights, AreSpreadOverADisc)
{
    const std::vector<Light> lights{overhead()};
    Vec3f mean(0.0f);
    float farthest = 0.0f;
    for (int sample = 0; sample < 64; ++sample) {
        const Vec3f moved = shadowedLights(lights, {Vec3f(0.0f), 1.0f}, sample)[0].from.position;
        EXPECT_NEAR(moved.y, 2.0f, 1e-5f);
        mean += moved / 64.0f;
        farthest = std::max(farthest, std::hypot(moved.x, moved.z) / 2.0f);
    }
    EXPECT_LT(std::hypot(mean.x, mean.z), 0.01f);
    EXPECT_GT(farthest, 0.9f * static_cast<float>(std::tan(kShadowSoftness)));
    EXPECT_LT(farthest, 1.001f * static_cast<float>(std::tan(kShadowSoftness)));
}

}  // namespace
}  // namespace fbrdf::scene
