// A program for the parts 0, 1, ... of a pass reads
//     exponent<p>, product<p>     from the factors that do not depend on the light
//     sum<p> += weight product exp2(exponent<p> + ...)     for each light
//     colour = sum over p of product<p> sum<p>
// Logs are added, so a term costs one exp2 per light however many factors it has.
#include "FactorWriter.h"
#include "LobeWriter.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/plan/LightVectors.h>

#include <algorithm>
#include <set>

namespace fbrdf {
namespace {

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::gl, "shader", what);
}

/// How a program computes an angle or a vector of the pair.
struct Variable {
    const char *type, *name;
    const char* local;    ///< from wo, wi, h in the tangent frame
    const char* general;  ///< from wo, wi, h and the normal n in any frame
};

/// Those that depend on wo alone, and those that the light changes; later ones may use earlier
/// ones.
constexpr Variable kViewVariables[] = {
    {"vec2", "theta_o", "fbrdfZenith(wo)", "fbrdfZenithAbout(n, wo)"},
};
constexpr Variable kPairVariables[] = {
    {"vec3", "both", "wi + wo", "wi + wo"},
    {"vec2", "size", "fbrdfSizeOf(both)", "fbrdfSizeOf(both)"},
    {"vec3", "h", "fbrdfHalfVector(wo, wi)", "fbrdfHalfVector(wo, wi)"},
    {"vec2", "theta_h", "fbrdfHalfZenith(both.z, vec3(both.xy, 0.0), size)",
     "fbrdfHalfZenith(NoV + NoL, cross(n, both), size)"},
    {"vec2", "theta_i", "fbrdfZenith(wi)", "fbrdfZenithAbout(n, wi)"},
    {"vec2", "theta_d", "fbrdfDifferenceAngle(wo, wi, size.x)",
     "fbrdfDifferenceAngle(wo, wi, size.x)"},
    {"float", "side", "wo.x * wi.y - wo.y * wi.x", "dot(acrossView, wi)"},
    {"float", "lean", "0.5 * size.x * (NoV - NoL)", "0.5 * size.x * (NoV - NoL)"},
    {"vec2", "phi_d", "fbrdfDifferenceAzimuth(side, lean)", "fbrdfDifferenceAzimuth(side, lean)"},
    {"vec2", "half_phi_d", "fbrdfHalfDifferenceAzimuth(side, lean)",
     "fbrdfHalfDifferenceAzimuth(side, lean)"},
    {"vec2", "side_phi_d", "fbrdfSideDifferenceAzimuth(side, lean)",
     "fbrdfSideDifferenceAzimuth(side, lean)"},
    {"vec3", "d", "fbrdfDifferenceVector(h, wi)", "fbrdfDifferenceVector(h, wi)"},
};

/// Declares those of the variables that the factors use.
template <size_t Count>
std::string variableLines(const FragmentContext& c, const Variable (&variables)[Count],
                          const std::string& indent)
{
    const bool local = needsLocalFrame(c);
    const auto used = variablesUsed(c);
    std::string text;
    for (const Variable& v : variables)
        if (used.count(v.name))
            text += indent + v.type + " " + v.name + " = " + (local ? v.local : v.general) + ";\n";
    return text;
}

/// Declares what does not depend on the light, from wo.
std::string viewLines(const FragmentContext& c)
{
    std::string text = variableLines(c, kViewVariables, "    ");
    if (variablesUsed(c).count("side") && !needsLocalFrame(c))
        text += "    vec3 acrossView = cross(n, wo);\n";
    text += viewAxisLines(c);
    for (size_t p = 0; p < c.spec.parts.size(); ++p) {
        const Part& part = c.spec.parts[p];
        const std::string k = std::to_string(p);
        text += "    vec3 exponent" + k + " = " + lowers(c, part) + ";\n    vec3 product" + k +
                " = " + (part.scaled ? "fbrdfScale" + std::to_string(part.term) : "vec3(1.0)") +
                (part.scaled && isTinted(c, part.term) ? " * fbrdfTinted.rgb" : "") + ";\n" +
                factorsOf(c, part, false, k, "    ");
    }
    return text;
}

/// Declares directions and angles of the pair, from wo and wi.
std::string pairLines(const FragmentContext& c, const std::string& indent)
{
    return variableLines(c, kPairVariables, indent);
}

/// One of the vectors of lights. index: the expression for its number.
std::string lightVector(const FragmentContext& c, const std::string& index)
{
    return c.spec.clustered ? "texelFetch(fbrdfLightBuffer, " + index + ")"
                            : "fbrdfLights[" + index + "]";
}

std::string vectorIndex(const std::string& light)
{
    return light == "0" ? light : std::to_string(kVectorsPerLight) + " * " + light;
}

