// The C ABI in a GL context: a host in C11, one that draws by itself, contexts, threads, faults.
#include "CApiTest.h"
#include "Materials.h"
#include "plain.h"

#include <gtest/gtest.h>

#include <thread>

namespace fbrdf::test {
namespace {

class CApiGL : public CApiTest {};

TEST_P(CApiGL, AHostInCDrawsTheExpectedNumbers)
{
    Offscreen offscreen = makeOffscreen(kSize);
    Lines lines;
    auto stats = abi::describe<fbrdf_draw_stats>();
    ASSERT_EQ(plain_draw(context().loader(), nullptr, {write, &lines}, offscreen.framebuffer(),
                         kSize, &stats),
              FBRDF_RESULT_OK)
        << (lines.empty() ? "" : lines[0].text);
    EXPECT_TRUE(lines.empty());
    EXPECT_EQ(stats.passes, 1u);
    EXPECT_EQ(stats.lights_used, 1u);
    EXPECT_STREQ(stats.accumulation, "RGBA32F");
    expectPlainPicture(offscreen.readPixels());
}

TEST_P(CApiGL, OlderStatsGetTheirPartOnly)
{
    Offscreen offscreen = makeOffscreen(kSize);
    fbrdf_draw_stats stats{};
    stats.struct_size = offsetof(fbrdf_draw_stats, lights_given);
    stats.max_lookups = 77;
    ASSERT_EQ(plain_draw(context().loader(), nullptr, {}, offscreen.framebuffer(), kSize, &stats),
              FBRDF_RESULT_OK);
    EXPECT_EQ(stats.draw_calls, 1u);
    EXPECT_EQ(stats.max_lookups, 77u);
}

TEST_P(CApiGL, NewerStatsAreZeroInWhatIsNotKnown)
{
    Offscreen offscreen = makeOffscreen(kSize);
    struct Newer {
        fbrdf_draw_stats known;
        uint32_t added;
    } newer{abi::describe<fbrdf_draw_stats>(), 77};
    newer.known.struct_size = sizeof newer;
    ASSERT_EQ(
        plain_draw(context().loader(), nullptr, {}, offscreen.framebuffer(), kSize, &newer.known),
        FBRDF_RESULT_OK);
    EXPECT_EQ(newer.known.draw_calls, 1u);
    EXPECT_EQ(newer.added, 0u);
}

TEST_P(CApiGL, AnEngineDrawsByItselfWithTheFunctions)
{
    Plain plain;
    makePlain(plain);
    ASSERT_TRUE(plain.gpuMaterial);
    const char* functions = nullptr;
    auto glsl = abi::describe<fbrdf_glsl_desc>();
    glsl.glsl_version = 140;
    glsl.max_lights = 2;
    ASSERT_EQ(fbrdf_gpu_material_glsl(plain.gpuMaterial.get(), &glsl, &functions), FBRDF_RESULT_OK);
    const std::string fragment =
        "#version 140\n" + std::string(functions) +
        "out vec4 colour;\nvoid main()\n{\n    vec3 n = vec3(0.0, 0.0, 1.0);\n"
        "    vec3 f = fbrdfEvaluate(n, normalize(vec3(0.5, 0.0, 1.0)));\n"
        "    vec3 radiance = fbrdfRadiance(vec3(0.0), n, vec3(1.0, 0.0, 0.0), n);\n"
        "    colour = gl_FragCoord.x < 8.0 ? vec4(f, 1.0) : vec4(radiance, 1.0);\n}\n";
    const GLuint program = linkProgram(
        gl(),
        "#version 140\nvoid main() { gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0,"
        " float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }\n",
        fragment);
    abi::Binding binding;
    ASSERT_EQ(binding.create(fbrdf_binding_create, plain.gpuMaterial.get(), program),
              FBRDF_RESULT_OK);
    uint32_t units = 0;
    ASSERT_EQ(fbrdf_binding_apply(binding.get(), 2, &units), FBRDF_RESULT_OK);
    EXPECT_EQ(units, 2u);
    fbrdf_light lights[2]{};
    for (fbrdf_light& light : lights) {
        light.type = FBRDF_LIGHT_DIRECTIONAL;
        light.position[2] = 1.0f;
        for (float& channel : light.intensity) channel = 0.5f;
    }
    float vectors[24];
    for (int i = 0; i < 2; ++i)
        ASSERT_EQ(fbrdf_light_vectors(&lights[i], nullptr, vectors + 12 * i), FBRDF_RESULT_OK);
    gl().Uniform4fv(gl().GetUniformLocation(program, "fbrdfLights"), 6, vectors);
    gl().Uniform1i(gl().GetUniformLocation(program, "fbrdfLightCount"), 2);
    Offscreen offscreen = makeOffscreen(kSize);
    gl().BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
    gl().Viewport(0, 0, kSize, kSize);
    GLuint array = 0;
    gl().GenVertexArrays(1, &array);
    gl().BindVertexArray(array);
    gl().DrawArrays(GL_TRIANGLES, 0, 3);
    gl().BindVertexArray(0);
    gl().DeleteVertexArrays(1, &array);
    expectPlainPicture(offscreen.readPixels());
    EXPECT_EQ(fbrdf_binding_apply(binding.get(), 100000, nullptr), FBRDF_RESULT_ERROR_GL);
    EXPECT_EQ(fbrdf_binding_apply(binding.get(), 2, nullptr), FBRDF_RESULT_OK);
    gl().UseProgram(0);
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl().DeleteProgram(program);
}

TEST_P(CApiGL, MapsAreRecombinedOnRequest)
{
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    Material pqp = constantMaterial(formPqp(16, 0.5), -1.0f);
    for (int i = 0; i < 16 * 16; ++i)
        for (int c = 0; c < 3; ++c)
            pqp.tables[0].texels[static_cast<size_t>(3 * i + c)] =
                0.05f * static_cast<float>(i % 16 + c);
    abi::Material material, plain;
    ASSERT_EQ(GivenMaterial(pqp).create(desc.log, material), FBRDF_RESULT_OK);
    ASSERT_EQ(plain.create(plain_material, &desc.log), FBRDF_RESULT_OK);
    abi::GpuMaterial gpuMaterial;
    auto cube = abi::describe<fbrdf_gpu_material_desc>();
    const auto make = [&](const fbrdf_material* of) {
        return gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), of, &cube);
    };
    ASSERT_EQ(make(material.get()), FBRDF_RESULT_OK);
    EXPECT_EQ(fbrdf_gpu_material_look_up_error(gpuMaterial.get()), 0.0f);
    cube.look_up = FBRDF_LOOK_UP_CUBE;
    cube.map_size = 32;
    ASSERT_EQ(make(material.get()), FBRDF_RESULT_OK);
    const float error = fbrdf_gpu_material_look_up_error(gpuMaterial.get());
    EXPECT_GT(error, 0.0f);
    EXPECT_LT(error, 0.25f);
    EXPECT_STREQ(fbrdf_gpu_material_why_not_recombined(gpuMaterial.get()), "");
    EXPECT_TRUE(lines.empty());
    // A material that replaces it is looked up in the same way.
    ASSERT_EQ(fbrdf_gpu_material_replace(gpuMaterial.get(), plain.get()), FBRDF_RESULT_OK);
    EXPECT_NE(std::string(fbrdf_gpu_material_why_not_recombined(gpuMaterial.get())).find("angles"),
              std::string::npos);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].severity, FBRDF_SEVERITY_WARNING);
    ASSERT_EQ(fbrdf_gpu_material_replace(gpuMaterial.get(), material.get()), FBRDF_RESULT_OK);
    EXPECT_EQ(fbrdf_gpu_material_look_up_error(gpuMaterial.get()), error);
    for (const auto& [lookUp, size] : {std::pair<uint32_t, uint32_t>{3, 0}, {2, 31}, {1, ~0u}}) {
        cube.look_up = lookUp;
        cube.map_size = size;
        EXPECT_EQ(make(material.get()), FBRDF_RESULT_ERROR_ARGUMENT) << lookUp << " " << size;
    }
    EXPECT_EQ(gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), nullptr, nullptr),
              FBRDF_RESULT_ERROR_ARGUMENT);
    ASSERT_EQ(
        gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
        FBRDF_RESULT_OK);
    EXPECT_EQ(fbrdf_gpu_material_look_up_error(gpuMaterial.get()), 0.0f);
    EXPECT_GT(fbrdf_gpu_material_filter_error(gpuMaterial.get()), 0.0f);
    auto precise = abi::describe<fbrdf_gpu_material_desc>();
    precise.precise = 1;
    ASSERT_EQ(
        gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), &precise),
        FBRDF_RESULT_OK);
    EXPECT_EQ(fbrdf_gpu_material_filter_error(gpuMaterial.get()), 0.0f);
    EXPECT_EQ(fbrdf_gpu_material_filter_error(nullptr), 0.0f);
    EXPECT_STREQ(fbrdf_gpu_material_why_not_recombined(nullptr), "");
    EXPECT_EQ(fbrdf_gpu_material_look_up_error(nullptr), 0.0f);
}

