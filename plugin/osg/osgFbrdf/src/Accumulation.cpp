#include "Accumulation.h"

#include "MaterialStates.h"

#include <osgFbrdf/FactorizedBrdf.h>

namespace osgFbrdf {

std::array<fbrdf::ColourFormat, 3> formatsFrom(fbrdf::ColourFormat wanted)
{
    constexpr auto k32 = fbrdf::ColourFormat::rgba32f, k16 = fbrdf::ColourFormat::rgba16f,
                   k8 = fbrdf::ColourFormat::rgba8;
    if (wanted == k8) return {k8, k16, k32};
    if (wanted == k16) return {k16, k32, k8};
    return {k32, k16, k8};
}

std::optional<fbrdf::Peaks> peaksOf(const FactorizedBrdf& effect, const Illumination& light)
{
    if (light.lists || !light.lights.attenuations.empty()) return std::nullopt;
    fbrdf::Peaks peaks = effect.getMaterial()->states()->peaks();
    for (double& scale : peaks.scales) scale *= static_cast<double>(effect.getExposure());
    for (const fbrdf::Light& each : light.lights.lights)
        peaks.lights.push_back(fbrdf::largestIrradiance(each, light.bounds));
    return peaks;
}

}  // namespace osgFbrdf
