// MeshArrays.h - where the arrays of a mesh are: copied into buffers of ours, or in buffers of the
// host.
#pragma once
#include "Objects.h"

#include <fbrdf/gl/MeshData.h>

#include <array>

namespace fbrdf::gl {

/// Locations that every program binds its attributes to; extra array k is at kExtra + k.
enum Attribute : GLuint {
    kPosition,
    kNormal,
    kTangent,
    kTextureCoordinate,
    kExtra,
    kAttributeCount = kExtra + kExtraArrays
};

struct MeshArrays {
    struct Array {
        GLuint buffer = 0;
        GLint components = 0;  ///< 0: the mesh has no such array
        size_t offset = 0;     ///< bytes
        GLsizei stride = 0;    ///< bytes; 0: packed
    };
    std::array<Array, kAttributeCount> attributes{};
    GLuint indexBuffer = 0;
    GLenum indexType = GL_UNSIGNED_INT;
    size_t indexOffset = 0;  ///< bytes
    GLsizei indexCount = 0;
    Sphere bounds;  ///< object space
};

/// Buffers that belong to a mesh.
struct MeshStorage {
    Object vertices, indices;
};

/// Uploads; the caller has an UploadGuard, and the vertex array bound that is to know the index
/// buffer. Throws Error(input) for arrays that do not agree, Error(gl) where indices of 32 bits are
/// missing.
MeshArrays uploadArrays(const DevicePtr& device, const MeshData& mesh, MeshStorage& storage);

/// Checks the host's buffers and finds the bounds; binds them to the array buffer only. Throws
/// Error(input) for what the buffers do not contain, Error(gl) for names that are no buffers.
MeshArrays hostArrays(const Device& device, const MeshBuffers& mesh);

/// A sphere about the middle of the box around the positions.
Sphere boundsOf(const std::vector<Vec3f>& positions);

[[noreturn]] void failMesh(const std::string& what);

}  // namespace fbrdf::gl
