#include "LobeWriter.h"

#include "FactorWriter.h"

#include <fbrdf/shaders/PackedParameters.h>

namespace fbrdf {
namespace {

std::string real(int value)
{
    return std::to_string(value) + ".0";
}

/// The lobes whose rows there are: those of the pass in uniforms, or all in a buffer.
LobeShare storedLobes(const FragmentContext& c)
{
    const LobeShare& share = c.spec.lobes;
    return c.packed ? LobeShare{share.table, 0, share.table.lobes, true} : share;
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
                std::to_string(share.vectors()) + ").xy;\n";
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

}  // namespace

std::string lobeUniforms(const FragmentContext& c)
{
    if (!hasLobes(c)) return "";
    const std::string text =
        "uniform samplerCube fbrdfEnvironment;\nuniform mat3 fbrdfToEnvironment;\n"
        "uniform vec4 fbrdfEnvironmentScale;\n";
    // The functions that draw directions declare the lobes themselves.
    if (c.spec.lobes.samples > 0) return text + "uniform vec2 fbrdfSampleLattice;\n";
    if (c.packed) return text + "uniform samplerBuffer fbrdfLobeRows;\n";
    return text + "uniform vec4 fbrdfLobes[" + std::to_string(c.spec.lobes.vectors()) + "];\n" +
           (hasBentLobes(c) ? "uniform vec2 fbrdfLobeBend;\n" : "");
}

std::string lobeLines(const FragmentContext& c)
{
    if (!hasLobes(c)) return "";
    const LobeShare& share = c.spec.lobes;
    const std::string indent = "        ";
    std::string text = "    if (NoV > 0.0) {\n" + placeLines(c) + indent +
                       "vec4 first = " + interpolated(c, 0) + ";\n" + indent +
                       "vec3 lobes = vec3(0.0);\n";
    if (share.cosine)
        text += indent + "lobes += first.rgb * " +
                fetched(needsLocalFrame(c) ? "frame.n" : "n", real(kCosineLevel)) + ";\n";
    const LobeShare stored = storedLobes(c);
    if (stored.rows() > stored.count + 1)
        text += indent + "vec4 tilts = " + interpolated(c, stored.count + 1) + ";\n";
    for (int k = 0; k < share.count; ++k) {
        const std::string lobe = "lobe" + std::to_string(k);
        text += indent + "vec4 " + lobe + " = " + interpolated(c, 1 + placeOf(c, k)) + ";\n" +
                indent + "lobes += " + lobe + ".rgb * " + fetched(axisOf(c, k), lobe + ".w") +
                ";\n";
    }
    return text + indent + "total += lobes * fbrdfEnvironmentScale.rgb;\n    }\n";
}

}  // namespace fbrdf
