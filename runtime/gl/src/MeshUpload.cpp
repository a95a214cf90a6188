#include "MeshArrays.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <limits>

namespace fbrdf::gl {
namespace {

/// size: of an array that may be left out.
void checkOptional(size_t size, size_t count, const char* name)
{
    if (size != 0 && size != count)
        failMesh(
            Found(std::to_string(size) + " " + name).expected("none or " + std::to_string(count)));
}

void checkIndices(const MeshData& mesh)
{
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        failMesh(
            Found(std::to_string(mesh.indices.size()) + " indices").expected("three a triangle"));
    if (mesh.indices.size() > static_cast<size_t>(std::numeric_limits<GLsizei>::max()))
        failMesh(Found(std::to_string(mesh.indices.size()) + " indices").expected("below 2^31"));
    for (const uint32_t index : mesh.indices)
        if (index >= mesh.positions.size())
            failMesh(Found("index " + std::to_string(index))
                         .expected("below " + std::to_string(mesh.positions.size())));
}

void check(const MeshData& mesh)
{
    const size_t count = mesh.positions.size();
    if (mesh.normals.size() != count)
        failMesh(Found(std::to_string(mesh.normals.size()) + " normals")
                     .expected(std::to_string(count)));
    checkOptional(mesh.tangents.size(), count, "tangents");
    checkOptional(mesh.handedness.size(), mesh.tangents.size(), "signs of tangents");
    checkOptional(mesh.textureCoordinates.size(), count, "texture coordinates");
    if (mesh.extra.size() > kExtraArrays)
        failMesh(Found(std::to_string(mesh.extra.size()) + " extra arrays")
                     .expected("at most " + std::to_string(kExtraArrays)));
    for (const auto& array : mesh.extra)
        if (array.size() != count)
            failMesh(Found("an extra array of " + std::to_string(array.size()))
                         .expected(std::to_string(count)));
    // A wrong index would read beyond the arrays on the GPU, with whatever result.
    checkIndices(mesh);
}

/// Tangents as vec4, w = handedness.
std::vector<glm::vec4> tangentsOf(const MeshData& mesh)
{
    std::vector<glm::vec4> tangents;
    for (size_t i = 0; i < mesh.tangents.size(); ++i)
        tangents.emplace_back(mesh.tangents[i],
                              mesh.handedness.empty() ? 1.0f : mesh.handedness[i]);
    return tangents;
}

/// Puts one array after the other into one buffer.
void uploadVertices(const DevicePtr& device, const MeshData& mesh, MeshArrays& arrays,
                    Object& vertices)
{
    vertices = createObject(device, ObjectKind::buffer);
    // Arrays are not interleaved: hosts pass separate arrays, and copying each whole is quickest.
    std::vector<unsigned char> bytes;
    const auto append = [&](GLuint attribute, GLint components, const auto& array) {
        if (array.empty()) return;
        arrays.attributes[attribute] = {vertices.name(), components, bytes.size(), 0};
        const auto* first = reinterpret_cast<const unsigned char*>(array.data());
        bytes.insert(bytes.end(), first, first + array.size() * sizeof array[0]);
    };
    append(kPosition, 3, mesh.positions);
    append(kNormal, 3, mesh.normals);
    append(kTangent, 4, tangentsOf(mesh));
    append(kTextureCoordinate, 2, mesh.textureCoordinates);
    for (size_t k = 0; k < mesh.extra.size(); ++k)
        append(static_cast<GLuint>(kExtra + k), 4, mesh.extra[k]);
    const Functions& gl = device->gl;
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                  GL_STATIC_DRAW);
    label(*device, ObjectKind::buffer, vertices, "mesh vertices");
}

void uploadIndices(const DevicePtr& device, const MeshData& mesh, MeshArrays& arrays,
                   Object& indices)
{
    const Functions& gl = device->gl;
    indices = createObject(device, ObjectKind::buffer);
    // OpenGL ES and WebGL want to know the kind of a buffer when it is bound first.
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                  mesh.indices.data(), GL_STATIC_DRAW);
    label(*device, ObjectKind::buffer, indices, "mesh indices");
    arrays.indexBuffer = indices.name();
    arrays.indexCount = static_cast<GLsizei>(mesh.indices.size());
}

}  // namespace

void failMesh(const std::string& what)
{
    throw Error(ErrorKind::input, "mesh", what);
}

Sphere boundsOf(const std::vector<Vec3f>& positions)
{
    FBRDF_ASSERT(positions.size(), >, 0u);
    Vec3f low = positions.front(), high = low;
    for (const Vec3f& position : positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    // The smallest sphere would cull little more and take far longer to find.
    const Vec3f centre = 0.5f * (low + high);
    return {centre, glm::distance(centre, high)};
}

MeshArrays uploadArrays(const DevicePtr& device, const MeshData& mesh, MeshStorage& storage)
{
    // Checked before anything is made, so that a refusal leaves nothing behind.
    check(mesh);
    if (!device->wideIndices)
        throw Error(ErrorKind::gl, "mesh",
                    Found("no 32-bit indices").expected("OES_element_index_uint"));
    MeshArrays arrays;
    arrays.bounds = boundsOf(mesh.positions);
    uploadVertices(device, mesh, arrays, storage.vertices);
    uploadIndices(device, mesh, arrays, storage.indices);
    return arrays;
}

}  // namespace fbrdf::gl
