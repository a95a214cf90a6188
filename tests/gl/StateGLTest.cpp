// Whatever state the host has, the picture is the same, and the state is the host's again after.
#include "StateTest.h"

#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <algorithm>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;
constexpr unsigned kSeeds = 24;

class State : public StateTest {
protected:
    /// Scrambles the state, acts, compares the state, and leaves defaults.
    template <class Act>
    void expectKept(unsigned seed, Act act)
    {
        scrambler_->scramble(seed);
        const StateSnapshot before = now();
        act();
        EXPECT_EQ(difference(before, now()), "") << "seed " << seed;
        scrambler_->setDefaults();
    }
};

TEST_P(State, DrawingPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    const auto mesh = renderer_->createMesh(knotMesh(48, 8));
    const auto material = renderer_->createMaterial(testMaterials()[4]);
    const auto lights = testLights(3);
    const gl::View view = perspectiveView();
    for (const OffscreenFormat format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8})
        for (const Technique technique : {Technique::single, Technique::twoLookup}) {
            Offscreen offscreen = makeOffscreen(kSize, format);
            const gl::Target target{offscreen.framebuffer(), kSize, kSize};
            const auto draw = [&] {
                renderer_->draw(target, view, {{material.get(), mesh.get()}}, lights,
                                {technique, 8, 0});
            };
            draw();
            const auto expected = offscreen.readPixels();
            for (unsigned seed = 0; seed < kSeeds; ++seed) {
                offscreen.clear();
                expectKept(seed, draw);
                ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
            }
        }
}

TEST_P(State, ListsMadeByTheGpuPutBackWhatTheyFindAndAreNotDisturbedByIt)
{
    if (!isCore() || renderer_->capabilities().computeBuffers == 0)
        GTEST_SKIP() << "needs compute shaders";
    const auto mesh = renderer_->createMesh(knotMesh(48, 8));
    const auto material = renderer_->createMaterial(testMaterials()[4]);
    std::vector<Light> lights = testLights(30);
    gl::DrawOptions options;
    options.clustered = true;
    options.listsBy = gl::ListsBy::gpu;
    Offscreen offscreen = makeOffscreen(kSize);
    const auto draw = [&] {
        lights[1].position.x = -lights[1].position.x;  // lists are made anew
        const auto stats =
            renderer_->draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                            {{material.get(), mesh.get()}}, lights, options);
        EXPECT_EQ(stats.listsBy, gl::ListsBy::gpu) << stats.whyListsByCpu;
    };
    draw();
    offscreen.clear();
    draw();
    const auto expected = offscreen.readPixels();
    for (unsigned seed = 0; seed < kSeeds / 2; ++seed) {
        expectKept(seed, draw);
        offscreen.clear();
        expectKept(seed + kSeeds, draw);
        ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
    }
}

TEST_P(State, IsPutBackWhereQueriesWithoutAnIndexAreCoarse)
{
    Hooks hooks(context().loader());
    hooks.coarseQueries = true;
    gl::Renderer renderer(hooked(hooks));
    const auto mesh = renderer.createMesh(sphereMesh(4));
    const auto material = renderer.createMaterial(testMaterials()[0]);
    Offscreen offscreen = makeOffscreen(kSize);
    for (unsigned seed = 0; seed < kSeeds; ++seed)
        expectKept(seed, [&] {
            renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                          {{material.get(), mesh.get()}}, testLights(3));
        });
}

