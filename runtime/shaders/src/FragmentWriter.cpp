// A program for the parts 0, 1, ... of a pass reads
//     exponent<p>, product<p>     from the factors that do not depend on the light
//     sum<p> += weight product exp2(exponent<p> + ...)     for each light
//     colour = sum over p of product<p> sum<p>
// Logs are added, so a term costs one exp2 a light however many factors it has.
#include "FragmentWriter.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/plan/LightVectors.h>
#include <fbrdf/shaders/PackedParameters.h>

#include <algorithm>
#include <cstdio>
#include <set>

namespace fbrdf {
namespace {

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::gl, "shader", what);
}

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    std::string result = text;
    if (result.find_first_of(".e") == std::string::npos) result += ".0";
    return result;
}

const Factor& factorOf(const FragmentContext& c, const Part& part, int index)
{
    return c.form.terms[static_cast<size_t>(part.term)].factors[static_cast<size_t>(index)];
}

const TableSpec& tableOf(const FragmentContext& c, const Factor& factor)
{
    return c.form.tables[static_cast<size_t>(factor.table)];
}

const TableEncoding& encodingOf(const FragmentContext& c, const Factor& factor)
{
    return c.encodings[static_cast<size_t>(factor.table)];
}

template <class Visit>
void forEachFactor(const FragmentContext& c, Visit visit)
{
    for (const Part& part : c.spec.parts)
        for (const int index : part.factors) visit(factorOf(c, part, index));
}

bool needsLocalFrame(const FragmentContext& c)
{
    bool needed = c.local;
    forEachFactor(c, [&needed](const Factor& factor) {
        needed = needed || std::holds_alternative<Direction>(factor.argument);
    });
    return needed;
}

bool dependsOnLight(const FragmentContext& c)
{
    bool depends = c.spec.lit;
    forEachFactor(c, [&depends](const Factor& factor) {
        depends = depends || fbrdf::dependsOnLight(factor);
    });
    return depends;
}

/// Names of the variables that arguments use: "theta_h", "h", ...
std::set<std::string> variablesUsed(const FragmentContext& c)
{
    std::set<std::string> names;
    forEachFactor(c, [&names](const Factor& factor) {
        if (const auto* direction = std::get_if<Direction>(&factor.argument))
            names.insert(directionName(*direction));
        else
            for (const Angle angle : std::get<std::vector<Angle>>(factor.argument))
                names.insert(angleName(angle));
    });
    if (names.count("theta_h") || names.count("phi_d") || names.count("d")) names.insert("h");
    return names;
}

/// The vector that a direction names, as an expression.
std::string directionExpression(const Direction& direction)
{
    switch (direction.kind) {
        case Direction::Kind::mirror: return "vec3(-wo.xy, wo.z)";
        case Direction::Kind::difference: return "d";
        case Direction::Kind::combination: break;
    }
    const std::string name = directionName(direction);
    if (name == "wi" || name == "wo" || name == "h") return name;
    return "fbrdfCombination(vec3(" + number(direction.weight_wi) + ", " +
           number(direction.weight_wo) + ", " + number(direction.weight_n) + "), " +
           (direction.weight_wi != 0.0 ? "wi" : "vec3(0.0)") + ", wo)";
}

std::string axisCall(const AxisMap& map, Angle angle)
{
    const std::string name = angleName(angle);
    return std::string("fbrdfAxis(") + (map.from == AxisMap::From::cosine ? "true, " : "false, ") +
           number(map.exponent) + ", " + name + ".x, " + name + ".y)";
}

/// (position + 1/2) / size along one axis.
std::string axisCoordinate(const Axis& axis, Angle angle)
{
    return axisCall(axis.map, angle) + " * " + number((axis.size - 1.0) / axis.size) + " + " +
           number(0.5 / axis.size);
}

/// The variable that holds an axis over theta_o: the same for all lights, so it is computed once.
std::string viewAxisName(const Factor& factor, size_t axis)
{
    return "theta_o" + std::to_string(factor.table) + "_" + std::to_string(axis);
}