/// Declares the direction to a light and what its strength is computed from. light: the expression
/// for its index; in a clustered loop `position` is known.
std::string lightLines(const FragmentContext& c, const std::string& light,
                       const std::string& indent)
{
    const bool local = needsLocalFrame(c);
    // In eye space; directions in the tangent frame leave it to those who need it.
    const std::string to = local || c.shadow ? "toLight" : "wi", index = vectorIndex(light);
    std::string text;
    if (c.spec.hosted) {
        text = indent + "vec3 " + to + ";\n" + indent + "vec3 irradiance = fbrdfHostLight(" +
               light + ", fbrdfPosition, " + to + ");\n";
    } else {
        text = indent + "vec4 " +
               (c.spec.clustered ? "" : "position = " + lightVector(c, index) + ", ") +
               "intensity = " + lightVector(c, index + " + 1") + ";\n" + indent +
               "vec2 squares;\n" + indent + "vec3 " + to +
               " = fbrdfToLight(position, intensity.w, fbrdfPosition, squares);\n";
    }
    if (local) text += indent + "vec3 wi = fbrdfLocal(frame, toLight);\n";
    if (!local && c.shadow) text += indent + "vec3 wi = toLight;\n";
    return text + indent + (local ? "float NoL = wi.z;\n" : "float NoL = dot(n, wi);\n");
}

/// The factor by which the host's shadow hook dims a light.
std::string shadowFactor(const FragmentContext& c, const std::string& light)
{
    if (!c.shadow) return "";
    const std::string number = c.spec.clustered ? "texelFetch(fbrdfLightNumbers, " + light + ").r"
                                                : "fbrdfLightNumbers[" + light + "]";
    return " * fbrdfShadow(" + number + ", fbrdfPosition, toLight)";
}

/// The irradiance of a light on the surface.
std::string weightOf(const FragmentContext& c, const std::string& light)
{
    if (c.spec.hosted) return "irradiance * NoL";
    const std::string to = needsLocalFrame(c) || c.shadow ? "toLight" : "wi";
    return "intensity.rgb * (NoL * fbrdfFalloff(squares, position.w) * fbrdfConeFactor(" +
           lightVector(c, vectorIndex(light) + " + 2") + ", " + to + "))";
}

/// Adds one light to sum<p>, if it is above the horizon. All that only such a light needs is
/// computed behind the question: a GPU skips it where it is below for a whole group of pixels.
std::string litLines(const FragmentContext& c, const std::string& light, const std::string& indent)
{
    const std::string inner = indent + "    ";
    std::string text = indent + "if (NoL > 0.0) {\n" + inner +
                       "vec3 weight = " + weightOf(c, light) + shadowFactor(c, light) + ";\n" +
                       pairLines(c, inner);
    for (size_t p = 0; p < c.spec.parts.size(); ++p) {
        const std::string k = std::to_string(p);
        text += inner + "{\n" + inner + "    vec3 exponent = exponent" + k + ";\n" + inner +
                "    vec3 product = weight;\n" +
                factorsOf(c, c.spec.parts[p], true, "", inner + "    ") + inner + "    sum" + k +
                " += product * exp2(exponent);\n" + inner + "}\n";
    }
    return text + indent + "}\n";
}

/// A loop over the lights that reach everywhere and those of the fragment's list. Each fragment
/// skips to its own next light that reaches it, so that neighbours that run in step shade at the
/// same time.
std::string clusteredLoop(const FragmentContext& c)
{
    return "    ivec2 list = fbrdfLightList(fbrdfLightLists, fbrdfClusterGrid, fbrdfClusterScale, "
           "gl_FragCoord.xy, -fbrdfPosition.z);\n"
           "    int end = fbrdfLightCount + list.y;\n"
           "    for (int i = 0; i < end; ++i) {\n"
           "        int light = fbrdfListed(fbrdfLightIndices, list, fbrdfLightCount, i);\n"
           "        vec4 position = texelFetch(fbrdfLightBuffer, 3 * light);\n"
           "        while (i + 1 < end && !fbrdfReaches(position, fbrdfPosition)) {\n"
           "            light = fbrdfListed(fbrdfLightIndices, list, fbrdfLightCount, ++i);\n"
           "            position = texelFetch(fbrdfLightBuffer, 3 * light);\n"
           "        }\n" +
           lightLines(c, "light", "        ") + litLines(c, "light", "        ") + "    }\n";
}

/// The head of the loop over lights. GLSL ES 1.00 needs a constant number of iterations
/// (Appendix A of its specification).
std::string lightLoop(const FragmentContext& c)
{
    if (c.glsl != kGlslEs100) return "    for (int i = 0; i < fbrdfLightCount; ++i) {\n";
    return "    for (int i = 0; i < " + std::to_string(c.spec.lightSlots) +
           "; ++i) {\n        if (i >= fbrdfLightCount) break;\n";
}

