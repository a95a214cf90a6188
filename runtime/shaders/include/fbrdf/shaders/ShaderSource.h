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
//   lobes       fbrdfLobes[] (vec4, see LobeRows.h), of bent ones fbrdfLobeBend (vec2)
//   environment fbrdfEnvironment (samplerCube, prefiltered), fbrdfToEnvironment (mat3: from eye
//               space), fbrdfEnvironmentScale (vec4: intensity, and what is added to a level of a
//               lobe); where directions are drawn: fbrdfEnvironment is not prefiltered, the last of
//               fbrdfEnvironmentScale texels on a side of its faces, fbrdfSampleLattice (vec2:
//               their number, latticeStep)
//   area lights fbrdfAreaLights[5 slots] (vec4), fbrdfAreaLightCount (int)      see AreaVectors.h
// Instanced programs read maps from arrays, and buffers: see PackedParameters.h.
#pragma once
#include <fbrdf/brdf/DirectionMap.h>
#include <fbrdf/plan/Plan.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// How the texels of a table come out of its texture.
struct TableEncoding {
    bool logarithmic = true;  ///< log2 F, added; otherwise F, multiplied
    bool ranged = false;      ///< lower + extent x texel
    /// The map that stands for a table over one direction; a samplerCube where it is cube.
    LookUp lookUp = LookUp::native;
    int mapSize = 0;  ///< texels on a side of a parabolic map
    /// The shader filters from single texels: 4 fetches, or 8 of a volume, stand for one look-up.
    /// The texture must not filter. Not for cube maps.
    bool precise = false;
};

/// What one program computes: a pass without its place in the plan.
struct ProgramSpec {
    std::vector<Part> parts;
    int lightSlots = 0;  ///< lights that fit into fbrdfLights; 0: nothing depends on the light
    bool lit = false, reads = false;
    Transfer transfer = Transfer::linear;
    bool gained = false;  ///< times fbrdfGain
    /// Lights come from the list of the fragment's cluster (clusters.glsl); the first
    /// fbrdfLightCount lights are in every list. Needs GLSL 1.40.
    bool clustered = false;
    /// Lobes are added; firstArea and areaCount are 0. ES 1.00 refuses them, and GLSL 1.20 needs
    /// GL_ARB_shader_texture_lod where there is an environment.
    LobeShare lobes = {};
    /// The same as `clustered` for area lights.
    bool areaLists = false;
    /// Lights come from the function of HostLights.
    bool hosted = false;
    /// What is read may be the mean of several samples that were cleared to 0 before: its alpha is
    /// the share of them that was drawn to. 1 changes nothing.
    bool resolved = false;
    /// What is written is a surface, whose alpha is 1 whatever the tint hook gives. Hosts whose
    /// alpha test goes by it leave it out.
    bool toSurface = false;
};

/// The program of a pass. lightSlots is the number of lights rounded up to 1, 8, 64, ..., at most
/// maxLights (maxLightsInUniforms with the lobes of the pass), so that a changed number of lights
/// seldom needs another program.
ProgramSpec programSpec(const Pass& pass, int maxLights);

/// Where vertices and tangents come from; the same for both shaders of a program.
struct SurfaceInputs {
    /// Matrices, positions and normals are the built-in gl_* of GLSL 1.20; only the tangent is an
    /// attribute of its own.
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
    /// GLSL of the host, put after version.glsl; "": none. The vertex hook defines
    ///     void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)
    /// and the shadow hook, which gives the share of a light that arrives,
    ///     float fbrdfShadow(int light, vec3 position, vec3 toLight)   (or a vec3)
    /// in eye space, toLight being unit.
    std::string vertexHook = {}, shadowHook = {};
    /// The same of the surface: the tint hook defines
    ///     vec4 fbrdfTint()
    /// what the terms in tintedTerms are multiplied with at the fragment (at most 1), and its
    /// alpha; it may read fbrdfTextureCoordinate. Of lobes, the cosine is tinted with any term, and
    /// the others where all terms are.
    std::string tintHook = {};
    std::vector<int> tintedTerms = {};
    /// GLSL of the host that defines the inputs of the vertex shader in the place of ours, where
    /// vertices and matrices have other names (docs/porting.md). "": the fields above say so.
    std::string vertexInputs = {};
};

/// Versions of GLSL that programs are written in; 100 and 300 are those of OpenGL ES.
inline constexpr std::array<int, 7> kGlslVersions{120, 140, 150, 330, 450, 100, 300};

/// glsl: a version of kGlslVersions. ES 1.00 has neither volumes nor an index that varies, so it
/// refuses a form with 3D tables or with knots in uniforms.
std::string vertexSource(int glsl, const SurfaceInputs& inputs = {});
/// encodings: one for each table of the form. Throws Error(gl) for a form that GLSL cannot express.
std::string fragmentSource(const Form& form, const std::vector<TableEncoding>& encodings,
                           const ProgramSpec& spec, int glsl, const SurfaceInputs& inputs = {});

