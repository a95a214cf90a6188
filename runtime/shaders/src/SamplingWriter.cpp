#include "SamplingWriter.h"

#include "EmbeddedShaders.h"

namespace fbrdf {
namespace {

std::string defined(const std::string& name, int value)
{
    return "#define FBRDF_LOBE" + name + " " + std::to_string(value) + "\n";
}

}  // namespace

std::string lobeFunctions(const LobeLayout& table)
{
    const LobeShare share = wholeShare(table);
    const bool bent = table.axes == LobeAxes::bent;
    std::string text = "uniform vec4 fbrdfLobes[" + std::to_string(share.vectors()) + "];\n" +
                       (bent ? "uniform vec2 fbrdfLobeBend;\n#define FBRDF_LOBES_BENT\n" : "") +
                       "#define FBRDF_LOBE_ROW(index) fbrdfLobes[index]\n" +
                       defined("S", table.lobes) + defined("_ROWS", share.rows()) +
                       defined("_THETAS", table.thetas) + defined("_AZIMUTHS", table.azimuths);
    for (const char* file : {"lobe_frame.glsl", "lobes.glsl", "sampling.glsl"})
        text += embeddedShader(file);
    return text;
}

std::string sampledMain(const FragmentContext& c)
{
    return "void main()\n{\n" + tintLines(c) + "    vec3 viewer = fbrdfToViewer();\n" +
           surfaceLines(c) +
           "    vec3 total = vec3(0.0);\n"
           "    if (NoV > 0.0) {\n"
           "        FbrdfLobeMixture mixture = fbrdfLobeMixture(wo);\n"
           "        int count = int(fbrdfSampleLattice.x);\n"
           "        for (int i = 0; i < count; ++i) {\n"
           "            vec4 drawn = fbrdfSampleMixture(mixture, fbrdfSamplePoint(float(i), "
           "fbrdfSampleLattice));\n"
           "            if (drawn.z > 0.0 && drawn.w > 0.0) {\n"
           "                vec3 to = fbrdfToEnvironment * fbrdfFromLocal(frame, drawn.xyz);\n"
           "                float level = fbrdfLevelOfCell(1.0 / (fbrdfSampleLattice.x * drawn.w), "
           "to, fbrdfEnvironmentScale.w);\n"
           "                total += fbrdfEvaluate(wo, drawn.xyz) * (drawn.z / drawn.w) * "
           "FBRDF_TEXTURE_CUBE_LEVEL(fbrdfEnvironment, to, level).rgb;\n"
           "            }\n        }\n"
           "        total *= fbrdfEnvironmentScale.rgb / fbrdfSampleLattice.x;\n    }\n" +
           outputLines(c);
}

}  // namespace fbrdf
