// ClusterScenes.h - lights and projections of the tests of lists, and what a fragment would read.
#pragma once
#include <fbrdf/plan/LightClusters.h>

#include <glm/gtc/matrix_transform.hpp>

#include <numeric>
#include <random>
#include <vector>

namespace fbrdf {

inline Light pointLight(const Vec3f& position, float radius, float intensity = 1.0f)
{
    Light light;
    light.position = position;
    light.radius = radius;
    light.intensity = Vec3f(intensity);
    return light;
}

inline Light spotLight(const Vec3f& position, const Vec3f& axis, float outer, float radius)
{
    Light light = pointLight(position, radius);
    light.type = Light::Type::spot;
    light.axis = axis;
    light.outerAngle = outer;
    return light;
}

inline std::vector<LightVectors> randomLights(int count, std::mt19937& random)
{
    std::uniform_real_distribution<float> position(-6.0f, 6.0f), radius(0.2f, 3.0f);
    std::vector<LightVectors> lights;
    for (int i = 0; i < count; ++i)
        lights.push_back(
            lightVectors(pointLight({position(random), position(random), position(random) - 6.0f},
                                    i % 9 == 8 ? 0.0f : radius(random)),
                         glm::dmat4(1.0)));
    return lights;
}

inline bool reaches(const LightVectors& light, const Vec3d& point)
{
    const Vec3d d = Vec3d(light[0]) - point;
    return glm::dot(d, d) * double(light[0].w) < 1.0;
}

/// The lights that the loop of a clustered program visits. unit: place in the picture.
inline std::vector<int> lightsAt(const LightClusters& clusters, const glm::dvec2& unit,
                                 double distance)
{
    const LightList list = lightList(clusters, 2.0 * unit - 1.0, distance);
    std::vector<int> lights(static_cast<size_t>(clusters.everywhere));
    std::iota(lights.begin(), lights.end(), 0);
    const auto first = clusters.indices.begin() + list.first;
    lights.insert(lights.end(), first, first + list.count);
    return lights;
}

/// The point that is seen at a place in the picture, at a distance from the eye.
inline Vec3d pointAt(const glm::dmat4& projection, const glm::dvec2& unit, double distance)
{
    const glm::dvec4 clip = projection * glm::dvec4(0.0, 0.0, -distance, 1.0);
    return Vec3d(glm::inverse(projection) *
                 glm::dvec4((2.0 * unit - 1.0) * clip.w, clip.z, clip.w));
}

inline glm::dmat4 perspective()
{
    return glm::perspective(0.9, 1.3, 0.1, 50.0);
}

/// Left and right, or top and bottom, change places.
inline glm::dmat4 mirrored(bool sideways)
{
    return glm::scale(glm::dmat4(1.0), Vec3d(sideways ? -1.0 : 1.0, sideways ? 1.0 : -1.0, 1.0)) *
           glm::perspective(0.9, 1.3, 0.1, 50.0);
}

/// The eye is beside the middle of the picture, as in a headset.
inline glm::dmat4 offCentre()
{
    return glm::frustum(-0.02, 0.07, -0.05, 0.04, 0.1, 50.0);
}

inline glm::dmat4 parallel()
{
    return glm::ortho(-5.0, 4.0, -3.0, 5.0, 0.1, 50.0);
}

}  // namespace fbrdf
