#include <fbrdf/scene/Lights.h>

#include <algorithm>
#include <tuple>

namespace fbrdf::scene {
namespace {

bool isSameLight(const Light& a, const Light& b)
{
    const auto values = [](const Light& l) {
        return std::tie(l.type, l.position, l.intensity, l.radius, l.axis, l.innerAngle,
                        l.outerAngle);
    };
    return values(a) == values(b);
}

bool isSameAreaLight(const AreaLight& a, const AreaLight& b)
{
    const auto values = [](const AreaLight& l) {
        return std::tie(l.shape, l.position, l.end, l.size, l.normal, l.axisU, l.axisV, l.vertices,
                        l.radiance, l.twoSided, l.radius);
    };
    return values(a) == values(b);
}

}  // namespace

bool LightSet::operator==(const LightSet& other) const
{
    return std::equal(lights.begin(), lights.end(), other.lights.begin(), other.lights.end(),
                      isSameLight) &&
           std::equal(areaLights.begin(), areaLights.end(), other.areaLights.begin(),
                      other.areaLights.end(), isSameAreaLight);
}

}  // namespace fbrdf::scene
