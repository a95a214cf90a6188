// CpuRendererTest.cpp - the CPU pictures against closed forms; no GL.
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/CpuRenderer.h>
#include <fbrdf/scene/Lights.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

constexpr int kSize = 96;

Brdf lambert(double albedo)
{
    return [albedo](const Vec3d&, const Vec3d&) { return Vec3d(albedo / kPi); };
}

Light directional(const Vec3f& direction, const Vec3f& irradiance)
{
    Light light;
    light.type = Light::Type::directional;
    light.position = direction;
    light.intensity = irradiance;
    return light;
}

Scene sceneOf(const Mesh& mesh, Brdf brdf, std::vector<Light> lights, const Camera& camera = {})
{
    Scene scene;
    scene.instances = {{&mesh}};
    scene.brdfs = {std::move(brdf)};
    scene.lights = std::move(lights);
    scene.view = viewFromCamera(camera, 1.0, boundsOf(mesh));
    return scene;
}

/// Where the ray through a pixel meets the unit sphere at the origin; false if it does not.
bool spherePoint(const Camera& camera, int x, int y, Vec3d& point)
{
    const double scale = std::tan(0.5 * camera.fovy);
    const Vec3d direction = glm::normalize(Vec3d(((x + 0.5) / kSize * 2.0 - 1.0) * scale,
                                                 (1.0 - (y + 0.5) / kSize * 2.0) * scale, -1.0));
    const double b = glm::dot(camera.eye, direction);
    const double discriminant = b * b - glm::dot(camera.eye, camera.eye) + 1.0;
    if (discriminant < 0.0) return false;
    point = camera.eye + (-b - std::sqrt(discriminant)) * direction;
    return true;
}

/// Largest difference to albedo / pi E cos on pixels whose ray meets the sphere well inside.
double worstAgainstLambert(const Image& image, double albedo, const Vec3d& toLight)
{
    double worst = 0.0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            Vec3d p;
            if (!spherePoint(Camera(), x, y, p) || p.z < 0.45) continue;  // the silhouette is 0.25
            const double expected = albedo / kPi * std::max(0.0, glm::dot(p, toLight));
            worst = std::max(worst, std::abs(double(image.pixel(x, y)[1]) - expected));
        }
    return worst;
}

// The mesh is inscribed, so its points are up to 1.6e-4 (1 - cos(pi / 176)) off the true ones; the
// slope of cos there is at most 1 and the albedo 0.8 / pi.
constexpr double kTessellation = 1e-3;

TEST(Reference, LambertianSphereUnderADirectionalLightIsTheClosedForm)
{
    const Vec3f toLight = glm::normalize(Vec3f(0.4f, 0.6f, 0.7f));
    const Mesh mesh = makeSphere();
    const Image image = renderReference(
        sceneOf(mesh, lambert(0.8), {directional(toLight, Vec3f(1.0f))}), {kSize, kSize});
    EXPECT_LT(worstAgainstLambert(image, 0.8, Vec3d(toLight)), kTessellation);
    EXPECT_GT(worstAgainstLambert(image, 0.79, Vec3d(toLight)), kTessellation) << "the tester";
    EXPECT_GT(worstAgainstLambert(image, 0.8, Vec3d(0.0, 0.0, 1.0)), 0.1) << "the tester";
}

TEST(Reference, CoversTheDiscOfTheSphere)
{
    const Mesh mesh = makeSphere();
    const Image image = renderReference(sceneOf(mesh, lambert(0.8), makeLights(1)), {kSize, kSize});
    int differ = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            Vec3d p;
            const bool inside = spherePoint(Camera(), x, y, p);
            const float coverage = image.pixel(x, y)[3];
            EXPECT_TRUE(coverage == 0.0f || coverage == 1.0f);
            differ += inside != (coverage > 0.5f);
        }
    EXPECT_LE(differ, 2) << "centres within 1e-4 of the outline";
}

TEST(Reference, PointLightsFallOffWithTheSquareOfDistanceAndEndAtTheirRadius)
{
    const Mesh mesh = makePlane(1);
    Light light;
    light.intensity = {1.0f, 2.0f, 4.0f};
    const auto centre = [&](float z, float radius) {
        light.position = {0.0f, 0.0f, z};
        light.radius = radius;
        return renderReference(sceneOf(mesh, lambert(1.0), {light}), {1, 1}).pixel(0, 0)[2];
    };
    EXPECT_NEAR(centre(1.0f, 0.0f), 4.0 / kPi, 1e-6);
    EXPECT_NEAR(centre(2.0f, 0.0f), 1.0 / kPi, 1e-6);
    EXPECT_NEAR(centre(2.0f, 4.0f), 1.0 / kPi * std::pow(1.0 - 1.0 / 16.0, 2), 1e-6);
    EXPECT_EQ(centre(2.0f, 1.9f), 0.0f);
    EXPECT_EQ(centre(-1.0f, 0.0f), 0.0f) << "behind the surface";
}

