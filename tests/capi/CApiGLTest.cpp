// The C ABI in a GL context: a host in C11, one that draws by itself, contexts, threads, faults.
#include "CApiTest.h"
#include "Materials.h"
#include "plain.h"

#include <gtest/gtest.h>

#include <thread>

namespace fbrdf::test {
namespace {

constexpr int kSize = 16;
constexpr float kTexel = 1e-4f;  // tables of floats, one exp2 in the shader

class CApiGL : public CApiTest {};

void expectPlainPicture(const std::vector<float>& pixels)
{
    for (size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_NEAR(pixels[i], 0.25f, kTexel);
        ASSERT_NEAR(pixels[i + 1], 0.5f, kTexel);
        ASSERT_NEAR(pixels[i + 2], 1.0f, kTexel);
        ASSERT_EQ(pixels[i + 3], 1.0f);
    }
}

TEST_P(CApiGL, AHostInCDrawsWhatTheNumbersSay)
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
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    ASSERT_EQ(material.create(plain_material, &desc.log), FBRDF_RESULT_OK);
    ASSERT_EQ(
        gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
        FBRDF_RESULT_OK);
    const char* functions = nullptr;
    auto glsl = abi::describe<fbrdf_glsl_desc>();
    glsl.glsl_version = 140;
    glsl.max_lights = 2;
    ASSERT_EQ(fbrdf_gpu_material_glsl(gpuMaterial.get(), &glsl, &functions), FBRDF_RESULT_OK);
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
    ASSERT_EQ(binding.create(fbrdf_binding_create, gpuMaterial.get(), program), FBRDF_RESULT_OK);
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
    EXPECT_STREQ(fbrdf_gpu_material_why_not_recombined(nullptr), "");
    EXPECT_EQ(fbrdf_gpu_material_look_up_error(nullptr), 0.0f);
}

TEST_P(CApiGL, FaultsAreResultsAndLogLines)
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
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc),
              FBRDF_RESULT_OK);  // the next good call

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

/// Nowhere until a hook brings it into view, by what its extra array holds.
fbrdf_result makeLiftedQuad(fbrdf_renderer* renderer, abi::Mesh& out)
{
    const float positions[12] = {-2, -2, 50, 2, -2, 50, 2, 2, 50, -2, 2, 50},
                normals[12] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                shift[16] = {50, 0, 0, 0, 50, 0, 0, 0, 50, 0, 0, 0, 50, 0, 0, 0};
    const float* const extra[] = {shift};
    const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    auto shape = abi::describe<fbrdf_mesh_desc>();
    shape.vertex_count = 4;
    shape.index_count = 6;
    shape.positions = positions;
    shape.normals = normals;
    shape.indices = indices;
    shape.extra_count = 1;
    shape.extra = extra;
    return out.create(fbrdf_mesh_create, renderer, &shape);
}

/// What set_uniforms is called with.
struct HookHost {
    const GladGLContext& gl;
    int calls;
};

/// Brings the quad into view, and halves one of two lights.
fbrdf_hooks_desc liftAndShade(HookHost& host)
{
    auto given = abi::describe<fbrdf_hooks_desc>();
    given.vertex =
        "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position.z -= fbrdfExtra0.x; }\n";
    given.shadow =
        "uniform float shade;\nfloat fbrdfShadow(int light, vec3 position, vec3 toLight)\n"
        "{ return light == 1 ? shade : 0.0; }\n";
    given.shadow_uniforms = 1;
    given.user = &host;
    given.set_uniforms = [](void* user, uint32_t program) {
        HookHost& h = *static_cast<HookHost*>(user);
        h.gl.Uniform1f(h.gl.GetUniformLocation(program, "shade"), 0.5f);
        ++h.calls;
    };
    return given;
}