TEST_P(CApiGL, FaultsOfARendererAreResultsAndLogLines)
{
    Lines lines;
    auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    const auto expectRefused = [&](fbrdf_result expected, const char* words) {
        EXPECT_EQ(renderer.create(fbrdf_renderer_create, &desc), expected) << words;
        EXPECT_FALSE(renderer);
        ASSERT_EQ(lines.size(), 1u) << words;
        EXPECT_EQ(lines[0].code, expected);
        EXPECT_EQ(lines[0].severity, FBRDF_SEVERITY_ERROR);
        EXPECT_NE(lines[0].text.find(words), std::string::npos) << lines[0].text;
        lines.clear();
    };
    desc.api_version = FBRDF_VERSION(7, 0);
    expectRefused(FBRDF_RESULT_ERROR_VERSION, "api_version 7.0");
    desc = rendererDesc(lines);
    desc.api_version = FBRDF_VERSION(0, 1);
    expectRefused(FBRDF_RESULT_ERROR_VERSION, "api_version 0.1, expected a program of 0.2 to 0.2");
    desc = rendererDesc(lines);
    desc.struct_size = offsetof(fbrdf_renderer_desc, state_mode);
    expectRefused(FBRDF_RESULT_ERROR_VERSION, "found a size of");
    desc = rendererDesc(lines);
    desc.state_mode = 9;
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, "state_mode: found 9");
    desc = rendererDesc(lines);
    desc.load = [](void*, const char*) -> void* { return nullptr; };
    expectRefused(FBRDF_RESULT_ERROR_GL, "OpenGL");
    desc = rendererDesc(lines);
    EXPECT_EQ(renderer.create(fbrdf_renderer_create, &desc),
              FBRDF_RESULT_OK);  // the next good call
}

