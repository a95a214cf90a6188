// What the C ABI has of the options and statistics of C++ does what it does there.
#include "CApiTest.h"
#include "Materials.h"

#include "support/gl/Hooks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace fbrdf::test {
namespace {

/// A square of a pqp material under two lights, and a loader that counts programs.
class CApiOptions : public CApiTest {
protected:
    void SetUp() override
    {
        CApiTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        hooks_ = std::make_unique<Hooks>(context().loader());
        const auto desc = hookedDesc();
        makeRenderer(desc);
        Material pqp = constantMaterial(formPqp(16, 0.5), -1.0f);
        for (size_t i = 0; i < pqp.tables[0].texels.size(); ++i)
            pqp.tables[0].texels[i] = -0.05f * static_cast<float>(i % 16);
        ASSERT_EQ(GivenMaterial(pqp).create(desc.log, material_), FBRDF_RESULT_OK);
        upload({});
        for (fbrdf_light& light : lights_) {
            light.type = FBRDF_LIGHT_DIRECTIONAL;
            light.position[2] = light.intensity[0] = 0.5f;
        }
    }
    void TearDown() override
    {
        mesh_.reset();
        gpuMaterial_.reset();
        renderer_.reset();
        hooks_.reset();
        CApiTest::TearDown();
    }