/// Declares the axes over theta_o of the factors that also depend on the light.
std::string viewAxisLines(const FragmentContext& c)
{
    std::set<std::string> lines;
    forEachFactor(c, [&](const Factor& factor) {
        const auto* grid = std::get_if<GridDomain>(&tableOf(c, factor).domain);
        if (!grid || tableOf(c, factor).uniform || !fbrdf::dependsOnLight(factor)) return;
        const auto& angles = std::get<std::vector<Angle>>(factor.argument);
        for (size_t i = 0; i < angles.size(); ++i)
            if (angles[i] == Angle::theta_o)
                lines.insert("    float " + viewAxisName(factor, i) + " = " +
                             axisCoordinate(grid->axes[i], angles[i]) + ";\n");
    });
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

/// Texture coordinate of a factor: (position + 1/2) / size.
std::string coordinate(const FragmentContext& c, const Factor& factor)
{
    const TableSpec& table = tableOf(c, factor);
    if (const auto* disc = std::get_if<DiscDomain>(&table.domain)) {
        const double size = disc->size;
        return "(fbrdfDisc(" + number(size) + ", " + number(disc->gamma) + ", " +
               number(disc->radius) + ", " +
               directionExpression(std::get<Direction>(factor.argument)) + ") + 0.5) * " +
               number(1.0 / size);
    }
    const auto& axes = std::get<GridDomain>(table.domain).axes;
    const auto& angles = std::get<std::vector<Angle>>(factor.argument);
    std::string text = axes.size() == 3 ? "vec3(" : "vec2(";
    for (size_t i = 0; i < axes.size(); ++i) {
        const bool ofView = angles[i] == Angle::theta_o && fbrdf::dependsOnLight(factor);
        text += (i ? ", " : "") +
                (ofView ? viewAxisName(factor, i) : axisCoordinate(axes[i], angles[i]));
    }
    return text + (axes.size() == 1 ? ", 0.5)" : ")");
}

std::string textureFetch(const FragmentContext& c, const Factor& factor)
{
    const bool volume = domainSize(tableOf(c, factor).domain)[2] > 1;
    const auto* grid = std::get_if<GridDomain>(&tableOf(c, factor).domain);
    const bool three = volume || (grid && grid->axes.size() == 3);
    const std::string at = coordinate(c, factor);
    return std::string(three ? "FBRDF_TEXTURE3" : "FBRDF_TEXTURE2") + "(fbrdfTable" +
           std::to_string(factor.table) + ", " +
           (c.packed ? "vec3(" + at + ", float(fbrdfMaterial))" : at) + ").rgb";
}

std::string parameter(int index)
{
    return "texelFetch(fbrdfParameters, fbrdfFirst + " + std::to_string(index) + ").rgb";
}

/// Knot `index`, an expression, of a uniform table.
std::string knot(const FragmentContext& c, int table, const std::string& index)
{
    if (!c.packed) return "fbrdfKnots" + std::to_string(table) + "[" + index + "]";
    const int first = parameterLayout(c.form).tables[static_cast<size_t>(table)];
    return "texelFetch(fbrdfParameters, fbrdfFirst + " + std::to_string(first) + " + " + index +
           ").rgb";
}

/// Declares what uniforms hold in a program of one material.
std::string parameterLines(const FragmentContext& c)
{
    if (!c.packed) return "";
    const ParameterLayout layout = parameterLayout(c.form);
    std::set<std::string> lines;
    forEachFactor(c, [&](const Factor& factor) {
        if (tableOf(c, factor).uniform || !encodingOf(c, factor).ranged) return;
        const std::string k = std::to_string(factor.table);
        const int first = layout.tables[static_cast<size_t>(factor.table)];
        lines.insert("    vec3 fbrdfLower" + k + " = " + parameter(first) + ", fbrdfExtent" + k +
                     " = " + parameter(first + 1) + ";\n");
    });
    for (const Part& part : c.spec.parts)
        if (part.scaled)
            lines.insert("    vec3 fbrdfScale" + std::to_string(part.term) + " = " +
                         parameter(layout.scales + part.term) + ";\n");
    std::string text =
        "    int fbrdfFirst = fbrdfMaterial * " + std::to_string(layout.stride) + ";\n";
    for (const std::string& line : lines) text += line;
    return text;
}

/// Linear interpolation between knots of a uniform array.
std::string knotsLines(const FragmentContext& c, const Factor& factor, const std::string& target,
                       const std::string& operation)
{
    const Axis& axis = std::get<GridDomain>(tableOf(c, factor).domain).axes[0];
    if (axis.size == 1) return target + operation + knot(c, factor.table, "0") + ";\n";
    const Angle angle = std::get<std::vector<Angle>>(factor.argument)[0];
    return "{ float x = " + axisCall(axis.map, angle) + " * " + number(axis.size - 1.0) +
           "; int k = int(min(x, " + number(axis.size - 2.0) + ")); " + target + operation +
           "mix(" + knot(c, factor.table, "k") + ", " + knot(c, factor.table, "k + 1") +
           ", x - float(k)); }\n";
}

/// One statement: the factor's value into `exponent` or `product`, both with the suffix.
std::string factorLines(const FragmentContext& c, const Factor& factor, const std::string& suffix,
                        const std::string& indent)
{
    const TableEncoding& encoding = encodingOf(c, factor);
    const std::string target = (encoding.logarithmic ? "exponent" : "product") + suffix,
                      operation = encoding.logarithmic ? " += " : " *= ",
                      k = std::to_string(factor.table);
    if (tableOf(c, factor).uniform) return indent + knotsLines(c, factor, target, operation);
    std::string value = textureFetch(c, factor);
    if (encoding.ranged && encoding.logarithmic)
        value = "fbrdfExtent" + k + " * " + value;  // the lower end is in `lowers`
    else if (encoding.ranged)
        value = "fbrdfLower" + k + " + fbrdfExtent" + k + " * " + value;
    return indent + target + operation + value + ";\n";
}

/// Lower ends of all ranged logs of a part: they do not depend on the light even where the texel
/// does.
std::string lowers(const FragmentContext& c, const Part& part)
{
    std::string text;
    for (const int index : part.factors) {
        const Factor& factor = factorOf(c, part, index);
        const TableEncoding& encoding = encodingOf(c, factor);
        if (encoding.ranged && encoding.logarithmic && !tableOf(c, factor).uniform)
            text += (text.empty() ? "" : " + ") + ("fbrdfLower" + std::to_string(factor.table));
    }
    return text.empty() ? "vec3(0.0)" : text;
}

std::string factorsOf(const FragmentContext& c, const Part& part, bool ofLight,
                      const std::string& suffix, const std::string& indent)
{
    std::string text;
    for (const int index : part.factors) {
        const Factor& factor = factorOf(c, part, index);
        if (fbrdf::dependsOnLight(factor) == ofLight)
            text += factorLines(c, factor, suffix, indent);
    }
    return text;
}

std::string surfaceLines(const FragmentContext& c)
{
    return needsLocalFrame(c) ? "    FbrdfFrame frame = fbrdfFrame(fbrdfNormal, fbrdfTangent);\n"
                                "    vec3 wo = fbrdfLocal(frame, viewer);\n"
                                "    float NoV = wo.z;\n"
                              : "    vec3 n = normalize(fbrdfNormal);\n"
                                "    vec3 wo = viewer;\n"
                                "    float NoV = dot(n, wo);\n";
}

/// What does not depend on the light, from wo.
std::string viewLines(const FragmentContext& c)
{
    std::string text;
    if (variablesUsed(c).count("theta_o"))
        text += needsLocalFrame(c) ? "    vec2 theta_o = fbrdfZenith(wo);\n"
                                   : "    vec2 theta_o = fbrdfZenithAbout(n, wo);\n";
    text += viewAxisLines(c);
    for (size_t p = 0; p < c.spec.parts.size(); ++p) {
        const Part& part = c.spec.parts[p];
        const std::string k = std::to_string(p);
        text += "    vec3 exponent" + k + " = " + lowers(c, part) + ";\n    vec3 product" + k +
                " = " + (part.scaled ? "fbrdfScale" + std::to_string(part.term) : "vec3(1.0)") +
                ";\n" + factorsOf(c, part, false, k, "    ");
    }
    return text;
}

/// Directions and angles of the pair, from wo and wi.
std::string pairLines(const FragmentContext& c, const std::string& indent)
{
    const bool local = needsLocalFrame(c);
    const auto used = variablesUsed(c);
    std::string text;
    if (used.count("h")) text += indent + "vec3 h = fbrdfHalf(wo, wi);\n";
    const std::string zenith = local ? "fbrdfZenith(" : "fbrdfZenithAbout(n, ";
    if (used.count("theta_h")) text += indent + "vec2 theta_h = " + zenith + "h);\n";
    if (used.count("theta_i")) text += indent + "vec2 theta_i = " + zenith + "wi);\n";
    if (used.count("theta_d")) text += indent + "vec2 theta_d = fbrdfDifference(wo, wi);\n";
    if (used.count("phi_d"))
        text += indent + "vec2 phi_d = fbrdfDifferenceAzimuth(" +
                (local ? "vec3(0.0, 0.0, 1.0)" : "n") + ", h, wi, NoV, NoL);\n";
    if (used.count("d")) text += indent + "vec3 d = fbrdfDifferenceVector(wi, h);\n";
    return text;
}

/// Direction and angles of the light whose first vector is `index`.
std::string lightLines(const FragmentContext& c, const std::string& index,
                       const std::string& indent)
{
    const bool local = needsLocalFrame(c);
    std::string text = indent + "vec3 wi;\n" + indent + "vec3 irradiance = fbrdfIrradiance(";
    for (const char* const k : {"", " + 1", " + 2"})
        text += (c.spec.clustered ? "texelFetch(fbrdfLightBuffer, " + index + k + "), "
                                  : "fbrdfLights[" + index + k + "], ");
    text += "fbrdfPosition, wi);\n";
    if (local) text += indent + "wi = fbrdfLocal(frame, wi);\n";
    return text + indent + (local ? "float NoL = wi.z;\n" : "float NoL = dot(n, wi);\n") +
           pairLines(c, indent);
}

/// sum<p> of one light, above the horizon only.
std::string litLines(const FragmentContext& c, const std::string& indent)
{
    const std::string inner = indent + "    ";
    std::string text = indent + "if (NoL > 0.0) {\n" + inner + "vec3 weight = irradiance * NoL;\n";
    for (size_t p = 0; p < c.spec.parts.size(); ++p) {
        const std::string k = std::to_string(p);
        text += inner + "{\n" + inner + "    vec3 exponent = exponent" + k + ";\n" + inner +
                "    vec3 product = weight;\n" +
                factorsOf(c, c.spec.parts[p], true, "", inner + "    ") + inner + "    sum" + k +
                " += product * exp2(exponent);\n" + inner + "}\n";
    }
    return text + indent + "}\n";
}

/// Lights that reach everywhere, then those of the fragment's list.
std::string clusteredLoop(const FragmentContext& c)
{
    return "    ivec2 list = fbrdfLightList(gl_FragCoord.xy, -fbrdfPosition.z);\n"
           "    for (int i = 0; i < fbrdfLightCount + list.y; ++i) {\n"
           "        int light = " +
           std::to_string(kVectorsPerLight) +
           " * (i < fbrdfLightCount ? i\n"
           "            : texelFetch(fbrdfLightIndices, list.x + i - fbrdfLightCount).r);\n" +
           lightLines(c, "light", "        ") + litLines(c, "        ") + "    }\n";
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
        text += lightLines(c, "0", "    ") + litLines(c, "    ");
    else
        text += "    for (int i = 0; i < fbrdfLightCount; ++i) {\n" +
                lightLines(c, std::to_string(kVectorsPerLight) + " * i", "        ") +
                litLines(c, "        ") + "    }\n";
    return text + "    vec3 total = NoV > 0.0 ? " + total + " : vec3(0.0);\n";
}

/// total: the product without light, from the angles of the pair.
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
    return (dependsOnLight(c) ? lightLines(c, "0", "    ") : "") + productLines(c);
}

