// What a host brings through the C ABI: hooks, buffers, and its convention of depth.
#include "CApiTest.h"
#include "plain.h"

#include <gtest/gtest.h>

namespace fbrdf::test {
namespace {

class CApiHost : public CApiTest {};

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

TEST_P(CApiHost, HooksMoveVerticesAndShadeLights)
{
    Plain plain;
    makePlain(plain);
    ASSERT_TRUE(plain.gpuMaterial);
    abi::Mesh mesh;
    abi::Hooks hooks;
    ASSERT_EQ(makeLiftedQuad(plain.renderer.get(), mesh), FBRDF_RESULT_OK);
    HookHost host{gl(), 0};
    auto given = liftAndShade(host);
    ASSERT_EQ(hooks.create(fbrdf_hooks_create, plain.renderer.get(), &given), FBRDF_RESULT_OK);

    Offscreen offscreen = makeOffscreen(kSize);
    fbrdf_light lights[2]{};
    for (fbrdf_light& light : lights) {
        light.type = FBRDF_LIGHT_DIRECTIONAL;
        light.position[2] = 1.0f;
        for (float& channel : light.intensity) channel = 2.0f;
    }
    fbrdf_item item{};
    item.material = plain.gpuMaterial.get();
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
    ASSERT_EQ(fbrdf_draw(plain.renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    expectPlainPicture(offscreen.readPixels());  // half of twice what plain.c's light gives
    EXPECT_EQ(host.calls, 1);
    draw.item_size = offsetof(fbrdf_item, hooks);  // an older caller's: not brought into view
    offscreen.clear();
    ASSERT_EQ(fbrdf_draw(plain.renderer.get(), &draw, nullptr), FBRDF_RESULT_OK);
    EXPECT_EQ(offscreen.readPixels()[3], 0.0f);
    expectMessages();
    given.shadow = "nonsense";
    EXPECT_EQ(hooks.create(fbrdf_hooks_create, plain.renderer.get(), &given),
              FBRDF_RESULT_ERROR_INPUT);
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

TEST_P(CApiHost, BuffersOfTheHostAreDrawnWhereTheyAre)
{
    Plain plain;
    makePlain(plain);
    ASSERT_TRUE(plain.gpuMaterial);
    const HostBuffers buffers(gl());
    const float bounds[4] = {0.0f, 0.0f, 0.0f, 6.0f};
    for (const float* given : {bounds, static_cast<const float*>(nullptr)}) {
        fbrdf_mesh_buffers_desc triangle = buffers.desc();
        triangle.bounds = given;
        abi::Mesh mesh;
        ASSERT_EQ(mesh.create(fbrdf_mesh_create_from_buffers, plain.renderer.get(), &triangle),
                  FBRDF_RESULT_OK);
        Offscreen offscreen = makeOffscreen(kSize);
        ASSERT_EQ(plain_draw_mesh(plain.renderer.get(), plain.gpuMaterial.get(), mesh.get(),
                                  offscreen.framebuffer(), kSize, nullptr, nullptr),
                  FBRDF_RESULT_OK);
        expectPlainPicture(offscreen.readPixels());
    }
    EXPECT_TRUE(plain.lines.empty());
    const auto expectRefused = [&](fbrdf_result expected, const fbrdf_mesh_buffers_desc& wrong) {
        abi::Mesh mesh;
        EXPECT_EQ(mesh.create(fbrdf_mesh_create_from_buffers, plain.renderer.get(), &wrong),
                  expected);
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
TEST_P(CApiHost, DepthIsTheHosts)
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
    expectRefused(FBRDF_RESULT_ERROR_ARGUMENT, "found depth 2,");
    depth.struct_size = 20;
    expectRefused(FBRDF_RESULT_ERROR_VERSION, "depth: found a size of 20 bytes");
}

INSTANTIATE_TEST_SUITE_P(Backends, CApiHost, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
