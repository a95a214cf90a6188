// What the host says of its geometry: mirrored and stretched objects, hands of tangents, derived
// tangents, normal maps, vertex and shadow hooks. Against the CPU, or against a mesh that holds
// the same by itself.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "support/gl/CompareImages.h"
#include "support/gl/ExpectError.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;
// Against the reference: as in ImageGLTest.
constexpr double kAgainstReference = 1e-4;
// The same geometry by other float operations, in tables of noise.
constexpr double kSameGeometry = 5e-4;
// Derivatives are differences of neighbouring pixels: 24 bits less those of the coordinates.
constexpr double kDerived = 5e-3;
// Where one thing is wrong, the picture is far off.
constexpr double kNoticed = 0.1;

/// Not symmetric in any direction of the tangent frame.
Material brushed()
{
    return noiseMaterial(formPqpr(16, 0.5, 12), Storage::half);
}

/// [-1, 1]^2 at z = 0; tangents turned by `turn`, texture coordinates along them.
gl::MeshData planeMesh(float turn, float handedness)
{
    gl::MeshData mesh;
    const Vec3f t(std::cos(turn), std::sin(turn), 0.0f), s(-t.y, t.x, 0.0f);
    for (const float y : {-1.0f, 1.0f})
        for (const float x : {-1.0f, 1.0f}) {
            const Vec3f place(x, y, 0.0f);
            mesh.positions.push_back(place);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.tangents.push_back(t);
            mesh.handedness.push_back(handedness);
            mesh.textureCoordinates.emplace_back(0.5f + 0.5f * glm::dot(place, t),
                                                 0.5f + 0.5f * handedness * glm::dot(place, s));
        }
    mesh.indices = {0, 1, 3, 0, 3, 2};
    return mesh;
}

gl::MeshData transformed(gl::MeshData mesh, const glm::mat4& matrix)
{
    const glm::mat3 linear(matrix), normal(glm::inverseTranspose(linear));
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i] = Vec3f(matrix * glm::vec4(mesh.positions[i], 1.0f));
        mesh.normals[i] = normal * mesh.normals[i];
        mesh.tangents[i] = linear * mesh.tangents[i];
    }
    if (glm::determinant(linear) < 0.0f) mesh.handedness.assign(mesh.positions.size(), -1.0f);
    return mesh;
}

/// A plane that fills the target, one pixel a texel of a map as large.
gl::View mapView()
{
    gl::View view;
    view.view = glm::translate(glm::mat4(1.0f), Vec3f(0.0f, 0.0f, -4.0f));
    view.projection = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f, 10.0f);
    return view;
}

class Geometry : public RendererTest {
protected:
    void TearDown() override
    {
        if (map_ != 0) gl().DeleteTextures(1, &map_);
        RendererTest::TearDown();
    }

    struct Object {
        gl::MeshData mesh;
        glm::mat4 model{1.0f};
        const gl::GpuHooks* hooks = nullptr;
        uint32_t normalMap = 0;
    };
    Drawn draw(const Material& material, const Object& object, const gl::View& view = mapView(),
               const gl::DrawOptions& options = {}, std::vector<Light> lights = testLights(6))
    {
        const auto gpu = renderer_->createMaterial(material);
        const auto mesh = renderer_->createMesh(object.mesh);
        return drawItems(*renderer_, kSize, view,
                         {{gpu.get(), mesh.get(), object.model, object.hooks, object.normalMap}},
                         lights, options);
    }

    std::vector<double> reference(const Material& material, const Object& object,
                                  const SurfaceReference& surface, const gl::View& view = mapView(),
                                  const std::vector<Light>& lights = testLights(6))
    {
        Offscreen offscreen = makeOffscreen(kSize);
        return referenceImage(material,
                              geometryBuffer(gl(), offscreen, object.mesh, object.model, view),
                              lights, view, surface);
    }

