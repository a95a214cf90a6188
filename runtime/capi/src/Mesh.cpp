#include "Boundary.h"

using namespace fbrdf::capi;

namespace {

/// count vectors, one component after the other; none where there are no numbers.
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
    fbrdf::gl::MeshData mesh{vectors<fbrdf::Vec3f>(desc.positions, count),
                             vectors<fbrdf::Vec3f>(desc.normals, count),
                             vectors<fbrdf::Vec3f>(desc.tangents, count),
                             {desc.indices, desc.indices + desc.index_count},
                             vectors<glm::vec2>(desc.texture_coordinates, count),
                             vectors<float>(desc.handedness, count)};
    if (desc.extra_count > 0) required(desc.extra, "extra");
    if (desc.extra_count > fbrdf::gl::kExtraArrays)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "extra_count: found " + std::to_string(desc.extra_count) +
                          ", expected at most " + std::to_string(fbrdf::gl::kExtraArrays));
    for (uint32_t k = 0; k < desc.extra_count; ++k)
        mesh.extra.push_back(vectors<glm::vec4>(&required(desc.extra[k], "extra"), count));
    return mesh;
}

}  // namespace

fbrdf_result fbrdf_mesh_create(fbrdf_renderer* renderer, const fbrdf_mesh_desc* desc,
                               fbrdf_mesh** out)
{
    return created(logOf(renderer), out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        return new fbrdf_mesh{shared,
                              shared->renderer.createMesh(meshOf(descriptor(desc, "mesh")))};
    });
}

void fbrdf_mesh_release(fbrdf_mesh* mesh)
{
    delete mesh;
}
