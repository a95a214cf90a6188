// PathTracerTest.cpp - pictures with shadows and interreflection against closed forms, and against
// the reference without either.
#include "EveryShape.h"

#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/scene/Shading.h>
#include <fbrdf/truth/Occluders.h>
#include <fbrdf/truth/PathTracer.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace fbrdf::truth {
namespace {

using namespace scene;

// Of some 1,000 pixels one is off by that many standard errors once in 1,000 runs; seeds are fixed.
constexpr double kSigmas = 5.0;
constexpr double kFloat = 1e-6;  // pictures are in float

Brdf lambert(const Vec3d& albedo)
{
    return [albedo](const Vec3d&, const Vec3d&) { return albedo / kPi; };
}

/// A coloured base under a lobe of width 1/4 about the mirror direction.
Vec3d glossy(const Vec3d& wo, const Vec3d& wi)
{
    const double cosine = glm::dot(Vec3d(-wo.x, -wo.y, wo.z), wi);
    return Vec3d(0.1, 0.05, 0.02) + Vec3d(0.4) * stretchedCosine(cosine, 0.25);
}

/// Lobes that are roughly those of `glossy`.
LobeTable glossyLobes()
{
    LobeTable table;
    table.lobes = 1;
    table.thetas = 2;
    LobeKnot knot;
    knot.cosine = Vec3f(0.3f, 0.15f, 0.06f);
    knot.lobes[0].weight = Vec3f(0.4f);
    knot.lobes[0].level = 4.0f;
    table.knots = {knot, knot};
    return table;
}

Scene sceneOf(std::vector<Instance> instances, Brdf brdf, const Camera& camera = {})
{
    Scene scene;
    scene.instances = std::move(instances);
    scene.brdfs = {std::move(brdf)};
    scene.view = viewFromCamera(camera, 1.0, {Vec3f(0.0f), 3.0f});
    return scene;
}

PathOptions optionsOf(int size, int bounces)
{
    PathOptions options;
    options.picture = {size, size};
    options.bounces = bounces;
    options.spread = false;
    return options;
}

PathPicture traced(const Scene& scene, const PathOptions& options, int samples,
                   const LobeTable& lobes = {})
{
    PathTracer tracer(scene, std::vector<LobeTable>(scene.brdfs.size(), lobes), options);
    tracer.add(samples);
    return tracer.picture();
}

/// The mean of a channel over covered pixels, and its standard error.
struct Channel {
    double mean = 0.0, error = 0.0;
};
Channel channelOf(const PathPicture& picture, int c)
{
    Channel channel;
    double count = 0.0;
    for (size_t i = 0; i < picture.error.size(); ++i) {
        if (!(picture.image.rgba[4 * i + 3] > 0.0f)) continue;
        ++count;
        channel.mean += static_cast<double>(picture.image.rgba[4 * i + static_cast<size_t>(c)]);
        channel.error += std::pow(static_cast<double>(picture.error[i][c]), 2.0);
    }
    return {channel.mean / count, std::sqrt(channel.error) / count};
}

/// How many standard errors the worst pixel is off; `relative`: what is allowed beside the noise.
double worstSigmas(const PathPicture& found, const Image& expected, double relative)
{
    double worst = 0.0;
    for (size_t i = 0; i < found.error.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const size_t k = 4 * i + static_cast<size_t>(c);
            const auto value = static_cast<double>(expected.rgba[k]);
            const double off = std::abs(static_cast<double>(found.image.rgba[k]) - value);
            const double error = static_cast<double>(found.error[i][c]);
            worst = std::max(worst, (off - relative * value - kFloat) / (error + 1e-12));
        }
    return worst;
}

EnvironmentLight constantEnvironment(const Vec3f& radiance)
{
    EnvironmentLight light;
    light.panorama = {4, 2, std::vector<Vec3f>(8, radiance)};
    return light;
}

/// A matrix that mirrors, stretches by different factors, turns and moves.
glm::mat4 unevenMatrix()
{
    glm::mat4 m = glm::translate(glm::mat4(1.0f), {0.1f, -0.2f, 0.3f});
    m = glm::rotate(m, 0.5f, {0.3f, 1.0f, 0.2f});
    return glm::scale(m, {-1.2f, 0.5f, 0.8f});
}

/// A colour wherever a surface is seen; black where its interpolated normal looks away, as some do
/// at the outline of a coarse mesh.
Image constantPicture(const Scene& scene, const Vec3f& colour, int size)
{
    Image image(size, size);
    const Fragments seen = rasterise(scene.instances, scene.view, size, size);
    for (size_t i = 0; i < seen.pixels.size(); ++i) {
        if (!seen.pixels[i].covered()) continue;
        image.rgba[4 * i + 3] = 1.0f;
        const Instance& instance = scene.instances[static_cast<size_t>(seen.pixels[i].instance)];
        const SurfacePoint point =
            surfacePoint(*instance.mesh, ToWorld(instance.model), seen.pixels[i]);
        if (!(glm::dot(point.normal, Eye(scene.view).directionFrom(point.position)) > 0.0))
            continue;
        for (int c = 0; c < 3; ++c) image.rgba[4 * i + static_cast<size_t>(c)] = colour[c];
    }
    return image;
}

// --- the furnace ---------------------------------------------------------------------------------

TEST(Furnace, AWhiteConvexObjectIsAsBrightAsWhatIsAround)
{
    const Mesh mesh = makeSphere(24, 12);
    const EnvironmentLight light = constantEnvironment({1.0f, 2.0f, 0.5f});
    for (const glm::mat4& model : {glm::mat4(1.0f), unevenMatrix()})
        for (const LightSearch search :
             {LightSearch::combined, LightSearch::byLights, LightSearch::byMaterials}) {
            Scene scene = sceneOf({{&mesh, model}}, lambert(Vec3d(1.0)));
            scene.environment = &light;
            PathOptions options = optionsOf(16, 4);
            options.search = search;
            const PathPicture picture = traced(scene, options, 64);
            Image expected = constantPicture(scene, light.panorama.texels[0], 16);
            EXPECT_LT(worstSigmas(picture, expected, 0.0), kSigmas)
                << "search " << static_cast<int>(search) << ", mirrored " << (model[0][0] != 1.0f);
            // A cosine-distributed direction has the same weight whatever it is.
            if (search == LightSearch::byMaterials) {
                EXPECT_LT(noiseOf(picture), kFloat);
            }
            for (int c = 0; c < 3; ++c) {
                const Channel found = channelOf(picture, c),
                              exact = channelOf({expected, picture.error}, c);
                EXPECT_NEAR(found.mean, exact.mean, kSigmas * found.error + kFloat);
                EXPECT_GT(1.1 * exact.mean - found.mean, kSigmas * found.error) << "the tester";
            }
        }
}

TEST(Furnace, ConcaveWhiteObjectsAreNearlySoWithBouncesAndDarkerWithout)
{
    // Light is lost where the interpolated normal sees below a facet of the hollow side.
    constexpr double kFacets = 0.02;
    const Mesh mesh = makeKnot(96, 16);
    const EnvironmentLight light = constantEnvironment(Vec3f(1.0f));
    Scene scene = sceneOf({{&mesh}}, lambert(Vec3d(1.0)));
    scene.environment = &light;
    const Channel without = channelOf(traced(scene, optionsOf(16, 0), 16), 0),
                  with = channelOf(traced(scene, optionsOf(16, 50), 16), 0);
    EXPECT_LT(without.mean, 0.95);
    EXPECT_NEAR(with.mean, 1.0, kSigmas * with.error + kFacets);
}

// --- interreflection -----------------------------------------------------------------------------

/// The unit sphere seen from inside.
Mesh hollowSphere()
{
    Mesh mesh = makeSphere(96, 48);
    for (Vec3f& normal : mesh.normals) normal = -normal;
    return mesh;
}

Camera fromInside()
{
    Camera camera;
    camera.eye = {0.0, 0.0, 0.2};
    camera.fovy = 90.0 * kDegree;
    return camera;
}

const Vec3d kAlbedo(0.2, 0.5, 0.8);
// Facets of the inscribed mesh are nearer to the centre by up to 1 - cos(pi / 68).
constexpr double kInscribed = 2e-3;

/// Irradiance `first` everywhere on a closed diffuse sphere becomes first (1 + rho + rho^2 + ...)
/// (the integrating sphere: Goebel 1967, Eq. 3), cut off after the bounces.
void expectIntegratingSphere(const Scene& scene, double first, int bounces)
{
    const PathPicture picture = traced(scene, optionsOf(12, bounces), 32);
    for (int c = 0; c < 3; ++c) {
        const double rho = kAlbedo[c];
        const double sum = (1.0 - std::pow(rho, bounces + 1)) / (1.0 - rho);
        const double expected = rho / kPi * first * sum;
        const Channel found = channelOf(picture, c);
        EXPECT_NEAR(found.mean, expected, kSigmas * found.error + kInscribed * expected)
            << "bounces " << bounces << " channel " << c;
        EXPECT_LT(found.error, 0.03 * expected) << "the test would not see much";
    }
}

TEST(Interreflection, OfAnIntegratingSphereIsAGeometricSeries)
{
    const Mesh mesh = hollowSphere();
    Scene scene = sceneOf({{&mesh}}, lambert(kAlbedo), fromInside());
    scene.lights = {Light()};  // intensity 1, at the centre
    for (const int bounces : {0, 1, 3, 60}) expectIntegratingSphere(scene, 1.0, bounces);
}

TEST(Interreflection, OfASphereAroundAnAreaLightIsTheSame)
{
    const Mesh mesh = hollowSphere();
    Scene scene = sceneOf({{&mesh}}, lambert(kAlbedo), fromInside());
    AreaLight light;
    light.size = 0.25f;  // a cap whose sine is 1/4 is seen from everywhere
    scene.areaLights = {light};
    for (const int bounces : {0, 60}) expectIntegratingSphere(scene, kPi / 16.0, bounces);
}

// --- the reference, without anything that blocks -------------------------------------------------

std::vector<Light> lightsOfEveryKind()
{
    std::vector<Light> lights = makeLights(3, 5);
    lights.emplace_back();
    lights.back().type = Light::Type::directional;
    lights.back().position = {0.3f, 0.4f, 0.8f};
    lights.emplace_back();
    lights.back().type = Light::Type::spot;
    lights.back().position = {0.5f, 0.5f, 3.0f};
    lights.back().outerAngle = 0.5f;
    lights.back().radius = 5.0f;
    return lights;
}

TEST(WithoutBounces, PointLightsGiveTheReferenceExactly)
{
    const Mesh sphere = makeSphere(32, 16), plane = makePlane(4);
    for (const Mesh* mesh : {&sphere, &plane})
        for (const glm::mat4& model : {glm::mat4(1.0f), unevenMatrix()}) {
            Scene scene = sceneOf({{mesh, model}}, glossy);
            scene.lights = lightsOfEveryKind();
            const Image reference = renderReference(scene, {48, 48});
            EXPECT_EQ(traced(scene, optionsOf(48, 0), 1).image.rgba, reference.rgba);
        }
}

TEST(WithoutBounces, AParallelProjectionGivesTheReferenceToo)
{
    const Mesh mesh = makeSphere(32, 16);
    Scene scene = sceneOf({{&mesh}}, glossy);
    scene.view.projection = glm::ortho(-1.5f, 1.5f, -1.5f, 1.5f, 1.0f, 10.0f);
    scene.lights = lightsOfEveryKind();
    EXPECT_EQ(traced(scene, optionsOf(32, 0), 1).image.rgba, renderReference(scene, {32, 32}).rgba);
}

// The reference sums over points and texels, which have no noise, and are off a little.
constexpr double kReferencePoints = 0.01;

/// Pixel by pixel, and all together, where the noise is least.
void expectConverged(const PathPicture& picture, const Image& reference)
{
    EXPECT_LT(worstSigmas(picture, reference, kReferencePoints), kSigmas);
    for (int c = 0; c < 3; ++c) {
        const Channel found = channelOf(picture, c),
                      expected = channelOf({reference, picture.error}, c);
        EXPECT_NEAR(found.mean, expected.mean,
                    kSigmas * found.error + kReferencePoints * expected.mean);
        EXPECT_LT(found.error, 0.02 * found.mean) << "the test would not see much";
    }
}

TEST(WithoutBounces, AreaLightsConvergeToTheReference)
{
    const Mesh sphere = makeSphere(32, 16);
    Scene scene = sceneOf({{&sphere}}, glossy);
    scene.areaLights = test::lightsOfEveryShape();
    const Image reference = renderReference(scene, {6, 6});
    for (const LobeTable& lobes : {LobeTable(), glossyLobes()}) {
        expectConverged(traced(scene, optionsOf(6, 0), 800, lobes), reference);
    }
}

TEST(WithoutBounces, EnvironmentsConvergeToTheReference)
{
    const Mesh sphere = makeSphere(32, 16);
    EnvironmentLight light;
    light.panorama = {32, 16, std::vector<Vec3f>(512, Vec3f(0.2f, 0.3f, 0.5f))};
    light.panorama.texels[32 * 4 + 20] = Vec3f(60.0f, 50.0f, 30.0f);
    light.rotation = 2.5;
    Scene scene = sceneOf({{&sphere}}, glossy);
    scene.environment = &light;
    const Image reference = renderReference(scene, {6, 6});
    for (const LobeTable& lobes : {LobeTable(), glossyLobes()}) {
        expectConverged(traced(scene, optionsOf(6, 0), 800, lobes), reference);
    }
}

TEST(WithoutShadows, EnvironmentsAndTheGroundConvergeToTheReference)
{
    // Two balls that would hide much of the sky from each other, on a ground that they shade.
    const Mesh sphere = makeSphere(32, 16);
    const glm::mat4 beside = glm::translate(glm::mat4(1.0f), {1.4f, 0.6f, 0.0f});
    EnvironmentLight light;
    light.panorama = {32, 16, std::vector<Vec3f>(512, Vec3f(0.2f, 0.3f, 0.5f))};
    light.panorama.texels[32 * 4 + 20] = Vec3f(60.0f, 50.0f, 30.0f);
    Camera camera;
    camera.eye = {0.0, 2.0, 5.0};
    Scene scene = sceneOf({{&sphere}, {&sphere, beside}}, glossy, camera);
    Ground ground(scene.instances);
    ground.setVisibility(visibleSky(Occluders(scene.instances), ground));
    scene.environment = &light;
    scene.lights = lightsOfEveryKind();
    scene.shadow = [](size_t i, const SurfacePoint& point, const Incident&) {
        return i == 0 && point.position.x > 0.2;
    };
    scene.ground = &ground;
    scene.instances.push_back(ground.object(1));
    scene.brdfs.push_back(Ground::brdf());
    const Image reference = renderReference(scene, {8, 8});
    PathOptions options = optionsOf(8, 0);
    options.shadows = false;
    for (const LobeTable& lobes : {LobeTable(), glossyLobes()}) {
        PathTracer tracer(scene, {lobes, {}}, options);
        tracer.add(800);
        expectConverged(tracer.picture(), reference);
    }
    // The test can fail: with shadows the balls darken each other.
    options.shadows = true;
    EXPECT_GT(worstSigmas(traced(scene, options, 800), reference, kReferencePoints), 2.0 * kSigmas);
}

// --- shadows -------------------------------------------------------------------------------------

TEST(Shadows, OfASphereOnAPlaneIsADisc)
{
    // From z = 3 a ball of radius 1/4 at z = 3/2 has a shadow of radius 3 tan(asin(1/6)) at z = 0.
    const double radius = 3.0 * std::tan(std::asin(1.0 / 6.0));
    constexpr double kEdge = 0.01;  // the ball is a mesh of 96 x 48 facets
    const Mesh plane = makePlane(2), ball = makeSphere(96, 48);
    const glm::mat4 model = glm::scale(glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 1.5f}),
                                       glm::vec3(0.25f, 0.25f, -0.25f));
    Camera camera;
    camera.eye = {0.0, -3.0, 3.0};
    Scene scene = sceneOf({{&plane}, {&ball, model}}, lambert(Vec3d(0.5)), camera);
    scene.lights = {Light()};
    scene.lights[0].position = {0.0f, 0.0f, 3.0f};
    constexpr int kSize = 64;
    const Image picture = traced(scene, optionsOf(kSize, 0), 1).image,
                reference = renderReference(scene, {kSize, kSize});
    const Fragments seen = rasterise(scene.instances, scene.view, kSize, kSize);
    int dark = 0, lit = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Fragment& fragment = seen.at(x, y);
            if (fragment.instance != 0) continue;
            const Vec3d p = surfacePoint(plane, ToWorld(glm::mat4(1.0f)), fragment).position;
            const double distance = std::hypot(p.x, p.y);
            if (std::abs(distance - radius) < kEdge) continue;
            const bool isDark = distance < radius;
            EXPECT_EQ(picture.pixel(x, y)[0], isDark ? 0.0f : reference.pixel(x, y)[0]);
            ++(isDark ? dark : lit);
        }
    EXPECT_GT(dark, 100);
    EXPECT_GT(lit, 400);
}