TEST_P(CApiGL, FaultsOfADrawAreResults)
{
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    auto draw = abi::describe<fbrdf_draw_desc>();
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_ERROR_GL);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].text.find("0x0 pixels"), std::string::npos) << lines[0].text;
    Offscreen offscreen = makeOffscreen(kSize);
    draw.framebuffer = offscreen.framebuffer();
    draw.width = draw.height = kSize;
    for (const int diagonal : {0, 5, 10, 15})
        draw.view[diagonal] = draw.projection[diagonal] = 1.0f;
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    draw.struct_size = offsetof(fbrdf_draw_desc, max_lights);  // an older caller's
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    draw.item_count = 1;
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    fbrdf_item item{};
    draw.items = &item;
    draw.item_size = 4;
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_ERROR_VERSION);
    draw.item_size = sizeof item;
    auto stats = abi::describe<fbrdf_draw_stats>();
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, &stats), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.items_failed, 1u);
    EXPECT_EQ(fbrdf_draw(nullptr, &draw, nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    struct Newer {
        fbrdf_item item;
        uint64_t added;
    } newer{{}, 0};
    draw.items = &newer.item;
    draw.item_size = sizeof newer;
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    newer.added = 1;
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_ERROR_VERSION);
    newer.added = 0;

    fbrdf_renderer_abandon(renderer.get());
    EXPECT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_ERROR_GL);
}

