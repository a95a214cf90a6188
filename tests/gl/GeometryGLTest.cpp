// Mirrored and stretched objects, handedness of tangents, derived tangents and normal maps are
// compared with the CPU, or with a mesh whose own arrays contain the same.
#include "GeometryTest.h"

namespace fbrdf::test {
namespace {

TEST_P(Geometry, StretchedAndMirroredObjectsAreAsMeshesThatAreSo)
{
    for (const Vec3f scale :
         {Vec3f(1.1f, 0.4f, 0.7f), Vec3f(-1.0f, 1.0f, 1.0f), Vec3f(-0.8f, -1.1f, -0.5f)}) {
        const glm::mat4 matrix =
            glm::rotate(glm::scale(glm::mat4(1.0f), scale), 0.5f, Vec3f(0.3f, 1.0f, 0.2f));
        const Object moved{sphereMesh(24), matrix}, baked{transformed(sphereMesh(24), matrix)};
        expectSame(draw(brushed(), moved, perspectiveView()).pixels,
                   draw(brushed(), baked, perspectiveView()).pixels, kSameGeometry);
    }
}

TEST_P(Geometry, HandsOfTangentsTurnTheFrame)
{
    const Object left{planeMesh(0.5f, -1.0f)}, right{planeMesh(0.5f, 1.0f)};
    SurfaceReference mirrored;
    mirrored.handedness = -1.0;
    const Drawn drawn = draw(brushed(), left);
    expectSame(drawn.pixels, reference(brushed(), left, mirrored), kAgainstReference);
    expectOther(drawn.pixels, draw(brushed(), right).pixels);
}

TEST_P(Geometry, TangentsAreDerivedFromTextureCoordinates)
{
    for (const float handedness : {1.0f, -1.0f}) {
        Object given{planeMesh(0.5f, handedness)}, bare = given;
        bare.mesh.tangents.clear();
        bare.mesh.handedness.clear();
        const glm::mat4 tilt = glm::rotate(glm::mat4(1.0f), 0.4f, Vec3f(1.0f, 0.5f, 0.0f));
        for (const glm::mat4& model : {tilt, glm::scale(tilt, Vec3f(-1.0f, 0.6f, 1.0f))}) {
            given.model = bare.model = model;
            expectSame(draw(brushed(), bare).pixels, draw(brushed(), given).pixels, kDerived);
        }
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(Geometry, NormalMapsMatchTheReference)
{
    const auto normals = bumps();
    const Material glossy = noiseMaterial(formHdio({16, 8, 8}), Storage::half);
    for (const Material& material : {brushed(), glossy})
        for (const float handedness : {1.0f, -1.0f}) {
            Object plane{planeMesh(0.0f, handedness)};
            plane.normalMap = normalMap(normals);
            SurfaceReference surface;
            surface.handedness = static_cast<double>(handedness);
            surface.normal = [&](size_t pixel) {
                const size_t row = pixel / kSize, column = pixel % kSize,
                             at = handedness < 0.0f ? kSize - 1 - row : row;
                return Vec3d(normals[at * kSize + column]);
            };
            const Drawn drawn = draw(material, plane);
            expectSame(drawn.pixels, reference(material, plane, surface), kAgainstReference);
            const int ofView = material.form.name == "pqpr" ? 1 : 0;
            EXPECT_EQ(drawn.stats.maxLookups, 1 + ofView + 6 * 2);
        }
}

TEST_P(Geometry, NormalMapsNeedNoTangents)
{
    Object given{planeMesh(0.3f, 1.0f)}, bare = given;
    bare.mesh.tangents.clear();
    bare.mesh.handedness.clear();
    given.normalMap = bare.normalMap = normalMap({Vec3f(0.3f, -0.4f, 0.8f)});
    expectSame(draw(brushed(), bare).pixels, draw(brushed(), given).pixels, kDerived);
    Object tilted{planeMesh(0.3f, 1.0f)};
    for (size_t i = 0; i < 4; ++i) {
        const Vec3f t = tilted.mesh.tangents[i], s(-t.y, t.x, 0.0f);
        tilted.mesh.normals[i] = 0.3f * t - 0.4f * s + Vec3f(0.0f, 0.0f, 0.8f);
    }
    expectSame(draw(brushed(), given).pixels, draw(brushed(), tilted).pixels, kSameGeometry);
}

INSTANTIATE_TEST_SUITE_P(Backends, Geometry, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