TEST(Shadows, AnEdgeThroughTheMiddleHidesHalfOfAnAreaLight)
{
    const Mesh plane = makePlane(2);
    glm::mat4 blocker = glm::translate(glm::mat4(1.0f), {-5.0f, 0.0f, 1.5f});
    blocker = glm::scale(blocker, glm::vec3(5.0f, 5.0f, 1.0f));
    Camera camera;
    camera.eye = {4.0, 0.0, 1.0};
    camera.fovy = 0.01 * kDegree;
    Scene scene = sceneOf({{&plane}, {&plane, blocker}}, lambert(Vec3d(0.5)), camera);
    AreaLight disc;
    disc.shape = AreaLight::Shape::disc;
    disc.position = {0.0f, 0.0f, 3.0f};
    disc.normal = {0.0f, 0.0f, -1.0f};
    disc.size = 1.0f;
    AreaLight ball;
    ball.position = {0.0f, 0.0f, 3.0f};
    for (const AreaLight& light : {disc, ball}) {
        scene.areaLights = {light};
        const Channel shadowed = channelOf(traced(scene, optionsOf(4, 0), 500), 0);
        const double full = static_cast<double>(renderReference(scene, {1, 1}).pixel(0, 0)[0]);
        EXPECT_NEAR(shadowed.mean, 0.5 * full, kSigmas * shadowed.error + kReferencePoints * full);
        EXPECT_LT(shadowed.error, 0.02 * full);
    }
}