    template <class A, class B>
    static void expectSame(const std::vector<A>& found, const std::vector<B>& expected, double most)
    {
        const auto difference = compareImages(found, expected);
        EXPECT_TRUE(difference.comparable);
        EXPECT_LE(difference.maxRelative, most) << describe(difference);
    }
    template <class A, class B>
    static void expectOther(const std::vector<A>& found, const std::vector<B>& expected)
    {
        const auto difference = compareImages(found, expected);
        EXPECT_TRUE(difference.comparable);
        EXPECT_GT(difference.maxRelative, kNoticed) << describe(difference);
    }

    /// A texture of the host: float texels, kSize x kSize, one a pixel.
    uint32_t normalMap(const std::vector<Vec3f>& normals)
    {
        std::vector<float> texels;
        for (const Vec3f& n : normals)
            for (int c = 0; c < 3; ++c) texels.push_back(0.5f + 0.5f * n[c]);
        gl().GenTextures(1, &map_);
        gl().BindTexture(GL_TEXTURE_2D, map_);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        const auto size = static_cast<GLsizei>(std::sqrt(static_cast<double>(normals.size())));
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, size, size, 0, GL_RGB, GL_FLOAT,
                        texels.data());
        gl().BindTexture(GL_TEXTURE_2D, 0);
        return map_;
    }

    std::shared_ptr<gl::GpuHooks> hooksOf(const std::string& vertex, const std::string& shadow)
    {
        gl::Hooks hooks;
        hooks.vertex = vertex;
        hooks.shadow = shadow;
        return renderer_->createHooks(hooks);
    }

private:
    GLuint map_ = 0;
};

/// Bumps, one a texel.
std::vector<Vec3f> bumps()
{
    std::vector<Vec3f> normals;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            normals.emplace_back(0.5f * std::sin(0.4f * static_cast<float>(x)),
                                 0.4f * std::cos(0.3f * static_cast<float>(y)), 0.8f);
    return normals;
}

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
    const Material glossy = noiseMaterial(formHdio(16, 8, 8), Storage::half);
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

constexpr const char* kSkin =
    "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
    "uniform vec4 bones[4];\n"  // columns of a bone beside the one that stays
    "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
    "{\n"
    "    if (fbrdfExtra0.x > 0.5) {\n"
    "        mat3 turn = mat3(bones[0].xyz, bones[1].xyz, bones[2].xyz);\n"
    "        position = turn * position + bones[3].xyz;\n"
    "        normal = turn * normal;\n"
    "        tangent.xyz = turn * tangent.xyz;\n"
    "    }\n"
    "}\n";

