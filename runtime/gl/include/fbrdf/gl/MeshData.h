// MeshData.h - the triangles of one object: in arrays that the renderer copies, or in buffer
// objects that the host has already. Object space; counter-clockwise seen from outside.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/LightSelection.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace fbrdf::gl {

/// A mesh has at most so many extra arrays, which vertex hooks read (Hooks).
constexpr size_t kExtraArrays = 4;

/// Arrays in the host's memory, copied while createMesh runs. Each is as long as `positions`, or
/// empty where that is allowed.
struct MeshData {
    std::vector<Vec3f> positions;
    /// Need not be unit, must not be 0.
    std::vector<Vec3f> normals;
    /// Need not be unit or orthogonal. May be empty: where a material needs a frame, it is then
    /// derived per pixel, towards increasing s of the texture coordinates; without texture
    /// coordinates it is arbitrary.
    std::vector<Vec3f> tangents;
    /// Three for each triangle.
    std::vector<uint32_t> indices;
    /// May be empty. For normal maps and derived tangents.
    std::vector<glm::vec2> textureCoordinates = {};
    /// One for each tangent: negative where s = -n x t, as under mirrored texture coordinates. May
    /// be empty, which means s = n x t.
    std::vector<float> handedness = {};
    /// Arrays for vertex hooks: fbrdfExtra0 is the first.
    std::vector<std::vector<glm::vec4>> extra = {};
};

/// 32-bit floats in a buffer object of the host, one element for each vertex.
struct BufferArray {
    uint32_t buffer = 0;  ///< name of the buffer object; 0: the mesh has no such array
    size_t offset = 0;    ///< bytes before the first element
    uint32_t stride = 0;  ///< bytes from one element to the next; 0: elements follow each other
};

enum class IndexType { uint16, uint32 };

/// Buffer objects of the host, bound where they are. Nothing is copied: what the host writes into
/// them later is drawn, and the mesh must not be drawn after the host has deleted one of them.
struct MeshBuffers {
    uint32_t vertexCount = 0;   ///< every array is as long; indices are below it
    BufferArray positions;      ///< three floats each
    BufferArray normals;        ///< three floats each; as MeshData::normals
    BufferArray tangents = {};  ///< as MeshData::tangents, may be missing
    int tangentComponents = 4;  ///< 4: the last is the handedness, as in glTF; or 3: without
    BufferArray textureCoordinates = {};  ///< two floats each, may be missing
    std::vector<BufferArray> extra = {};  ///< four floats each; as MeshData::extra
    uint32_t indexBuffer = 0;
    size_t indexOffset = 0;   ///< bytes before the first index
    uint32_t indexCount = 0;  ///< three for each triangle
    IndexType indexType = IndexType::uint32;
    /// Contains all positions, before vertex hooks move them; lights are culled by it, so it must
    /// stay true when positions change. Where it is missing, createMesh reads the positions back
    /// once, and waits for the GPU to do so; OpenGL ES cannot, and needs it.
    std::optional<Sphere> bounds = {};
};

}  // namespace fbrdf::gl
