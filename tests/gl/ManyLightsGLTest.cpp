// Lists of lights, culling, scissors and caps are compared with all lights in one pass.
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"
#include "support/gl/GlTest.h"
#include "support/gl/Hooks.h"
#include "support/gl/Scenes.h"

#include <numeric>
#include <random>

namespace fbrdf::test {
namespace {

constexpr int kSize = 48;
// The same terms are added in another order.
constexpr double kOrder = 1e-4;

/// Small lights near the surface of what is drawn, a few of them without a radius.
std::vector<Light> smallLights(int count)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1.3f, 1.3f), radius(0.2f, 0.8f);
    std::vector<Light> lights = testLights(count);
    for (size_t i = 0; i < lights.size(); ++i) {
        if (i % 16 == 0 || lights[i].type == Light::Type::directional) continue;
        lights[i].position = {place(random), place(random), place(random)};
        lights[i].radius = radius(random);
        lights[i].intensity *= 0.02f;
    }
    return lights;
}

class ManyLights : public GlTest {
protected:
    Drawn draw(gl::Renderer& renderer, const std::vector<Light>& lights,
               const gl::DrawOptions& options, const gl::View& view = perspectiveView())
    {
        const auto material = renderer.createMaterial(testMaterials()[0]);
        const auto mesh = renderer.createMesh(knotMesh(48, 8));
        return drawItems(renderer, kSize, view, {{material.get(), mesh.get()}}, lights, options);
    }
    bool hasLists() const { return !GetParam().legacy; }
};

TEST_P(ManyLights, ListsDrawWhatOnePassDraws)
{
    gl::Renderer renderer = makeRenderer();
    gl::DrawOptions clustered;
    clustered.clustered = true;
    for (const gl::View& view : {perspectiveView(), orthographicView()})
        for (const int count : {1, 7, 200}) {
            const auto lights = smallLights(count);
            const Drawn plain = draw(renderer, lights, {}, view),
                        listed = draw(renderer, lights, clustered, view);
            const auto difference = compareImages(listed.pixels, plain.pixels);
            EXPECT_TRUE(difference.comparable);
            EXPECT_LE(difference.maxRelative, kOrder) << describe(difference) << " of " << count;
            EXPECT_EQ(listed.stats.lightsUsed, count);
            EXPECT_TRUE(count < 200 || !hasLists() || listed.stats.maxLookups < 2 * 150);
        }
    EXPECT_EQ(log.empty(), hasLists());
}

TEST_P(ManyLights, ListsHoldMoreThanUniforms)
{
    if (!hasLists()) GTEST_SKIP() << "lists need OpenGL 3.1";
    gl::RendererOptions options = rendererOptions();
    options.capabilities = makeRenderer().capabilities();
    options.capabilities->maxUniformVectors = 64;
    gl::Renderer renderer(options);
    gl::DrawOptions clustered;
    clustered.clustered = true;
    const Drawn listed = draw(renderer, smallLights(500), clustered),
                passes = draw(renderer, smallLights(500), {});
    EXPECT_EQ(listed.stats.passes, 1);
    EXPECT_GT(passes.stats.passes, 5);
    EXPECT_LE(compareImages(listed.pixels, passes.pixels).maxRelative, kOrder);
}

TEST_P(ManyLights, NewLightsMakeNoObjectsAndNoPrograms)
{
    if (!hasLists()) GTEST_SKIP() << "lists need OpenGL 3.1";
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(knotMesh(48, 8));
    Offscreen offscreen = makeOffscreen(kSize);
    gl::DrawOptions clustered;
    clustered.clustered = true;
    int made = 0;
    for (const int count : {300, 10, 299, 1, 150}) {
        renderer.draw({offscreen.framebuffer(), kSize, kSize}, perspectiveView(),
                      {{material.get(), mesh.get()}}, smallLights(count), clustered);
        if (made == 0) made = hooks.made;
        EXPECT_EQ(hooks.made, made) << count;
    }
    EXPECT_GT(made, 0);
}

TEST_P(ManyLights, ScissoredPassesDrawWhatOnePassDraws)
{
    gl::Renderer renderer = makeRenderer();
    const auto lights = smallLights(60);
    for (const auto technique : {Technique::twoLookup, Technique::batched})
        for (const gl::View& view : {perspectiveView(), orthographicView()})
            EXPECT_LE(compareImages(draw(renderer, lights, {technique, 4}, view).pixels,
                                    draw(renderer, lights, {}, view).pixels)
                          .maxRelative,
                      kOrder);
}

