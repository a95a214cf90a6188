#include "Boundary.h"

#include <fbrdf/base/Found.h>

using namespace fbrdf::capi;

namespace {

/// `count` vectors whose components follow each other; no vectors where `numbers` is NULL.
template <class Vector>
std::vector<Vector> vectors(const float* numbers, uint32_t count)
{
    std::vector<Vector> result(numbers ? count : 0);
    if (!result.empty()) std::memcpy(result.data(), numbers, result.size() * sizeof result[0]);
    return result;
}

fbrdf::gl::MeshData meshOf(const fbrdf_mesh_desc& desc)
{
    required(desc.positions, "positions");
    required(desc.normals, "normals");
    required(desc.indices, "indices");
    const uint32_t count = desc.vertex_count;
    fbrdf::gl::MeshData mesh;
    mesh.positions = vectors<fbrdf::Vec3f>(desc.positions, count);
    mesh.normals = vectors<fbrdf::Vec3f>(desc.normals, count);
    mesh.tangents = vectors<fbrdf::Vec3f>(desc.tangents, count);
    mesh.indices.assign(desc.indices, desc.indices + desc.index_count);
    mesh.textureCoordinates = vectors<glm::vec2>(desc.texture_coordinates, count);
    mesh.handedness = vectors<float>(desc.handedness, count);
    if (desc.extra_count > 0) required(desc.extra, "extra");
    if (desc.extra_count > fbrdf::gl::kExtraArrays)
        throw Failure(
            FBRDF_RESULT_ERROR_ARGUMENT,
            "extra_count: " + fbrdf::Found(std::to_string(desc.extra_count))
                                  .expected("at most " + std::to_string(fbrdf::gl::kExtraArrays)));
    for (uint32_t k = 0; k < desc.extra_count; ++k)
        mesh.extra.push_back(vectors<glm::vec4>(&required(desc.extra[k], "extra"), count));
    return mesh;
}

fbrdf::gl::BufferArray arrayOf(const fbrdf_buffer_array& given)
{
    return {given.buffer, static_cast<size_t>(given.offset), given.stride};
}

/// The extra arrays up to the last one that exists.
std::vector<fbrdf::gl::BufferArray> extraOf(const fbrdf_mesh_buffers_desc& desc)
{
    std::vector<fbrdf::gl::BufferArray> extra;
    for (const fbrdf_buffer_array& given : desc.extra) extra.push_back(arrayOf(given));
    // A descriptor has places for all of them, and the renderer counts what is there.
    while (!extra.empty() && extra.back().buffer == 0) extra.pop_back();
    return extra;
}

fbrdf::gl::MeshBuffers meshOf(const fbrdf_mesh_buffers_desc& desc)
{
    fbrdf::gl::MeshBuffers mesh;
    mesh.vertexCount = desc.vertex_count;
    mesh.positions = arrayOf(desc.positions);
    mesh.normals = arrayOf(desc.normals);
    mesh.tangents = arrayOf(desc.tangents);
    if (desc.tangent_components > 4 ||
        (desc.tangent_components % 4 != 0 && desc.tangent_components != 3))
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "tangent_components: " +
                          fbrdf::Found(std::to_string(desc.tangent_components)).expected("3 or 4"));
    mesh.tangentComponents = desc.tangent_components == 3 ? 3 : 4;
    mesh.textureCoordinates = arrayOf(desc.texture_coordinates);
    mesh.extra = extraOf(desc);
    mesh.indexBuffer = desc.index_buffer;
    mesh.indexOffset = static_cast<size_t>(desc.index_offset);
    mesh.indexCount = desc.index_count;
    mesh.indexType =
        enumerator(desc.index_type, FBRDF_INDEX_UINT16, "index_type") == FBRDF_INDEX_UINT16
            ? fbrdf::gl::IndexType::uint16
            : fbrdf::gl::IndexType::uint32;
    if (desc.bounds) {
        const float* b = desc.bounds;
        mesh.bounds = fbrdf::Sphere{{b[0], b[1], b[2]}, b[3]};
    }
    return mesh;
}

template <class Desc>
fbrdf_result createMesh(fbrdf_renderer* renderer, const Desc* desc, fbrdf_mesh** out)
{
    return created(logOf(renderer), out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        return new fbrdf_mesh{shared,
                              shared->renderer.createMesh(meshOf(descriptor(desc, "mesh")))};
    });
}

}  // namespace

fbrdf_result fbrdf_mesh_create(fbrdf_renderer* renderer, const fbrdf_mesh_desc* desc,
                               fbrdf_mesh** out)
{
    return createMesh(renderer, desc, out);
}

fbrdf_result fbrdf_mesh_create_from_buffers(fbrdf_renderer* renderer,
                                            const fbrdf_mesh_buffers_desc* desc, fbrdf_mesh** out)
{
    return createMesh(renderer, desc, out);
}

void fbrdf_mesh_release(fbrdf_mesh* mesh)
{
    delete mesh;
}