void check(const FragmentContext& c)
{
    if (c.encodings.size() != c.form.tables.size())
        fail(std::to_string(c.encodings.size()) + " encodings, expected one for each of " +
             std::to_string(c.form.tables.size()) + " tables");
    if (dependsOnLight(c) && c.spec.lightSlots < 1)
        fail("factors that depend on the light in a program without lights");
}

}  // namespace

std::string uniformDeclarations(const FragmentContext& c)
{
    check(c);
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
        const bool three = dimensionCount(table.domain) == 3;
        lines.insert(std::string("uniform ") +
                     (three      ? "sampler3D"
                      : c.packed ? "sampler2DArray"
                                 : "sampler2D") +
                     " fbrdfTable" + k + ";\n");
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
    if (dependsOnLight(c) && !c.spec.clustered)
        lines.insert("uniform vec4 fbrdfLights[" +
                     std::to_string(kVectorsPerLight * c.spec.lightSlots) + "];\n");
    if (c.spec.lit && (c.spec.clustered || c.spec.lightSlots > 1))
        lines.insert("uniform int fbrdfLightCount;\n");
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

std::string mainFunction(const FragmentContext& c)
{
    std::string text = "void main()\n{\n";
    if (!c.spec.parts.empty())
        text += "    vec3 viewer = fbrdfToViewer();\n" + parameterLines(c) + surfaceLines(c) +
                viewLines(c);
    text += c.spec.lit && !c.spec.parts.empty() ? litBody(c) : unlitBody(c);
    if (c.spec.reads)
        text += "    total *= FBRDF_TEXTURE2(fbrdfRead, gl_FragCoord.xy * fbrdfReadScale).rgb;\n";
    if (c.spec.transfer == Transfer::toneMap) text += "    total = fbrdfToneMapped(total);\n";
    if (isCurved(c.spec.transfer))
        text += "    total = fbrdfSrgbFromLinear(min(total, vec3(1.0)));\n";
    return text + "    fbrdfColour = vec4(total, 1.0);\n}\n";
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
    return "vec3 fbrdfRadiance(vec3 fbrdfPosition, vec3 fbrdfNormal, vec3 fbrdfTangent, vec3 "
           "viewer)\n{\n" +
           surfaceLines(c) + viewLines(c) + litBody(c) + "    return total;\n}\n";
}

}  // namespace fbrdf
