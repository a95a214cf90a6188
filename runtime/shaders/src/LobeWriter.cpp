#include "LobeWriter.h"

#include "FactorWriter.h"

#include <fbrdf/shaders/PackedParameters.h>

#include <vector>

namespace fbrdf {
namespace {

std::string real(int value)
{
    return std::to_string(value) + ".0";
}

/// The lobes whose rows there are: those of the pass in uniforms, or all in a buffer.
LobeShare storedLobes(const FragmentContext& c)
{
    LobeShare stored = c.spec.lobes;
    if (!c.packed) return stored;
    stored.first = 0;
    stored.count = stored.table.lobes;
    stored.cosine = true;
    return stored;
}

/// The place of lobe `lobe` of the pass among those that are stored.
int placeOf(const FragmentContext& c, int lobe)
{
    return c.spec.lobes.first + lobe - storedLobes(c).first;
}

/// A row between the knots about wo.
std::string interpolated(const FragmentContext& c, int row)
{
    const LobeShare share = storedLobes(c);
    const auto rowAt = [&c](const std::string& index) {
        return c.packed ? "texelFetch(fbrdfLobeRows, " + index + ")" : "fbrdfLobes[" + index + "]";
    };
    const auto between = [&](int first) {
        return "mix(" + rowAt("knot + " + std::to_string(first + row)) + ", " +
               rowAt("knot + " + std::to_string(first + share.rows() + row)) + ", theta.y)";
    };
    if (share.table.azimuths == 1) return between(0);
    return "mix(" + between(0) + ", " + between(share.rows() * share.table.thetas) + ", azimuth.y)";
}

std::string placeLines(const FragmentContext& c)
{
    const LobeShare share = storedLobes(c);
    const bool local = needsLocalFrame(c);
    const std::string last = real(share.table.thetas - 1), rows = std::to_string(share.rows());
    std::string text = std::string("        vec2 theta = fbrdfLobeKnot(fbrdfThetaPosition(") +
                       (local ? "length(wo.xy)" : "length(cross(n, wo))") + ", NoV, " + last +
                       "), " + last + ");\n        int knot = " + rows + " * int(theta.x);\n";
    if (c.packed)
        text += "        int rows = " + std::to_string(packedLobeStride(share.table)) +
                " * fbrdfMaterial;\n        knot += rows;\n";
    if (c.packed && share.table.axes == LobeAxes::bent)
        text += "        vec2 fbrdfLobeBend = texelFetch(fbrdfLobeRows, rows + " +
                std::to_string(share.knotVectors()) + ").xy;\n";
    if (share.table.azimuths == 1) return text;
    const std::string end = real(share.table.azimuths - 1);
    return text + "        vec2 azimuth = fbrdfLobeKnot(fbrdfAzimuthPosition(wo.xy, " + end +
           "), " + end +
           ");\n        knot += " + std::to_string(share.rows() * share.table.thetas) +
           " * int(azimuth.x);\n";
}

std::string fetched(const std::string& axis, const std::string& level)
{
    return "FBRDF_TEXTURE_CUBE_LEVEL(fbrdfEnvironment, fbrdfToEnvironment * " + axis + ", " +
           level + " + fbrdfEnvironmentScale.w).rgb";
}

/// The axis of a lobe in eye space; its row has been read.
std::string axisOf(const FragmentContext& c, int lobe)
{
    const LobeShare& share = c.spec.lobes;
    if (share.table.axes == LobeAxes::bent) {
        const double offset = share.first + lobe - 0.5 * (share.table.lobes - 1);
        const std::string local =
            "fbrdfBentAxis(wo, " + real(static_cast<int>(offset)) + " * fbrdfLobeBend)";
        return "fbrdfFromLocal(frame, " + local + ")";
    }
    const std::string level = "lobe" + std::to_string(lobe) + ".w";
    const int place = placeOf(c, lobe);
    const std::string tilt = place == 0 ? "first.w" : place == 1 ? "tilts.x" : "tilts.y";
    return std::string("fbrdfTiltedAxis(") + (needsLocalFrame(c) ? "frame.n" : "n") +
           ", viewer, NoV, " + tilt + " * exp2(" + level + " - " + real(kCosineLevel) + "))";
}

std::string normalOf(const FragmentContext& c)
{
    return needsLocalFrame(c) ? "frame.n" : "n";
}

/// A lobe of the pass as expressions.
struct LobeNames {
    std::string axis, weight, level;
};

/// All of them, the cosine first.
std::vector<LobeNames> lobesOf(const FragmentContext& c)
{
    std::vector<LobeNames> lobes;
    if (c.spec.lobes.cosine) lobes.push_back({normalOf(c), "first.rgb", real(kCosineLevel)});
    for (int k = 0; k < c.spec.lobes.count; ++k) {
        const std::string number = std::to_string(k);
        lobes.push_back({"axis" + number, "lobe" + number + ".rgb", "lobe" + number + ".w"});
    }
    return lobes;
}

/// Declares the rows of the lobes of the pass, and their axes.
std::string lobeRowLines(const FragmentContext& c, const std::string& indent)
{
    const LobeShare stored = storedLobes(c);
    std::string text = indent + "vec4 first = " + interpolated(c, 0) + ";\n";
    if (c.tinted && !c.tinted->empty()) text += indent + "first.rgb *= fbrdfTinted.rgb;\n";
    if (stored.rows() > stored.count + 1)
        text += indent + "vec4 tilts = " + interpolated(c, stored.count + 1) + ";\n";
    for (int k = 0; k < c.spec.lobes.count; ++k) {
        const std::string number = std::to_string(k);
        text += indent + "vec4 lobe" + number + " = " + interpolated(c, 1 + placeOf(c, k)) + ";\n" +
                indent + "vec3 axis" + number + " = " + axisOf(c, k) + ";\n";
        if (isTinted(c, -1)) text += indent + "lobe" + number + ".rgb *= fbrdfTinted.rgb;\n";
    }
    return text;
}

std::string environmentLines(const FragmentContext& c, const std::string& indent)
{
    if (!c.spec.lobes.environment) return "";
    std::string text = indent + "vec3 reflected = vec3(0.0);\n";
    for (const LobeNames& lobe : lobesOf(c))
        text +=
            indent + "reflected += " + lobe.weight + " * " + fetched(lobe.axis, lobe.level) + ";\n";
    return text + indent + "total += reflected * fbrdfEnvironmentScale.rgb;\n";
}

/// The lobes as arrays, so that the text of what is inside of a light exists once.
std::string lobeArrayLines(const FragmentContext& c, const std::string& indent)
{
    const auto lobes = lobesOf(c);
    const std::string count = std::to_string(lobes.size());
    std::string text = indent + "vec3 axes[" + count + "], weights[" + count + "];\n" + indent +
                       "float levels[" + count + "];\n";
    for (size_t k = 0; k < lobes.size(); ++k) {
        const std::string at = "[" + std::to_string(k) + "] = ";
        text += indent + "axes" + at + lobes[k].axis + ";\n" + indent + "weights" + at +
                lobes[k].weight + ";\n" + indent + "levels" + at + lobes[k].level + ";\n";
    }
    return text;
}

/// The head of the loop over area lights, up to the vector that decides which points a light
/// reaches.
std::string areaLoop(const FragmentContext& c, const std::string& indent)
{
    const std::string inner = indent + "    ";
    if (!c.spec.areaLists)
        return indent + "for (int i = 0; i < fbrdfAreaLightCount; ++i) {\n" + inner +
               "int light = " + std::to_string(kVectorsPerAreaLight) + " * i;\n" + inner +
               "vec4 centre = fbrdfAreaLights[light];\n";
    return indent +
           "ivec2 areaList = fbrdfLightList(fbrdfAreaLists, fbrdfAreaGrid, fbrdfAreaScale, "
           "gl_FragCoord.xy, -fbrdfPosition.z);\n" +
           indent + "for (int i = 0; i < fbrdfAreaLightCount + areaList.y; ++i) {\n" + inner +
           "int light = " + std::to_string(kVectorsPerAreaLight) +
           " * fbrdfListed(fbrdfAreaIndices, areaList, fbrdfAreaLightCount, i);\n" + inner +
           "vec4 centre = texelFetch(fbrdfAreaBuffer, light);\n";
}

/// The share of the lobes inside of each area light.
std::string areaLines(const FragmentContext& c, const std::string& indent)
{
    if (!hasAreaLights(c)) return "";
    const std::string inner = indent + "    ", deep = inner + "    ";
    const auto vector = [&c](const char* k) {
        return c.spec.areaLists ? std::string("texelFetch(fbrdfAreaBuffer, light + ") + k + ")"
                                : std::string("fbrdfAreaLights[light + ") + k + "]";
    };
    const std::string shadow =
        c.shadow ? " * fbrdfShadow(int(d.w / 8.0), fbrdfPosition, normalize(toCentre))" : "";
    return lobeArrayLines(c, indent) + areaLoop(c, indent) + inner +
           "vec3 toCentre = centre.xyz - fbrdfPosition;\n" + inner +
           "float window = fbrdfInfluenceWindow(dot(toCentre, toCentre), centre.w);\n" + inner +
           "if (window > 0.0) {\n" + deep + "vec4 a = " + vector("1") + ", b = " + vector("2") +
           ", c = " + vector("3") + ", d = " + vector("4") + ";\n" + deep +
           "FbrdfAreaContour contour = fbrdfAreaContour(a, b, c, d, fbrdfPosition);\n" + deep +
           "vec3 inside = vec3(0.0);\n" + deep + "for (int k = 0; k < " +
           std::to_string(lobesOf(c).size()) + "; ++k)\n" + deep +
           "    inside += weights[k] * fbrdfLobeInArea(contour, " + normalOf(c) +
           ", axes[k], levels[k]);\n" + deep + "total += inside * window * vec3(a.w, b.w, c.w)" +
           shadow + ";\n" + inner + "}\n" + indent + "}\n";
}

}  // namespace

std::string lobeUniforms(const FragmentContext& c)
{
    if (!hasLobes(c)) return "";
    std::string text;
    if (c.spec.lobes.environment)
        text +=
            "uniform samplerCube fbrdfEnvironment;\nuniform mat3 fbrdfToEnvironment;\n"
            "uniform vec4 fbrdfEnvironmentScale;\n";
    // The functions that draw directions declare the lobes themselves.
    if (c.spec.lobes.samples > 0) return text + "uniform vec2 fbrdfSampleLattice;\n";
    if (hasAreaLights(c) && c.spec.areaLists)
        text +=
            "uniform samplerBuffer fbrdfAreaBuffer;\n"
            "uniform isamplerBuffer fbrdfAreaIndices, fbrdfAreaLists;\n"
            "uniform ivec3 fbrdfAreaGrid;\nuniform vec4 fbrdfAreaScale;\n"
            "uniform int fbrdfAreaLightCount;\n";
    else if (hasAreaLights(c))
        text += "uniform vec4 fbrdfAreaLights[" +
                std::to_string(kVectorsPerAreaLight * c.spec.lobes.areaSlots) +
                "];\nuniform int fbrdfAreaLightCount;\n";
    if (c.packed) return text + "uniform samplerBuffer fbrdfLobeRows;\n";
    return text + "uniform vec4 fbrdfLobes[" + std::to_string(c.spec.lobes.knotVectors()) + "];\n" +
           (hasBentLobes(c) ? "uniform vec2 fbrdfLobeBend;\n" : "");
}

std::string lobeLines(const FragmentContext& c)
{
    if (!hasLobes(c)) return "";
    const std::string indent = "        ";
    return "    if (NoV > 0.0) {\n" + placeLines(c) + lobeRowLines(c, indent) +
           environmentLines(c, indent) + areaLines(c, indent) + "    }\n";
}

}  // namespace fbrdf