TEST(Reference, HandsTheBrdfDirectionsInTheTangentFrame)
{
    // The frame of the plane is t, s, n = x, y, z. The eye is straight above, so the pixel sees the
    // origin.
    const Mesh mesh = makePlane(1);
    const Vec3d toLight = glm::normalize(Vec3d(0.3, -0.5, 0.8));
    const Brdf probe = [&](const Vec3d& wo, const Vec3d& wi) {
        EXPECT_NEAR(glm::distance(wo, Vec3d(0.0, 0.0, 1.0)), 0.0, 1e-6);
        EXPECT_NEAR(glm::distance(wi, toLight), 0.0, 1e-6);
        return Vec3d(1.0);
    };
    const Image image =
        renderReference(sceneOf(mesh, probe, {directional(Vec3f(toLight), Vec3f(1.0f))}), {1, 1});
    EXPECT_NEAR(image.pixel(0, 0)[0], toLight.z, 1e-6);
}

TEST(Reference, DirectionsAreUnitAndAboveTheHorizon)
{
    const Mesh mesh = makeKnot(64, 12);
    const Brdf probe = [](const Vec3d& wo, const Vec3d& wi) {
        EXPECT_NEAR(glm::length(wo), 1.0, 1e-12);
        EXPECT_NEAR(glm::length(wi), 1.0, 1e-12);
        EXPECT_TRUE(wo.z > 0.0 && wi.z > 0.0);
        return Vec3d(1.0);
    };
    renderReference(sceneOf(mesh, probe, makeLights(5)), {32, 32});
}

TEST(Reference, AddsLightsUp)
{
    const Mesh mesh = makeSphere(32, 16);
    const auto lights = makeLights(3, 4);
    Image sum(24, 24);
    for (const Light& light : lights) {
        const Image one = renderReference(sceneOf(mesh, lambert(0.5), {light}), {24, 24});
        for (size_t i = 0; i < sum.rgba.size(); ++i) sum.rgba[i] += one.rgba[i];
    }
    const Image all = renderReference(sceneOf(mesh, lambert(0.5), lights), {24, 24});
    for (size_t i = 0; i < sum.rgba.size(); ++i)
        if (i % 4 != 3) {
            EXPECT_NEAR(all.rgba[i], sum.rgba[i], 1e-6f);
        }
}

TEST(Reference, DoesNotDependOnTheNumberOfThreads)
{
    const Mesh mesh = makeKnot(64, 12);
    const Scene scene = sceneOf(mesh, lambert(0.5), makeLights(4));
    PictureOptions options{40, 40, 1};
    const Image one = renderReference(scene, options), vertexOne = renderVertex(scene, options);
    options.threads = 3;
    EXPECT_EQ(one.rgba, renderReference(scene, options).rgba);
    EXPECT_EQ(vertexOne.rgba, renderVertex(scene, options).rgba);
}

TEST(Reference, TurnedInstancesAreShadedInTheWorld)
{
    // A sphere turned by a quarter about y and its light turned along: the same picture from there.
    const Mesh mesh = makeKnot(64, 12);
    const Brdf sharp = [](const Vec3d& wo, const Vec3d& wi) {
        const Vec3d h = glm::normalize(wo + wi);
        return Vec3d(std::exp(-8.0 * h.x * h.x - 40.0 * h.y * h.y));
    };
    const Scene scene = sceneOf(mesh, sharp, {directional({0.0f, 0.6f, 0.8f}, Vec3f(1.0f))});
    Camera side;
    side.eye = {4.0, 0.0, 0.0};
    Scene turned = sceneOf(mesh, sharp, {directional({0.8f, 0.6f, 0.0f}, Vec3f(1.0f))}, side);
    // Columns: z becomes x, x becomes -z.
    turned.instances[0].model = glm::mat4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1);
    const Image a = renderReference(scene, {32, 32}), b = renderReference(turned, {32, 32});
    for (size_t i = 0; i < a.rgba.size(); ++i) EXPECT_NEAR(a.rgba[i], b.rgba[i], 1e-4f);
}

TEST(Vertex, IsExactAtTheVerticesAndLinearBetween)
{
    // One triangle pair under a light close by: the middle of the plane is the mean of its corners.
    const Mesh mesh = makePlane(1);
    Light light;
    light.position = {0.0f, 0.0f, 0.5f};
    const Scene scene = sceneOf(mesh, lambert(kPi), {light});
    const double corner = 0.5 / std::sqrt(2.25) / 2.25;
    const Image vertex = renderVertex(scene, {64, 64}), exact = renderReference(scene, {64, 64});
    EXPECT_NEAR(vertex.pixel(32, 32)[0], corner, 1e-6);
    EXPECT_NEAR(exact.pixel(32, 32)[0], 4.0, 0.05) << "the highlight that the vertices miss";
}

TEST(Vertex, ApproachesTheReferenceOnFineMeshes)
{
    const Mesh coarse = makeSphere(16, 8), fine = makeSphere(256, 128);
    const auto difference = [](const Mesh& mesh) {
        const Brdf gloss = [](const Vec3d& wo, const Vec3d& wi) {
            return Vec3d(std::pow(glm::normalize(wo + wi).z, 50.0));
        };
        const Scene scene = sceneOf(mesh, gloss, makeLights(2));
        const Image a = renderVertex(scene, {64, 64}), b = renderReference(scene, {64, 64});
        double sum = 0.0;
        for (size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(double(a.rgba[i] - b.rgba[i]));
        return sum / static_cast<double>(a.rgba.size());
    };
    EXPECT_LT(difference(fine), 0.02 * difference(coarse));
}

}  // namespace
}  // namespace fbrdf::scene