TEST_P(State, HooksAndNormalMapsPutBackWhatTheyFindAndAreNotDisturbedByIt)
{
    gl::MeshData shape = sphereMesh(12);
    shape.tangents.clear();
    for (const Vec3f& p : shape.positions) shape.textureCoordinates.emplace_back(p.x, p.y);
    shape.extra.emplace_back(shape.positions.size(), glm::vec4(0.1f));
    gl::Hooks hooks;
    hooks.vertex =
        "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position *= 1.0 - fbrdfExtra0.x; }\n";
    hooks.shadow = "float fbrdfShadow(int light, vec3 position, vec3 toLight) { return 0.5; }\n";
    const auto mesh = renderer_->createMesh(shape);
    const auto material = renderer_->createMaterial(testMaterials()[0]);
    std::shared_ptr<gl::GpuHooks> made = renderer_->createHooks(hooks);
    expectKept(3, [&] { made = renderer_->createHooks(hooks); });
    const unsigned char bump[] = {160, 100, 255, 255};
    GLuint map = 0;
    gl().GenTextures(1, &map);
    gl().BindTexture(GL_TEXTURE_2D, map);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bump);
    gl().BindTexture(GL_TEXTURE_2D, 0);
    Offscreen offscreen = makeOffscreen(kSize);
    const auto draw = [&] {
        const auto stats = renderer_->draw(
            {offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
            {{material.get(), mesh.get(), glm::mat4(1.0f), made.get(), map}}, testLights(3));
        EXPECT_EQ(stats.itemsFailed, 0);
    };
    draw();
    const auto expected = offscreen.readPixels();
    for (unsigned seed = 0; seed < kSeeds / 3; ++seed) {
        offscreen.clear();
        expectKept(seed, draw);
        ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
    }
    gl().DeleteTextures(1, &map);
}

TEST_P(State, MakingThingsPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    Offscreen offscreen = makeOffscreen(kSize);
    const gl::Target target{offscreen.framebuffer(), kSize, kSize};
    const auto lights = testLights(3);
    std::vector<float> expected;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        std::shared_ptr<gl::GpuMaterial> material;
        std::shared_ptr<gl::GpuMesh> mesh;
        if (seed == 0) {
            material = renderer_->createMaterial(everythingMaterial());
            mesh = renderer_->createMesh(sphereMesh(8));
        } else {
            expectKept(seed, [&] { material = renderer_->createMaterial(everythingMaterial()); });
            expectKept(seed, [&] { mesh = renderer_->createMesh(sphereMesh(8)); });
        }
        offscreen.clear();
        renderer_->draw(target, perspectiveView(), {{material.get(), mesh.get()}}, lights);
        if (seed == 0) expected = offscreen.readPixels();
        ASSERT_EQ(offscreen.readPixels(), expected) << "seed " << seed;
    }
}

// The filter of a context is measured when the first material is made.
TEST_P(State, MeasuringPutsBackWhatItFindsAndIsNotDisturbedByIt)
{
    double expected = 0.0;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        renderer_ = std::make_unique<gl::Renderer>(makeRenderer());
        std::shared_ptr<gl::GpuMaterial> material;
        expectKept(seed, [&] { material = renderer_->createMaterial(everythingMaterial()); });
        if (seed == 0) expected = material->filterError();
        ASSERT_GT(expected, 0.0);
        ASSERT_EQ(material->filterError(), expected) << "seed " << seed;
    }
    EXPECT_TRUE(std::none_of(log.begin(), log.end(), [](const std::string& line) {
        return line.find("assumed") != std::string::npos;
    }));
}

TEST_P(State, CubeMapsPutBackWhatTheyFindAndAreNotDisturbedByIt)
{
    const auto mesh = renderer_->createMesh(knotMesh(48, 8));
    Offscreen offscreen = makeOffscreen(kSize);
    std::vector<float> expected;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        std::shared_ptr<gl::GpuMaterial> material;
        expectKept(seed, [&] {
            material = renderer_->createMaterial(testMaterials()[0], {LookUp::cube, 8});
        });
        offscreen.clear();
        expectKept(seed, [&] {
            renderer_->draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                            {{material.get(), mesh.get()}}, testLights(3));
        });
        const auto pixels = offscreen.readPixels();
        if (seed == 0) expected = pixels;
        ASSERT_EQ(pixels, expected) << "seed " << seed;
    }
}

TEST_P(State, LibrariesPutBackWhatTheyFindAndAreNotDisturbedByIt)
{
    const auto mesh = renderer_->createMesh(knotMesh(48, 8));
    const Form form = formPqpr(8, 0.5, 6);
    const Material material = noiseMaterial(form, Storage::log8);
    Offscreen offscreen = makeOffscreen(kSize);
    std::vector<float> expected;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        std::shared_ptr<gl::GpuLibrary> library;
        offscreen.clear();
        expectKept(seed, [&] {
            library = renderer_->createLibrary({material, noiseMaterial(form, Storage::log8, 2)});
        });
        expectKept(seed, [&] { renderer_->replaceMaterial(*library, 0, material); });
        expectKept(seed, [&] {
            renderer_->drawBatch({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                 {library.get(), mesh.get(), {{glm::mat4(1.0f), 1}, {}}},
                                 testLights(3));
        });
        const auto pixels = offscreen.readPixels();
        if (seed == 0) expected = pixels;
        ASSERT_EQ(pixels, expected) << "seed " << seed;
    }
}

