#include <fbrdf/truth/Emitters.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::truth {

EnvironmentEmitter::EnvironmentEmitter(const scene::EnvironmentLight& light) : light_(light)
{
    const Panorama& panorama = light.panorama;
    double sum = 0.0;
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const Vec3d texel(panorama.texel(x, y));
            sum += (texel.x + texel.y + texel.z) / 3.0 * texelSolidAngle(panorama, y);
            sums_.push_back(sum);
        }
}

Emission EnvironmentEmitter::drawn(const Vec2<double>& u) const
{
    const double sum = u.x * sums_.back();
    // The first sum above: a black texel, which adds nothing, is never drawn.
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), sum);
    if (found == sums_.end()) return {};
    const auto index = static_cast<int>(found - sums_.begin());
    const Panorama& panorama = light_.panorama;
    const int x = index % panorama.width, y = index / panorama.width;
    const double before = index == 0 ? 0.0 : *(found - 1);
    const double across = (sum - before) / (*found - before);
    // Even by solid angle: the cosine of the angle from +y is even between the edges of the row.
    const double cosine = glm::mix(std::cos(kPi * y / panorama.height),
                                   std::cos(kPi * (y + 1) / panorama.height), u.y);
    const Vec3d direction = panoramaDirection((x + across) / panorama.width,
                                              std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi);
    return ofTexel(light_.fromEnvironment(direction), x, y);
}

Emission EnvironmentEmitter::along(const Vec3d& direction) const
{
    const Panorama& panorama = light_.panorama;
    const Vec2<double> place = panoramaPlace(light_.toEnvironment(direction));
    const auto index = [](double at, int count) {
        return std::clamp(static_cast<int>(at * count), 0, count - 1);
    };
    return ofTexel(direction, index(place.x, panorama.width), index(place.y, panorama.height));
}

Emission EnvironmentEmitter::ofTexel(const Vec3d& direction, int x, int y) const
{
    const Panorama& panorama = light_.panorama;
    const Vec3d texel(panorama.texel(x, y));
    Emission emission{direction};
    emission.radiance = light_.intensity * texel;
    if (sums_.back() > 0.0) emission.pdf = (texel.x + texel.y + texel.z) / 3.0 / sums_.back();
    return emission;
}

}  // namespace fbrdf::truth
