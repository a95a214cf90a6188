// Libraries of the C ABI: batches, and files that are replaced while a scene runs.
#include "CApiTest.h"

#include <fbrdf/io/MaterialFile.h>

#include <gtest/gtest.h>

#include <glm/gtc/type_ptr.hpp>

#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <fstream>
#include <functional>
#include <iterator>

namespace fbrdf::test {
namespace {

constexpr int kSize = 32;

std::string bytesOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void writeBytes(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

class CApiLibrary : public CApiTest {
protected:
    void SetUp() override
    {
        CApiTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        const auto desc = rendererDesc(lines_);
        ASSERT_EQ(renderer_.create(fbrdf_renderer_create, &desc), FBRDF_RESULT_OK);
        for (unsigned seed = 1; seed < 4; ++seed) {
            const std::string path = file(seed);
            writeMaterial(noiseMaterial(formPqp(8, 0.5), Storage::half, seed), path);
            abi::Material material;
            ASSERT_EQ(material.create(fbrdf_material_read, path.c_str(), &desc.log),
                      FBRDF_RESULT_OK);
            materials_.push_back(std::move(material));
        }
        const gl::MeshData sphere = sphereMesh(8);
        auto mesh = abi::describe<fbrdf_mesh_desc>();
        mesh.vertex_count = static_cast<uint32_t>(sphere.positions.size());
        mesh.index_count = static_cast<uint32_t>(sphere.indices.size());
        mesh.positions = glm::value_ptr(sphere.positions[0]);
        mesh.normals = glm::value_ptr(sphere.normals[0]);
        mesh.tangents = glm::value_ptr(sphere.tangents[0]);
        mesh.indices = sphere.indices.data();
        ASSERT_EQ(mesh_.create(fbrdf_mesh_create, renderer_.get(), &mesh), FBRDF_RESULT_OK);
        const fbrdf_material* two[] = {materials_[0].get(), materials_[1].get()};
        ASSERT_EQ(library_.create(fbrdf_library_create, renderer_.get(), 2u, two), FBRDF_RESULT_OK);
        lines_.clear();
    }
    void TearDown() override
    {
        library_.reset();
        mesh_.reset();
        renderer_.reset();
        CApiTest::TearDown();
    }

    std::string file(unsigned seed) const
    {
        return dir_.file("m" + std::to_string(seed) + ".fbrdf");
    }

    static fbrdf_draw_desc drawDesc(const Offscreen& offscreen)
    {
        static fbrdf_light light{};
        light.position[2] = 3.0f;
        for (float& channel : light.intensity) channel = 5.0f;
        auto draw = abi::describe<fbrdf_draw_desc>();
        draw.framebuffer = offscreen.framebuffer();
        draw.width = draw.height = kSize;
        const gl::View view = orthographicView();
        std::copy_n(glm::value_ptr(view.view), 16, draw.view);
        std::copy_n(glm::value_ptr(view.projection), 16, draw.projection);
        draw.light_count = 1;
        draw.light_size = sizeof light;
        draw.lights = &light;
        return draw;
    }

    /// Two half-size objects side by side, of materials 0 and 1.
    std::vector<float> picture(fbrdf_draw_stats* stats = nullptr)
    {
        fbrdf_instance instances[2]{};
        for (int i = 0; i < 2; ++i) {
            for (const int diagonal : {0, 5, 10}) instances[i].model[diagonal] = 0.5f;
            instances[i].model[15] = 1.0f;
            instances[i].model[12] = i == 0 ? -0.5f : 0.5f;
            instances[i].material = static_cast<uint32_t>(i);
        }
        auto batch = abi::describe<fbrdf_batch_desc>();
        batch.instance_count = 2;
        batch.instance_size = sizeof instances[0];
        batch.library = library_.get();
        batch.mesh = mesh_.get();
        batch.instances = instances;
        Offscreen offscreen = makeOffscreen(kSize);
        const fbrdf_draw_desc draw = drawDesc(offscreen);
        EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, &batch, stats), FBRDF_RESULT_OK);
        return offscreen.readPixels();
    }

    /// What a host does that saw a file change: reads it, and replaces only where that succeeded.
    fbrdf_result reloaded(const std::string& path,
                          const std::function<fbrdf_result(const fbrdf_material*)>& replace)
    {
        const fbrdf_log toLines{write, &lines_};
        abi::Material material;
        const fbrdf_result result = material.create(fbrdf_material_read, path.c_str(), &toLines);
        return result == FBRDF_RESULT_OK ? replace(material.get()) : result;
    }

