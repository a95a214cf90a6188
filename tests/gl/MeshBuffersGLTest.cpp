// Meshes in buffers of the host draw what copied meshes draw; buffers that do not fit are refused.
#include "GeometryTest.h"

#include "support/ExpectError.h"
#include "support/gl/Hooks.h"

namespace fbrdf::test {
namespace {

/// A mesh in one interleaved buffer behind some bytes of the host's own, and one of indices.
struct HostMesh {
    const GladGLContext& gl;
    GLuint buffers[2] = {};
    gl::MeshBuffers mesh;

    HostMesh(const GladGLContext& context, const gl::MeshData& data, gl::IndexType indexType)
        : gl(context)
    {
        constexpr size_t kBefore = 20;
        std::vector<float> numbers(kBefore / sizeof(float), 1e9f);
        const bool hasTangents = !data.tangents.empty();
        const bool hasCoordinates = !data.textureCoordinates.empty();
        for (size_t i = 0; i < data.positions.size(); ++i) {
            append(numbers, data.positions[i]);
            append(numbers, data.normals[i]);
            if (hasTangents) append(numbers, data.tangents[i]);
            if (hasTangents) numbers.push_back(data.handedness.empty() ? 1 : data.handedness[i]);
            if (hasCoordinates) append(numbers, data.textureCoordinates[i]);
            for (const auto& array : data.extra) append(numbers, array[i]);
        }
        gl.GenBuffers(2, buffers);
        store(buffers[0], numbers);
        size_t at = kBefore;
        const auto stride = static_cast<uint32_t>((numbers.size() * sizeof(float) - kBefore) /
                                                  data.positions.size());
        const auto next = [&](size_t floats) {
            const gl::BufferArray array{buffers[0], at, stride};
            at += floats * sizeof(float);
            return array;
        };
        mesh.vertexCount = static_cast<uint32_t>(data.positions.size());
        mesh.positions = next(3);
        mesh.normals = next(3);
        if (hasTangents) mesh.tangents = next(4);
        if (hasCoordinates) mesh.textureCoordinates = next(2);
        for (size_t k = 0; k < data.extra.size(); ++k) mesh.extra.push_back(next(4));
        setIndices(data.indices, indexType);
    }
    ~HostMesh() { gl.DeleteBuffers(2, buffers); }
    HostMesh(const HostMesh&) = delete;
    HostMesh& operator=(const HostMesh&) = delete;

    template <class Vector>
    static void append(std::vector<float>& numbers, const Vector& v)
    {
        for (int i = 0; i < v.length(); ++i) numbers.push_back(v[i]);
    }
    template <class T>
    void store(GLuint buffer, const std::vector<T>& data) const
    {
        gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(T)),
                      data.data(), GL_DYNAMIC_DRAW);
        gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    }
    void setIndices(const std::vector<uint32_t>& indices, gl::IndexType type)
    {
        mesh.indexBuffer = buffers[1];
        mesh.indexCount = static_cast<uint32_t>(indices.size());
        mesh.indexType = type;
        std::vector<uint32_t> wide(1, 0);  // one that the mesh does not use
        wide.insert(wide.end(), indices.begin(), indices.end());
        mesh.indexOffset = type == gl::IndexType::uint32 ? sizeof(uint32_t) : sizeof(uint16_t);
        if (type == gl::IndexType::uint32) return store(buffers[1], wide);
        store(buffers[1], std::vector<uint16_t>(wide.begin(), wide.end()));
    }
};

class MeshBuffersTest : public RendererTest {
protected:
    std::vector<float> draw(const gl::GpuMesh& mesh, const gl::GpuHooks* hooks = nullptr)
    {
        const auto material = renderer_->createMaterial(brushed());
        const Drawn drawn =
            drawItems(*renderer_, kSize, perspectiveView(),
                      {{material.get(), &mesh, glm::mat4(1.0f), hooks}}, testLights(4));
        EXPECT_EQ(drawn.stats.itemsFailed, 0);
        return drawn.pixels;
    }
    void refused(ErrorKind kind, const std::string& words, const gl::MeshBuffers& mesh)
    {
        expectError(kind, words, [&] { renderer_->createMesh(mesh); });
    }
};

TEST_P(MeshBuffersTest, DrawWhatCopiedMeshesDraw)
{
    gl::MeshData mirrored = sphereMesh(12), bare = sphereMesh(12), derived = sphereMesh(12);
    mirrored.handedness.assign(mirrored.positions.size(), -1.0f);
    bare.tangents.clear();
    derived.tangents.clear();
    for (const Vec3f& p : derived.positions) derived.textureCoordinates.emplace_back(p.x, p.y);
    for (const gl::MeshData& data : {knotMesh(48, 8), mirrored, bare, derived})
        for (const auto type : {gl::IndexType::uint16, gl::IndexType::uint32}) {
            const HostMesh host(gl(), data, type);
            const auto copied = renderer_->createMesh(data),
                       bound = renderer_->createMesh(host.mesh);
            EXPECT_EQ(draw(*bound), draw(*copied));
            EXPECT_EQ(bound->bounds().centre, copied->bounds().centre);
            EXPECT_EQ(bound->bounds().radius, copied->bounds().radius);
        }
}

TEST_P(MeshBuffersTest, TangentsMayHaveThreeComponents)
{
    const gl::MeshData data = sphereMesh(12);
    HostMesh host(gl(), data, gl::IndexType::uint32);
    host.mesh.tangentComponents = 3;
    EXPECT_EQ(draw(*renderer_->createMesh(host.mesh)), draw(*renderer_->createMesh(data)));
}