TEST_P(CApiGL, ListsOfLightsAreMadeByWhomIsSaid)
{
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    Offscreen offscreen = makeOffscreen(kSize);
    std::vector<fbrdf_light> lights(20);
    for (size_t i = 0; i < lights.size(); ++i) {
        lights[i].position[0] = 0.1f * static_cast<float>(i) - 1.0f;
        lights[i].intensity[0] = lights[i].radius = 1.0f;
    }
    auto draw = abi::describe<fbrdf_draw_desc>();
    draw.framebuffer = offscreen.framebuffer();
    draw.width = draw.height = kSize;
    for (const int diagonal : {0, 5, 10, 15})
        draw.view[diagonal] = draw.projection[diagonal] = 1.0f;
    draw.lights = lights.data();
    draw.light_count = static_cast<uint32_t>(lights.size());
    draw.light_size = sizeof lights[0];
    auto stats = abi::describe<fbrdf_draw_stats>();
    const auto made = [&](uint32_t by) {
        draw.lists_by = by;
        return fbrdf_draw(renderer.get(), &draw, &stats);
    };
    EXPECT_EQ(made(FBRDF_LISTS_BY_GPU), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.lists_by, uint32_t(FBRDF_LISTS_BY_AUTOMATIC));  // there are none
    draw.clustered = 1;
    EXPECT_EQ(made(FBRDF_LISTS_BY_CPU), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.lists_by, uint32_t(FBRDF_LISTS_BY_CPU));
    EXPECT_STREQ(stats.why_lists_by_cpu, "asked for");
    EXPECT_EQ(made(FBRDF_LISTS_BY_GPU), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.lists_by == uint32_t(FBRDF_LISTS_BY_GPU),
              std::string(stats.why_lists_by_cpu).empty());
    draw.max_lights = 3;
    EXPECT_EQ(made(FBRDF_LISTS_BY_GPU), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.lists_by, uint32_t(FBRDF_LISTS_BY_CPU));
    EXPECT_NE(std::string(stats.why_lists_by_cpu), "");
    EXPECT_EQ(made(3), FBRDF_RESULT_ERROR_ARGUMENT);
}

TEST_P(CApiGL, FunctionsThatSampleComeOnRequest)
{
    Plain plain;
    makePlain(plain);
    ASSERT_TRUE(plain.gpuMaterial);
    auto glsl = abi::describe<fbrdf_glsl_desc>();
    const char *without = nullptr, *with = nullptr;
    ASSERT_EQ(fbrdf_gpu_material_glsl(plain.gpuMaterial.get(), &glsl, &without), FBRDF_RESULT_OK);
    glsl.sampling = 1;
    ASSERT_EQ(fbrdf_gpu_material_glsl(plain.gpuMaterial.get(), &glsl, &with), FBRDF_RESULT_OK);
    EXPECT_EQ(std::string(without).find("fbrdfSampleLobes"), std::string::npos);
    EXPECT_EQ(std::string(with).rfind(without, 0), 0u);
    EXPECT_NE(std::string(with).find("vec4 fbrdfSampleLobes(vec3 wo, vec2 u)"), std::string::npos);
}

TEST_P(CApiGL, AMaterialThatCannotBeReplacedStays)
{
    Plain plain;
    makePlain(plain);
    ASSERT_TRUE(plain.gpuMaterial);
    EXPECT_EQ(fbrdf_gpu_material_replace(plain.gpuMaterial.get(), nullptr),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_gpu_material_replace(plain.gpuMaterial.get(), plain.material.get()),
              FBRDF_RESULT_OK);
    const char* functions = nullptr;
    auto glsl = abi::describe<fbrdf_glsl_desc>();
    EXPECT_EQ(fbrdf_gpu_material_glsl(plain.gpuMaterial.get(), &glsl, &functions), FBRDF_RESULT_OK);
    glsl.glsl_version = 111;
    EXPECT_EQ(fbrdf_gpu_material_glsl(plain.gpuMaterial.get(), &glsl, &functions),
              FBRDF_RESULT_ERROR_GL);
    EXPECT_EQ(functions, nullptr);
}

INSTANTIATE_TEST_SUITE_P(Backends, CApiGL, ::testing::ValuesIn(modernVariants()), variantName);

TEST(CApiThreads, TwoContextsOnTwoThreadsDrawTheSame)
{
    std::vector<float> pixels[2];
    const auto work = [&pixels](size_t index) {
        HeadlessContext context({Backend::egl});
        Offscreen offscreen(context.loader(), {kSize, kSize});
        offscreen.clear();
        for (int i = 0; i < 3; ++i)
            if (plain_draw(context.loader(), nullptr, {}, offscreen.framebuffer(), kSize,
                           nullptr) != FBRDF_RESULT_OK)
                return;
        pixels[index] = offscreen.readPixels();
    };
    std::thread other(work, 1);
    work(0);
    other.join();
    ASSERT_FALSE(pixels[0].empty());
    expectPlainPicture(pixels[0]);
    EXPECT_EQ(pixels[0], pixels[1]);
}

}  // namespace
}  // namespace fbrdf::test