TEST(Shadows, ALightThatLiesOnASurfaceIsNotBlockedByIt)
{
    const Mesh plane = makePlane(2);
    const glm::mat4 ceiling = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 2.0f});
    Camera camera;
    camera.eye = {3.0, 0.0, 1.5};
    Scene scene = sceneOf({{&plane}, {&plane, ceiling}}, lambert(Vec3d(0.5)), camera);
    AreaLight light;
    light.shape = AreaLight::Shape::rectangle;
    light.position = {0.0f, 0.0f, 2.0f};
    light.axisV = {0.0f, -0.5f, 0.0f};
    scene.areaLights = {light};
    const PathPicture picture = traced(scene, optionsOf(8, 0), 100);
    EXPECT_LT(worstSigmas(picture, renderReference(scene, {8, 8}), kReferencePoints), kSigmas);
}

// --- estimators ----------------------------------------------------------------------------------

/// A ball over a plane, under an area light and an environment with a sun.
struct Studio {
    Mesh plane = makePlane(2), ball = makeSphere(32, 16);
    EnvironmentLight environment;
    Scene scene;

    Studio()
    {
        environment.panorama = {16, 8, std::vector<Vec3f>(128, Vec3f(0.2f))};
        environment.panorama.texels[16 + 5] = Vec3f(20.0f, 15.0f, 10.0f);
        const glm::mat4 place = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, 0.5f});
        Camera camera;
        camera.eye = {0.0, -2.0, 3.0};
        scene = sceneOf({{&plane}, {&ball, glm::scale(place, glm::vec3(0.5f)), 1}}, glossy, camera);
        scene.brdfs.push_back(lambert({0.8, 0.5, 0.3}));
        scene.environment = &environment;
        AreaLight light;
        light.position = {1.0f, 0.0f, 2.0f};
        light.size = 0.3f;
        light.radiance = {5.0f, 6.0f, 7.0f};
        scene.areaLights = {light};
        scene.lights = makeLights(2, 3);
    }
};