TEST_P(MeshBuffersTest, VertexHooksReadExtraArrays)
{
    gl::MeshData data = sphereMesh(12);
    data.extra.emplace_back(data.positions.size(), glm::vec4(0.25f));
    gl::Hooks hooks;
    hooks.vertex =
        "FBRDF_ATTRIBUTE vec4 fbrdfExtra0;\n"
        "void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)\n"
        "{ position *= 1.0 - fbrdfExtra0.x; }\n";
    const auto compiled = renderer_->createHooks(hooks);
    const HostMesh host(gl(), data, gl::IndexType::uint32);
    EXPECT_EQ(draw(*renderer_->createMesh(host.mesh), compiled.get()),
              draw(*renderer_->createMesh(data), compiled.get()));
}

TEST_P(MeshBuffersTest, WhatTheHostWritesIsDrawn)
{
    gl::MeshData small = sphereMesh(12);
    for (Vec3f& position : small.positions) position *= 0.5f;
    HostMesh host(gl(), sphereMesh(12), gl::IndexType::uint32);
    const auto bound = renderer_->createMesh(host.mesh);
    const HostMesh other(gl(), small, gl::IndexType::uint32);
    // Through the CPU: OpenGL 2.1 copies no buffers.
    GLint size = 0;
    gl().BindBuffer(GL_ARRAY_BUFFER, other.buffers[0]);
    gl().GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
    std::vector<char> bytes(static_cast<size_t>(size));
    gl().GetBufferSubData(GL_ARRAY_BUFFER, 0, size, bytes.data());
    gl().BindBuffer(GL_ARRAY_BUFFER, host.buffers[0]);
    gl().BufferSubData(GL_ARRAY_BUFFER, 0, size, bytes.data());
    gl().BindBuffer(GL_ARRAY_BUFFER, 0);
    EXPECT_EQ(draw(*bound), draw(*renderer_->createMesh(small)));
}

TEST_P(MeshBuffersTest, BoundsOfTheHostAreTaken)
{
    HostMesh host(gl(), sphereMesh(12), gl::IndexType::uint32);
    host.mesh.bounds = Sphere{Vec3f(1.0f, 2.0f, 3.0f), 4.0f};
    const auto mesh = renderer_->createMesh(host.mesh);
    EXPECT_EQ(mesh->bounds().centre, Vec3f(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(mesh->bounds().radius, 4.0f);
}

TEST_P(MeshBuffersTest, BuffersOfTheHostAreNeitherCopiedNorDeleted)
{
    Hooks hooks(context().loader());
    gl::RendererOptions options = rendererOptions();
    options.load = Hooks::load;
    options.loadUser = &hooks;
    const HostMesh host(gl(), sphereMesh(12), gl::IndexType::uint16);
    {
        gl::Renderer renderer(options);
        const auto mesh = renderer.createMesh(host.mesh);
        EXPECT_EQ(hooks.alive["Buffers"], 0);
        EXPECT_EQ(hooks.alive["VertexArrays"], GetParam().legacy ? 0 : 1);
    }
    EXPECT_EQ(hooks.made, hooks.deleted);
    for (const GLuint buffer : host.buffers) EXPECT_TRUE(gl().IsBuffer(buffer));
}

TEST_P(MeshBuffersTest, WhatDoesNotFitIsRefused)
{
    const HostMesh host(gl(), knotMesh(48, 8), gl::IndexType::uint32);
    const auto with = [&](auto change) {
        gl::MeshBuffers mesh = host.mesh;
        change(mesh);
        return mesh;
    };
    const auto input = ErrorKind::input;
    refused(input, "found 0 vertices", with([](auto& m) { m.vertexCount = 0; }));
    refused(input, "for positions, expected", with([](auto& m) { ++m.vertexCount; }));
    refused(input, "found buffer 0", with([](auto& m) { m.normals.buffer = 0; }));
    refused(ErrorKind::gl, "found no buffer object 12345 for tangents",
            with([](auto& m) { m.tangents.buffer = 12345; }));
    refused(input, "found normals at offset", with([](auto& m) { m.normals.offset += 2; }));
    refused(input, "and stride 8", with([](auto& m) { m.normals.stride = 8; }));
    refused(input, "of 5 components", with([](auto& m) { m.tangentComponents = 5; }));
    refused(input, "three a triangle", with([](auto& m) { m.indexCount -= 1; }));
    refused(input, "for indices", with([](auto& m) { m.indexCount += 3; }));
    refused(input, "for indices", with([](auto& m) { m.indexOffset = 2; }));
    refused(input, "for indices", with([](auto& m) { m.indexOffset = size_t(1) << 40; }));
    refused(input, "for positions", with([](auto& m) { m.positions.offset = ~size_t(0) - 3; }));
    refused(input, "found buffer 0 for extra array 0",
            with([](auto& m) { m.extra.emplace_back(); }));
    refused(input, "found 5 extra arrays", with([](auto& m) { m.extra.assign(5, m.positions); }));
    refused(input, "bounds that are not finite", with([](auto& m) {
                m.bounds = Sphere{Vec3f(0.0f), -1.0f};
            }));
}

INSTANTIATE_TEST_SUITE_P(Backends, MeshBuffersTest, ::testing::ValuesIn(allVariants()),
                         variantName);

}  // namespace
}  // namespace fbrdf::test
