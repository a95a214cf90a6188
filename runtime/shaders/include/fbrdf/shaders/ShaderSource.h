// ShaderSource.h - the text of the programs that passes need, written from a form. GL-free: a
// renderer, an engine plugin and a validator use the same text.
//
// Conventions of every program
//   attributes  fbrdfVertex, fbrdfVertexNormal (vec3), fbrdfVertexTangent (vec4, w: handedness),
//               object space; fbrdfVertexTextureCoordinate (vec2) where SurfaceInputs wants it
//   matrices    fbrdfModelView, fbrdfProjection (mat4)      or gl_*, see SurfaceInputs
//   viewer      fbrdfEye (vec4)            see eyeFromProjection
//   lights      fbrdfLights[3 slots] (vec4), fbrdfLightCount (int)      see LightVectors.h
//               fbrdfLightNumbers[slots] (int) for a shadow hook
//   table k     fbrdfTable<k> (sampler), where ranged: fbrdfLower<k>, fbrdfExtent<k> (vec3);
//               a uniform table: fbrdfKnots<k>[knots] (vec3), decoded
//   term t      fbrdfScale<t> (vec3)
//   surface     fbrdfRead (sampler), fbrdfReadScale (vec2: 1 / size in pixels)
//   gain        fbrdfGain (float), see Pass
// Instanced programs read maps from arrays, and buffers: see PackedParameters.h.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>
#include <fbrdf/plan/Plan.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// How the texels of a table come out of its texture.
struct TableEncoding {
    bool logarithmic = true;  ///< log2 F, added; otherwise F, multiplied
    bool ranged = false;      ///< lower + extent x texel
    /// Of a table over one direction: the map that stands for it, a samplerCube where it is cube.
    LookUp lookUp = LookUp::native;
    int mapSize = 0;  ///< texels on a side of a parabolic map
};

/// What one program computes: a pass without its place in the plan.
struct ProgramSpec {
    std::vector<Part> parts;
    int lightSlots = 0;  ///< lights that fbrdfLights has room for; 0: nothing depends on the light
    bool lit = false, reads = false;
    Transfer transfer = Transfer::linear;
    bool gained = false;  ///< times fbrdfGain
    bool clustered =
        false;  ///< lights come from the list of the fragment's cluster (clusters.glsl),
                ///< the first fbrdfLightCount of them in every list; GLSL 1.40
};

/// The program of a pass; lightSlots becomes a power of 8 or so, so that a changed number of lights
/// seldom needs another program. maxLights: maxLightsInUniforms.
ProgramSpec programSpec(const Pass& pass, int maxLights);

/// Where vertices and tangents come from; the same for both shaders of a program.
struct SurfaceInputs {
    /// Matrices, positions and normals are the built-in gl_* of GLSL 1.20; only the tangent has a
    /// name of ours.
    bool builtIns = false;
    /// The tangent is derived per pixel, towards increasing s of the texture coordinates; GLSL ES
    /// 1.00 then needs OES_standard_derivatives. With builtIns they are gl_MultiTexCoord0.
    bool derivedTangent = false;
    /// Model-view matrix and material come from fbrdfInstances, tables from texture arrays
    /// (PackedParameters.h); GLSL 1.40.
    bool instanced = false;
    /// Normals come from fbrdfNormalMap (sampler2D) at the texture coordinates: 2 texel - 1, in the
    /// tangent frame.
    bool normalMap = false;
    /// GLSL of the host (Hooks, Renderer.h), after version.glsl; "": none.
    std::string vertexHook = {}, shadowHook = {};
};

/// glsl: 120, 140, 150, 330 or 450; of ES 300, or 100, which has neither volumes nor an index that
/// varies: a form with 3D tables or with knots in uniforms is refused there.
std::string vertexSource(int glsl, const SurfaceInputs& inputs = {});
/// encodings: one for each table of the form. Throws Error(gl) for a form that GLSL cannot express.
std::string fragmentSource(const Form& form, const std::vector<TableEncoding>& encodings,
                           const ProgramSpec& spec, int glsl, const SurfaceInputs& inputs = {});

/// What somebody else's fragment shader needs to shade with a material, to be put after its
/// #version line; it declares the uniforms above of lights, tables and terms, and
///   vec3 fbrdfEvaluate(vec3 wo, vec3 wi)   f in 1/sr; unit, tangent frame; 0 below the horizon
///   vec3 fbrdfRadiance(vec3 position, vec3 normal, vec4 tangent, vec3 viewer)
///       sum over the first fbrdfLightCount lights of f cos E, in the space of the lights; viewer
///       is unit, towards the eye; tangent.w: handedness, 1 where tangent is a vec3
/// maxLights >= 1: room of fbrdfLights. Throws as fragmentSource.
std::string materialFunctions(const Form& form, const std::vector<TableEncoding>& encodings,
                              int glsl, int maxLights);

/// A file of glsl/ by its name, "lights.glsl"; empty where there is none.
std::string_view shaderSnippet(std::string_view name);

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