TEST(Estimators, LightsMaterialsAndBothTogetherAgree)
{
    const Studio studio;
    const auto picture = [&](LightSearch search, const LobeTable& lobes) {
        PathOptions options = optionsOf(8, 3);
        options.search = search;
        options.seed = static_cast<uint64_t>(search) + (lobes.isEmpty() ? 0 : 10);
        return traced(studio.scene, options, 200, lobes);
    };
    const PathPicture best = picture(LightSearch::combined, glossyLobes());
    for (const LightSearch search :
         {LightSearch::combined, LightSearch::byLights, LightSearch::byMaterials})
        for (const LobeTable& lobes : {LobeTable(), glossyLobes()}) {
            const PathPicture other = picture(search, lobes);
            for (int c = 0; c < 3; ++c) {
                const Channel a = channelOf(best, c), b = channelOf(other, c);
                EXPECT_NEAR(a.mean, b.mean, kSigmas * std::hypot(a.error, b.error));
                EXPECT_LT(b.error, 0.05 * b.mean) << "the test would not see much";
            }
            EXPECT_LE(noiseOf(best), 1.1 * noiseOf(other));
        }
}

TEST(Estimators, TheTesterSeesLightThatIsCountedTwice)
{
    const Studio studio;
    PathOptions options = optionsOf(8, 3);
    const PathPicture once = traced(studio.scene, options, 200, glossyLobes());
    Scene twice = studio.scene;
    twice.areaLights.push_back(twice.areaLights.front());
    const Channel a = channelOf(once, 0),
                  b = channelOf(traced(twice, options, 200, glossyLobes()), 0);
    EXPECT_GT(b.mean - a.mean, kSigmas * std::hypot(a.error, b.error));
}