    TemporaryDir dir_;
    Lines lines_;
    abi::Renderer renderer_;
    std::vector<abi::Material> materials_;
    abi::Mesh mesh_;
    abi::Library library_;
};

TEST_P(CApiLibrary, ABatchIsOneDrawCall)
{
    auto stats = abi::describe<fbrdf_draw_stats>();
    const auto two = picture(&stats);
    EXPECT_EQ(stats.draw_calls, 1u);
    EXPECT_STREQ(fbrdf_library_why_not_packed(library_.get()), "");
    ASSERT_EQ(fbrdf_library_replace(library_.get(), 1, materials_[0].get()), FBRDF_RESULT_OK);
    EXPECT_NE(picture(), two);
    ASSERT_EQ(fbrdf_library_replace(library_.get(), 1, materials_[1].get()), FBRDF_RESULT_OK);
    EXPECT_EQ(picture(), two);
    EXPECT_TRUE(lines_.empty());
}

TEST_P(CApiLibrary, AFileThatIsBeingWrittenDisturbsNothing)
{
    const std::string path = dir_.file("live.fbrdf"), whole = bytesOf(file(3));
    const auto replace = [&](const fbrdf_material* by) {
        return fbrdf_library_replace(library_.get(), 0, by);
    };
    const auto before = picture();
    ASSERT_GT(whole.size(), 100u);
    for (size_t size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
        writeBytes(path, whole.substr(0, size));
        lines_.clear();
        ASSERT_EQ(reloaded(path, replace), FBRDF_RESULT_ERROR_INPUT) << size;
        ASSERT_EQ(lines_.size(), 1u);
        EXPECT_EQ(lines_[0].code, FBRDF_RESULT_ERROR_INPUT);
        ASSERT_EQ(picture(), before) << size;
    }
    EXPECT_EQ(reloaded(dir_.file("none"), replace), FBRDF_RESULT_ERROR_INPUT);
    ASSERT_EQ(picture(), before);
    writeBytes(path, whole);
    ASSERT_EQ(reloaded(path, replace), FBRDF_RESULT_OK);
    EXPECT_NE(picture(), before);
}

TEST_P(CApiLibrary, AMaterialKeepsItsLastGoodFile)
{
    abi::GpuMaterial gpuMaterial;
    ASSERT_EQ(gpuMaterial.create(fbrdf_gpu_material_create, renderer_.get(), materials_[0].get(),
                                 nullptr),
              FBRDF_RESULT_OK);
    fbrdf_item item{};
    item.material = gpuMaterial.get();
    item.mesh = mesh_.get();
    for (const int diagonal : {0, 5, 10, 15}) item.model[diagonal] = 1.0f;
    const auto drawn = [&] {
        Offscreen offscreen = makeOffscreen(kSize);
        fbrdf_draw_desc draw = drawDesc(offscreen);
        draw.item_count = 1;
        draw.item_size = sizeof item;
        draw.items = &item;
        EXPECT_EQ(fbrdf_draw(renderer_.get(), &draw, nullptr), FBRDF_RESULT_OK);
        return offscreen.readPixels();
    };
    const auto replace = [&](const fbrdf_material* by) {
        return fbrdf_gpu_material_replace(gpuMaterial.get(), by);
    };
    const auto before = drawn();
    const std::string path = dir_.file("live.fbrdf"), whole = bytesOf(file(3));
    writeBytes(path, whole.substr(0, whole.size() / 2));
    EXPECT_EQ(reloaded(path, replace), FBRDF_RESULT_ERROR_INPUT);
    EXPECT_EQ(drawn(), before);
    writeBytes(path, whole);
    EXPECT_EQ(reloaded(path, replace), FBRDF_RESULT_OK);
    EXPECT_NE(drawn(), before);
}

TEST_P(CApiLibrary, WrongArgumentsAreResultsAndLogLines)
{
    const auto before = picture();
    const fbrdf_material* const none[] = {nullptr};
    abi::Library library;
    EXPECT_EQ(library.create(fbrdf_library_create, renderer_.get(), 1u, none),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_library_replace(library_.get(), 2, materials_[0].get()),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_library_replace(library_.get(), ~0u, materials_[0].get()),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_library_replace(library_.get(), 0, nullptr), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(lines_.size(), 4u);
    EXPECT_EQ(fbrdf_library_replace(nullptr, 0, materials_[0].get()), FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_STREQ(fbrdf_library_why_not_packed(nullptr), "");
    Offscreen offscreen = makeOffscreen(kSize);
    fbrdf_draw_desc draw = drawDesc(offscreen);
    auto batch = abi::describe<fbrdf_batch_desc>();
    EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, &batch, nullptr),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, nullptr, nullptr),
              FBRDF_RESULT_ERROR_ARGUMENT);
    batch.library = library_.get();
    batch.mesh = mesh_.get();
    batch.instance_count = 1;
    fbrdf_instance instance{};
    batch.instances = &instance;
    batch.instance_size = 4;
    EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, &batch, nullptr),
              FBRDF_RESULT_ERROR_VERSION);
    batch.instance_size = sizeof instance;
    instance.material = ~0u;
    auto stats = abi::describe<fbrdf_draw_stats>();
    EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, &batch, &stats), FBRDF_RESULT_OK);
    EXPECT_EQ(stats.items_failed, 1u);
    draw.item_count = 1;
    EXPECT_EQ(fbrdf_draw_batch(renderer_.get(), &draw, &batch, nullptr),
              FBRDF_RESULT_ERROR_ARGUMENT);
    EXPECT_EQ(picture(), before);
}

INSTANTIATE_TEST_SUITE_P(Backends, CApiLibrary, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
