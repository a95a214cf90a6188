#include "MeshArrays.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace fbrdf::gl {
namespace {

/// Binds the buffer to the array buffer and returns its size in bytes.
size_t sizeOf(const Functions& gl, GLuint buffer, const std::string& name)
{
    if (!gl.IsBuffer(buffer))
        throw Error(ErrorKind::gl, "mesh",
                    Found("no buffer object " + std::to_string(buffer) + " for " + name)
                        .expected("one of the context"));
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    GLint size = 0;
    gl.GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
    // Sizes of 2 to 4 GB come back negative.
    return static_cast<size_t>(static_cast<GLuint>(size));
}

/// Checks that a buffer contains `count` elements of so many bytes.
// Reading beyond a buffer is undefined in GL, so it is checked here, once and not in every draw.
void checkRange(const Functions& gl, const BufferArray& array, size_t count, size_t bytes,
                const std::string& name)
{
    const size_t size = sizeOf(gl, array.buffer, name),
                 stride = array.stride != 0 ? array.stride : bytes;
    if (array.offset % 4 != 0 || stride % 4 != 0 || stride < bytes ||
        stride > static_cast<size_t>(std::numeric_limits<GLsizei>::max()))
        failMesh(Found(name + " at offset " + std::to_string(array.offset) + " and stride " +
                       std::to_string(array.stride))
                     .expected("multiples of 4 and at least " + std::to_string(bytes) +
                               " bytes an element"));
    // The last element need not be followed by a whole stride.
    const size_t last = (count - 1) * stride + bytes;
    if (array.offset > size || last > size - array.offset)
        failMesh(Found("a buffer of " + std::to_string(size) + " bytes for " + name)
                     .expected("at least " + std::to_string(array.offset) + " + " +
                               std::to_string(last)));
}

MeshArrays::Array checkedArray(const Functions& gl, const BufferArray& array, uint32_t count,
                               GLint components, const std::string& name)
{
    if (array.buffer == 0) return {};
    checkRange(gl, array, count, static_cast<size_t>(components) * sizeof(float), name);
    return {array.buffer, components, array.offset, static_cast<GLsizei>(array.stride)};
}

void checkCounts(const MeshBuffers& mesh)
{
    if (mesh.vertexCount == 0) failMesh(Found("0 vertices").expected("at least one"));
    if (mesh.indexCount == 0 || mesh.indexCount % 3 != 0 ||
        mesh.indexCount > static_cast<uint32_t>(std::numeric_limits<GLsizei>::max()))
        failMesh(Found(std::to_string(mesh.indexCount) + " indices")
                     .expected("three a triangle and below 2^31"));
    if (mesh.positions.buffer == 0 || mesh.normals.buffer == 0 || mesh.indexBuffer == 0)
        failMesh(Found("buffer 0").expected("buffers of positions, normals and indices"));
    if (mesh.tangentComponents != 3 && mesh.tangentComponents != 4)
        failMesh(Found("tangents of " + std::to_string(mesh.tangentComponents) + " components")
                     .expected("3 or 4"));
    if (mesh.extra.size() > kExtraArrays)
        failMesh(Found(std::to_string(mesh.extra.size()) + " extra arrays")
                     .expected("at most " + std::to_string(kExtraArrays)));
}

void setIndices(const Device& device, const MeshBuffers& mesh, MeshArrays& arrays)
{
    const bool wide = mesh.indexType == IndexType::uint32;
    if (wide && !device.wideIndices)
        throw Error(ErrorKind::gl, "mesh",
                    Found("no 32-bit indices").expected("OES_element_index_uint"));
    const size_t bytes = wide ? sizeof(uint32_t) : sizeof(uint16_t),
                 size = sizeOf(device.gl, mesh.indexBuffer, "indices");
    if (mesh.indexOffset % bytes != 0 || mesh.indexOffset > size ||
        mesh.indexCount * bytes > size - mesh.indexOffset)
        failMesh(Found("a buffer of " + std::to_string(size) + " bytes for indices")
                     .expected(std::to_string(mesh.indexCount * bytes) + " from a multiple of " +
                               std::to_string(bytes) + " on, not " +
                               std::to_string(mesh.indexOffset)));
    arrays.indexBuffer = mesh.indexBuffer;
    arrays.indexType = wide ? GL_UNSIGNED_INT : GL_UNSIGNED_SHORT;
    arrays.indexOffset = mesh.indexOffset;
    arrays.indexCount = static_cast<GLsizei>(mesh.indexCount);
}

bool isFinite(const Sphere& sphere)
{
    return std::isfinite(sphere.centre.x) && std::isfinite(sphere.centre.y) &&
           std::isfinite(sphere.centre.z) && std::isfinite(sphere.radius) && sphere.radius >= 0.0f;
}

/// Reads the positions back.
Sphere boundsIn(const Functions& gl, const BufferArray& array, uint32_t count)
{
    const size_t stride = array.stride != 0 ? array.stride : sizeof(Vec3f);
    std::vector<unsigned char> bytes((count - 1) * stride + sizeof(Vec3f));
    gl.BindBuffer(GL_ARRAY_BUFFER, array.buffer);
    gl.GetBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(array.offset),
                        static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    std::vector<Vec3f> positions(count);
    // Elements need not be aligned to those of the vector.
    for (size_t i = 0; i < count; ++i)
        std::memcpy(&positions[i], &bytes[i * stride], sizeof(Vec3f));
    return boundsOf(positions);
}

Sphere checkedBounds(const Device& device, const MeshBuffers& mesh)
{
    if (!mesh.bounds && device.gl.es != 0)
        throw Error(
            ErrorKind::gl, "mesh",
            Found("no bounds").expected("them in OpenGL ES, which does not read buffers back"));
    const Sphere bounds =
        mesh.bounds ? *mesh.bounds : boundsIn(device.gl, mesh.positions, mesh.vertexCount);
    if (!isFinite(bounds))
        failMesh(Found("bounds that are not finite").expected("a sphere around the positions"));
    return bounds;
}

}  // namespace

MeshArrays hostArrays(const Device& device, const MeshBuffers& mesh)
{
    const Functions& gl = device.gl;
    const uint32_t count = mesh.vertexCount;
    checkCounts(mesh);
    MeshArrays arrays;
    auto& attributes = arrays.attributes;
    attributes[kPosition] = checkedArray(gl, mesh.positions, count, 3, "positions");
    attributes[kNormal] = checkedArray(gl, mesh.normals, count, 3, "normals");
    attributes[kTangent] =
        checkedArray(gl, mesh.tangents, count, mesh.tangentComponents, "tangents");
    attributes[kTextureCoordinate] =
        checkedArray(gl, mesh.textureCoordinates, count, 2, "texture coordinates");
    for (size_t k = 0; k < mesh.extra.size(); ++k) {
        const std::string name = "extra array " + std::to_string(k);
        if (mesh.extra[k].buffer == 0) failMesh(Found("buffer 0 for " + name).expected("one"));
        attributes[kExtra + k] = checkedArray(gl, mesh.extra[k], count, 4, name);
    }
    // Indices themselves are not checked: that would read the whole buffer back.
    setIndices(device, mesh, arrays);
    // Last, for reading back waits for the GPU.
    arrays.bounds = checkedBounds(device, mesh);
    return arrays;
}

}  // namespace fbrdf::gl
