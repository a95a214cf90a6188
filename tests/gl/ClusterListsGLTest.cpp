// ClusterListsGLTest.cpp - the lists that the compute shader makes, read back, against those of the
// CPU.
#include <fbrdf/shaders/ShaderSource.h>

#include <gtest/gtest.h>

#include "plan/ClusterScenes.h"
#include "support/gl/GlTest.h"

#include <algorithm>
#include <set>

namespace fbrdf::test {
namespace {

using Lists = std::vector<std::vector<int32_t>>;

struct MadeLists {
    Lists lists;
    int entries = 0;  ///< indices in use
};

class ClusterLists : public RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        if (!isReady()) return;
        if (renderer_->capabilities().computeBuffers == 0) GTEST_SKIP() << "needs compute shaders";
        const std::string text = clusterListsSource();
        const GLchar* const source = text.c_str();
        const GLuint shader = gl().CreateShader(GL_COMPUTE_SHADER);
        gl().ShaderSource(shader, 1, &source, nullptr);
        gl().CompileShader(shader);
        program_ = gl().CreateProgram();
        gl().AttachShader(program_, shader);
        gl().LinkProgram(program_);
        gl().DeleteShader(shader);
        gl().GenBuffers(3, buffers_);
    }
    void TearDown() override
    {
        if (program_ != 0) {
            gl().DeleteProgram(program_);
            gl().DeleteBuffers(3, buffers_);
        }
        RendererTest::TearDown();
    }

    /// room: for indices.
    MadeLists made(const LightClusters& clusters, const ClusterWork& work, size_t room)
    {
        const auto& g = gl();
        const ClusterGrid& grid = clusters.grid;
        const auto count = static_cast<size_t>(grid.count());
        const auto lights = static_cast<int32_t>(clusters.lights.size());
        std::vector<int32_t> lists(2 * count + 2, -7), indices(room, -7);
        lists[2 * count] = lights - clusters.everywhere;
        upload(0, work.vectors.size() * sizeof(glm::vec4), work.vectors.data());
        upload(1, lists.size() * sizeof(int32_t), lists.data());
        upload(2, indices.size() * sizeof(int32_t), indices.data());
        g.UseProgram(program_);
        g.Uniform3i(g.GetUniformLocation(program_, "fbrdfClusterGrid"), grid.columns, grid.rows,
                    grid.slices);
        g.Uniform3i(g.GetUniformLocation(program_, "fbrdfListed"), clusters.everywhere, lights,
                    static_cast<GLint>(room));
        g.Uniform1f(g.GetUniformLocation(program_, "fbrdfTileMargin"), work.tileMargin);
        g.DispatchCompute(
            static_cast<GLuint>((grid.columns + kClustersPerGroup - 1) / kClustersPerGroup),
            static_cast<GLuint>(grid.rows), static_cast<GLuint>(grid.slices));
        g.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        download(1, lists);
        download(2, indices);
        g.UseProgram(0);
        MadeLists result;
        result.entries = lists[2 * count];
        for (size_t k = 0; k < count; ++k) {
            const auto first = indices.begin() + lists[2 * k];
            result.lists.emplace_back(first, first + lists[2 * k + 1]);
        }
        return result;
    }

private:
    void upload(GLuint index, size_t bytes, const void* data)
    {
        gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, index, buffers_[index]);
        gl().BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data,
                        GL_DYNAMIC_COPY);
    }
    void download(GLuint index, std::vector<int32_t>& values)
    {
        gl().BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers_[index]);
        gl().GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                              static_cast<GLsizeiptr>(values.size() * sizeof(int32_t)),
                              values.data());
    }

    GLuint program_ = 0, buffers_[3] = {};
};

/// Points, spots of any width, some lights without a radius.
std::vector<LightVectors> mixedLights(int count)
{
    std::mt19937 random(61);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> angle(0.1f, 3.0f);
    std::vector<LightVectors> lights = randomLights(count, random);
    for (size_t i = 0; i < lights.size(); i += 3) {
        const Vec3f axis = glm::normalize(Vec3f(normal(random), normal(random), normal(random)));
        lights[i][2] = glm::vec4(5.0f * axis, -5.0f * std::cos(angle(random)));
    }
    return lights;
}

Lists listsOf(const LightClusters& clusters)
{
    Lists lists;
    for (size_t k = 0; k < clusters.lists.size(); k += 2) {
        const auto first = clusters.indices.begin() + clusters.lists[k];
        lists.emplace_back(first, first + clusters.lists[k + 1]);
    }
    return lists;
}