std::string litBody(const FragmentContext& c)
{
    std::string text, total;
    for (size_t p = 0; p < c.spec.parts.size(); ++p) {
        const std::string k = std::to_string(p);
        text += "    vec3 sum" + k + " = vec3(0.0);\n";
        total += (p ? " + product" : "product") + k + " * sum" + k;
    }
    if (c.spec.clustered)
        text += clusteredLoop(c);
    else if (c.spec.lightSlots == 1)
        text += lightLines(c, "0", "    ") + litLines(c, "0", "    ");
    else
        text += lightLoop(c) + lightLines(c, "i", "        ") + litLines(c, "i", "        ") +
                "    }\n";
    return text + "    vec3 total = NoV > 0.0 ? " + total + " : vec3(0.0);\n";
}

/// Declares total: the product without light, from the angles of the pair.
std::string productLines(const FragmentContext& c)
{
    std::string text, total;
    for (size_t p = 0; p < c.spec.parts.size(); ++p) {
        const std::string k = std::to_string(p);
        text += factorsOf(c, c.spec.parts[p], true, k, "    ");
        total += (p ? " + product" : "product") + k + " * exp2(exponent" + k + ")";
    }
    return text + "    vec3 total = " + (total.empty() ? "vec3(0.0)" : total) + ";\n";
}

std::string unlitBody(const FragmentContext& c)
{
    return (dependsOnLight(c) ? lightLines(c, "0", "    ") + pairLines(c, "    ") : "") +
           productLines(c);
}

void check(const FragmentContext& c)
{
    if (c.encodings.size() != c.form.tables.size())
        fail(Found(std::to_string(c.encodings.size()) + " encodings")
                 .expected("one for each of " + std::to_string(c.form.tables.size()) + " tables"));
    if (dependsOnLight(c) && c.spec.lightSlots < 1 && c.spec.lobes.samples == 0)
        fail(Found("factors that depend on the light in a program without lights")
                 .expected("light slots"));
}

void checkEs100(const FragmentContext& c)
{
    forEachFactor(c, [&](const Factor& factor) {
        const TableSpec& table = tableOf(c, factor);
        if (table.uniform && texelCount(table.domain) > 1)
            fail("table '" + table.name + "': " +
                 Found("knots in uniforms")
                     .expected("a texture: GLSL ES 1.00 has no index that varies"));
        if (dimensionCount(table.domain) == 3)
            fail("table '" + table.name +
                 "': " + Found("three dimensions").expected("two: GLSL ES 1.00 has no volumes"));
    });
}

std::string samplerType(const FragmentContext& c, const Factor& factor)
{
    if (encodingOf(c, factor).lookUp == LookUp::cube) return "samplerCube";
    if (dimensionCount(tableOf(c, factor).domain) == 3) return "sampler3D";
    return c.packed ? "sampler2DArray" : "sampler2D";
}

}  // namespace

bool isTinted(const FragmentContext& c, int term)
{
    const auto has = [&c](int t) {
        return c.tinted && std::find(c.tinted->begin(), c.tinted->end(), t) != c.tinted->end();
    };
    if (term >= 0) return has(term);
    for (int t = 0; t < static_cast<int>(c.form.terms.size()); ++t)
        if (!has(t)) return false;
    return true;
}

std::string tintLines(const FragmentContext& c)
{
    return c.tinted ? "    fbrdfTinted = fbrdfTint();\n" : "";
}

std::string surfaceLines(const FragmentContext& c)
{
    const bool local = needsLocalFrame(c);
    std::string text;
    if (local || c.normalMap)
        text += "    FbrdfShadingFrame frame = fbrdfShadingFrame(fbrdfNormal, fbrdfTangent);\n";
    if (c.normalMap)
        text +=
            "    frame = fbrdfPerturbed(frame, 2.0 * FBRDF_TEXTURE_MIPMAPPED(fbrdfNormalMap, "
            "fbrdfTextureCoordinate).xyz - 1.0);\n";
    if (local) return text + "    vec3 wo = fbrdfLocal(frame, viewer);\n    float NoV = wo.z;\n";
    return text + "    vec3 n = " + (c.normalMap ? "frame.n" : "normalize(fbrdfNormal)") +
           ";\n    vec3 wo = viewer;\n    float NoV = dot(n, wo);\n";
}