TEST(Estimators, SeedsShowHalfOfTheErrorThatIsSaid)
{
    const Studio studio;
    PathOptions options = optionsOf(4, 2);
    double spread = 0.0, said = 0.0, mean = 0.0;
    std::vector<double> means;
    for (options.seed = 0; options.seed < 40; ++options.seed) {
        const Channel channel = channelOf(traced(studio.scene, options, 16, glossyLobes()), 1);
        means.push_back(channel.mean);
        mean += channel.mean / 40.0;
        said += channel.error / 40.0;
    }
    for (const double m : means) spread += (m - mean) * (m - mean) / 39.0;
    // Samples that are spread evenly do better than independent ones; 0.6 here. Of 40 means the
    // spread is known to 1 / sqrt(2 x 39), 11 %.
    EXPECT_LT(std::sqrt(spread) / said, 0.8);
    EXPECT_GT(std::sqrt(spread) / said, 0.3);
}

// --- pictures ------------------------------------------------------------------------------------

TEST(PathPictures, DependNeitherOnThreadsNorOnHowSamplesAreAdded)
{
    const Studio studio;
    PathOptions options = optionsOf(12, 5);
    options.spread = true;
    options.picture.threads = 1;
    const PathPicture one = traced(studio.scene, options, 8);
    options.picture.threads = 5;
    PathTracer tracer(studio.scene, {{}, {}}, options);
    tracer.add(3);
    tracer.add(0);
    tracer.add(5);
    EXPECT_EQ(tracer.samples(), 8);
    EXPECT_EQ(tracer.picture().image.rgba, one.image.rgba);
    EXPECT_EQ(tracer.picture().error, one.error);
    PathTracer byRows(studio.scene, {{}, {}}, options);
    for (int rows = 0; rows < 5 * 12; rows += 5) byRows.addRows(5);  // 5, 5 and 2 of 12
    EXPECT_EQ(byRows.samples(), 4);
    byRows.addRows(7);
    EXPECT_EQ(byRows.samples(), 4);
    const PathPicture four = traced(studio.scene, options, 4),
                      five = traced(studio.scene, options, 5);
    for (size_t i = 0; i < four.image.rgba.size(); ++i)
        EXPECT_EQ(byRows.picture().image.rgba[i], (i < 7 * 12 * 4 ? five : four).image.rgba[i]);
    byRows.add(4);
    EXPECT_EQ(byRows.samples(), 8);
    EXPECT_EQ(byRows.picture().image.rgba, one.image.rgba);
    EXPECT_EQ(byRows.picture().error, one.error);
    options.seed = 1;
    EXPECT_NE(traced(studio.scene, options, 8).image.rgba, one.image.rgba);
}