/// What a host's own fragment shader needs to shade with a material, to be put after its version
/// line. It declares the uniforms above of lights, tables and terms, and
///   vec3 fbrdfEvaluate(vec3 wo, vec3 wi)   f in 1/sr; unit, tangent frame; 0 when either direction
///       is at or below the horizon
///   vec3 fbrdfRadiance(vec3 position, vec3 normal, vec4 tangent, vec3 viewer)
///       sum over the first fbrdfLightCount lights of f cos E, in the space of the lights; viewer
///       is unit, towards the eye; tangent.w: handedness, 1 where tangent is a vec3
/// maxLights >= 1: lights that fit into fbrdfLights. Throws as fragmentSource.
std::string materialFunctions(const Form& form, const std::vector<TableEncoding>& encodings,
                              int glsl, int maxLights);

/// Where a host's own shader has its lights, if not in fbrdfLights: in a texture or a buffer, of
/// any number.
struct HostLights {
    /// GLSL that declares what it reads and defines
    ///     vec3 fbrdfHostLight(int light, vec3 position, out vec3 wi)
    /// irradiance on a surface that faces light `light` of fbrdfLightCount, shadows included; wi:
    /// unit, towards it. It may call fbrdfIrradiance with vectors of LightVectors.h. "": the host
    /// defines the function behind the text.
    std::string lights = {};
    /// Lobes that an environment lights, added to fbrdfRadiance; or area lights do, in eye space.
    LobeShare lobes = {};
};

/// The same with the lights of the host, of which fbrdfLightCount is the number. Throws for ES 1.00
/// too, whose loops have a constant number of steps.
std::string materialFunctions(const Form& form, const std::vector<TableEncoding>& encodings,
                              int glsl, const HostLights& lights);

/// What the same shader needs to draw directions by the lobes of the material, to be put after
/// materialFunctions. It declares fbrdfLobes and, of bent lobes, fbrdfLobeBend (above; all rows of
/// LobeRows.h), and the twins of LobeSampling.h:
///   vec4 fbrdfSampleLobes(vec3 wo, vec2 u)     a direction wi and its density in 1/sr; u in
///       [0, 1)^2; unit, tangent frame; wi may be below the horizon, where f is 0
///   float fbrdfLobePdf(vec3 wo, vec3 wi)       that density of any wi
///   FbrdfLobeMixture fbrdfLobeMixture(vec3 wo), and for many directions of one wo
///   vec4 fbrdfSampleMixture(FbrdfLobeMixture mixture, vec2 u)
///   float fbrdfMixturePdf(FbrdfLobeMixture mixture, vec3 wi)
/// Throws Error(gl) for a table without lobes, and for ES 1.00, which has no index that varies.
std::string samplingFunctions(const LobeLayout& table, int glsl);

/// Kinds of textures whose filter can be measured.
enum class ProbedTexture { plane, volume, cube, array };

/// Programs that measure how finely a texture of two texels along each axis is filtered. The texel
/// at (x, y, z) of 0 and 1 has fbrdfRamp.x (low) or fbrdfRamp.y (high) in red by x, in green by y,
/// in blue by z where there is one and else by x. The fragment at the centre of a pixel receives
///     red + green / 255 = -log2(e) / 32,   blue = 1
/// where e is the largest error found along the diagonal, 2^-32 to 1. Uniforms: fbrdfMap, fbrdfRamp
/// (vec2). Attribute: fbrdfVertex (vec3, in clip space).
std::string filterProbeVertexSource(int glsl);
std::string filterProbeFragmentSource(int glsl, ProbedTexture texture);

/// A fragment shader for the same vertices that writes fbrdfRamp.x + fbrdfRamp.y 511 i / 2^23 with
/// i = 4 (64 y + x) + 1 in red, one more in green, two more in blue, and alpha 1 to pixel (x, y) of
/// 64 x 64. All of it is exact in floats for ramps (vec2) of (0, 1), (0, 1/2), (0, 2^-14) and (1/4,
/// 1/4).
std::string roundingProbeFragmentSource(int glsl);

/// The compute shader that makes the lists of LightClusters.h from ClusterWork, in GLSL 4.30: a
/// group for each kClustersPerGroup clusters of a row, and for each row and slice. Its storage
/// buffers are bound to 0: ClusterWork::vectors; 1: the lists, and behind the last the number of
/// indices in use (ivec2: it, 0), which begins at the number of lights in lists; 2: the indices, of
/// which the first list all lights. Uniforms: fbrdfClusterGrid (ivec3), fbrdfListed (ivec3: the
/// first light that stands in lists, the number of lights, indices there is room for),
/// fbrdfTileMargin (float: ClusterWork::tileMargin).
std::string clusterListsSource();
constexpr int kClustersPerGroup = 64;
constexpr int kListBuffers = 3;  ///< storage buffers that it needs

/// A file of glsl/ by its name, "lights.glsl"; empty where there is none.
std::string_view shaderSnippet(std::string_view name);

struct LookupCount {
    int once = 0, perLight = 0;
};
/// Counts the fetches in the main function of a fragment shader, outside the loop over lights, or
/// over directions of an environment, and inside it, that read one of `activeSamplers` (those that
/// glGetActiveUniform lists).
LookupCount countLookups(const std::string& fragmentSource,
                         const std::vector<std::string>& activeSamplers);

/// The viewer in eye space, homogeneous: (point, 1), or (direction to it, 0) for a parallel
/// projection.
glm::dvec4 eyeFromProjection(const glm::dmat4& projection);

}  // namespace fbrdf
