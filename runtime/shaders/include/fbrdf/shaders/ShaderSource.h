// ShaderSource.h - the text of the programs that passes need, written from a form. GL-free: a
// renderer, an engine plugin and a validator use the same text.
//
// Conventions of every program
//   attributes  fbrdfVertex, fbrdfVertexNormal, fbrdfVertexTangent      vec3, object space
//   matrices    fbrdfModelView, fbrdfProjection (mat4), fbrdfNormalMatrix (mat3)
//   viewer      fbrdfEye (vec4)            see eyeFromProjection
//   lights      fbrdfLights[3 slots] (vec4), fbrdfLightCount (int)      see LightVectors.h
//   table k     fbrdfTable<k> (sampler), where ranged: fbrdfLower<k>, fbrdfExtent<k> (vec3);
//               a uniform table: fbrdfKnots<k>[knots] (vec3), decoded
//   term t      fbrdfScale<t> (vec3)
//   surface     fbrdfRead (sampler), fbrdfReadScale (vec2: 1 / size in pixels)
#pragma once
#include <fbrdf/plan/Plan.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace fbrdf {

/// How the texels of a table come out of its texture.
struct TableEncoding {
    bool logarithmic = true;  ///< log2 F, added; otherwise F, multiplied
    bool ranged = false;      ///< lower + extent x texel
};

/// What one program computes: a pass without its place in the plan.
struct ProgramSpec {
    std::vector<Part> parts;
    int lightSlots = 0;  ///< lights that fbrdfLights has room for; 0: nothing depends on the light
    bool lit = false, reads = false;
};

/// The program of a pass; lightSlots becomes a power of 8 or so, so that a changed number of lights
/// seldom needs another program. maxLights: maxLightsInUniforms.
ProgramSpec programSpec(const Pass& pass, int maxLights);

/// glsl: 120, 140, 150 or 330.
std::string vertexSource(int glsl);
/// encodings: one for each table of the form. Throws Error(gl) for a form that GLSL cannot express.
std::string fragmentSource(const Form& form, const std::vector<TableEncoding>& encodings,
                           const ProgramSpec& spec, int glsl);

struct LookupCount {
    int once = 0, perLight = 0;
};
/// Fetches in the main function of a fragment shader that sample one of `activeSamplers` (what
/// glGetActiveUniform lists): outside the loop over lights, and inside it.
LookupCount countLookups(const std::string& fragmentSource,
                         const std::vector<std::string>& activeSamplers);

/// The viewer in eye space, homogeneous: (point, 1), or (direction to it, 0) for a parallel
/// projection.
glm::dvec4 eyeFromProjection(const glm::dmat4& projection);

}  // namespace fbrdf
