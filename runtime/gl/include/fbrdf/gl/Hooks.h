// Hooks.h - GLSL of the host in the programs of its objects: it moves vertices and shadows lights.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace fbrdf::gl {

/// Functions and what they need, in the version of the context (Capabilities::glsl), without
/// #version. Names that begin with fbrdf are the renderer's. FBRDF_ATTRIBUTE and the other macros
/// of version.glsl are defined.
struct Hooks {
    /// Empty for none. Defines
    ///   void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)
    /// which moves a vertex in object space: skinning, morphing, wind. It may declare
    ///   FBRDF_ATTRIBUTE vec4 fbrdfExtra0;
    /// and so on to read MeshData::extra.
    std::string vertex;
    /// The distance that it moves a vertex at most, in object space: lights are culled by the
    /// bounds of the mesh and this. Infinity culls none.
    float reach = std::numeric_limits<float>::infinity();
    /// Empty for none. Defines
    ///   float fbrdfShadow(int light, vec3 position, vec3 toLight)
    /// which returns what passes of a light: `light` is its place among those that draw() was
    /// given, the other two are in eye space, toLight is unit. It is called above the horizon only,
    /// so it must not take derivatives. Its look-ups are not counted.
    std::string shadow;
    /// vec4 uniforms that `shadow` declares: so many fewer are left for lights.
    int shadowUniforms = 0;
    /// Sets the uniforms of both functions: called with the program current, once for each item and
    /// program. May be empty. The host binds its textures before the draw, to units that the
    /// renderer does not use.
    std::function<void(uint32_t program)> setUniforms;
};

}  // namespace fbrdf::gl
