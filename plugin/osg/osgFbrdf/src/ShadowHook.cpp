#include "ShadowHook.h"

#include "EmbeddedShaders.h"
#include "OsgLights.h"
#include "ShadowPlacement.h"

namespace osgFbrdf {
namespace {

std::string snippet(const char* name)
{
    return std::string(fbrdf::osgFbrdfShader(name));
}

/// What map k lets through, from `coordinate`.
std::string valueOf(ShadowFilter filter, const std::string& map, const std::string& k)
{
    switch (filter) {
        case ShadowFilter::plain: return "osgFbrdfPlain(" + map + ", coordinate)";
        case ShadowFilter::jittered: return "osgFbrdfJittered(" + map + ", coordinate)";
        // ParallelSplitShadowMap draws front faces too, and compares depths that are so much
        // nearer.
        case ShadowFilter::split:
            return "osgFbrdfPlain(" + map +
                   ", coordinate - vec4(0.0, 0.0, coordinate.q / 512.0, 0.0))";
        case ShadowFilter::colour:
            return "(coordinate.q > 0.0 ? FBRDF_TEXTURE2(" + map +
                   ", coordinate.st / coordinate.q).r : 1.0)";
    }
    return k;
}

/// The condition under which map k decides, with the uniforms zShadow<k> of ParallelSplitShadowMap.
std::string rangeOf(ShadowFilter filter, size_t k)
{
    if (filter != ShadowFilter::split) return "";
    const std::string depth = "2.0 * gl_FragCoord.z - 1.0";
    const std::string upTo = " && " + depth + " <= zShadow" + std::to_string(k);
    return (k ? " && " + depth + " > zShadow" + std::to_string(k - 1) : "") + upTo;
}

std::string declarations(const ShadowMaps& maps)
{
    const bool isColour = maps.filter == ShadowFilter::colour;
    std::string text =
        "uniform mat4 osgFbrdfShadowMatrices[" + std::to_string(maps.units.size()) + "];\n";
    for (size_t k = 0; k < maps.units.size(); ++k) {
        text += std::string("uniform ") + (isColour ? "sampler2D" : "sampler2DShadow") +
                " osgFbrdfShadowMap" + std::to_string(k) + ";\n";
        if (maps.filter == ShadowFilter::split)
            text += "uniform float zShadow" + std::to_string(k) + ";\n";
    }
    if (!isColour) text += snippet("shadows.glsl");
    if (maps.filter == ShadowFilter::jittered) text += snippet("shadows_jittered.glsl");
    return text;
}

/// Multiplies `lit` by what each map of the light lets through; maps: the set of them.
std::string mapLines(const ShadowMaps& maps)
{
    std::string text = "    vec4 coordinate;\n";
    for (size_t k = 0; k < maps.units.size(); ++k) {
        const std::string name = std::to_string(k);
        text += "    if (maps - 2 * (maps / 2) == 1" + rangeOf(maps.filter, k) + ") {\n" +
                "        coordinate = osgFbrdfShadowMatrices[" + name +
                "] * vec4(position, 1.0);\n" +
                "        lit *= " + valueOf(maps.filter, "osgFbrdfShadowMap" + name, name) +
                ";\n    }\n    maps /= 2;\n";
    }
    return text;
}

}  // namespace

int LightHooks::uniformVectors() const
{
    // A matrix is four vectors; a sampler may fill one, as may the uniforms of soft edges and
    // splits.
    const int maps = static_cast<int>(shadows.units.size());
    return (attenuated ? kVectorsPerAttenuation * kMostAttenuations : 0) +
           (maps > 0 ? 6 * maps + 3 : 0);
}

std::string shadowHook(const LightHooks& hooks)
{
    if (!hooks.any()) return "";
    const std::string bit = std::to_string(kShadowBit);
    std::string text = hooks.attenuated ? snippet("attenuation.glsl") : "";
    if (!hooks.shadows.empty()) text += declarations(hooks.shadows);
    text +=
        "float fbrdfShadow(int light, vec3 position, vec3 toLight)\n{\n    int maps = light / " +
        bit + ";\n    float lit = " +
        (hooks.attenuated ? "osgFbrdfAttenuation(light - " + bit + " * maps, position, toLight)"
                          : std::string("1.0")) +
        ";\n";
    if (!hooks.shadows.empty()) text += mapLines(hooks.shadows);
    return text + "    return lit;\n}\n";
}

}  // namespace osgFbrdf
