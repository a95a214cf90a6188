// All that can go wrong between a host and the library, as a host sees it: a result, a line of the
// log, and the next good call draws its picture.
#include "CApiTest.h"
#include "Materials.h"
#include "plain.h"

#include "support/gl/Hooks.h"
#include "support/TemporaryDir.h"

#include <fstream>
#include <functional>
#include <limits>
#include <memory>

namespace fbrdf::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A renderer with what plain_draw draws, and its log.
struct Host {
    HeadlessContext* context = nullptr;
    Hooks* hooks = nullptr;
    uint32_t framebuffer = 0;
    Lines lines;
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
    abi::Mesh mesh;
    fbrdf_item item{};
    fbrdf_light light{};
    fbrdf_draw_desc draw = abi::describe<fbrdf_draw_desc>();
    fbrdf_draw_stats stats = abi::describe<fbrdf_draw_stats>();

    fbrdf_renderer_desc desc()
    {
        auto result = abi::describe<fbrdf_renderer_desc>();
        result.api_version = FBRDF_API_VERSION;
        result.load = Hooks::load;
        result.load_user = hooks;
        result.log = {write, &lines};
        return result;
    }
    fbrdf_result plain()
    {
        return plain_draw(Hooks::load, hooks, {write, &lines}, framebuffer, kSize, nullptr);
    }
    fbrdf_result makeMesh(fbrdf_renderer* of, abi::Mesh& out) const
    {
        static const float corners[] = {-2, -2, 0, 2, -2, 0, 0, 4, 0};
        static const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
        static const uint32_t indices[] = {0, 1, 2};
        auto desc = abi::describe<fbrdf_mesh_desc>();
        desc.vertex_count = desc.index_count = 3;
        desc.positions = corners;
        desc.normals = normals;
        desc.indices = indices;
        return out.create(fbrdf_mesh_create, of, &desc);
    }
    void set()
    {
        const auto renderer_desc = desc();
        ASSERT_EQ(renderer.create(fbrdf_renderer_create, &renderer_desc), FBRDF_RESULT_OK);
        ASSERT_EQ(material.create(plain_material, &renderer_desc.log), FBRDF_RESULT_OK);
        ASSERT_EQ(
            gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
            FBRDF_RESULT_OK);
        ASSERT_EQ(makeMesh(renderer.get(), mesh), FBRDF_RESULT_OK);
        item.material = gpuMaterial.get();
        item.mesh = mesh.get();
        for (const int diagonal : {0, 5, 10, 15})
            item.model[diagonal] = draw.view[diagonal] = draw.projection[diagonal] = 1.0f;
        light.type = FBRDF_LIGHT_DIRECTIONAL;
        light.position[2] = light.intensity[0] = 1.0f;
        draw.framebuffer = framebuffer;
        draw.width = draw.height = kSize;
        draw.item_count = draw.light_count = 1;
        draw.item_size = sizeof item;
        draw.items = &item;
        draw.light_size = sizeof light;
        draw.lights = &light;
    }
    fbrdf_result drawn() { return fbrdf_draw(renderer.get(), &draw, &stats); }
    /// The first of fbrdf_renderer_create and what plain_draw does that fails with the loader.
    fbrdf_result created(fbrdf_renderer_desc desc)
    {
        abi::Renderer made;
        abi::GpuMaterial attempt;
        const fbrdf_result result = made.create(fbrdf_renderer_create, &desc);
        return result != FBRDF_RESULT_OK
                   ? result
                   : attempt.create(fbrdf_gpu_material_create, made.get(), material.get(), nullptr);
    }
    fbrdf_result loaded(const std::string& text)
    {
        const TemporaryDir folder;
        std::ofstream(folder.file("m.json")) << text;
        const fbrdf_log log{write, &lines};
        abi::Material none;
        return none.create(fbrdf_material_read, folder.file("m.json").c_str(), &log);
    }
};

