#include "EmbeddedShaders.h"
#include "FragmentWriter.h"
#include "LobeWriter.h"
#include "SamplingWriter.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/PrefilterSource.h>

#include <glm/matrix.hpp>

#include <algorithm>

namespace fbrdf {
namespace {

void checkVersion(int glsl)
{
    for (const int known : kGlslVersions)
        if (glsl == known) return;
    throw Error(ErrorKind::gl, "shader",
                Found("GLSL " + std::to_string(glsl))
                    .expected("120, 140, 150, 330 or 450, or of ES 100 or 300"));
}

/// Throws where there are no buffer textures: before GLSL 1.40 and in ES.
void checkBuffers(int glsl, const std::string& what)
{
    if (glsl == 120 || glsl == kGlslEs100 || glsl == kGlslEs300)
        throw Error(ErrorKind::gl, "shader",
                    Found("GLSL " + std::to_string(glsl)).expected("140 or newer for " + what));
}

std::string joined(std::initializer_list<const char*> files)
{
    std::string text;
    for (const char* file : files) text += embeddedShader(file);
    return text;
}

std::string assembled(int glsl, const SurfaceInputs& inputs,
                      std::initializer_list<const char*> files, bool choosesLevels = false)
{
    checkVersion(glsl);
    if (glsl != 120 && inputs.builtIns)
        throw Error(ErrorKind::gl, "shader",
                    Found("GLSL " + std::to_string(glsl)).expected("120 for built-in inputs"));
    if (inputs.instanced) checkBuffers(glsl, "instances");
    std::string text = "#version " + std::to_string(glsl) + (glsl == kGlslEs300 ? " es\n" : "\n");
    // This line is not in a file under #ifdef, because OpenSceneGraph puts declarations after the
    // last line that begins with #extension, wherever that is.
    if (glsl == kGlslEs100 && inputs.derivedTangent)
        text += "#extension GL_OES_standard_derivatives : require\n";
    if (glsl == 120 && choosesLevels) text += "#extension GL_ARB_shader_texture_lod : require\n";
    if (inputs.derivedTangent || inputs.normalMap || !inputs.tintHook.empty())
        text += "#define FBRDF_TEXTURE_COORDINATE\n";
    if (inputs.derivedTangent) text += "#define FBRDF_DERIVED_TANGENT\n";
    if (inputs.instanced) text += "#define FBRDF_INSTANCED\n";
    if (inputs.normalMap) text += "#define FBRDF_NORMAL_MAP\n";
    if (!inputs.vertexHook.empty()) text += "#define FBRDF_VERTEX_HOOK\n";
    return text + joined(files);
}

std::string vertexInputs(const SurfaceInputs& inputs)
{
    if (!inputs.vertexInputs.empty()) return inputs.vertexInputs;
    if (inputs.builtIns) return joined({"inputs_built_in.glsl"});
    return joined({inputs.instanced ? "inputs_instanced.glsl" : "inputs_uniform.glsl"});
}

/// The hook and the variable that has what it gives.
std::string tintFunctions(const SurfaceInputs& inputs)
{
    return inputs.tintHook.empty() ? "" : inputs.tintHook + "\nvec4 fbrdfTinted;\n";
}

const std::vector<int>* tintedTerms(const SurfaceInputs& inputs)
{
    return inputs.tintHook.empty() ? nullptr : &inputs.tintedTerms;
}

/// What the look-ups of a form need beside FBRDF_TEXTURE2 and the like.
std::string filterFunctions(const std::vector<TableEncoding>& encodings)
{
    const bool precise = std::any_of(encodings.begin(), encodings.end(),
                                     [](const TableEncoding& e) { return e.precise; });
    return precise ? joined({"filter.glsl"}) : "";
}

/// All terms with all factors, and the lights in a loop.
ProgramSpec wholeSpec(const Form& form, int lights)
{
    ProgramSpec spec;
    for (int t = 0; t < static_cast<int>(form.terms.size()); ++t) {
        Part part{t, {}, true};
        for (size_t k = 0; k < form.terms[static_cast<size_t>(t)].factors.size(); ++k)
            part.factors.push_back(static_cast<int>(k));
        spec.parts.push_back(std::move(part));
    }
    spec.lightSlots = std::max(2, lights);  // one slot would be written without the loop
    spec.lit = true;
    return spec;
}

/// The program of a pass that draws directions of an environment: the whole material at each.
std::string sampledSource(const Form& form, const std::vector<TableEncoding>& encodings,
                          const ProgramSpec& spec, int glsl, const SurfaceInputs& inputs)
{
    if (inputs.instanced)
        throw Error(ErrorKind::gl, "shader",
                    Found("directions of an environment for instances").expected("lobes"));
    ProgramSpec whole = spec;
    whole.parts = wholeSpec(form, 1).parts;
    whole.lit = whole.reads = whole.clustered = false;
    const FragmentContext context{
        form, encodings, whole, glsl, false, true, inputs.normalMap, false, tintedTerms(inputs)};
    const std::string uniforms = uniformDeclarations(context);
    return assembled(glsl, inputs,
                     {"version.glsl", "surface.glsl", "frame.glsl", "angles.glsl",
                      "projection.glsl", "transfer.glsl"},
                     true) +
           filterFunctions(encodings) + lobeFunctions(spec.lobes.table) + joined({"samples.glsl"}) +
           tintFunctions(inputs) + uniforms + evaluateFunction(context) + sampledMain(context);
}

/// What both kinds of materialFunctions have in common.
std::string hostFunctions(const Form& form, const std::vector<TableEncoding>& encodings,
                          const ProgramSpec& spec, int glsl, const HostLights& lights)
{
    checkVersion(glsl);
    if (spec.hosted && glsl == kGlslEs100)
        throw Error(ErrorKind::gl, "shader",
                    Found("GLSL ES 1.00, whose loops have a constant number of steps")
                        .expected("300 or newer for lights of the host"));
    const FragmentContext context{form, encodings, spec, glsl},
        local{form, encodings, spec, glsl, false, true};
    std::string uniforms = uniformDeclarations(context);
    if (spec.hosted) uniforms += "vec3 fbrdfHostLight(int light, vec3 position, out vec3 wi);\n";
    return joined({"version.glsl", "frame.glsl", "angles.glsl", "projection.glsl", "lights.glsl",
                   "transfer.glsl"}) +
           (hasLobes(context) ? joined({"lobes.glsl"}) : "") +
           (hasAreaLights(context) ? joined({"lobe_frame.glsl", "area.glsl"}) : "") +
           filterFunctions(encodings) + uniforms + lights.lights + evaluateFunction(local) +
           radianceFunction(context);
}

}  // namespace

ProgramSpec programSpec(const Pass& pass, int maxLights)
{
    FBRDF_ASSERT(maxLights, >=, 1);
    ProgramSpec spec{pass.parts,       0,     pass.lit,  pass.reads.has_value(), pass.transfer,
                     pass.gain != 1.0, false, pass.lobes};
    // Which area lights a pass adds does not change its text.
    spec.lobes.firstArea = spec.lobes.areaCount = 0;
    spec.toSurface = pass.writes != Surface::target;
    if (pass.lightCount > 0) {
        spec.lightSlots = 1;
        while (spec.lightSlots < pass.lightCount) spec.lightSlots *= 8;
        spec.lightSlots = std::max(pass.lightCount, std::min(spec.lightSlots, maxLights));
    }
    return spec;
}

std::string vertexSource(int glsl, const SurfaceInputs& inputs)
{
    return assembled(glsl, inputs, {"version.glsl"}) + inputs.vertexHook + "\n" +
           vertexInputs(inputs) + joined({"surface.vert"});
}

std::string fragmentSource(const Form& form, const std::vector<TableEncoding>& encodings,
                           const ProgramSpec& spec, int glsl, const SurfaceInputs& inputs)
{
    if (spec.clustered || spec.areaLists) checkBuffers(glsl, "lists of lights");
    if (!spec.lobes.isEmpty() && glsl == kGlslEs100)
        throw Error(ErrorKind::gl, "shader",
                    Found("GLSL ES 1.00").expected("300 or newer for lobes"));
    if (spec.lobes.samples > 0) return sampledSource(form, encodings, spec, glsl, inputs);
    const FragmentContext context{form,
                                  encodings,
                                  spec,
                                  glsl,
                                  inputs.instanced,
                                  false,
                                  inputs.normalMap,
                                  !inputs.shadowHook.empty(),
                                  tintedTerms(inputs)};
    // Uniforms are written first because uniformDeclarations refuses what does not agree.
    const std::string uniforms = uniformDeclarations(context);
    return assembled(glsl, inputs,
                     {"version.glsl", "surface.glsl", "frame.glsl", "angles.glsl",
                      "projection.glsl", "lights.glsl", "transfer.glsl"},
                     hasLobes(context) && spec.lobes.environment) +
           (hasLobes(context) ? joined({"lobes.glsl"}) : "") +
           (hasAreaLights(context) ? joined({"lobe_frame.glsl", "area.glsl"}) : "") +
           filterFunctions(encodings) +
           (spec.clustered || spec.areaLists ? joined({"clusters.glsl"}) : "") + inputs.shadowHook +
           "\n" + tintFunctions(inputs) + uniforms + mainFunction(context);
}

std::string materialFunctions(const Form& form, const std::vector<TableEncoding>& encodings,
                              int glsl, int maxLights)
{
    FBRDF_ASSERT(maxLights, >=, 1);
    return hostFunctions(form, encodings, wholeSpec(form, maxLights), glsl, {});
}

std::string materialFunctions(const Form& form, const std::vector<TableEncoding>& encodings,
                              int glsl, const HostLights& lights)
{
    ProgramSpec spec = wholeSpec(form, 1);
    spec.hosted = true;
    spec.lobes = lights.lobes;
    return hostFunctions(form, encodings, spec, glsl, lights);
}

std::string samplingFunctions(const LobeLayout& table, int glsl)
{
    checkVersion(glsl);
    if (table.lobes < 1)
        throw Error(ErrorKind::gl, "shader",
                    Found("a material without lobes").expected("those by which it is sampled"));
    if (glsl == kGlslEs100)
        throw Error(ErrorKind::gl, "shader",
                    Found("GLSL ES 1.00, which has no index that varies")
                        .expected("300 or newer for sampling"));
    return lobeFunctions(table);
}

std::string clusterListsSource()
{
    return "#version 430\n" + joined({"cluster_geometry.glsl", "cluster_lists.comp"});
}

std::string filterProbeVertexSource(int glsl)
{
    return assembled(glsl, {}, {"version.glsl", "filter_probe.vert"});
}

std::string filterProbeFragmentSource(int glsl, ProbedTexture texture)
{
    const char* const fetches[] = {
        "sampler2D fbrdfMap;\n#define FBRDF_PROBE(at) "
        "FBRDF_TEXTURE2(fbrdfMap, at.xy)\n",
        "sampler3D fbrdfMap;\n#define FBRDF_PROBE(at) "
        "FBRDF_TEXTURE3(fbrdfMap, at)\n",
        "samplerCube fbrdfMap;\n#define FBRDF_PROBE(at) "
        "FBRDF_TEXTURE_CUBE(fbrdfMap, vec3(1.0, 1.0 - 2.0 * at.yx))\n",
        "sampler2DArray fbrdfMap;\n#define FBRDF_PROBE(at) "
        "FBRDF_TEXTURE2(fbrdfMap, vec3(at.xy, 0.0))\n"};
    return assembled(glsl, {}, {"version.glsl"}) + "uniform " +
           fetches[static_cast<size_t>(texture)] + joined({"filter_probe.frag"});
}

std::string roundingProbeFragmentSource(int glsl)
{
    return assembled(glsl, {}, {"version.glsl", "rounding_probe.frag"});
}

std::string prefilterVertexSource(int glsl)
{
    return filterProbeVertexSource(glsl);
}

std::string prefilterSourceFragment(int glsl, bool fromCube)
{
    return assembled(glsl, {}, {"version.glsl"}, true) +
           (fromCube ? "#define FBRDF_FROM_CUBE\n" : "") +
           joined({"prefilter.glsl", "prefilter_source.frag"});
}

std::string prefilterLobeFragment(int glsl)
{
    return assembled(glsl, {},
                     {"version.glsl", "prefilter.glsl", "lobe_frame.glsl", "prefilter_lobe.frag"},
                     true);
}

std::string_view shaderSnippet(std::string_view name)
{
    return embeddedShader(name);
}

// The viewer E is where the projection divides by zero: P E = (0, 0, k, 0). Towards smaller depth
// is towards the viewer, hence k < 0.
glm::dvec4 eyeFromProjection(const glm::dmat4& projection)
{
    const glm::dvec4 eye = -(glm::inverse(projection) * glm::dvec4(0.0, 0.0, 1.0, 0.0));
    return eye.w != 0.0 ? eye / eye.w : eye;
}

}  // namespace fbrdf
