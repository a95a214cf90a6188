#include "CoarseFilter.h"

#include "ShaderRewriter.h"

namespace fbrdf::test {
namespace {

const char* const kLookUps = R"(
#if __VERSION__ < 130 && defined(GL_EXT_gpu_shader4)
#define FBRDF_SIZE2(map) vec2(textureSize2D(map, 0))
#define FBRDF_SIZE3(map) vec3(textureSize3D(map, 0))
#define FBRDF_FILTERED2 texture2D
#define FBRDF_FILTERED3 texture3D
#elif __VERSION__ >= 130
#define FBRDF_SIZE2(map) vec2(textureSize(map, 0).xy)
#define FBRDF_SIZE3(map) vec3(textureSize(map, 0))
#define FBRDF_FILTERED2(map, at) textureLod(map, at, 0.0)
#define FBRDF_FILTERED3(map, at) textureLod(map, at, 0.0)
#endif
#ifdef FBRDF_SIZE2
vec2 fbrdfCoarse(vec2 at, vec2 size) { return (floor((at * size - 0.5) * FBRDF_STEPS + 0.5) / FBRDF_STEPS + 0.5) / size; }
vec3 fbrdfCoarse(vec3 at, vec3 size) { return (floor((at * size - 0.5) * FBRDF_STEPS + 0.5) / FBRDF_STEPS + 0.5) / size; }
vec4 fbrdfLookedUp(sampler2D map, vec2 at) { return FBRDF_FILTERED2(map, fbrdfCoarse(at, FBRDF_SIZE2(map))); }
vec4 fbrdfLookedUp(sampler3D map, vec3 at) { return FBRDF_FILTERED3(map, fbrdfCoarse(at, FBRDF_SIZE3(map))); }
#if __VERSION__ >= 130
vec4 fbrdfLookedUp(sampler2DArray map, vec3 at)
{
    return FBRDF_FILTERED2(map, vec3(fbrdfCoarse(at.xy, FBRDF_SIZE2(map)), at.z));
}
vec4 fbrdfLookedUp(samplerCube map, vec3 at)
{
    vec3 face = at / max(abs(at.x), max(abs(at.y), abs(at.z)));
    return textureLod(map, fbrdfCoarse(0.5 * face + 0.5, vec3(FBRDF_SIZE2(map).x)) * 2.0 - 1.0, 0.0);
}
#undef FBRDF_TEXTURE_CUBE
#define FBRDF_TEXTURE_CUBE fbrdfLookedUp
#endif
#undef FBRDF_TEXTURE2
#undef FBRDF_TEXTURE3
#define FBRDF_TEXTURE2 fbrdfLookedUp
#define FBRDF_TEXTURE3 fbrdfLookedUp
#endif
)";
const std::string kEndOfMacros = "#define FBRDF_TEXTURE_PRECISE fbrdfFiltered\n";

std::string coarse(std::string text, int bits)
{
    const size_t at = text.find(kEndOfMacros);
    if (at == std::string::npos) return text;
    text.insert(at + kEndOfMacros.size(),
                "#define FBRDF_STEPS " + std::to_string(1 << bits) + ".0\n" + kLookUps);
    // GLSL 1.20 has no textureSize; where that extension is missing, it filters as the driver does.
    if (text.rfind("#version 120", 0) == 0)
        text.insert(text.find('\n') + 1,
                    "#ifdef GL_EXT_gpu_shader4\n#extension GL_EXT_gpu_shader4 : enable\n#endif\n");
    if (text.rfind("#version 300 es", 0) == 0)
        text.insert(text.find('\n') + 1, "precision highp sampler2DArray;\n");
    return text;
}

}  // namespace

HeadlessContext::Load coarselyFiltering(Backend backend, int bits)
{
    return rewritingShaders(backend,
                            [bits](std::string text) { return coarse(std::move(text), bits); });
}

}  // namespace fbrdf::test