TEST(PathPictures, SpreadSamplesSmoothTheEdgesAndKeepTheArea)
{
    const Mesh mesh = makeSphere(64, 32);
    Scene scene = sceneOf({{&mesh}}, lambert(Vec3d(0.5)));
    scene.view.projection = glm::ortho(-1.25f, 1.25f, -1.25f, 1.25f, 1.0f, 10.0f);
    scene.lights = makeLights(1);
    PathOptions options = optionsOf(20, 0);
    options.spread = true;
    const Image image = traced(scene, options, 64).image;
    double area = 0.0;
    int partly = 0;
    for (size_t i = 3; i < image.rgba.size(); i += 4) {
        const double alpha = static_cast<double>(image.rgba[i]);
        area += alpha * std::pow(2.5 / 20.0, 2.0);
        partly += alpha > 0.0 && alpha < 1.0;
    }
    EXPECT_NEAR(area, kPi, 0.01 * kPi);
    EXPECT_GT(partly, 30);
    EXPECT_EQ(image.pixel(10, 10)[3], 1.0f);
    EXPECT_EQ(image.pixel(0, 0)[3], 0.0f);
}

TEST(PathPictures, OfLightsThatAreNotValidAndOfNothingAreBlack)
{
    const Mesh mesh = makeSphere(16, 8);
    Scene scene = sceneOf({{&mesh}}, lambert(Vec3d(0.5)));
    AreaLight light;
    light.size = -1.0f;
    scene.areaLights = {light};
    const Image image = traced(scene, optionsOf(8, 3), 2).image;
    EXPECT_EQ(image.pixel(4, 4)[1], 0.0f);
    EXPECT_EQ(image.pixel(4, 4)[3], 1.0f);
    EXPECT_EQ(noiseOf(traced(scene, optionsOf(8, 3), 2)), 0.0);
    scene.instances.clear();
    EXPECT_EQ(traced(scene, optionsOf(8, 3), 2).image.pixel(4, 4)[3], 0.0f);
}

}  // namespace
}  // namespace fbrdf::truth
