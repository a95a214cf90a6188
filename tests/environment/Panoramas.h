// Panoramas.h - panoramas whose light is known.
#pragma once
#include <fbrdf/environment/Panorama.h>

#include <random>

namespace fbrdf {

inline Panorama constantPanorama(int width, int height, const Vec3f& radiance)
{
    return {width, height,
            std::vector<Vec3f>(static_cast<size_t>(width) * static_cast<size_t>(height), radiance)};
}

/// One texel of radiance 1, the others 0.
inline Panorama oneTexelPanorama(int width, int height, int x, int y)
{
    Panorama panorama = constantPanorama(width, height, Vec3f(0.0f));
    panorama.texels[static_cast<size_t>(y * width + x)] = Vec3f(1.0f);
    return panorama;
}

inline Panorama randomPanorama(int width, int height, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    Panorama panorama = constantPanorama(width, height, Vec3f(0.0f));
    for (Vec3f& texel : panorama.texels) texel = Vec3f(value(random), value(random), value(random));
    return panorama;
}

/// radiance(direction) at the centres of texels.
template <class Radiance>
Panorama panoramaOf(int width, int height, const Radiance& radiance)
{
    Panorama panorama = constantPanorama(width, height, Vec3f(0.0f));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            panorama.texels[static_cast<size_t>(y * width + x)] =
                Vec3f(radiance(panoramaDirection((x + 0.5) / width, (y + 0.5) / height)));
    return panorama;
}

inline Vec3d randomDirection(std::mt19937& random)
{
    std::normal_distribution<double> component;
    return glm::normalize(Vec3d(component(random), component(random), component(random)));
}

}  // namespace fbrdf
