#include "EmbeddedShaders.h"
#include "FragmentWriter.h"

#include <fbrdf/brdf/Error.h>

#include <glm/matrix.hpp>

#include <algorithm>

namespace fbrdf {
namespace {

std::string assembled(int glsl, std::initializer_list<const char*> files)
{
    if (glsl != 120 && glsl != 140 && glsl != 150 && glsl != 330)
        throw Error(ErrorKind::gl, "shader",
                    "found GLSL " + std::to_string(glsl) + ", expected 120, 140, 150 or 330");
    std::string text = "#version " + std::to_string(glsl) + "\n";
    for (const char* file : files) text += embeddedShader(file);
    return text;
}

}  // namespace

ProgramSpec programSpec(const Pass& pass, int maxLights)
{
    ProgramSpec spec{pass.parts, 0, pass.lit, pass.reads.has_value()};
    if (pass.lightCount > 0) {
        spec.lightSlots = 1;
        while (spec.lightSlots < pass.lightCount) spec.lightSlots *= 8;
        spec.lightSlots = std::max(pass.lightCount, std::min(spec.lightSlots, maxLights));
    }
    return spec;
}

std::string vertexSource(int glsl)
{
    return assembled(glsl, {"version.glsl", "surface.vert"});
}

std::string fragmentSource(const Form& form, const std::vector<TableEncoding>& encodings,
                           const ProgramSpec& spec, int glsl)
{
    const FragmentContext context{form, encodings, spec};
    // Declared first: that is where what does not agree is refused.
    const std::string uniforms = uniformDeclarations(context);
    return assembled(glsl, {"version.glsl", "surface.glsl", "frame.glsl", "angles.glsl",
                            "projection.glsl", "lights.glsl"}) +
           uniforms + mainFunction(context);
}

// The viewer E is where the projection divides by zero: P E = (0, 0, k, 0). Towards smaller depth
// is towards the viewer, hence k < 0.
glm::dvec4 eyeFromProjection(const glm::dmat4& projection)
{
    const glm::dvec4 eye = -(glm::inverse(projection) * glm::dvec4(0.0, 0.0, 1.0, 0.0));
    return eye.w != 0.0 ? eye / eye.w : eye;
}

}  // namespace fbrdf
