// TechniquesGLTest.cpp - the runtime's pictures against the CPU's, on EGL and OSMesa: coverage, the
// reference, one technique against the other, and the number of passes and look-ups.
#include "GlPictures.h"
#include "PictureDifference.h"

#include <fbrdf/scene/Camera.h>
#include <fbrdf/scene/Lights.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace fbrdf::scene {
namespace {

// What is asked: float shading of 8-bit logs against double.
constexpr double kAgainstReference = 2e-3;
// The same floats added in another order.
constexpr double kBetweenTechniques = 1e-4;
// Corners that float arithmetic snaps to another 1/256 of a pixel change that share of the outline.
constexpr double kCoverageShare = 2e-3;
constexpr int kSize = 96;

enum class Shape { sphere, knot };

Mesh meshOf(Shape shape)
{
    return shape == Shape::sphere ? makeSphere(64, 32) : makeKnot(160, 24);
}

Scene sceneOf(const Mesh& mesh, const Material& material, int lights)
{
    Scene scene;
    scene.instances = {{&mesh}};
    scene.brdfs = {brdfOf(material)};
    scene.lights = makeLights(lights, 7);
    Camera camera;
    camera.eye = {0.7, 0.9, 3.8};
    scene.view = viewFromCamera(camera, 1.0, boundsOf(mesh));
    return scene;
}

void expectSameCoverage(const PictureDifference& difference)
{
    EXPECT_GT(difference.compared, kSize * kSize / 5);
    EXPECT_LE(difference.coverageDiffers, kCoverageShare * difference.compared);
    EXPECT_TRUE(difference.edgesOnly) << "coverage differs inside";
}

// --- the tester ---------------------------------------------------------------------------------

TEST(Compare, SeesOneWrongPixelAndOneWrongEdge)
{
    Image reference(8, 8);
    for (int y = 2; y < 6; ++y)
        for (int x = 2; x < 6; ++x)
            for (int c = 0; c < 4; ++c) reference.pixel(x, y)[c] = 1.0f;
    EXPECT_EQ(compare(reference, reference).worst, 0.0);
    EXPECT_EQ(compare(reference, reference).compared, 16);
    Image other = reference;
    other.pixel(3, 4)[1] = 1.003f;
    EXPECT_NEAR(compare(other, reference).worst, 3e-3, 1e-6);
    EXPECT_EQ(compare(other, reference).worstY, 4);
    other.pixel(3, 4)[1] = NAN;
    EXPECT_EQ(compare(other, reference).worst, HUGE_VAL);
    other = reference;
    other.pixel(2, 2)[3] = 0.0f;
    EXPECT_EQ(compare(other, reference).coverageDiffers, 1);
    EXPECT_TRUE(compare(other, reference).edgesOnly);
    other.pixel(0, 7)[3] = 1.0f;
    EXPECT_FALSE(compare(other, reference).edgesOnly);
}

TEST(Compare, DarkPixelsAreMeasuredAgainstTheBrightest)
{
    Image reference(2, 1), other(2, 1);
    for (Image* image : {&reference, &other}) {
        image->rgba = {10.0f, 10.0f, 10.0f, 1.0f, 1e-6f, 1e-6f, 1e-6f, 1.0f};
    }
    other.pixel(1, 0)[0] = 6e-6f;
    EXPECT_NEAR(compare(other, reference).worst, 5e-6 / (kFloorShare * 10.0), 1e-7);
}

// --- GL ------------------------------------------------------------------------------------------

class TechniquesGL : public testing::TestWithParam<Backend> {
protected:
    void SetUp() override
    {
        if (!hasBackend(GetParam())) GTEST_SKIP() << "no context on " << backendName(GetParam());
        pictures_ = std::make_unique<GlPictures>(GetParam());
    }
    std::unique_ptr<GlPictures> pictures_;