bool isSubset(const std::vector<int32_t>& part, const std::vector<int32_t>& whole)
{
    return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

size_t entriesOf(const Lists& lists)
{
    size_t sum = 0;
    for (const auto& list : lists) sum += list.size();
    return sum;
}

TEST_P(ClusterLists, AreThoseOfTheCpu)
{
    for (const glm::dmat4& projection : {perspective(), parallel(), mirrored(true), offCentre()})
        for (const int count : {3, 64, 700}) {
            const auto lights = mixedLights(count);
            ClusterBuilder builder;
            builder.updateWork(lights, projection);
            const LightClusters& clusters = builder.clusters();
            const ClusterWork& work = builder.work();
            EXPECT_TRUE(clusters.lists.empty());
            const MadeLists gpu = made(clusters, work, work.mostEntries);
            const LightClusters cpu = lightClusters(lights, projection);
            ASSERT_EQ(cpu.places, clusters.places);
            const Lists expected = listsOf(cpu);
            ASSERT_EQ(gpu.lists.size(), expected.size());
            size_t same = 0;
            for (size_t k = 0; k < expected.size(); ++k) {
                const auto& list = gpu.lists[k];
                ASSERT_TRUE(std::is_sorted(list.begin(), list.end()));
                // The CPU trims cones at the ends of a row; the GPU leaves them out anywhere. A
                // sphere that touches a box may be in either list by rounding.
                same += isSubset(list, expected[k]) ? 1 : 0;
            }
            EXPECT_GE(double(same), 0.99 * double(expected.size()));
            EXPECT_LE(double(entriesOf(gpu.lists)), 1.001 * double(entriesOf(expected)) + 8.0);
            EXPECT_LE(static_cast<size_t>(gpu.entries), work.mostEntries);
            EXPECT_EQ(static_cast<size_t>(gpu.entries),
                      entriesOf(gpu.lists) + clusters.lights.size() -
                          static_cast<size_t>(clusters.everywhere));
            EXPECT_LT(double(work.mostEntries), 4.0 * double(entriesOf(expected)) + 1000.0);
            EXPECT_EQ(made(clusters, work, work.mostEntries).lists, gpu.lists);
        }
}

TEST_P(ClusterLists, LoseNoLightThatReachesAPoint)
{
    const auto lights = mixedLights(500);
    ClusterBuilder builder;
    builder.updateWork(lights, perspective());
    LightClusters clusters = builder.clusters();
    const Lists lists = made(clusters, builder.work(), builder.work().mostEntries).lists;
    for (const auto& list : lists) {
        clusters.lists.push_back(static_cast<int32_t>(clusters.indices.size()));
        clusters.lists.push_back(static_cast<int32_t>(list.size()));
        clusters.indices.insert(clusters.indices.end(), list.begin(), list.end());
    }
    std::mt19937 random(67);
    std::uniform_real_distribution<double> unit(0.0, 1.0), depth(0.1, 14.0);
    size_t reaching = 0;
    for (int k = 0; k < 3000; ++k) {
        const glm::dvec2 at(unit(random), unit(random));
        const Vec3d point = pointAt(perspective(), at, depth(random));
        std::set<int> listed;
        for (const int slot : lightsAt(clusters, at, -point.z))
            listed.insert(clusters.places[static_cast<size_t>(slot)]);
        for (size_t i = 0; i < lights.size(); ++i) {
            const Vec3f toLight = glm::normalize(Vec3f(Vec3d(lights[i][0]) - point));
            if (!reaches(lights[i], point) ||
                lights[i][2].w - glm::dot(Vec3f(lights[i][2]), toLight) <= 0.0f)
                continue;
            ++reaching;
            ASSERT_EQ(listed.count(static_cast<int>(i)), 1u) << i;
        }
    }
    EXPECT_GT(reaching, 10000u);
}

TEST_P(ClusterLists, WithoutRoomHaveAllLights)
{
    const auto lights = mixedLights(300);
    ClusterBuilder builder;
    builder.updateWork(lights, perspective());
    const LightClusters& clusters = builder.clusters();
    const auto all = clusters.lights.size() - static_cast<size_t>(clusters.everywhere);
    const MadeLists enough = made(clusters, builder.work(), builder.work().mostEntries),
                    little = made(clusters, builder.work(), all + 2000);
    size_t whole = 0;
    for (size_t k = 0; k < little.lists.size(); ++k) {
        whole += little.lists[k].size() == all ? 1 : 0;
        ASSERT_TRUE(little.lists[k].size() == all || little.lists[k] == enough.lists[k]);
        ASSERT_TRUE(isSubset(enough.lists[k], little.lists[k]));
    }
    EXPECT_GT(whole, 0u);
    EXPECT_LT(whole, little.lists.size());
}

INSTANTIATE_TEST_SUITE_P(Backends, ClusterLists, ::testing::ValuesIn(modernVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
