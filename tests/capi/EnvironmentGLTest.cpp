// EnvironmentGLTest.cpp - light from everywhere and from area lights through the C ABI.
#include "CApiTest.h"
#include "Materials.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

namespace fbrdf::test {
namespace {

class CApiEnvironmentGL : public CApiTest {
protected:
    fbrdf_environment_desc grey(float radiance)
    {
        texels_.assign(3 * 8 * 4, radiance);
        auto desc = abi::describe<fbrdf_environment_desc>();
        desc.width = 8;
        desc.height = 4;
        desc.size = 16;
        desc.radiance = texels_.data();
        return desc;
    }

    /// Draws a square of the plain material until its lobes are there: its file has none, so they
    /// are fitted beside the drawing thread. Expects albedo x radiance everywhere.
    /// share: by how much of itself the albedo may be off. Returns the stats of the last draw.
    fbrdf_draw_stats expectAlbedo(Plain& plain, fbrdf_draw_desc& draw, float radiance,
                                  float share = 0.005f)
    {
        EXPECT_TRUE(plain.gpuMaterial);
        Offscreen offscreen = makeOffscreen(kSize);
        const float quad[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
        const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
        const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
        auto meshDesc = abi::describe<fbrdf_mesh_desc>();
        meshDesc.vertex_count = 4;
        meshDesc.index_count = 6;
        meshDesc.positions = quad;
        meshDesc.normals = normals;
        meshDesc.indices = indices;
        abi::Mesh mesh;
        EXPECT_EQ(mesh.create(fbrdf_mesh_create, plain.renderer.get(), &meshDesc), FBRDF_RESULT_OK);
        fbrdf_item item{};
        item.material = plain.gpuMaterial.get();
        item.mesh = mesh.get();
        draw.framebuffer = offscreen.framebuffer();
        draw.width = draw.height = kSize;
        for (int i = 0; i < 16; i += 5) draw.view[i] = draw.projection[i] = item.model[i] = 1.0f;
        draw.projection[10] = -1.0f;  // the camera looks along -z
        draw.item_count = 1;
        draw.item_size = sizeof item;
        draw.items = &item;
        auto stats = abi::describe<fbrdf_draw_stats>();
        for (int frame = 0; frame < 600; ++frame) {
            offscreen.clear();  // what was drawn without lobes is as near
            EXPECT_EQ(fbrdf_draw(plain.renderer.get(), &draw, &stats), FBRDF_RESULT_OK);
            if (stats.items_without_environment == 0) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        EXPECT_EQ(stats.items_without_environment, 0u) << stats.why_no_environment;
        EXPECT_EQ(stats.lights_given, draw.area_light_count);
        // f is constant: 1/4 R, 1/2 G, 1 B, so its albedo is pi f; white furnace within a 200th.
        const std::vector<float> pixels = offscreen.readPixels();
        const float expected = 3.14159265f * radiance;
        for (size_t i = 0; i < pixels.size(); i += 4) {
            EXPECT_NEAR(pixels[i], 0.25f * expected, share * 0.25f * expected);
            EXPECT_NEAR(pixels[i + 1], 0.5f * expected, share * 0.5f * expected);
            EXPECT_NEAR(pixels[i + 2], expected, share * expected);
        }
        return stats;
    }

    std::vector<float> texels_;
};

TEST_P(CApiEnvironmentGL, LightsAnObject)
{
    Plain plain;
    makePlain(plain);
    auto desc = grey(1.0f);
    desc.unfiltered = 1;
    abi::Environment environment;
    ASSERT_EQ(environment.create(fbrdf_environment_create, plain.renderer.get(), &desc),
              FBRDF_RESULT_OK)
        << (plain.lines.empty() ? "" : plain.lines[0].text);
    auto light = abi::describe<fbrdf_environment_light>();
    light.environment = environment.get();
    light.intensity[0] = light.intensity[1] = light.intensity[2] = 0.5f;
    auto draw = abi::describe<fbrdf_draw_desc>();
    draw.environment = &light;
    EXPECT_GT(expectAlbedo(plain, draw, 0.5f).environment_error, 0.0f);
    // By directions; by lobes where another technique is asked for.
    light.samples = 256;
    auto stats = expectAlbedo(plain, draw, 0.5f, 0.02f);
    EXPECT_STREQ(stats.why_not_sampled, "");
    EXPECT_EQ(stats.environment_error, 0.0f);
    draw.technique = FBRDF_TECHNIQUE_TWO_LOOKUP;
    stats = expectAlbedo(plain, draw, 0.5f);
    EXPECT_NE(std::string(stats.why_not_sampled).find("two-lookup"), std::string::npos);
    light.samples = 5000;
    draw.item_count = 0;
    EXPECT_EQ(fbrdf_draw(plain.renderer.get(), &draw, &stats), FBRDF_RESULT_ERROR_ARGUMENT);
}

// From inside a sphere, or from between two squares that are far larger than their distance, light
// comes from everywhere.
TEST_P(CApiEnvironmentGL, AreaLightsLightAnObject)
{
    Plain plain;
    makePlain(plain);
    fbrdf_area_light sphere{}, ceiling{};
    for (fbrdf_area_light* light : {&sphere, &ceiling})
        for (float& r : light->radiance) r = 0.5f;
    sphere.size = 5.0f;
    const float corners[] = {-4000, -4000, 2, -4000, 4000, 2, 4000, 4000, 2, 4000, -4000, 2};
    ceiling.shape = FBRDF_AREA_SHAPE_POLYGON;
    ceiling.vertex_count = 4;
    ceiling.vertices = corners;
    for (const fbrdf_area_light& light : {sphere, ceiling}) {
        auto draw = abi::describe<fbrdf_draw_desc>();
        draw.area_lights = &light;
        draw.area_light_count = 1;
        draw.area_light_size = sizeof light;
        expectAlbedo(plain, draw, 0.5f);
    }
}

TEST_P(CApiEnvironmentGL, ChecksAreaLights)
{
    Plain plain;
    makePlain(plain);
    Offscreen offscreen = makeOffscreen(kSize);
    const auto drawn = [&](const fbrdf_area_light& light, fbrdf_draw_stats& stats) {
        auto draw = abi::describe<fbrdf_draw_desc>();
        draw.framebuffer = offscreen.framebuffer();
        draw.width = draw.height = kSize;
        for (int i = 0; i < 16; i += 5) draw.view[i] = draw.projection[i] = 1.0f;
        draw.projection[10] = -1.0f;
        draw.area_lights = &light;
        draw.area_light_count = 1;
        draw.area_light_size = sizeof light;
        plain.lines.clear();
        return fbrdf_draw(plain.renderer.get(), &draw, &stats);
    };
    auto stats = abi::describe<fbrdf_draw_stats>();
    // A light that is none is dropped, counted and logged.
    fbrdf_area_light light{};
    EXPECT_EQ(drawn(light, stats), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.lights_dropped, 1u);
    EXPECT_EQ(plain.lines.size(), 1u);
    light.size = 1.0f;
    EXPECT_EQ(drawn(light, stats), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.lights_dropped, 0u);
    light.shape = 5;
    EXPECT_EQ(drawn(light, stats), FBRDF_RESULT_ERROR_ARGUMENT);
    light.shape = FBRDF_AREA_SHAPE_POLYGON;
    light.vertex_count = 3;
    EXPECT_EQ(drawn(light, stats), FBRDF_RESULT_ERROR_ARGUMENT);
    light.vertices = light.position;
    light.vertex_count = 4000000000u;
    EXPECT_EQ(drawn(light, stats), FBRDF_RESULT_ERROR_ARGUMENT);
    light = {};
    light.reserved = 1;
    EXPECT_EQ(drawn(light, stats), FBRDF_RESULT_ERROR_VERSION);
}

TEST_P(CApiEnvironmentGL, RefusesWhatIsNone)
{
    Plain plain;
    makePlain(plain);
    const auto refuses = [&](const fbrdf_environment_desc& desc, fbrdf_result expected) {
        fbrdf_environment* environment = nullptr;
        plain.lines.clear();
        EXPECT_EQ(fbrdf_environment_create(plain.renderer.get(), &desc, &environment), expected);
        EXPECT_EQ(environment, nullptr);
        EXPECT_EQ(plain.lines.size(), 1u);
    };
    auto desc = grey(1.0f);
    desc.radiance = nullptr;
    refuses(desc, FBRDF_RESULT_ERROR_ARGUMENT);
    desc = grey(1.0f);
    desc.width = 0;
    refuses(desc, FBRDF_RESULT_ERROR_ARGUMENT);
    desc = grey(1.0f);
    desc.size = 48;
    refuses(desc, FBRDF_RESULT_ERROR_ARGUMENT);
    desc.size = ~0u;
    refuses(desc, FBRDF_RESULT_ERROR_ARGUMENT);
    refuses(grey(std::numeric_limits<float>::quiet_NaN()), FBRDF_RESULT_ERROR_INPUT);
    refuses(grey(-1.0f), FBRDF_RESULT_ERROR_INPUT);
    desc = grey(1.0f);
    desc.texture = 12345;
    refuses(desc, FBRDF_RESULT_ERROR_GL);
    fbrdf_environment_release(nullptr);
}

INSTANTIATE_TEST_SUITE_P(Backends, CApiEnvironmentGL, ::testing::ValuesIn(modernVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