    fbrdf_renderer_desc hookedDesc()
    {
        auto desc = rendererDesc(lines_);
        desc.load = Hooks::load;
        desc.load_user = hooks_.get();
        return desc;
    }
    void makeRenderer(const fbrdf_renderer_desc& desc)
    {
        static const float corners[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
        static const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
        static const float tangents[] = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
        static const uint32_t indices[] = {0, 1, 2, 0, 2, 3};
        mesh_.reset();
        gpuMaterial_.reset();
        ASSERT_EQ(renderer_.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
        auto mesh = abi::describe<fbrdf_mesh_desc>();
        mesh.vertex_count = 4;
        mesh.index_count = 6;
        mesh.positions = corners;
        mesh.normals = normals;
        mesh.tangents = tangents;
        mesh.indices = indices;
        ASSERT_EQ(mesh_.create(fbrdf_mesh_create, renderer_.get(), &mesh), FBRDF_RESULT_OK);
    }
    void upload(fbrdf_gpu_material_desc desc)
    {
        desc.struct_size = sizeof desc;
        ASSERT_EQ(
            gpuMaterial_.create(fbrdf_gpu_material_create, renderer_.get(), material_.get(), &desc),
            FBRDF_RESULT_OK);
    }
    fbrdf_draw_desc drawDesc(const Offscreen& offscreen)
    {
        item_.material = gpuMaterial_.get();
        item_.mesh = mesh_.get();
        auto draw = abi::describe<fbrdf_draw_desc>();
        draw.framebuffer = offscreen.framebuffer();
        draw.width = draw.height = kSize;
        for (const int diagonal : {0, 5, 10, 15})
            item_.model[diagonal] = draw.view[diagonal] = draw.projection[diagonal] = 1.0f;
        draw.projection[10] = -1.0f;
        draw.item_count = 1;
        draw.item_size = sizeof item_;
        draw.items = &item_;
        draw.light_count = 2;
        draw.light_size = sizeof lights_[0];
        draw.lights = lights_;
        draw.technique = FBRDF_TECHNIQUE_TWO_LOOKUP;
        return draw;
    }
    fbrdf_draw_stats drawn(const fbrdf_draw_desc& draw)
    {
        auto stats = abi::describe<fbrdf_draw_stats>();
        EXPECT_EQ(fbrdf_draw(renderer_.get(), &draw, &stats), FBRDF_RESULT_OK);
        EXPECT_EQ(stats.items_failed, 0u);
        return stats;
    }
    int programs() const { return hooks_->alive["Program"]; }

    Lines lines_;
    std::unique_ptr<Hooks> hooks_;
    abi::Renderer renderer_;
    abi::Material material_;
    abi::GpuMaterial gpuMaterial_;
    abi::Mesh mesh_;
    fbrdf_item item_{};
    fbrdf_light lights_[2]{};
};

TEST_P(CApiOptions, LightsAddUpInTheFormatThatIsAskedFor)
{
    Offscreen offscreen = makeOffscreen(kSize, OffscreenFormat::rgba8);
    auto draw = drawDesc(offscreen);
    const fbrdf_draw_stats automatic = drawn(draw);
    const char* const names[] = {"RGBA8", "RGBA16", "RGBA16F", "RGBA32F"};
    int had = 0;
    for (uint32_t format = FBRDF_ACCUMULATION_RGBA8; format <= FBRDF_ACCUMULATION_RGBA32F;
         ++format) {
        draw.accumulation = format;
        const fbrdf_draw_stats stats = drawn(draw);
        const std::string name = names[format - 1];
        // A context need not have RGBA16, and takes what it would have taken.
        if (name != "RGBA16" || stats.accumulation == name)
            EXPECT_EQ(stats.accumulation, name) << stats.why_accumulation;
        else
            EXPECT_STREQ(stats.accumulation, automatic.accumulation);
        had += stats.accumulation == name ? 1 : 0;
        // Floats are what a CPU takes anyway, without a reason.
        if (stats.accumulation == name && format != FBRDF_ACCUMULATION_RGBA32F) {
            EXPECT_EQ(stats.why_accumulation, name + " was asked for");
        }
    }
    EXPECT_GE(had, 3);
    // A caller that was compiled before the field was there.
    draw.accumulation = FBRDF_ACCUMULATION_RGBA16F;
    draw.struct_size = offsetof(fbrdf_draw_desc, accumulation);
    EXPECT_STREQ(drawn(draw).accumulation, automatic.accumulation);
    draw.struct_size = sizeof draw;
    draw.accumulation = FBRDF_ACCUMULATION_RGBA32F + 1;
    EXPECT_EQ(fbrdf_draw(renderer_.get(), &draw, nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    draw.accumulation = 0;
    draw.reserved = 1;
    EXPECT_EQ(fbrdf_draw(renderer_.get(), &draw, nullptr), FBRDF_RESULT_ERROR_VERSION);
}

TEST_P(CApiOptions, StatisticsHaveWhatErrorsAreMadeOf)
{
    Offscreen offscreen = makeOffscreen(kSize);
    fbrdf_draw_stats stats = drawn(drawDesc(offscreen));
    EXPECT_EQ(stats.filter, uint32_t(FBRDF_FILTER_HARDWARE));
    EXPECT_EQ(stats.error_filtering, fbrdf_gpu_material_filter_error(gpuMaterial_.get()));
    EXPECT_GT(stats.error_filtering, 0.0f);
    EXPECT_EQ(stats.error_recombination, 0.0f);
    EXPECT_EQ(stats.error_filtering_absolute, 0.0f);  // all its maps are logarithmic
    fbrdf_gpu_material_desc how{};
    how.look_up = FBRDF_LOOK_UP_PARABOLIC;
    how.map_size = 32;
    upload(how);
    stats = drawn(drawDesc(offscreen));
    EXPECT_GT(stats.error_recombination, 0.0f);
    EXPECT_EQ(stats.error_recombination, fbrdf_gpu_material_look_up_error(gpuMaterial_.get()));
    how = {};
    how.precise = 1;
    upload(how);
    stats = drawn(drawDesc(offscreen));
    EXPECT_EQ(stats.filter, uint32_t(FBRDF_FILTER_SHADER));
    EXPECT_EQ(stats.error_filtering, 0.0f);
}

struct Watched {
    std::vector<fbrdf_pass_event> begun;
    size_t ended = 0;
    std::string material;
};

TEST_P(CApiOptions, PassesAreWatched)
{
    Watched watched;
    auto desc = hookedDesc();
    desc.passes = {
        [](void* user, const fbrdf_pass_event* event) {
            auto& to = *static_cast<Watched*>(user);
            to.begun.push_back(*event);
            to.material = event->material;
        },
        [](void* user, const fbrdf_pass_event*) { ++static_cast<Watched*>(user)->ended; },
        &watched};
    makeRenderer(desc);
    upload({});
    Offscreen offscreen = makeOffscreen(kSize);
    const fbrdf_draw_stats stats = drawn(drawDesc(offscreen));
    ASSERT_EQ(watched.begun.size(), stats.passes);
    EXPECT_EQ(watched.ended, stats.passes);
    EXPECT_EQ(stats.passes, 3u);  // a light each, and p(wo)
    uint32_t lookups = 0, lights = 0;
    for (size_t i = 0; i < watched.begun.size(); ++i) {
        const fbrdf_pass_event& event = watched.begun[i];
        EXPECT_EQ(event.struct_size, sizeof event);
        EXPECT_EQ(event.index, i);
        EXPECT_EQ(event.count, stats.passes);
        EXPECT_LT(event.first_light, 2u);
        lights += event.light_count;
        lookups = std::max(lookups, event.lookups);
    }
    EXPECT_EQ(lights, 2u);
    EXPECT_EQ(lookups, stats.max_lookups);
    EXPECT_EQ(watched.material, "pqp");  // that of its form, as it has none
    // Either may be missing, and older callers have neither.
    desc.passes.begins = nullptr;
    makeRenderer(desc);
    upload({});
    drawn(drawDesc(offscreen));
    EXPECT_EQ(watched.begun.size(), stats.passes);
    EXPECT_EQ(watched.ended, 2 * size_t(stats.passes));
    desc.struct_size = offsetof(fbrdf_renderer_desc, passes);
    makeRenderer(desc);
    upload({});
    drawn(drawDesc(offscreen));
    EXPECT_EQ(watched.ended, 2 * size_t(stats.passes));
}

TEST_P(CApiOptions, PreparedDrawsNeedNoCompiler)
{
    Offscreen offscreen = makeOffscreen(kSize);
    auto draw = drawDesc(offscreen);
    const int before = programs();
    ASSERT_EQ(fbrdf_prepare(renderer_.get(), &draw), FBRDF_RESULT_OK);
    const int prepared = programs();
    EXPECT_GT(prepared, before);
    hooks_->corruptShaders = true;
    drawn(draw);
    EXPECT_EQ(programs(), prepared);
    hooks_->corruptShaders = false;
    EXPECT_TRUE(lines_.empty());
    item_.material = nullptr;
    EXPECT_EQ(fbrdf_prepare(renderer_.get(), &draw), FBRDF_RESULT_ERROR_ARGUMENT);
    item_.material = gpuMaterial_.get();
    item_.mesh = nullptr;
    EXPECT_EQ(fbrdf_prepare(renderer_.get(), &draw), FBRDF_RESULT_ERROR_ARGUMENT);
    draw.light_count = ~0u;
    EXPECT_EQ(fbrdf_prepare(renderer_.get(), &draw), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_prepare(renderer_.get(), nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_prepare(nullptr, &draw), FBRDF_RESULT_ERROR_ARGUMENT);
}

TEST_P(CApiOptions, ProgramsThatNoDrawUsesAreDeletedBeyondTheLimit)
{
    constexpr int kIdleDraws = 256;  // as the header says
    Offscreen offscreen = makeOffscreen(kSize);
    for (const uint32_t limit : {1u, 0u}) {
        auto desc = hookedDesc();
        desc.idle_programs = limit;
        makeRenderer(desc);
        upload({});
        auto draw = drawDesc(offscreen);
        for (const uint32_t technique :
             {FBRDF_TECHNIQUE_BATCHED, FBRDF_TECHNIQUE_TWO_LOOKUP, FBRDF_TECHNIQUE_SINGLE}) {
            draw.technique = technique;
            drawn(draw);
        }
        const int made = programs();
        draw.light_count = 1;
        for (int i = 0; i < 2 * kIdleDraws; ++i) drawn(draw);
        if (limit == 0)
            EXPECT_GE(programs(), made);
        else
            EXPECT_LT(programs(), made);
    }
}

TEST_P(CApiOptions, LibrariesAreUploadedAsIsAskedFor)
{
    const fbrdf_material* const two[] = {material_.get(), material_.get()};
    fbrdf_instance instance{};
    for (const int diagonal : {0, 5, 10, 15}) instance.model[diagonal] = 1.0f;
    Offscreen offscreen = makeOffscreen(kSize);
    const auto filterOf = [&](const fbrdf_gpu_material_desc* desc) {
        abi::Library library;
        EXPECT_EQ(library.create(fbrdf_library_create_with, renderer_.get(), 2u, two, desc),
                  FBRDF_RESULT_OK);
        auto batch = abi::describe<fbrdf_batch_desc>();
        batch.instance_count = 1;
        batch.instance_size = sizeof instance;
        batch.library = library.get();
        batch.mesh = mesh_.get();
        batch.instances = &instance;
        auto draw = drawDesc(offscreen);
        draw.item_count = 0;
        auto stats = abi::describe<fbrdf_draw_stats>();
        EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, &batch, &stats), FBRDF_RESULT_OK);
        EXPECT_EQ(stats.items_failed, 0u);
        return stats.filter;
    };
    auto how = abi::describe<fbrdf_gpu_material_desc>();
    EXPECT_EQ(filterOf(nullptr), uint32_t(FBRDF_FILTER_HARDWARE));
    EXPECT_EQ(filterOf(&how), uint32_t(FBRDF_FILTER_HARDWARE));
    how.precise = 1;
    EXPECT_EQ(filterOf(&how), uint32_t(FBRDF_FILTER_SHADER));
    how.look_up = 9;
    fbrdf_library* library = nullptr;
    EXPECT_EQ(fbrdf_library_create_with(renderer_.get(), 2, two, &how, &library),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(library, nullptr);
}

TEST_P(CApiOptions, EnvironmentsComeGradually)
{
    const std::vector<float> grey(3 * 8 * 4, 1.0f);
    auto desc = abi::describe<fbrdf_environment_desc>();
    desc.width = 8;
    desc.height = 4;
    desc.size = 64;
    desc.radiance = grey.data();
    desc.gradual = 1;
    abi::Environment environment;
    ASSERT_EQ(environment.create(fbrdf_environment_create, renderer_.get(), &desc),
              FBRDF_RESULT_OK);
    uint32_t finished = 7, steps = 0;
    const bool byCpu = !lines_.empty();  // a note says so
    while (finished != 1 && steps < 1000) {
        ASSERT_EQ(fbrdf_environment_refine(environment.get(), 4096, &finished), FBRDF_RESULT_OK);
        ++steps;
    }
    EXPECT_EQ(finished, 1u);
    EXPECT_EQ(steps > 1, !byCpu);
    EXPECT_EQ(fbrdf_environment_refine(environment.get(), 1, nullptr), FBRDF_RESULT_OK);
    EXPECT_EQ(fbrdf_environment_refine(environment.get(), 0, nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_environment_refine(nullptr, 1, &finished), FBRDF_RESULT_ERROR_ARGUMENT);
}

INSTANTIATE_TEST_SUITE_P(Backends, CApiOptions, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
