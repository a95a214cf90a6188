#include "EnvironmentScenes.h"

#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kThetas = 8, kAzimuths = 4;

/// A number that changes slowly with the place in the table.
float wave(int theta, int azimuth, size_t lobe, int channel)
{
    return std::sin(0.4f * static_cast<float>(theta) + 0.5f * static_cast<float>(azimuth) +
                    1.3f * static_cast<float>(lobe) + 0.8f * static_cast<float>(channel));
}

}  // namespace

LobeTable testLobes(LobeAxes axes, int lobes, bool acrossTangent)
{
    LobeTable table;
    table.axes = axes;
    table.lobes = lobes;
    table.thetas = kThetas;
    table.azimuths = axes == LobeAxes::bent ? kAzimuths : 1;
    table.spread = axes == LobeAxes::bent ? 0.2f : 0.0f;
    table.acrossTangent = acrossTangent;
    table.error = 0.01 * lobes;
    for (int a = 0; a < table.azimuths; ++a)
        for (int t = 0; t < kThetas; ++t) {
            LobeKnot& knot = table.knots.emplace_back();
            for (int c = 0; c < 3; ++c) knot.cosine[c] = 0.3f + 0.2f * wave(t, a, 9, c);
            for (size_t k = 0; k < static_cast<size_t>(lobes); ++k) {
                for (int c = 0; c < 3; ++c)
                    knot.lobes[k].weight[c] = 0.25f + 0.2f * wave(t, a, k, c);
                knot.lobes[k].level = 3.0f + 1.5f * wave(t, a, k, 3);
                if (axes == LobeAxes::tilted) knot.lobes[k].tilt = 0.6f * wave(t, a, k, 4);
            }
        }
    return table;
}

Material withLobes(Material material, const LobeTable& lobes)
{
    material.lobes = lobes;
    return material;
}

Panorama testPanorama(int width, float lamp)
{
    Panorama panorama{width, width / 2, {}};
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3d d = panoramaDirection((x + 0.5) / width, (y + 0.5) / panorama.height);
            panorama.texels.emplace_back(1.2 + d.x, 1.1 + d.y * d.z, 1.3 + std::sin(3.0 * d.z));
        }
    if (lamp > 0.0f)
        panorama.texels[static_cast<size_t>(width * (panorama.height / 3) + width / 5)] =
            Vec3f(lamp);
    return panorama;
}

Panorama whitePanorama()
{
    return {8, 4, std::vector<Vec3f>(32, Vec3f(1.0f))};
}

Panorama turnedPanorama(const Panorama& panorama)
{
    // -z goes to -x, which is a quarter of the width to the left.
    Panorama turned = panorama;
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x) {
            const int to = (x + 3 * panorama.width / 4) % panorama.width;
            turned.texels[static_cast<size_t>(y * panorama.width + to)] = panorama.texel(x, y);
        }
    return turned;
}

AreaLight areaLightOf(AreaLight::Shape shape)
{
    AreaLight light;
    light.shape = shape;
    light.radiance = {1.0f, 2.0f, 0.5f};
    light.position = {1.5f, 0.5f, 1.6f};
    light.size = 0.7f;
    light.end = {-1.0f, 1.5f, 1.0f};
    light.normal = {-1.0f, -0.2f, -1.0f};
    light.axisU = {0.0f, 0.6f, 0.0f};
    light.axisV = {0.5f, 0.0f, -0.4f};
    light.vertices = {{1.5f, -1, 1}, {-0.5f, -1, 3}, {-0.5f, 1, 3}, {0.5f, 0.6f, 2}, {1.5f, 1, 1}};
    return light;
}

std::vector<AreaLight> oneOfEach()
{
    std::vector<AreaLight> lights;
    for (const AreaLight::Shape shape : kShapes) lights.push_back(areaLightOf(shape));
    lights[1].radius = 3.0f;
    return lights;
}

}  // namespace fbrdf::test
