#include "FactorWriter.h"

#include "LobeWriter.h"

#include <fbrdf/base/Number.h>

#include <fbrdf/shaders/PackedParameters.h>

#include <algorithm>
#include <array>

namespace fbrdf {
namespace {

std::string number(double value)
{
    std::string result = numberText(value, 9);
    if (result.find_first_of(".e") == std::string::npos) result += ".0";
    return result;
}

/// The GLSL expression of the vector that a direction names.
std::string directionExpression(const Direction& direction)
{
    switch (direction.kind) {
        case Direction::Kind::mirror: return "vec3(-wo.xy, wo.z)";
        case Direction::Kind::difference: return "d";
        case Direction::Kind::combination: break;
    }
    const std::string name = directionName(direction);
    if (name == "wi" || name == "wo" || name == "h") return name;
    return "fbrdfCombination(vec3(" + number(direction.weight_wo) + ", " +
           number(direction.weight_wi) + ", " + number(direction.weight_n) + "), wo, " +
           (direction.weight_wi != 0.0 ? "wi" : "vec3(0.0)") + ")";
}

std::string axisCall(const AxisMap& map, Angle angle)
{
    const std::string name = angleName(angle);
    return std::string("fbrdfAxisCoordinate(") +
           (map.from == AxisMap::From::cosine ? "true, " : "false, ") + number(map.exponent) +
           ", " + name + ".x, " + name + ".y)";
}

/// The texture coordinate along one axis: (position + 1/2) / size; or the position, in texels.
std::string axisCoordinate(const Axis& axis, Angle angle, bool precise)
{
    if (precise) return axisCall(axis.map, angle) + " * " + number(axis.size - 1.0);
    return axisCall(axis.map, angle) + " * " + number((axis.size - 1.0) / axis.size) + " + " +
           number(0.5 / axis.size);
}

/// The variable for an axis over an angle of the view, which is the same for all lights and so
/// computed once.
std::string viewAxisName(const Factor& factor, size_t axis)
{
    const Angle angle = std::get<std::vector<Angle>>(factor.argument)[axis];
    return angleName(angle) + std::to_string(factor.table) + "_" + std::to_string(axis);
}

/// Texture coordinate of a factor over one direction.
std::string directionCoordinate(const DiscDomain& native, const TableEncoding& encoding,
                                const Direction& direction)
{
    if (encoding.lookUp == LookUp::cube) return directionExpression(direction);
    const DiscDomain disc =
        encoding.lookUp == LookUp::parabolic ? DiscDomain::fitting(encoding.mapSize, 1.0) : native;
    const double size = disc.size;
    const std::string position = "fbrdfDiscPosition(" + number(size) + ", " + number(disc.gamma) +
                                 ", " + number(disc.radius) + ", " +
                                 directionExpression(direction) + ")";
    return encoding.precise ? position : "(" + position + " + 0.5) * " + number(1.0 / size);
}

/// Texture coordinate of a factor: (position + 1/2) / size; or the position, in texels, where the
/// shader filters.
std::string coordinate(const FragmentContext& c, const Factor& factor)
{
    const TableSpec& table = tableOf(c, factor);
    if (const auto* disc = std::get_if<DiscDomain>(&table.domain))
        return directionCoordinate(*disc, encodingOf(c, factor),
                                   std::get<Direction>(factor.argument));
    const auto& axes = std::get<GridDomain>(table.domain).axes;
    const auto& angles = std::get<std::vector<Angle>>(factor.argument);
    const bool precise = encodingOf(c, factor).precise;
    std::string text = axes.size() == 3 ? "vec3(" : "vec2(";
    for (size_t i = 0; i < axes.size(); ++i) {
        const bool ofView = !angleInfo(angles[i]).dependsOnLight && fbrdf::dependsOnLight(factor);
        text += (i ? ", " : "") +
                (ofView ? viewAxisName(factor, i) : axisCoordinate(axes[i], angles[i], precise));
    }
    return text + (axes.size() > 1 ? ")" : precise ? ", 0.0)" : ", 0.5)");
}

/// Texels along the axes of what a factor looks up.
std::string sizeExpression(const FragmentContext& c, const Factor& factor)
{
    const TableEncoding& encoding = encodingOf(c, factor);
    const TableSpec& table = tableOf(c, factor);
    std::array<int, 3> size = domainSize(table.domain);
    if (encoding.lookUp == LookUp::parabolic) size = {encoding.mapSize, encoding.mapSize, 1};
    const bool volume = dimensionCount(table.domain) == 3;
    return (volume ? "vec3(" : "vec2(") + number(size[0]) + ", " + number(size[1]) +
           (volume ? ", " + number(size[2]) + ")" : ")");
}

std::string textureFetch(const FragmentContext& c, const Factor& factor)
{
    const bool precise = encodingOf(c, factor).precise;
    const char* const fetch = precise ? "FBRDF_TEXTURE_PRECISE"
                              : encodingOf(c, factor).lookUp == LookUp::cube ? "FBRDF_TEXTURE_CUBE"
                              : dimensionCount(tableOf(c, factor).domain) == 3 ? "FBRDF_TEXTURE3"
                                                                               : "FBRDF_TEXTURE2";
    const std::string at = coordinate(c, factor);
    return std::string(fetch) + "(fbrdfTable" + std::to_string(factor.table) + ", " +
           (c.packed ? "vec3(" + at + ", float(fbrdfMaterial))" : at) +
           (precise ? ", " + sizeExpression(c, factor) : "") + ").rgb";
}

std::string parameter(int index)
{
    return "texelFetch(fbrdfParameters, fbrdfFirst + " + std::to_string(index) + ").rgb";
}

/// The expression of a knot of a uniform table; index is an expression, too.
std::string knot(const FragmentContext& c, int table, const std::string& index)
{
    if (!c.packed) return "fbrdfKnots" + std::to_string(table) + "[" + index + "]";
    const int first = parameterLayout(c.form).tables[static_cast<size_t>(table)];
    return "texelFetch(fbrdfParameters, fbrdfFirst + " + std::to_string(first) + " + " + index +
           ").rgb";
}

/// Interpolates linearly between the knots of a uniform array.
std::string knotsLines(const FragmentContext& c, const Factor& factor, const std::string& target,
                       const std::string& operation)
{
    const Axis& axis = std::get<GridDomain>(tableOf(c, factor).domain).axes[0];
    if (axis.size == 1) return target + operation + knot(c, factor.table, "0") + ";\n";
    const Angle angle = std::get<std::vector<Angle>>(factor.argument)[0];
    return "{ float x = " + axisCall(axis.map, angle) + " * " + number(axis.size - 1.0) +
           "; int k = int(min(max(0.0, x), " + number(axis.size - 2.0) + ")); " + target +
           operation + "mix(" + knot(c, factor.table, "k") + ", " + knot(c, factor.table, "k + 1") +
           ", x - float(k)); }\n";
}

/// The statement that brings the value of a factor into exponent<suffix> or product<suffix>.
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
        value = "fbrdfExtent" + k + " * " + value;  // `lowers` adds the lower end
    else if (encoding.ranged)
        value = "fbrdfLower" + k + " + fbrdfExtent" + k + " * " + value;
    return indent + target + operation + value + ";\n";
}

}  // namespace

bool needsLocalFrame(const FragmentContext& c)
{
    bool needed = c.local || hasBentLobes(c);
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
    if (names.count("d")) names.insert("h");
    if (names.count("phi_d") || names.count("half_phi_d") || names.count("side_phi_d"))
        names.insert({"side", "lean"});
    if (names.count("theta_h") || names.count("theta_d") || names.count("lean"))
        names.insert({"both", "size"});
    return names;
}

std::string viewAxisLines(const FragmentContext& c)
{
    std::set<std::string> lines;
    forEachFactor(c, [&](const Factor& factor) {
        const auto* grid = std::get_if<GridDomain>(&tableOf(c, factor).domain);
        if (!grid || tableOf(c, factor).uniform || !fbrdf::dependsOnLight(factor)) return;
        const auto& angles = std::get<std::vector<Angle>>(factor.argument);
        for (size_t i = 0; i < angles.size(); ++i)
            if (!angleInfo(angles[i]).dependsOnLight)
                lines.insert(
                    "    float " + viewAxisName(factor, i) + " = " +
                    axisCoordinate(grid->axes[i], angles[i], encodingOf(c, factor).precise) +
                    ";\n");
    });
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

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

}  // namespace fbrdf