TEST_P(State, ListsOfLightsPutBackWhatTheyFind)
{
    const auto mesh = renderer_->createMesh(knotMesh(48, 8));
    const auto material = renderer_->createMaterial(testMaterials()[4]);
    Offscreen offscreen = makeOffscreen(kSize);
    gl::DrawOptions options;
    options.clustered = true;
    const auto draw = [&] {
        renderer_->draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                        {{material.get(), mesh.get()}}, testLights(12), options);
    };
    std::vector<float> expected;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        offscreen.clear();
        expectKept(seed, draw);  // the first also makes the buffers
        const auto pixels = offscreen.readPixels();
        if (seed == 0) expected = pixels;
        ASSERT_EQ(pixels, expected) << "seed " << seed;
    }
}

TEST_P(State, PreparingPutsBackWhatItFinds)
{
    const auto material = renderer_->createMaterial(testMaterials()[0]);
    for (unsigned seed = 0; seed < 4; ++seed)
        expectKept(seed, [&] { renderer_->prepare(*material, {Technique::twoLookup, 8, 0}, 3); });
}

TEST_P(State, ADrawThatIsRefusedPutsBackWhatItFinds)
{
    Offscreen flat(context().loader(), {8, 8, OffscreenFormat::rgba32f, false});
    for (unsigned seed = 0; seed < kSeeds; ++seed)
        expectKept(seed, [&] {
            EXPECT_THROW(renderer_->draw({flat.framebuffer(), 8, 8}, perspectiveView(), {}, {}),
                         Error);
        });
}

TEST_P(State, AnUnusedTextureUnitIsLeftAlone)
{
    gl::RendererOptions options = rendererOptions();
    options.firstTextureUnit = 3;
    gl::Renderer renderer(options);
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(sphereMesh(8));
    Offscreen offscreen = makeOffscreen(kSize);
    const gl::Target target{offscreen.framebuffer(), kSize, kSize};
    const auto lights = testLights(3);
    renderer.draw(target, perspectiveView(), {{material.get(), mesh.get()}}, lights);
    const auto expected = offscreen.readPixels();
    expectKept(1, [&] {
        renderer.draw(target, perspectiveView(), {{material.get(), mesh.get()}}, lights);
    });
    EXPECT_EQ(offscreen.readPixels(), expected);
}

INSTANTIATE_TEST_SUITE_P(Backends, State, ::testing::ValuesIn(allVariants()), variantName);

// The tester itself: a host call that leaves something behind is noticed, and scrambling scrambles.
class StateTester : public State {};

TEST_P(StateTester, NoticesEveryKindOfChange)
{
    const StateSnapshot before = now();
    const auto changed = [&](auto act) {
        act();
        const bool seen = !difference(before, now()).empty();
        scrambler_->setDefaults();
        return seen;
    };
    const auto& g = gl();
    EXPECT_FALSE(changed([] {}));
    EXPECT_TRUE(changed([&] { g.Enable(GL_CULL_FACE); }));
    EXPECT_TRUE(changed([&] { g.DepthFunc(GL_EQUAL); }));
    EXPECT_TRUE(changed([&] { g.ColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE); }));
    EXPECT_TRUE(changed([&] { g.ActiveTexture(GL_TEXTURE3); }));
    EXPECT_TRUE(changed([&] { g.Viewport(1, 2, 3, 4); }));
    EXPECT_TRUE(changed([&] { g.PixelStorei(GL_UNPACK_ALIGNMENT, 2); }));
}

TEST_P(StateTester, ScramblingChangesMostOfIt)
{
    const StateSnapshot before = now();
    size_t lines = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        scrambler_->scramble(seed);
        const std::string text = difference(before, now());
        lines += static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
        scrambler_->setDefaults();
    }
    EXPECT_GT(lines, 4u * 50u);
}

INSTANTIATE_TEST_SUITE_P(Backends, StateTester, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
