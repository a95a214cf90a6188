// MaterialUniforms.h - the uniforms of a material in a linked program, the renderer's own or one of
// a host.
#pragma once
#include "MaterialResources.h"

#include <vector>

namespace fbrdf::gl {

/// Locations are -1 where a program has no such uniform.
struct MaterialUniforms {
    struct OfTable {
        GLint sampler = -1, lower = -1, extent = -1, knots = -1;
    };
    std::vector<OfTable> tables;  ///< one for each of the form
    std::vector<GLint> scales;    ///< one for each term
};

MaterialUniforms findUniforms(const MaterialResources& material, GLuint program);

/// Sets ranges, knots and scales; the caller binds the textures. The program must be current.
void setUniforms(const MaterialResources& material, const MaterialUniforms& uniforms);

}  // namespace fbrdf::gl