struct Fault {
    const char* name;
    fbrdf_result expected;
    const char* said;  ///< in the only line of the log; "": none
    std::function<fbrdf_result(Host&)> happens;
};

/// Makes an hdio of which one texel is replaced, and one letter of the form.
fbrdf_result made(Host& host, float texel, char firstOfForm = '{')
{
    GivenMaterial given(constantMaterial(formHdio({4, 4, 4}), 0.0f));
    given.texels[1][7] = texel;
    given.form[0] = firstOfForm;
    abi::Material none;
    return given.create({write, &host.lines}, none);
}

std::vector<Fault> faultsOfTheContext()
{
    return {
        {"NoLoader", FBRDF_RESULT_ERROR_GL, "loader",
         [](Host& h) {
             auto desc = h.desc();
             desc.load = nullptr;
             return h.created(desc);
         }},
        {"ALoaderOfNothing", FBRDF_RESULT_ERROR_GL, "loader",
         [](Host& h) {
             auto desc = h.desc();
             desc.load = [](void*, const char*) -> void* { return nullptr; };
             return h.created(desc);
         }},
        {"ALoaderWithoutAFunction", FBRDF_RESULT_ERROR_GL, "glUseProgram",
         [](Host& h) {
             h.hooks->hidden = {"glUseProgram"};
             return h.plain();
         }},
        {"ALostContext", FBRDF_RESULT_ERROR_GL, "context",
         [](Host& h) {
             fbrdf_renderer_abandon(h.renderer.get());
             return h.drawn();
         }},
        {"AContextThatDoesNotShare", FBRDF_RESULT_OK, "another renderer",
         [](Host& h) {
             HeadlessContext other(h.context->options());
             auto desc = abi::describe<fbrdf_renderer_desc>();
             desc.api_version = FBRDF_API_VERSION;
             desc.load = other.loader();
             abi::Renderer theirs;
             abi::Mesh mesh;
             EXPECT_EQ(theirs.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
             EXPECT_EQ(h.makeMesh(theirs.get(), mesh), FBRDF_RESULT_OK);
             h.context->makeCurrent();
             h.item.mesh = mesh.get();
             const fbrdf_result result = h.drawn();
             EXPECT_EQ(h.stats.items_failed, 1u);
             other.makeCurrent();
             mesh.reset();
             theirs.reset();
             h.context->makeCurrent();
             return result;
         }},
        {"OutOfMemory", FBRDF_RESULT_ERROR_GL, "out of memory",
         [](Host& h) {
             h.hooks->errorAfter = 1;
             h.hooks->nextError = GL_OUT_OF_MEMORY;
             abi::Mesh mesh;
             return h.makeMesh(h.renderer.get(), mesh);
         }},
    };
}

std::vector<Fault> faultsOfPrograms()
{
    return {
        {"AShaderThatDoesNotCompile", FBRDF_RESULT_ERROR_GL, "compile",
         [](Host& h) {
             h.hooks->corruptShaders = true;
             return h.plain();
         }},
        {"AProgramThatDoesNotLink", FBRDF_RESULT_ERROR_GL, "link",
         [](Host& h) {
             h.hooks->spoilPrograms = true;
             return h.plain();
         }},
        {"NoTextureUnitsLeft", FBRDF_RESULT_ERROR_GL, "textures in one pass",
         [](Host& h) {
             auto desc = h.desc();
             GLint units = 0;
             h.hooks->real.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
             desc.first_texture_unit = static_cast<uint32_t>(units - 1);
             return h.created(desc);
         }},
    };
}

std::vector<Fault> faultsOfTargets()
{
    return {
        {"AnIncompleteFramebuffer", FBRDF_RESULT_ERROR_GL, "complete",
         [](Host& h) {
             h.hooks->real.GenFramebuffers(1, &h.draw.framebuffer);
             const fbrdf_result result = h.drawn();
             h.hooks->real.DeleteFramebuffers(1, &h.draw.framebuffer);
             return result;
         }},
        {"ATargetOfNoSize", FBRDF_RESULT_ERROR_GL, "0x16",
         [](Host& h) {
             h.draw.width = 0;
             return h.drawn();
         }},
    };
}

std::vector<Fault> faultsOfData()
{
    return {
        {"NanInAMaterial", FBRDF_RESULT_ERROR_INPUT, "finite",
         [](Host& h) { return made(h, kNan); }},
        {"AFormThatIsNotJson", FBRDF_RESULT_ERROR_INPUT, "not JSON",
         [](Host& h) { return made(h, 0.0f, '?'); }},
        {"AFileOfALaterVersion", FBRDF_RESULT_ERROR_INPUT, "version",
         [](Host& h) { return h.loaded(R"({"format": "fbrdf-material", "version": 99})"); }},
        {"NoLights", FBRDF_RESULT_OK, "",
         [](Host& h) {
             h.draw.light_count = 0;
             const fbrdf_result result = h.drawn();
             EXPECT_EQ(h.stats.items_failed, 0u);
             return result;
         }},
        {"ALightThatIsNoNumber", FBRDF_RESULT_OK, "",
         [](Host& h) {
             h.light.intensity[1] = kNan;
             const fbrdf_result result = h.drawn();
             EXPECT_EQ(h.stats.lights_dropped, 1u);
             return result;
         }},
    };
}

class FaultTable : public GlTest {};

TEST_P(FaultTable, EachIsAResultALineAndNoMore)
{
    expectMessages();
    std::vector<Fault> all;
    for (const auto& some :
         {faultsOfTheContext(), faultsOfPrograms(), faultsOfTargets(), faultsOfData()})
        all.insert(all.end(), some.begin(), some.end());
    for (const Fault& fault : all) {
        SCOPED_TRACE(fault.name);
        Hooks hooks(context().loader());
        Offscreen offscreen = makeOffscreen(kSize);
        offscreen.clear();
        Host host;
        host.context = &context();
        host.hooks = &hooks;
        host.framebuffer = offscreen.framebuffer();
        ASSERT_NO_FATAL_FAILURE(host.set());
        EXPECT_EQ(fault.happens(host), fault.expected);
        EXPECT_EQ(host.lines.size(), fault.said[0] ? 1u : 0u);
        for (const Line& line : host.lines) {
            EXPECT_NE(line.text.find(fault.said), std::string::npos) << line.text;
            EXPECT_EQ(line.code, fault.expected);
        }
        hooks.corruptShaders = hooks.spoilPrograms = false;
        hooks.hidden.clear();
        offscreen.clear();
        EXPECT_EQ(host.plain(), FBRDF_RESULT_OK);
        EXPECT_NEAR(offscreen.readPixels()[1], 0.5f, 1e-4f);
    }
}

// The host's windows are gone first, as when a program ends.
TEST_P(FaultTable, AContextMayBeDestroyedBeforeTheRenderer)
{
    Lines lines;
    abi::Renderer renderer;
    abi::Material material;
    abi::GpuMaterial gpuMaterial;
    {
        HeadlessContext first(context().options());
        auto desc = abi::describe<fbrdf_renderer_desc>();
        desc.api_version = FBRDF_API_VERSION;
        desc.load = first.loader();
        ASSERT_EQ(renderer.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
        ASSERT_EQ(material.create(plain_material, &desc.log), FBRDF_RESULT_OK);
        ASSERT_EQ(
            gpuMaterial.create(fbrdf_gpu_material_create, renderer.get(), material.get(), nullptr),
            FBRDF_RESULT_OK);
        fbrdf_renderer_abandon(renderer.get());
    }
    gpuMaterial.reset();
    renderer.reset();
    context().makeCurrent();
    Offscreen offscreen = makeOffscreen(kSize);
    EXPECT_EQ(plain_draw(context().loader(), nullptr, {}, offscreen.framebuffer(), kSize, nullptr),
              FBRDF_RESULT_OK);
}

INSTANTIATE_TEST_SUITE_P(Backends, FaultTable, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
