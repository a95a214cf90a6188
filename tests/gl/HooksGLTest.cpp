// Vertex and shadow hooks of the host are compared with the CPU, or with a mesh whose own arrays
// contain the same.
#include "GeometryTest.h"

#include "support/ExpectError.h"
#include "support/gl/Hooks.h"

#include <algorithm>
#include <limits>

namespace fbrdf::test {
namespace {

class HostHooks : public Geometry {};

constexpr const char* kSkin =
    "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
    "uniform vec4 bones[4];\n"  // columns of the bone that moves
    "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
    "{\n"
    "    if (fbrdfExtra0.x > 0.5) {\n"
    "        mat3 turn = mat3(bones[0].xyz, bones[1].xyz, bones[2].xyz);\n"
    "        position = turn * position + bones[3].xyz;\n"
    "        normal = turn * normal;\n"
    "        tangent.xyz = turn * tangent.xyz;\n"
    "    }\n"
    "}\n";

TEST_P(HostHooks, AVertexHookSkinsInEveryTechnique)
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
    for (const auto technique : allTechniques()) {
        const gl::DrawOptions options{technique, 2};
        expectSame(
            draw(brushed(), {skinned, glm::mat4(1.0f), skin.get()}, perspectiveView(), options)
                .pixels,
            draw(brushed(), {baked}, perspectiveView(), options).pixels, kSameGeometry);
    }
    EXPECT_TRUE(log.empty()) << log[0];
}

TEST_P(HostHooks, WhatAVertexHookMovesIsLitWhereItEndsUp)
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
    EXPECT_EQ(lit(wrong.get(), behind).stats.lightsCulled, 1);  // the reach of this hook is false
}

constexpr const char* kShadow =
    "uniform float shade;\n"
    "float fbrdfShadow(int light, vec3 position, vec3 toLight)\n"
    "{\n"
    "    if (light == 1) return 0.0;\n"
    "    return position.x > 0.1 ? shade : 1.0 / (1.0 + 0.1 * float(light));\n"
    "}\n";

TEST_P(HostHooks, AShadowHookKnowsEveryLightByItsPlace)
{
    gl::Hooks hooks;
    hooks.shadow = kShadow;
    hooks.shadowUniforms = 1;
    hooks.setUniforms = [&](uint32_t program) {
        gl().Uniform1f(gl().GetUniformLocation(program, "shade"), 0.25f);
    };
    const auto shadow = renderer_->createHooks(hooks);
    auto lights = testLights(9);
    lights[0].position.x =
        std::numeric_limits<float>::quiet_NaN();  // it keeps its place all the same
    SurfaceReference surface;
    surface.shadow = [](size_t light, const Vec3d& position) {
        if (light == 1) return 0.0;
        return position.x > double(0.1f) ? 0.25 : 1.0 / (1.0 + 0.1 * static_cast<double>(light));
    };
    const Object object{sphereMesh(16), glm::mat4(1.0f), shadow.get()};
    const auto expected = reference(brushed(), object, surface, perspectiveView(), lights);
    gl::DrawOptions capped, clustered;
    capped.maxLights = 8;  // a limit sorts the lights
    clustered.clustered = !GetParam().legacy;
    for (const gl::DrawOptions& options :
         {gl::DrawOptions{}, gl::DrawOptions{Technique::batched, 3},
          gl::DrawOptions{Technique::twoLookup}, capped, clustered})
        expectSame(draw(brushed(), object, perspectiveView(), options, lights).pixels, expected,
                   kAgainstReference);
    expectOther(draw(brushed(), {object.mesh}, perspectiveView(), {}, lights).pixels, expected);
}

TEST_P(HostHooks, BatchesTakeHooksAndNormalMaps)
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

TEST_P(HostHooks, WhatIsMissingIsReportedAndTheNextDrawWorks)
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

TEST_P(HostHooks, PreparedProgramsAreThoseThatDraw)
{
    Hooks counted(context().loader());
    gl::Renderer renderer(hooked(counted));
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

// What a host is told of passes is the plan that is drawn, in its order.
TEST_P(HostHooks, APassWatchIsToldOfEveryPass)
{
    std::vector<gl::PassEvent> begun;
    std::vector<Pass> passes;
    size_t ended = 0;
    gl::RendererOptions options = rendererOptions();
    options.passes.begins = [&](const gl::PassEvent& event) {
        EXPECT_EQ(begun.size(), ended) << "one after the other";
        begun.push_back(event);
        passes.push_back(*event.pass);
    };
    options.passes.ends = [&](const gl::PassEvent& event) {
        EXPECT_EQ(event.index, begun.back().index);
        ++ended;
    };
    gl::Renderer renderer(options);
    const auto material = renderer.createMaterial(brushed());
    const auto mesh = renderer.createMesh(planeMesh(0.0f, 1.0f));
    EXPECT_TRUE(begun.empty());
    for (const auto technique : allTechniques()) {
        begun.clear();
        passes.clear();
        ended = 0;
        const Drawn drawn = drawItems(renderer, kSize, mapView(), {{material.get(), mesh.get()}},
                                      testLights(3), {technique});
        ASSERT_EQ(static_cast<int>(begun.size()), drawn.stats.passes) << techniqueName(technique);
        EXPECT_EQ(ended, begun.size());
        int lookups = 0, lights = 0;
        for (size_t i = 0; i < begun.size(); ++i) {
            EXPECT_EQ(begun[i].index, static_cast<int>(i));
            EXPECT_EQ(begun[i].count, drawn.stats.passes);
            lookups = std::max(lookups, begun[i].lookups);
            if (passes[i].lit) lights += passes[i].lightCount;
        }
        EXPECT_EQ(lookups, drawn.stats.maxLookups);
        EXPECT_GE(lights, 3);
        EXPECT_EQ(passes[0].blend, Blend::replace);
    }
}

// An error that quotes the compiler may have several lines, which expectError refuses.
template <class Action>
void expectCompilersWords(const std::string& words, const Action& action)
{
    try {
        action();
        ADD_FAILURE() << "nothing was thrown, expected the words: " << words;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST_P(HostHooks, HooksThatDoNotCompileAreRefused)
{
    expectMessages();
    expectCompilersWords("hooks", [&] { hooksOf("void fbrdfVertexHook(", ""); });
    expectCompilersWords("fbrdfVertexHook", [&] { hooksOf("float other;\n", ""); });
    expectCompilersWords("fbrdfShadow", [&] { hooksOf("", "float other;\n"); });
    gl::Hooks negative;
    negative.reach = -1.0f;
    expectError(ErrorKind::input, "reach", [&] { renderer_->createHooks(negative); });
    EXPECT_EQ(draw(brushed(), {planeMesh(0.0f, 1.0f)}).stats.itemsFailed, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, HostHooks, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
