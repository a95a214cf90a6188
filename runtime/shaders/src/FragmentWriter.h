// FragmentWriter.h - writes the uniforms and main() of a fragment shader from a form.
#pragma once
#include <fbrdf/shaders/ShaderSource.h>

#include <string>

namespace fbrdf {

constexpr int kGlslEs100 = 100, kGlslEs300 = 300;

struct FragmentContext {
    const Form& form;
    const std::vector<TableEncoding>& encodings;
    const ProgramSpec& spec;
    int glsl;
    bool packed = false;  ///< maps are in arrays, the rest in a buffer (PackedParameters.h)
    bool local = false;   ///< directions are given in the tangent frame even if the form needs none
    bool normalMap = false, shadow = false;    ///< see SurfaceInputs
    const std::vector<int>* tinted = nullptr;  ///< terms with a tint; null: there is no tint hook
};

/// True where the tint hook multiplies the term; with -1: every term.
bool isTinted(const FragmentContext& context, int term);
/// The beginning of main(): the tint, once for all terms.
std::string tintLines(const FragmentContext& context);

std::string uniformDeclarations(const FragmentContext& context);
/// Statements that declare frame (or n), wo and NoV of the fragment, from viewer.
std::string surfaceLines(const FragmentContext& context);
/// The end of main(): what becomes of total.
std::string outputLines(const FragmentContext& context);
std::string mainFunction(const FragmentContext& context);
/// vec3 fbrdfEvaluate(vec3 wo, vec3 wi). Expects context.local.
std::string evaluateFunction(const FragmentContext& context);
/// vec3 fbrdfRadiance(vec3 position, vec3 normal, vec4 tangent, vec3 viewer). Expects a lit pass.
std::string radianceFunction(const FragmentContext& context);

}  // namespace fbrdf