TEST_P(ManyLights, ListsFollowLightsThatMove)
{
    if (!hasLists()) GTEST_SKIP() << "lists need OpenGL 3.1";
    gl::Renderer renderer = makeRenderer();
    const auto material = renderer.createMaterial(testMaterials()[0]);
    const auto mesh = renderer.createMesh(knotMesh(48, 8));
    gl::DrawOptions clustered;
    clustered.clustered = true;
    auto lights = smallLights(100);
    const auto drawn = [&](const gl::DrawOptions& options) {
        return drawItems(renderer, kSize, perspectiveView(), {{material.get(), mesh.get()}}, lights,
                         options)
            .pixels;
    };
    const auto before = drawn(clustered);
    EXPECT_EQ(drawn(clustered), before);  // nothing has moved
    for (Light& light : lights) light.position.x += 0.3f;
    const auto moved = drawn(clustered);
    EXPECT_NE(moved, before);
    EXPECT_LE(compareImages(moved, drawn({})).maxRelative, kOrder);
    // So few that each fragment looks at all of them.
    lights.resize(5);
    const auto few = drawn(clustered);
    EXPECT_EQ(few, drawn({}));
    lights = smallLights(100);
    EXPECT_EQ(drawn(clustered), before);
}

TEST_P(ManyLights, BatchesOfLightsThatAreNearShadeFewPixels)
{
    Hooks hooks(context().loader());
    gl::Renderer renderer(hooked(hooks));
    std::vector<Light> lights;
    for (int i = 0; i < 64; ++i) {
        Light light;
        light.position = {0.25f * static_cast<float>((i * 37) % 8) - 0.9f,
                          0.25f * static_cast<float>((i * 29) % 64 / 8) - 0.9f, 0.4f};
        light.radius = 0.3f;
        lights.push_back(light);
    }
    draw(renderer, lights, {});  // what the first material needs is drawn now
    const auto samples = [&] {
        hooks.samples.clear();
        hooks.countSamples = true;
        draw(renderer, lights, {Technique::batched, 8});
        hooks.countSamples = false;
        return std::pair{hooks.samples.front(),
                         std::accumulate(hooks.samples.begin() + 1, hooks.samples.end(), 0u)};
    };
    const auto [first, added] = samples();
    EXPECT_GT(added, 0u);
    EXPECT_LT(added, 7 * first / 2);  // of seven passes, half is never reached
}

// Lists that have the same lights in the same order give the same sums.
TEST_P(ManyLights, ListsOfTheGpuDrawWhatThoseOfTheCpuDo)
{
    gl::Renderer renderer = makeRenderer();
    if (!hasLists() || renderer.capabilities().computeBuffers == 0)
        GTEST_SKIP() << "needs compute shaders";
    const auto material =
        renderer.createMaterial(withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2)));
    const auto mesh = renderer.createMesh(knotMesh(48, 8));
    gl::DrawOptions options;
    options.clustered = true;
    for (int i = 0; i < 12; ++i) {
        AreaLight light;
        light.shape = i % 2 == 0 ? AreaLight::Shape::disc : AreaLight::Shape::rectangle;
        const float angle = static_cast<float>(i);
        light.position = {1.2f * std::cos(angle), 1.2f * std::sin(angle), 0.3f};
        light.normal = {std::sin(angle), 0.3f, -std::cos(angle)};
        light.size = 0.2f;
        light.radius = 1.5f;
        options.areaLights.push_back(light);
    }
    for (const gl::View& view : {perspectiveView(), orthographicView()})
        for (const int count : {9, 130}) {
            auto lights = smallLights(count);
            for (size_t i = 3; i < lights.size(); i += 4) {
                if (lights[i].type == Light::Type::directional) continue;
                lights[i].type = Light::Type::spot;
                lights[i].axis = -lights[i].position;
            }
            for (Light& light : lights) light.radius *= 2.0f;  // fewer clusters
            const auto drawBy = [&](gl::ListsBy who) {
                options.listsBy = who;
                return drawItems(renderer, kSize, view, {{material.get(), mesh.get()}}, lights,
                                 options);
            };
            const Drawn cpu = drawBy(gl::ListsBy::cpu), gpu = drawBy(gl::ListsBy::gpu);
            EXPECT_EQ(cpu.stats.listsBy, gl::ListsBy::cpu);
            EXPECT_EQ(cpu.stats.whyListsByCpu, "asked for");
            EXPECT_EQ(gpu.stats.listsBy, gl::ListsBy::gpu) << gpu.stats.whyListsByCpu;
            EXPECT_EQ(gpu.stats.whyListsByCpu, "");
            EXPECT_EQ(gpu.pixels, cpu.pixels) << count;
            EXPECT_EQ(drawBy(gl::ListsBy::gpu).pixels, gpu.pixels);
        }
    for (const std::string& line : log) ADD_FAILURE() << line;
}