TEST_P(CApiGL, HooksMoveVerticesAndShadeLights)
{
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
    abi::Mesh mesh;
    abi::Hooks hooks;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    ASSERT_EQ(material.create(plain_material, &desc.log), FBRDF_RESULT_OK);
    ASSERT_EQ(
        gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
        FBRDF_RESULT_OK);
    ASSERT_EQ(makeLiftedQuad(renderer.get(), mesh), FBRDF_RESULT_OK);
    HookHost host{gl(), 0};
    auto given = liftAndShade(host);
    ASSERT_EQ(hooks.create(fbrdf_hooks_create, renderer.get(), &given), FBRDF_RESULT_OK);

    Offscreen offscreen = makeOffscreen(kSize);
    fbrdf_light lights[2]{};
    for (fbrdf_light& light : lights) {
        light.type = FBRDF_LIGHT_DIRECTIONAL;
        light.position[2] = 1.0f;
        for (float& channel : light.intensity) channel = 2.0f;
    }
    fbrdf_item item{};
    item.material = gpuMaterial.get();
    item.mesh = mesh.get();
    item.hooks = hooks.get();
    auto draw = abi::describe<fbrdf_draw_desc>();
    draw.framebuffer = offscreen.framebuffer();
    draw.width = draw.height = kSize;
    for (const int diagonal : {0, 5, 10, 15})
        item.model[diagonal] = draw.view[diagonal] = draw.projection[diagonal] = 1.0f;
    draw.projection[10] = -1.0f;  // looks along -z
    draw.item_count = 1;
    draw.item_size = sizeof item;
    draw.items = &item;
    draw.light_count = 2;
    draw.light_size = sizeof(fbrdf_light);
    draw.lights = lights;
    ASSERT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    expectPlainPicture(offscreen.readPixels());  // half of twice what plain.c's light gives
    EXPECT_EQ(host.calls, 1);
    draw.item_size = offsetof(fbrdf_item, hooks);  // an older caller's: not brought into view
    offscreen.clear();
    ASSERT_EQ(fbrdf_draw(renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    EXPECT_EQ(offscreen.readPixels()[3], 0.0f);
    expectMessages();
    given.shadow = "nonsense";
    EXPECT_EQ(hooks.create(fbrdf_hooks_create, renderer.get(), &given), FBRDF_RESULT_ERROR_INPUT);
    EXPECT_TRUE(hooks);
}

/// A triangle that covers the view: position and normal of a corner side by side, 16-bit indices
/// behind two others.
class HostBuffers {
public:
    explicit HostBuffers(const GladGLContext& gl) : gl_(gl)
    {
        const float corners[18] = {-2, -2, 0, 0, 0, 1, 4, -2, 0, 0, 0, 1, -2, 4, 0, 0, 0, 1};
        const uint16_t indices[5] = {7, 7, 0, 1, 2};
        gl_.GenBuffers(2, buffers_);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        gl_.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
        gl_.BufferData(GL_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
        gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
    }
    ~HostBuffers() { gl_.DeleteBuffers(2, buffers_); }
    HostBuffers(const HostBuffers&) = delete;
    HostBuffers& operator=(const HostBuffers&) = delete;

    fbrdf_mesh_buffers_desc desc() const
    {
        auto result = abi::describe<fbrdf_mesh_buffers_desc>();
        result.vertex_count = result.index_count = 3;
        result.positions = {0, buffers_[0], 24};
        result.normals = {12, buffers_[0], 24};
        result.index_buffer = buffers_[1];
        result.index_offset = 4;
        result.index_type = FBRDF_INDEX_UINT16;
        return result;
    }

private:
    const GladGLContext& gl_;
    GLuint buffers_[2] = {};
};

TEST_P(CApiGL, BuffersOfTheHostAreDrawnWhereTheyAre)
{
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    ASSERT_EQ(material.create(plain_material, &desc.log), FBRDF_RESULT_OK);
    ASSERT_EQ(
        gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
        FBRDF_RESULT_OK);
    const HostBuffers buffers(gl());
    const float bounds[4] = {0.0f, 0.0f, 0.0f, 6.0f};
    for (const float* given : {bounds, static_cast<const float*>(nullptr)}) {
        fbrdf_mesh_buffers_desc triangle = buffers.desc();
        triangle.bounds = given;
        abi::Mesh mesh;
        ASSERT_EQ(mesh.create(fbrdf_mesh_create_from_buffers, renderer.get(), &triangle),
                  FBRDF_RESULT_OK);
        Offscreen offscreen = makeOffscreen(kSize);
        ASSERT_EQ(plain_draw_mesh(renderer.get(), gpuMaterial.get(), mesh.get(),
                                  offscreen.framebuffer(), kSize, nullptr, nullptr),
                  FBRDF_RESULT_OK);
        expectPlainPicture(offscreen.readPixels());
    }
    EXPECT_TRUE(lines.empty());
    const auto expectRefused = [&](fbrdf_result expected, const fbrdf_mesh_buffers_desc& wrong) {
        abi::Mesh mesh;
        EXPECT_EQ(mesh.create(fbrdf_mesh_create_from_buffers, renderer.get(), &wrong), expected);
    };
    fbrdf_mesh_buffers_desc wrong = buffers.desc();
    wrong.index_type = 2;
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, wrong);
    wrong = buffers.desc();
    wrong.tangent_components = 2;
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, wrong);
    wrong = buffers.desc();
    wrong.positions.buffer = 0;
    expectRefused(FBRDF_RESULT_ERROR_INPUT, wrong);
}

/// The quad of plain.c is at depth 1/2, between both clear values.
TEST_P(CApiGL, DepthIsTheHosts)
{
    Offscreen offscreen = makeOffscreen(kSize);
    gl().BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
    gl().ClearDepth(0.0);
    gl().Clear(GL_DEPTH_BUFFER_BIT);
    gl().ClearDepth(1.0);
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    Lines lines;
    auto depth = abi::describe<fbrdf_depth_desc>();
    depth.test = FBRDF_DEPTH_TEST_GREATER;
    depth.range_high = 1.0f;
    const auto drawn = [&](const fbrdf_depth_desc* with) {
        return plain_draw_with_depth(context().loader(), nullptr, {write, &lines},
                                     offscreen.framebuffer(), kSize, with, nullptr);
    };
    ASSERT_EQ(drawn(nullptr), FBRDF_RESULT_OK);  // nothing is nearer than a depth of 0
    for (const float channel : offscreen.readPixels()) ASSERT_EQ(channel, 0.0f);
    ASSERT_EQ(drawn(&depth), FBRDF_RESULT_OK);
    expectPlainPicture(offscreen.readPixels());
    EXPECT_TRUE(lines.empty());
    const auto expectRefused = [&](fbrdf_result expected, const char* words) {
        EXPECT_EQ(drawn(&depth), expected);
        ASSERT_EQ(lines.size(), 1u) << words;
        EXPECT_NE(lines[0].text.find(words), std::string::npos) << lines[0].text;
        lines.clear();
        depth.test = FBRDF_DEPTH_TEST_GREATER;
        depth.clip = FBRDF_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE;
        depth.range_high = 1.0f;
    };
    depth.test = 4;
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, "depth test: found 4");
    depth.clip = 2;
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, "depth clip: found 2");
    depth.range_high = 2.0f;
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, "found depth 2.0");
    depth.struct_size = 20;
    expectRefused(FBRDF_RESULT_ERROR_VERSION, "depth: found a size of 20 bytes");
}

TEST_P(CApiGL, AMaterialThatCannotBeReplacedStays)
{
    Lines lines;
    const auto desc = rendererDesc(lines);
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
    ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
    ASSERT_EQ(material.create(plain_material, &desc.log), FBRDF_RESULT_OK);
    ASSERT_EQ(
        gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
        FBRDF_RESULT_OK);
    EXPECT_EQ(fbrdf_gpu_material_replace(gpuMaterial.get(), nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_gpu_material_replace(gpuMaterial.get(), material.get()), FBRDF_RESULT_OK);
    const char* functions = nullptr;
    auto glsl = abi::describe<fbrdf_glsl_desc>();
    EXPECT_EQ(fbrdf_gpu_material_glsl(gpuMaterial.get(), &glsl, &functions), FBRDF_RESULT_OK);
    glsl.glsl_version = 111;
    EXPECT_EQ(fbrdf_gpu_material_glsl(gpuMaterial.get(), &glsl, &functions), FBRDF_RESULT_ERROR_GL);
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
