#include "LobeInfo.h"

#include <fmt/format.h>

namespace fbrdf::tool {

Json lobesJson(const LobeTable& lobes)
{
    if (lobes.isEmpty()) return nullptr;
    return {{"axes", lobes.axes == LobeAxes::bent ? "bent" : "tilted"},
            {"lobes", lobes.lobes},
            {"knots", lobes.knots.size()},
            {"error", jsonOf(lobes.error)},
            {"fewer_errors", lobes.fewerErrors}};
}

std::string lobesText(const LobeTable& lobes)
{
    if (lobes.isEmpty()) return "no lobes: whoever draws one fits them";
    const char* const axes = lobes.axes == LobeAxes::bent ? "about bent normals" : "tilted";
    std::string text = fmt::format(
        "{} {} {} and a cosine at {} view directions, expected error {:.2g}", lobes.lobes,
        lobes.lobes == 1 ? "lobe" : "lobes", axes, lobes.knots.size(), lobes.error);
    if (!lobes.fewerErrors.empty())
        text += fmt::format(", {:.2g} with one lobe", lobes.fewerErrors.front());
    return text;
}

}  // namespace fbrdf::tool