TEST_P(ManyLights, ListsAreMadeByWhomIsSaid)
{
    gl::Renderer renderer = makeRenderer();
    gl::DrawOptions options;
    options.clustered = true;
    // Here the renderer is one in software.
    const Drawn automatic = draw(renderer, smallLights(100), options);
    EXPECT_EQ(automatic.stats.listsBy, hasLists() ? gl::ListsBy::cpu : gl::ListsBy::automatic);
    const bool isSoftware = renderer.capabilities().softwareSampling;
    EXPECT_EQ(automatic.stats.whyListsByCpu.find("software") != std::string::npos,
              hasLists() && isSoftware);
    if (!hasLists()) return;
    options.listsBy = gl::ListsBy::gpu;
    options.maxLights = 10;
    const Drawn limited = draw(renderer, smallLights(100), options);
    EXPECT_EQ(limited.stats.listsBy, gl::ListsBy::cpu);
    EXPECT_NE(limited.stats.whyListsByCpu.find("limit of 10 lights"), std::string::npos);
    EXPECT_EQ(log.size(), 1u);
    const Drawn few = draw(renderer, smallLights(4), options);
    EXPECT_EQ(few.stats.listsBy, gl::ListsBy::automatic);
    EXPECT_EQ(few.stats.whyListsByCpu, "");
}

TEST_P(ManyLights, ListsMayBeCapped)
{
    gl::Renderer renderer = makeRenderer();
    const auto lights = smallLights(200);
    gl::DrawOptions options;
    options.clustered = true;
    const Drawn all = draw(renderer, lights, options);
    options.maxLights = 200;
    const Drawn roomy = draw(renderer, lights, options);
    EXPECT_EQ(roomy.stats.lightsDropped, 0);
    EXPECT_LE(compareImages(roomy.pixels, all.pixels).maxRelative, kOrder);
    options.maxLights = 20;
    const Drawn capped = draw(renderer, lights, options);
    EXPECT_GT(capped.stats.lightsDropped, 0);
    EXPECT_LE(capped.stats.maxLookups, 1 + 2 * 20);
    EXPECT_GT(compareImages(capped.pixels, all.pixels).meanRelative, 1e-3);
}

TEST_P(ManyLights, WhatDoesNotReachAnItemIsCulledAndCounted)
{
    gl::Renderer renderer = makeRenderer();
    auto lights = testLights(4);
    for (Light& light : lights) light.radius = 0.0f;
    const Drawn before = draw(renderer, lights, {});
    for (int i = 0; i < 100; ++i) {
        Light far;
        far.position = {50.0f + static_cast<float>(i), 0.0f, 0.0f};
        far.radius = 3.0f;
        lights.push_back(far);
    }
    const Drawn after = draw(renderer, lights, {Technique::twoLookup, 8, 0});
    EXPECT_EQ(after.stats.lightsCulled, 100);
    EXPECT_EQ(after.stats.passes, 5);
    EXPECT_EQ(after.stats.lightsDropped, 0);
    EXPECT_LE(compareImages(after.pixels, before.pixels).maxRelative, kOrder);
}

TEST_P(ManyLights, ACapKeepsTheStrongestAndCountsTheRest)
{
    gl::Renderer renderer = makeRenderer();
    std::vector<Light> strong = testLights(3), all;
    for (Light& light : strong) light.radius = 0.0f;
    for (int i = 0; i < 20; ++i) {
        Light weak = strong[0];
        weak.intensity *= 1e-4f;
        all.push_back(weak);
    }
    all.insert(all.end(), strong.begin(), strong.end());
    gl::DrawOptions options;
    options.maxLights = 3;
    const Drawn capped = draw(renderer, all, options);
    EXPECT_EQ(capped.stats.lightsDropped, 20);
    EXPECT_LE(compareImages(capped.pixels, draw(renderer, strong, {}).pixels).maxRelative, kOrder);
    options.maxLights = -1;
    EXPECT_THROW(draw(renderer, all, options), Error);
}

INSTANTIATE_TEST_SUITE_P(Backends, ManyLights, ::testing::ValuesIn(allVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