    void expectAgreement(Shape shape, int lights);
    void expectAgreementOf(const Form& form, Shape shape, int lights);
};

/// single and two-lookup against the reference and against each other.
void TechniquesGL::expectAgreementOf(const Form& form, Shape shape, int lights)
{
    SCOPED_TRACE(form.name + (shape == Shape::knot ? " knot, " : " sphere, ") +
                 std::to_string(lights) + " lights");
    const Mesh mesh = meshOf(shape);
    const Material material = madeMaterial(form);
    const Scene scene = sceneOf(mesh, material, lights);
    const Image reference = renderReference(scene, {kSize, kSize});
    const GlPicture single = pictures_->draw(scene, material, Technique::single, kSize, kSize);
    const GlPicture two = pictures_->draw(scene, material, Technique::twoLookup, kSize, kSize);
    const PictureDifference toReference = compare(single.image, reference);
    const PictureDifference twoToReference = compare(two.image, reference);
    const PictureDifference between = compare(two.image, single.image);
    std::cout << form.name << (shape == Shape::knot ? " knot" : " sphere") << " N=" << lights
              << " single " << toReference.worst << " two-lookup " << twoToReference.worst
              << " between " << between.worst << " coverage " << toReference.coverageDiffers << "/"
              << toReference.compared << "\n";
    expectSameCoverage(toReference);
    EXPECT_LE(toReference.worst, kAgainstReference)
        << "at " << toReference.worstX << ", " << toReference.worstY;
    EXPECT_LE(twoToReference.worst, kAgainstReference)
        << "at " << twoToReference.worstX << ", " << twoToReference.worstY;
    EXPECT_EQ(between.coverageDiffers, 0);
    EXPECT_LE(between.worst, kBetweenTechniques);
    EXPECT_EQ(single.stats.accumulation, "RGBA32F");
    EXPECT_EQ(two.stats.accumulation, "RGBA32F");
    EXPECT_EQ(single.stats.lightsUsed, lights);
    EXPECT_EQ(single.stats.lightsDropped, 0);
    EXPECT_LE(two.stats.maxLookups, 2);
}

void TechniquesGL::expectAgreement(Shape shape, int lights)
{
    for (const Form& form : {formPqp(32, 0.5), formPqpr(32, 0.5, 16), formHdio({48, 8, 8})})
        expectAgreementOf(form, shape, lights);
}

/// The same for numbers of lights around every limit of the runtime: one test each, so that they
/// can run side by side.
class LightCountsGL : public TechniquesGL {};

TEST_P(LightCountsGL, SphereUnder1)
{
    expectAgreement(Shape::sphere, 1);
}

TEST_P(LightCountsGL, SphereUnder2)
{
    expectAgreement(Shape::sphere, 2);
}

TEST_P(LightCountsGL, SphereUnder8)
{
    expectAgreement(Shape::sphere, 8);
}

TEST_P(LightCountsGL, SphereUnder9)
{
    expectAgreement(Shape::sphere, 9);
}

TEST_P(LightCountsGL, SphereUnder64)
{
    expectAgreement(Shape::sphere, 64);
}

TEST_P(LightCountsGL, SphereUnder256)
{
    expectAgreement(Shape::sphere, 256);
}

TEST_P(LightCountsGL, KnotUnder1)
{
    expectAgreement(Shape::knot, 1);
}

TEST_P(LightCountsGL, KnotUnder2)
{
    expectAgreement(Shape::knot, 2);
}

TEST_P(LightCountsGL, KnotUnder8)
{
    expectAgreement(Shape::knot, 8);
}

TEST_P(LightCountsGL, KnotUnder9)
{
    expectAgreement(Shape::knot, 9);
}

TEST_P(LightCountsGL, KnotUnder64)
{
    expectAgreement(Shape::knot, 64);
}

TEST_P(LightCountsGL, KnotUnder256)
{
    expectAgreement(Shape::knot, 256);
}

TEST_P(TechniquesGL, FullMeshesAgreeToo)
{
    const Material material = madeMaterial(formPqp(32, 0.5));
    for (const Mesh& mesh : {makeSphere(), makeKnot()}) {
        const Scene scene = sceneOf(mesh, material, 3);
        const Image reference = renderReference(scene, {kSize, kSize});
        const GlPicture single = pictures_->draw(scene, material, Technique::single, kSize, kSize);
        const PictureDifference difference = compare(single.image, reference);
        std::cout << "full mesh: " << difference.worst << ", coverage "
                  << difference.coverageDiffers << "/" << difference.compared << "\n";
        expectSameCoverage(difference);
        EXPECT_LE(difference.worst, kAgainstReference);
    }
}

TEST_P(TechniquesGL, DirectionalWindowedAndSpotLightsAgree)
{
    const Mesh mesh = meshOf(Shape::knot);
    const Material material = madeMaterial(formPqp(32, 0.5));
    Scene scene = sceneOf(mesh, material, 6);
    for (size_t i = 0; i < scene.lights.size(); i += 2) {
        scene.lights[i].type = Light::Type::directional;
        scene.lights[i].intensity = Vec3f(1.0f, 0.5f, 0.7f);
        scene.lights[i].position = glm::normalize(scene.lights[i].position);
    }
    for (size_t i = 1; i < scene.lights.size(); i += 2) scene.lights[i].radius = 5.0f;
    Light& spot = scene.lights[1];
    spot.type = Light::Type::spot;
    spot.axis = -spot.position;
    spot.innerAngle = 0.1f;
    spot.outerAngle = 0.3f;
    const Image reference = renderReference(scene, {kSize, kSize});
    for (const Technique technique : {Technique::single, Technique::twoLookup}) {
        const GlPicture picture = pictures_->draw(scene, material, technique, kSize, kSize);
        EXPECT_LE(compare(picture.image, reference).worst, kAgainstReference);
    }
}

TEST_P(TechniquesGL, SeveralInstancesAgree)
{
    const Mesh mesh = makeKnot(80, 16);
    const Material material = madeMaterial(formPqp(32, 0.5));
    Scene scene = sceneOf(mesh, material, 3);
    scene.instances = {{&mesh}, {&mesh}, {&mesh}};
    scene.instances[1].model[3] = glm::vec4(0.5f, 0.2f, 0.4f, 1.0f);  // through the first
    // The sphere is turned by a quarter about z and stretched along x.
    scene.instances[2].model =
        glm::mat4(0, 0.6f, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, -0.3f, 0.1f, 0.8f, 1);
    scene.view = viewFromCamera(Camera(), 1.0, {Vec3f(0.0f), 2.0f});
    const Image reference = renderReference(scene, {kSize, kSize});
    for (const Technique technique : {Technique::single, Technique::twoLookup}) {
        const GlPicture picture = pictures_->draw(scene, material, technique, kSize, kSize);
        const PictureDifference difference = compare(picture.image, reference);
        expectSameCoverage(difference);
        EXPECT_LE(difference.worst, kAgainstReference)
            << techniqueName(technique) << " at " << difference.worstX << ", " << difference.worstY;
    }
}

TEST_P(TechniquesGL, TiesOfCoverageGoTheSameWay)
{
    // Corners on pixel centres, half-way between them and on odd 1/256 steps: every edge rule and
    // the snapping decide. Object space is pixels, y up.
    constexpr int kPixels = 16;
    Mesh mesh;
    const std::vector<Vec3f> fan{{2.5f, 2.5f, 0}, {8.5f, 2.5f, 0},   {13.5f, 2.5f, 0},
                                 {13.5f, 8, 0},   {13.5f, 12.5f, 0}, {7 + 3 / 256.0f, 13.5f, 0},
                                 {2.5f, 12.5f, 0}};
    for (size_t i = 0; i < fan.size(); ++i)
        for (const Vec3f& corner : {Vec3f(8.5f, 8.5f, 0.0f), fan[i], fan[(i + 1) % fan.size()]}) {
            mesh.indices.push_back(static_cast<uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(corner);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f);
        }
    Scene scene;
    const Material material = madeMaterial(formPqp(16, 0.5));
    scene.instances = {{&mesh}};
    scene.brdfs = {brdfOf(material)};
    const float scale = 2.0f / kPixels;
    scene.view.projection = glm::mat4(scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1);
    const Image reference = renderReference(scene, {kPixels, kPixels});
    const GlPicture drawn = pictures_->draw(scene, material, Technique::single, kPixels, kPixels);
    const PictureDifference difference = compare(drawn.image, reference);
    EXPECT_GT(difference.compared, 100);
    EXPECT_EQ(difference.coverageDiffers, 0);
}

TEST_P(TechniquesGL, AWrongBrdfIsSeen)
{
    const Mesh mesh = meshOf(Shape::sphere);
    const Material material = madeMaterial(formPqp(32, 0.5));
    Material other = material;
    other.scales[0].g *= 1.004f;
    const Scene scene = sceneOf(mesh, material, 2);
    const GlPicture picture = pictures_->draw(scene, other, Technique::single, kSize, kSize);
    EXPECT_GT(compare(picture.image, renderReference(scene, {kSize, kSize})).worst,
              kAgainstReference);
}

TEST_P(TechniquesGL, PqpNeedsNPlusOnePassesOfTwoLookups)
{
    const Mesh mesh = makeSphere(16, 8);
    const Material material = madeMaterial(formPqp(16, 0.5));
    const Scene scene = sceneOf(mesh, material, 5);
    const GlPicture two = pictures_->draw(scene, material, Technique::twoLookup, 16, 16);
    EXPECT_EQ(two.stats.passes, 6);
    EXPECT_EQ(two.stats.maxLookups, 2);
    const GlPicture single = pictures_->draw(scene, material, Technique::single, 16, 16);
    EXPECT_EQ(single.stats.passes, 1);
    EXPECT_EQ(single.stats.maxLookups, 2 * 5 + 1);
}

INSTANTIATE_TEST_SUITE_P(Backends, LightCountsGL, testing::Values(Backend::egl, Backend::osmesa),
                         [](const auto& backend) {
                             return std::string(backendName(backend.param));
                         });
INSTANTIATE_TEST_SUITE_P(Backends, TechniquesGL, testing::Values(Backend::egl, Backend::osmesa),
                         [](const auto& backend) {
                             return std::string(backendName(backend.param));
                         });

}  // namespace
}  // namespace fbrdf::scene
