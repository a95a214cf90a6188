// OccludersTest.cpp - what a sphere hides of lights and of the sky, against closed forms.
#include <fbrdf/scene/Camera.h>
#include <fbrdf/truth/Occluders.h>
#include <fbrdf/truth/PathTracer.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::truth {
namespace {

using namespace scene;

class OccludingSphere : public testing::Test {
protected:
    Mesh mesh_ = makeSphere(128, 64);
    std::vector<Instance> objects_{{&mesh_}};
    Occluders sphere_{objects_};
    Ground ground_{objects_};
};

TEST_F(OccludingSphere, HidesWhatIsBehindItAndNotWhatIsNearer)
{
    const SurfacePoint below{{0.2, -2.0, 0.1}, {0.0, 1.0, 0.0}, Vec3d(0.0)};
    EXPECT_TRUE(sphere_.hide(below, {0.0, 1.0, 0.0}, 9.0));
    EXPECT_FALSE(sphere_.hide(below, {0.0, 1.0, 0.0}, 0.9));
    EXPECT_FALSE(sphere_.hide(below, {1.0, 0.0, 0.0}, 9.0));
}

TEST_F(OccludingSphere, DoesNotShadeItselfUpToItsTerminator)
{
    for (int i = 0; i < 1000; ++i) {
        const double azimuth = 2.39996 * i, height = (i + 0.5) / 1000.0;
        const double level = std::sqrt(1.0 - height * height);
        const Vec3d place(level * std::cos(azimuth), height, level * std::sin(azimuth));
        EXPECT_FALSE(sphere_.hide({place, place, Vec3d(0.0)}, {0.0, 1.0, 0.0}, 9.0)) << height;
    }
}

// A sphere of radius 1 that lies on a plane hides 1 / d^3 of its irradiance, d: from its centre
// (Howell, Menguc, Siegel 2010, "Thermal Radiation Heat Transfer", configuration B-42: a sphere
// above the horizon of an element hides cos theta / d^2 of it).
TEST_F(OccludingSphere, LeavesOfTheSkyWhatTheClosedFormSays)
{
    const SkyVisibility sky = visibleSky(sphere_, ground_);
    double worst = 0.0, worstNoise = 0.0;
    const int middle = sky.size / 2;
    for (int row = 0; row < sky.size; ++row)
        for (int column = 0; column < sky.size; ++column) {
            const double step = 2.0 * ground_.radius() / (sky.size - 1);
            const double across = step * std::hypot(column - middle, row - middle);
            const double expected = 1.0 - std::pow(1.0 + across * across, -1.5);
            const double found =
                static_cast<double>(sky.texels[static_cast<size_t>(row * sky.size + column)]);
            worst = std::max(worst, std::abs(found - expected));
            worstNoise = std::max(worstNoise, std::abs(found - 0.9 * expected));
        }
    EXPECT_LT(worst, 0.03) << "256 rays";
    EXPECT_GT(worstNoise, 0.05) << "the tester";
}

TEST_F(OccludingSphere, LightsTheGroundAsPathsDo)
{
    Light light;
    light.type = Light::Type::directional;
    light.position = {0.5f, 1.0f, 0.3f};
    light.intensity = Vec3f(2.0f);
    Scene scene;
    scene.ground = &ground_;
    scene.instances = {objects_.front(), ground_.object(1)};
    scene.brdfs = {Ground::brdf(), Ground::brdf()};
    scene.lights = {light};
    scene.view = viewFromCamera({{0.0, 2.0, 5.0}, Vec3d(0.0), 0.7}, 1.0, ground_.bounds());
    scene.shadow = [this](size_t, const SurfacePoint& point, const Incident& incident) {
        return sphere_.hide(point, incident.direction, incident.distance);
    };
    PathOptions options;
    options.picture = {48, 48};
    options.bounces = 0;
    options.spread = false;
    PathTracer tracer(scene, std::vector<LobeTable>(2), options);
    tracer.add(1);
    const Image paths = tracer.picture().image, reference = renderReference(scene, {48, 48});
    int differ = 0, dark = 0, faded = 0;
    for (size_t i = 0; i < paths.rgba.size(); i += 4) {
        ASSERT_NEAR(paths.rgba[i + 3], reference.rgba[i + 3], 1e-6f);
        differ += std::abs(paths.rgba[i] - reference.rgba[i]) > 1e-5f;
        dark += paths.rgba[i] == 0.0f && paths.rgba[i + 3] == 1.0f;
        faded += paths.rgba[i + 3] > 0.0f && paths.rgba[i + 3] < 1.0f;
    }
    EXPECT_LE(differ, 8) << "edges of shadows";
    EXPECT_GT(dark, 40);
    EXPECT_GT(faded, 40);
}

}  // namespace
}  // namespace fbrdf::truth