TEST_P(Geometry, AVertexHookSkinsInEveryTechnique)
{
    const glm::mat4 bone = glm::rotate(glm::translate(glm::mat4(1.0f), Vec3f(0.2f, 0.1f, 0.3f)),
                                       0.7f, Vec3f(0.0f, 1.0f, 0.5f));
    gl::Hooks hooks;
    hooks.vertex = kSkin;
    hooks.setUniforms = [&](uint32_t program) {
        gl().Uniform4fv(gl().GetUniformLocation(program, "bones"), 4, &bone[0][0]);
    };
    const auto skin = renderer_->createHooks(hooks);
    gl::MeshData skinned = sphereMesh(16), baked = transformed(skinned, bone);
    skinned.extra.emplace_back();
    for (size_t i = 0; i < skinned.positions.size(); ++i) {
        const bool moves = skinned.positions[i].y > 0.2f;
        skinned.extra[0].emplace_back(moves ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f);
        if (moves) continue;
        baked.positions[i] = skinned.positions[i];
        baked.normals[i] = skinned.normals[i];
        baked.tangents[i] = skinned.tangents[i];
    }
    for (const auto technique : {Technique::single, Technique::batched, Technique::twoLookup}) {
        const gl::DrawOptions options{technique, 2};
        expectSame(
            draw(brushed(), {skinned, glm::mat4(1.0f), skin.get()}, perspectiveView(), options)
                .pixels,
            draw(brushed(), {baked}, perspectiveView(), options).pixels, kSameGeometry);
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(Geometry, WhatAVertexHookMovesIsLitWhereItEndsUp)
{
    Light lamp;
    lamp.position = {0.0f, 0.0f, 1.0f};
    lamp.radius = 2.0f;
    gl::Hooks hooks;
    hooks.vertex =
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position.z += 20.0; }\n";
    const auto far = renderer_->createHooks(hooks);
    hooks.reach = 20.0f;
    const auto said = renderer_->createHooks(hooks);
    hooks.reach = 1.0f;
    const auto wrong = renderer_->createHooks(hooks);
    const glm::mat4 behind = glm::translate(glm::mat4(1.0f), Vec3f(0.0f, 0.0f, -20.0f));
    const auto lit = [&](const gl::GpuHooks* given, const glm::mat4& model) {
        return draw(brushed(), {planeMesh(0.0f, 1.0f), model, given}, mapView(), {}, {lamp});
    };
    const Drawn plain = lit(nullptr, glm::mat4(1.0f));
    EXPECT_GT(*std::max_element(plain.pixels.begin(), plain.pixels.end()), 1.0f);
    for (const auto* given : {far.get(), said.get()})
        expectSame(lit(given, behind).pixels, plain.pixels, kSameGeometry);
    EXPECT_EQ(lit(wrong.get(), behind).stats.lightsCulled, 1);  // a host that lies about reach
}

constexpr const char* kShadow =
    "uniform float shade;\n"
    "float fbrdfShadow(int light, vec3 position, vec3 toLight)\n"
    "{\n"
    "    if (light == 1) return 0.0;\n"
    "    return position.x > 0.1 ? shade : 1.0 / (1.0 + 0.1 * float(light));\n"
    "}\n";

TEST_P(Geometry, AShadowHookKnowsEveryLightByItsPlace)
{
    gl::Hooks hooks;
    hooks.shadow = kShadow;
    hooks.shadowUniforms = 1;
    hooks.setUniforms = [&](uint32_t program) {
        gl().Uniform1f(gl().GetUniformLocation(program, "shade"), 0.25f);
    };
    const auto shadow = renderer_->createHooks(hooks);
    auto lights = testLights(9);
    lights[0].position.x = std::numeric_limits<float>::quiet_NaN();  // places are those given
    SurfaceReference surface;
    surface.shadow = [](size_t light, const Vec3d& position) {
        if (light == 1) return 0.0;
        return position.x > double(0.1f) ? 0.25 : 1.0 / (1.0 + 0.1 * static_cast<double>(light));
    };
    const Object object{sphereMesh(16), glm::mat4(1.0f), shadow.get()};
    const auto expected = reference(brushed(), object, surface, perspectiveView(), lights);
    gl::DrawOptions capped, clustered;
    capped.maxLights = 8;  // sorts them
    clustered.clustered = !GetParam().legacy;
    for (const gl::DrawOptions& options :
         {gl::DrawOptions{}, gl::DrawOptions{Technique::batched, 3},
          gl::DrawOptions{Technique::twoLookup}, capped, clustered})
        expectSame(draw(brushed(), object, perspectiveView(), options, lights).pixels, expected,
                   kAgainstReference);
    expectOther(draw(brushed(), {object.mesh}, perspectiveView(), {}, lights).pixels, expected);
}

TEST_P(Geometry, BatchesTakeHooksAndNormalMaps)
{
    const std::vector<Material> materials{brushed(),
                                          noiseMaterial(brushed().form, Storage::half, 7)};
    const auto library = renderer_->createLibrary(materials);
    const auto hooks = hooksOf(
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position.xy *= 0.5; }\n",
        "float fbrdfShadow(int light, vec3 position, vec3 toLight)\n"
        "{ return light == 2 ? 0.5 : 1.0; }\n");
    const auto mesh = renderer_->createMesh(planeMesh(0.3f, 1.0f));
    const uint32_t map = normalMap(bumps());
    std::vector<gl::Item> items;
    std::vector<std::shared_ptr<gl::GpuMaterial>> made;
    std::vector<gl::Instance> instances;
    for (int i = 0; i < 2; ++i) {
        made.push_back(renderer_->createMaterial(materials[static_cast<size_t>(i)]));
        const float x = static_cast<float>(i) - 0.5f;
        instances.push_back({glm::translate(glm::mat4(1.0f), Vec3f(x, 0.0f, 0.0f)), i});
        items.push_back({made.back().get(), mesh.get(), instances.back().model, hooks.get(), map});
    }
    Offscreen offscreen = makeOffscreen(kSize);
    const auto stats = renderer_->drawBatch(
        {offscreen.framebuffer(), kSize, kSize}, mapView(),
        {library.get(), mesh.get(), instances, hooks.get(), map}, testLights(6));
    EXPECT_EQ(stats.drawCalls, GetParam().legacy ? 2 : 1);
    expectSame(offscreen.readPixels(),
               drawItems(*renderer_, kSize, mapView(), items, testLights(6)).pixels, kSameGeometry);
}

