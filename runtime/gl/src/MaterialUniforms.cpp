#include "MaterialUniforms.h"

#include <glm/gtc/type_ptr.hpp>

#include <string>

namespace fbrdf::gl {

MaterialUniforms findUniforms(const MaterialResources& material, GLuint program)
{
    const auto location = [&](const std::string& name, size_t index) {
        return material.device()->gl.GetUniformLocation(program,
                                                        (name + std::to_string(index)).c_str());
    };
    // -1 stands for a uniform that the linker removed; GL ignores it, setUniforms saves the call.
    MaterialUniforms result;
    for (size_t i = 0; i < material.tables().size(); ++i)
        result.tables.push_back({location("fbrdfTable", i), location("fbrdfLower", i),
                                 location("fbrdfExtent", i), location("fbrdfKnots", i)});
    for (size_t t = 0; t < material.scales().size(); ++t)
        result.scales.push_back(location("fbrdfScale", t));
    return result;
}

void setUniforms(const MaterialResources& material, const MaterialUniforms& uniforms)
{
    const Functions& gl = material.device()->gl;
    for (size_t i = 0; i < uniforms.tables.size(); ++i) {
        const MaterialUniforms::OfTable& at = uniforms.tables[i];
        // A program whose text uses few tables may have been found for a form that has more.
        if (at.lower < 0 && at.extent < 0 && at.knots < 0) continue;
        const GpuTable& table = material.tables()[i];
        if (at.lower >= 0) gl.Uniform3fv(at.lower, 1, glm::value_ptr(table.lower));
        if (at.extent >= 0) gl.Uniform3fv(at.extent, 1, glm::value_ptr(table.extent));
        if (at.knots >= 0)
            gl.Uniform3fv(at.knots, static_cast<GLsizei>(table.knots.size()),
                          glm::value_ptr(table.knots.front()));
    }
    for (size_t t = 0; t < uniforms.scales.size(); ++t)
        if (uniforms.scales[t] >= 0)
            gl.Uniform3fv(uniforms.scales[t], 1, glm::value_ptr(material.scales()[t]));
}

}  // namespace fbrdf::gl
