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

}  // namespace fbrdf
