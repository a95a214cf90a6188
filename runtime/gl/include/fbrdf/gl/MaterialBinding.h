// MaterialBinding.h - a material in a program of the host: for engines that draw by themselves. The
// program contains the functions that materialFunctions returns, and perhaps samplingFunctions.
#pragma once
#include <fbrdf/gl/Handles.h>

#include <cstdint>
#include <memory>
#include <string>

namespace fbrdf::gl {

/// Functions of a material for somebody else's fragment shader; ShaderSource.h lists what they
/// declare. glsl: the version, as there. maxLights >= 1: the number of lights that fbrdfLights has
/// room for.
std::string materialFunctions(const GpuMaterial& material, int glsl, int maxLights);

/// Functions that draw directions of the material by its lobes, to be put after materialFunctions;
/// ShaderSource.h lists them. Waits for the lobes of a material that has none, see Environment.h.
/// Throws Error(gl) where those cannot be fitted, where the uniforms of a fragment shader have no
/// room for them, and for ES 1.00. Not for materials of a packed library.
std::string samplingFunctions(const GpuMaterial& material, int glsl);

/// Where a linked program of the host wants what a material consists of. It shares the ownership of
/// the material; the program stays the host's, which must not delete or relink it while it applies
/// the binding. Thread and context are those of the material.
class MaterialBinding {
public:
    /// Finds the uniforms of a linked program. material: not null. Throws Error(gl) where the
    /// program has none of them, for then it is another program, and for an abandoned context.
    MaterialBinding(std::shared_ptr<const GpuMaterial> material, uint32_t program);
    ~MaterialBinding();
    MaterialBinding(MaterialBinding&&) noexcept;
    MaterialBinding& operator=(MaterialBinding&&) noexcept;

    /// Makes the program current, sets its uniforms, binds the textures from `firstUnit` on and
    /// unbinds samplers there; leaves all that bound, and the active unit. Cube maps are filtered
    /// across their edges where the host enables GL_TEXTURE_CUBE_MAP_SEAMLESS. Returns the number
    /// of units. Throws Error(gl) where the units do not suffice.
    int apply(int firstUnit) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fbrdf::gl