std::string uniformDeclarations(const FragmentContext& c)
{
    check(c);
    if (c.glsl == kGlslEs100) checkEs100(c);
    std::set<std::string> lines;
    forEachFactor(c, [&](const Factor& factor) {
        const TableSpec& table = tableOf(c, factor);
        const std::string k = std::to_string(factor.table);
        if (table.uniform) {
            if (c.packed) return;
            lines.insert("uniform vec3 fbrdfKnots" + k + "[" +
                         std::to_string(texelCount(table.domain)) + "];\n");
            return;
        }
        lines.insert("uniform " + samplerType(c, factor) + " fbrdfTable" + k + ";\n");
        if (encodingOf(c, factor).ranged && !c.packed)
            lines.insert("uniform vec3 fbrdfLower" + k + ", fbrdfExtent" + k + ";\n");
    });
    for (const Part& part : c.spec.parts)
        if (part.scaled && !c.packed)
            lines.insert("uniform vec3 fbrdfScale" + std::to_string(part.term) + ";\n");
    if (c.packed) lines.insert("uniform samplerBuffer fbrdfParameters;\n");
    if (c.spec.reads) {
        lines.insert("uniform sampler2D fbrdfRead;\n");
        lines.insert("uniform vec2 fbrdfReadScale;\n");
    }
    if (c.spec.gained) lines.insert("uniform float fbrdfGain;\n");
    if (dependsOnLight(c) && !c.spec.clustered && !c.spec.hosted && c.spec.lobes.samples == 0)
        lines.insert("uniform vec4 fbrdfLights[" +
                     std::to_string(kVectorsPerLight * c.spec.lightSlots) + "];\n");
    if (c.shadow && c.spec.lit && !c.spec.parts.empty())
        lines.insert(c.spec.clustered ? "uniform isamplerBuffer fbrdfLightNumbers;\n"
                                      : "uniform int fbrdfLightNumbers[" +
                                            std::to_string(c.spec.lightSlots) + "];\n");
    if (c.spec.lit && (c.spec.clustered || c.spec.lightSlots > 1))
        lines.insert("uniform int fbrdfLightCount;\n");
    if (c.spec.clustered)
        lines.insert(
            "uniform samplerBuffer fbrdfLightBuffer;\n"
            "uniform isamplerBuffer fbrdfLightIndices, fbrdfLightLists;\n"
            "uniform ivec3 fbrdfClusterGrid;\nuniform vec4 fbrdfClusterScale;\n");
    std::string text;
    for (const std::string& line : lines) text += line;
    return text + lobeUniforms(c);
}

std::string outputLines(const FragmentContext& c)
{
    std::string text;
    if (c.spec.gained) text += "    total *= fbrdfGain;\n";
    if (c.spec.transfer == Transfer::toneMap) text += "    total = fbrdfToneMapped(total);\n";
    if (isCurved(c.spec.transfer))
        text += "    total = fbrdfSrgbFromLinear(min(total, vec3(1.0)));\n";
    return text + "    fbrdfColour = vec4(total, " +
           (c.tinted && !c.spec.toSurface ? "fbrdfTinted.a" : "1.0") + ");\n}\n";
}

/// Below a thousandth no sample was drawn to, as there are fewer.
std::string readLines(const FragmentContext& c)
{
    const std::string texel = "FBRDF_TEXTURE2(fbrdfRead, gl_FragCoord.xy * fbrdfReadScale)";
    if (!c.spec.resolved) return "    total *= " + texel + ".rgb;\n";
    return "    vec4 read = " + texel + ";\n    total *= read.rgb / max(read.a, 0.001);\n";
}

std::string mainFunction(const FragmentContext& c)
{
    std::string text = "void main()\n{\n" + tintLines(c);
    if (!c.spec.parts.empty() || hasLobes(c))
        text += "    vec3 viewer = fbrdfToViewer();\n" + parameterLines(c) + surfaceLines(c) +
                viewLines(c);
    text += c.spec.lit && !c.spec.parts.empty() ? litBody(c) : unlitBody(c);
    if (c.spec.reads) text += readLines(c);
    text += lobeLines(c);
    return text + outputLines(c);
}

std::string evaluateFunction(const FragmentContext& c)
{
    return "vec3 fbrdfEvaluate(vec3 wo, vec3 wi)\n{\n    float NoV = wo.z;\n    float NoL = "
           "wi.z;\n" +
           viewLines(c) + pairLines(c, "    ") + productLines(c) +
           "    return NoV > 0.0 && NoL > 0.0 ? total : vec3(0.0);\n}\n";
}

std::string radianceFunction(const FragmentContext& c)
{
    return "vec3 fbrdfRadiance(vec3 fbrdfPosition, vec3 fbrdfNormal, vec4 fbrdfTangent, vec3 "
           "viewer)\n{\n" +
           surfaceLines(c) + viewLines(c) + litBody(c) + lobeLines(c) +
           "    return total;\n}\n"
           "vec3 fbrdfRadiance(vec3 position, vec3 normal, vec3 tangent, vec3 viewer)\n{\n"
           "    return fbrdfRadiance(position, normal, vec4(tangent, 1.0), viewer);\n}\n";
}

}  // namespace fbrdf
