// EnvironmentGLTest.cpp - light from everywhere through the C ABI.
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

    std::vector<float> texels_;
};

TEST_P(CApiEnvironmentGL, LightsAnObject)
{
    Plain plain;
    makePlain(plain);
    ASSERT_TRUE(plain.gpuMaterial);
    Offscreen offscreen = makeOffscreen(kSize);
    auto desc = grey(1.0f);
    desc.unfiltered = 1;
    abi::Environment environment;
    ASSERT_EQ(environment.create(fbrdf_environment_create, plain.renderer.get(), &desc),
              FBRDF_RESULT_OK)
        << (plain.lines.empty() ? "" : plain.lines[0].text);
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
    ASSERT_EQ(mesh.create(fbrdf_mesh_create, plain.renderer.get(), &meshDesc), FBRDF_RESULT_OK);
    fbrdf_item item{};
    item.material = plain.gpuMaterial.get();
    item.mesh = mesh.get();
    auto light = abi::describe<fbrdf_environment_light>();
    light.environment = environment.get();
    light.intensity[0] = light.intensity[1] = light.intensity[2] = 0.5f;
    auto draw = abi::describe<fbrdf_draw_desc>();
    draw.framebuffer = offscreen.framebuffer();
    draw.width = draw.height = kSize;
    for (int i = 0; i < 16; i += 5) draw.view[i] = draw.projection[i] = item.model[i] = 1.0f;
    draw.projection[10] = -1.0f;  // the camera looks along -z
    draw.item_count = 1;
    draw.item_size = sizeof item;
    draw.items = &item;
    draw.environment = &light;
    auto stats = abi::describe<fbrdf_draw_stats>();
    // The file of the material has no lobes: they are fitted beside the drawing thread.
    for (int frame = 0; frame < 600; ++frame) {
        offscreen.clear();  // what was drawn without the environment is as near
        ASSERT_EQ(fbrdf_draw(plain.renderer.get(), &draw, &stats), FBRDF_RESULT_OK);
        if (stats.items_without_environment == 0) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_EQ(stats.items_without_environment, 0u) << stats.why_no_environment;
    EXPECT_GT(stats.environment_error, 0.0f);
    // f is constant: 1/4 R, 1/2 G, 1 B, so its albedo is pi f; white furnace within a 200th.
    const auto expectAlbedo = [&](float share) {
        const std::vector<float> pixels = offscreen.readPixels();
        const float pi = 3.14159265f;
        for (size_t i = 0; i < pixels.size(); i += 4)
            for (size_t c = 0; c < 3; ++c) {
                const float albedo = 0.125f * pi * static_cast<float>(1 << c);
                ASSERT_NEAR(pixels[i + c], albedo, share * albedo);
            }
    };
    expectAlbedo(0.005f);
    // By directions; by lobes where another technique is asked for.
    offscreen.clear();
    light.samples = 256;
    ASSERT_EQ(fbrdf_draw(plain.renderer.get(), &draw, &stats), FBRDF_RESULT_OK);
    EXPECT_STREQ(stats.why_not_sampled, "");
    EXPECT_EQ(stats.environment_error, 0.0f);
    expectAlbedo(0.02f);
    draw.technique = FBRDF_TECHNIQUE_TWO_LOOKUP;
    ASSERT_EQ(fbrdf_draw(plain.renderer.get(), &draw, &stats), FBRDF_RESULT_OK);
    EXPECT_NE(std::string(stats.why_not_sampled).find("two-lookup"), std::string::npos);
    light.samples = 5000;
    EXPECT_EQ(fbrdf_draw(plain.renderer.get(), &draw, &stats), FBRDF_RESULT_ERROR_ARGUMENT);
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