TEST_P(Geometry, WhatIsMissingIsSaidAndTheNextDrawWorks)
{
    const auto skin = hooksOf(kSkin, "");
    Object object{planeMesh(0.0f, 1.0f), glm::mat4(1.0f), skin.get()};
    EXPECT_EQ(draw(brushed(), object).stats.itemsFailed, 1);
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("extra array 0"), std::string::npos) << log[0];
    object = {planeMesh(0.0f, 1.0f)};
    object.mesh.textureCoordinates.clear();
    object.normalMap = normalMap(bumps());
    EXPECT_EQ(draw(brushed(), object).stats.itemsFailed, 1);
    ASSERT_EQ(log.size(), 2u);
    EXPECT_NE(log[1].find("texture coordinates"), std::string::npos) << log[1];
    object.normalMap = 0;
    EXPECT_EQ(draw(brushed(), object).stats.itemsFailed, 0);
}

TEST_P(Geometry, PreparedProgramsAreThoseThatDraw)
{
    Hooks counted(context().loader());
    gl::RendererOptions options = rendererOptions();
    options.load = Hooks::load;
    options.loadUser = &counted;
    gl::Renderer renderer(options);
    gl::Hooks hooks;
    hooks.vertex =
        "void fbrdfVertexHook(inout vec3 p, inout vec3 n, inout vec4 t) { p.x += 0.1; }\n";
    const auto made = renderer.createHooks(hooks);
    const auto material = renderer.createMaterial(brushed());
    const auto mesh = renderer.createMesh(planeMesh(0.0f, 1.0f));
    const gl::Item item{material.get(), mesh.get(), glm::mat4(1.0f), made.get(),
                        normalMap(bumps())};
    renderer.prepare(item, {Technique::twoLookup}, 3);
    const int before = counted.made;
    const Drawn drawn =
        drawItems(renderer, kSize, mapView(), {item}, testLights(3), {Technique::twoLookup});
    EXPECT_EQ(drawn.stats.itemsFailed, 0);
    EXPECT_EQ(counted.made, before);
}

TEST_P(Geometry, HooksThatDoNotCompileAreRefused)
{
    expectMessages();
    expectError(ErrorKind::input, "hooks", [&] { hooksOf("void fbrdfVertexHook(", ""); });
    expectError(ErrorKind::input, "fbrdfVertexHook", [&] { hooksOf("float other;\n", ""); });
    expectError(ErrorKind::input, "fbrdfShadow", [&] { hooksOf("", "float other;\n"); });
    gl::Hooks negative;
    negative.reach = -1.0f;
    expectError(ErrorKind::input, "reach", [&] { renderer_->createHooks(negative); });
    EXPECT_EQ(draw(brushed(), {planeMesh(0.0f, 1.0f)}).stats.itemsFailed, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, Geometry, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
