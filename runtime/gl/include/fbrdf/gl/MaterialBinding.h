// MaterialBinding.h - a material in a program of the host: for engines that draw by themselves. The
// program contains the functions of materialFunctions (ShaderSource.h).
#pragma once
#include <fbrdf/gl/Renderer.h>

namespace fbrdf::gl {

/// Functions of a material for somebody else's fragment shader; what it declares is said in
/// ShaderSource.h. glsl: as there; maxLights >= 1: room of fbrdfLights.
std::string materialFunctions(const GpuMaterial& material, int glsl, int maxLights);

class MaterialBinding {
public:
    /// Finds the uniforms of a linked program. Throws Error(gl) where it has none of them, for then
    /// it is another program, or an abandoned context.
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
