// Objects are deleted in any order, a lost context is not touched, renderers exist side by side.
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

class Lifetime : public GlTest {
protected:
    static void expectNothingAlive(const Hooks& hooks)
    {
        for (const auto& [kind, count] : hooks.alive) EXPECT_EQ(count, 0) << kind;
        EXPECT_GT(hooks.made, 0);
        EXPECT_EQ(hooks.made, hooks.deleted);
    }
    void drawEverything(gl::Renderer& renderer)
    {
        const auto mesh = renderer.createMesh(sphereMesh(8));
        for (const Material& material : testMaterials()) {
            const auto gpu = renderer.createMaterial(material);
            for (const OffscreenFormat format : {OffscreenFormat::rgba32f, OffscreenFormat::rgba8})
                for (const Technique technique : {Technique::single, Technique::twoLookup}) {
                    Offscreen offscreen = makeOffscreen(kSize, format);
                    renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                  {{gpu.get(), mesh.get()}}, testLights(3), {technique, 8, 0});
                }
        }
    }
};

TEST_P(Lifetime, EveryObjectIsDeleted)
{
    Hooks hooks(context().loader());
    {
        gl::Renderer renderer(hooked(hooks));
        drawEverything(renderer);
    }
    expectNothingAlive(hooks);
}

TEST_P(Lifetime, MaterialsMayOutliveTheRenderer)
{
    Hooks hooks(context().loader());
    {
        std::shared_ptr<gl::GpuMaterial> material;
        std::shared_ptr<gl::GpuMesh> mesh;
        {
            gl::Renderer renderer(hooked(hooks));
            material = renderer.createMaterial(testMaterials()[0]);
            mesh = renderer.createMesh(sphereMesh(4));
        }
        EXPECT_GT(hooks.alive.at("Textures"), 0);
    }
    expectNothingAlive(hooks);
}

TEST_P(Lifetime, DrawingAgainMakesNothingNew)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto mesh = renderer.createMesh(sphereMesh(8));
    const auto gpu = renderer.createMaterial(testMaterials()[4]);
    Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
    const auto draw = [&](int lights) {
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{gpu.get(), mesh.get()}}, testLights(lights), {Technique::twoLookup, 8, 0});
    };
    draw(3);
    const int made = hooks.made;
    for (const int lights : {3, 1, 7, 20}) draw(lights);
    EXPECT_EQ(hooks.made, made);
}

TEST_P(Lifetime, RefusedThingsLeaveNothingBehind)
{
    Hooks hooks(context().loader());
    {
        gl::Renderer renderer(hooked(hooks));
        Material broken = testMaterials()[0];
        broken.tables[1].texels[7] = std::numeric_limits<float>::quiet_NaN();
        EXPECT_THROW(renderer.createMaterial(broken), Error);
        hooks.corruptShaders = true;
        expectMessages();
        EXPECT_THROW(renderer.createMaterial(testMaterials()[0]), Error);
        hooks.corruptShaders = false;
        gl::MeshData mesh = sphereMesh(4);
        mesh.indices.back() = 1u << 20;
        EXPECT_THROW(renderer.createMesh(mesh), Error);
    }
    expectNothingAlive(hooks);
}

TEST_P(Lifetime, AnAbandonedContextIsNotTouched)
{
    Hooks hooks(context().loader());
    {
        gl::Renderer renderer(hooked(hooks));
        const auto material = renderer.createMaterial(testMaterials()[0]);
        const auto mesh = renderer.createMesh(sphereMesh(4));
        renderer.abandonContext();
        EXPECT_THROW(renderer.createMaterial(testMaterials()[0]), Error);
        EXPECT_THROW(renderer.draw({0, 8, 8}, perspectiveView(), {}, {}), Error);
        hooks.deleted = 0;
    }
    EXPECT_EQ(hooks.deleted, 0);
}

TEST_P(Lifetime, RenderersMove)
{
    gl::Renderer first = makeRenderer();
    const auto material = first.createMaterial(testMaterials()[2]);
    const auto mesh = first.createMesh(sphereMesh(8));
    gl::Renderer second = std::move(first);
    Offscreen offscreen = makeOffscreen(kSize);
    const auto stats = second.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                                   {{material.get(), mesh.get()}}, testLights(2));
    EXPECT_EQ(stats.itemsFailed, 0);
    first = makeRenderer();
    EXPECT_EQ(first.glVersion(), second.glVersion());
}

TEST_P(Lifetime, RenderersInSeveralContextsDoNotDisturbEachOther)
{
    struct One {
        HeadlessContext context;
        Offscreen offscreen;
        gl::Renderer renderer;
        std::shared_ptr<gl::GpuMaterial> material;
        std::shared_ptr<gl::GpuMesh> mesh;
    };
    const auto make = [](Backend backend) {
        HeadlessContext made({backend, HeadlessOptions::Profile::core, 3, 3, true});
        Offscreen offscreen(made.loader(), {kSize, kSize, OffscreenFormat::rgba32f, true});
        gl::RendererOptions options;
        options.load = made.loader();
        gl::Renderer renderer(options);
        auto material = renderer.createMaterial(testMaterials()[1]);
        auto mesh = renderer.createMesh(knotMesh(48, 8));
        return One{std::move(made), std::move(offscreen), std::move(renderer), material, mesh};
    };
    const auto draw = [](One& one) {
        one.context.makeCurrent();
        one.offscreen.clear();
        one.renderer.draw({one.offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                          {{one.material.get(), one.mesh.get()}}, testLights(5),
                          {Technique::twoLookup, 8, 0});
        return one.offscreen.readPixels();
    };
    std::vector<One> all;
    for (const Backend backend : {Backend::egl, Backend::osmesa, Backend::egl})
        all.push_back(make(backend));
    const auto expected = draw(all[0]);
    for (int round = 0; round < 2; ++round)
        for (One& one : all) EXPECT_EQ(draw(one), expected);  // all have the same rasteriser
    // A material of another context is refused, not drawn with.
    all[0].context.makeCurrent();
    const auto stats =
        all[0].renderer.draw({all[0].offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                             {{all[1].material.get(), all[0].mesh.get()}}, testLights(1));
    EXPECT_EQ(stats.itemsFailed, 1);
    EXPECT_EQ(stats.drawCalls, 0);
    while (!all.empty()) {
        all.back().context.makeCurrent();
        all.back().material.reset();
        all.back().mesh.reset();
        {
            const One last = std::move(all.back());
        }
        all.pop_back();
    }
    context().makeCurrent();
}

INSTANTIATE_TEST_SUITE_P(Backends, Lifetime, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
