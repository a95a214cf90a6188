// Selections, clusters and pixel bounds: nothing that a light reaches may be lost.
#include <fbrdf/plan/LightClusters.h>
#include <fbrdf/plan/LightSelection.h>

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace fbrdf {
namespace {

Light pointLight(const Vec3f& position, float radius, float intensity = 1.0f)
{
    Light light;
    light.position = position;
    light.radius = radius;
    light.intensity = Vec3f(intensity);
    return light;
}

TEST(LightSelection, CullsWhatDoesNotReach)
{
    const Sphere bounds{{0.0f, 0.0f, 0.0f}, 1.0f};
    const auto selection =
        selectLights({pointLight({3.0f, 0.0f, 0.0f}, 1.9f), pointLight({3.0f, 0.0f, 0.0f}, 2.1f),
                      pointLight({3.0f, 0.0f, 0.0f}, 0.0f)},
                     bounds, 0);
    EXPECT_EQ(selection.lights, (std::vector<int>{1, 2}));
    EXPECT_EQ(selection.culled, 1);
    EXPECT_EQ(selection.dropped, 0);
}

TEST(LightSelection, KeepsTheStrongestUnderACap)
{
    const Sphere bounds{{0.0f, 0.0f, 0.0f}, 1.0f};
    Light directional;
    directional.type = Light::Type::directional;
    directional.position = {0.0f, 0.0f, 1.0f};
    directional.intensity = Vec3f(0.3f);
    // At the nearest point: 1/4, 4/4, 1/16, 0.3.
    const std::vector<Light> lights{pointLight({3.0f, 0.0f, 0.0f}, 0.0f),
                                    pointLight({0.0f, 3.0f, 0.0f}, 0.0f, 4.0f),
                                    pointLight({0.0f, 0.0f, 5.0f}, 0.0f), directional};
    const auto selection = selectLights(lights, bounds, 2);
    EXPECT_EQ(selection.lights, (std::vector<int>{1, 3}));
    EXPECT_EQ(selection.dropped, 2);
    EXPECT_EQ(selectLights(lights, bounds, 4).lights, (std::vector<int>{1, 3, 0, 2}));
}

std::vector<LightVectors> randomLights(int count, std::mt19937& random)
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

bool reaches(const LightVectors& light, const Vec3d& point)
{
    const Vec3d d = Vec3d(light[0]) - point;
    return glm::dot(d, d) * double(light[1].w) < 1.0;
}

/// As fbrdfLightList and the loop of a clustered program do.
std::vector<int> listAt(const LightClusters& clusters, const glm::dvec2& unit, float distance)
{
    const ClusterGrid& grid = clusters.grid;
    const auto index = [](double x, int count) {
        return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1);
    };
    const int slice = index(
        double(std::log2(std::max(distance, 1e-6f)) * clusters.sliceScale + clusters.sliceBias),
        grid.slices);
    const size_t cluster = static_cast<size_t>(
        (slice * grid.rows + index(unit.y * grid.rows, grid.rows)) * grid.columns +
        index(unit.x * grid.columns, grid.columns));
    std::vector<int> lights;
    for (int i = 0; i < clusters.everywhere; ++i) lights.push_back(i);
    for (int i = 0; i < clusters.lists[2 * cluster + 1]; ++i)
        lights.push_back(clusters.indices[static_cast<size_t>(clusters.lists[2 * cluster] + i)]);
    return lights;
}

glm::dmat4 perspective()
{
    return glm::perspective(0.9, 1.3, 0.1, 50.0);
}

glm::dmat4 parallel()
{
    return glm::ortho(-5.0, 4.0, -3.0, 5.0, 0.1, 50.0);
}

TEST(LightClusters, HoldEveryLightThatReachesAPoint)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0), depth(0.1, 14.0);
    const auto lights = randomLights(200, random);
    for (const glm::dmat4& projection : {perspective(), parallel()}) {
        const LightClusters clusters = lightClusters(lights, projection);
        ASSERT_EQ(clusters.lights.size(), lights.size());
        size_t held = 0, reaching = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec2 pixel(unit(random), unit(random));
            const double z = depth(random);
            const glm::dvec4 clip = projection * glm::dvec4(0.0, 0.0, -z, 1.0);
            Vec3d point(glm::inverse(projection) *
                        glm::dvec4((2.0 * pixel - 1.0) * clip.w, clip.z, clip.w));
            const auto list = listAt(clusters, pixel, static_cast<float>(-point.z));
            ASSERT_LE(static_cast<int>(list.size()), clusters.longest);
            held += list.size();
            for (int k = 0; k < static_cast<int>(lights.size()); ++k) {
                if (!reaches(clusters.lights[static_cast<size_t>(k)], point)) continue;
                ++reaching;
                ASSERT_NE(std::find(list.begin(), list.end(), k), list.end()) << "light " << k;
            }
        }
        // The lists are worth it: not much longer than they must be.
        EXPECT_LT(double(held), 1.6 * double(reaching));
    }
}

TEST(LightClusters, OfNoLightsWithARadiusAreEmpty)
{
    const auto vectors = lightVectors(pointLight({0.0f, 0.0f, -3.0f}, 0.0f), glm::dmat4(1.0));
    for (const auto& lights :
         {std::vector<LightVectors>{}, std::vector<LightVectors>{vectors, vectors}}) {
        const LightClusters clusters = lightClusters(lights, perspective());
        EXPECT_EQ(clusters.everywhere, static_cast<int>(lights.size()));
        EXPECT_TRUE(clusters.indices.empty());
        EXPECT_TRUE(std::isfinite(clusters.sliceScale) && std::isfinite(clusters.sliceBias));
    }
}

TEST(PixelBounds, ContainEveryPointOfTheLight)
{
    constexpr int kWidth = 130, kHeight = 100;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const glm::dmat4& projection : {perspective(), parallel()})
        for (const LightVectors& light : randomLights(200, random)) {
            const PixelRect rect = pixelBounds(light, projection, kWidth, kHeight);
            if (light[1].w == 0.0f) {
                EXPECT_EQ(rect.width * rect.height, kWidth * kHeight);
                continue;
            }
            for (int i = 0; i < 50; ++i) {
                const Vec3d direction(normal(random), normal(random), normal(random));
                const Vec3d point =
                    Vec3d(light[0]) + glm::normalize(direction) / std::sqrt(double(light[1].w));
                const glm::dvec4 clip = projection * glm::dvec4(point, 1.0);
                if (clip.w <= 0.0) continue;
                const glm::dvec2 at =
                    (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(kWidth, kHeight);
                if (at.x < 0.0 || at.y < 0.0 || at.x >= kWidth || at.y >= kHeight) continue;
                ASSERT_TRUE(at.x >= rect.x && at.x < rect.x + rect.width && at.y >= rect.y &&
                            at.y < rect.y + rect.height);
            }
        }
}

TEST(PixelBounds, AreSmallForASmallLight)
{
    const auto light = lightVectors(pointLight({0.0f, 0.0f, -10.0f}, 0.1f), glm::dmat4(1.0));
    const PixelRect rect = pixelBounds(light, perspective(), 100, 100);
    EXPECT_GT(rect.width, 0);
    EXPECT_LT(rect.width, 8);
}

}  // namespace
}  // namespace fbrdf
