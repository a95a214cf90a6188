// Selections, clusters and pixel bounds: nothing that a light reaches may be lost.
#include "ClusterScenes.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/plan/LightSelection.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace fbrdf {
namespace {

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

TEST(LightSelection, CullsConesThatMiss)
{
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> angle(0.05f, 1.5f);
    const auto anywhere = [&] { return Vec3f(normal(random), normal(random), normal(random)); };
    const Sphere bounds{{0.3f, -0.2f, 0.1f}, 0.5f};
    int culled = 0;
    for (int i = 0; i < 400; ++i) {
        const Light light = spotLight(3.0f * anywhere(), anywhere(), angle(random), 0.0f);
        const bool isCulled = selectLights({light}, bounds, 0).culled == 1;
        culled += isCulled ? 1 : 0;
        for (int k = 0; isCulled && k < 50; ++k) {
            const Vec3d point = Vec3d(bounds.centre) + 0.5 * glm::normalize(Vec3d(anywhere()));
            const Vec3d toLight = glm::normalize(Vec3d(light.position) - point);
            ASSERT_EQ(coneFactor(light, toLight), 0.0);
        }
    }
    EXPECT_GT(culled, 100);
}

TEST(LightSelection, KeepsTheStrongestUnderACap)
{
    const Sphere bounds{{0.0f, 0.0f, 0.0f}, 1.0f};
    Light directional;
    directional.type = Light::Type::directional;
    directional.position = {0.0f, 0.0f, 1.0f};
    directional.intensity = Vec3f(0.3f);
    // Their irradiances at the nearest point are 1/4, 4/4, 1/16, 0.3.
    const std::vector<Light> lights{pointLight({3.0f, 0.0f, 0.0f}, 0.0f),
                                    pointLight({0.0f, 3.0f, 0.0f}, 0.0f, 4.0f),
                                    pointLight({0.0f, 0.0f, 5.0f}, 0.0f), directional};
    const auto selection = selectLights(lights, bounds, 2);
    EXPECT_EQ(selection.lights, (std::vector<int>{1, 3}));
    EXPECT_EQ(selection.dropped, 2);
    EXPECT_EQ(selectLights(lights, bounds, 4).lights, (std::vector<int>{1, 3, 0, 2}));
}

TEST(LightClusters, HoldEveryLightThatReachesAPoint)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0), depth(0.1, 14.0);
    const auto lights = randomLights(200, random);
    for (const glm::dmat4& projection :
         {perspective(), parallel(), mirrored(true), mirrored(false), offCentre()}) {
        const LightClusters clusters = lightClusters(lights, projection);
        ASSERT_EQ(clusters.lights.size(), clusters.places.size());
        EXPECT_LT(clusters.lights.size(), lights.size());  // some are behind the eye
        size_t held = 0, reaching = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec2 pixel(unit(random), unit(random));
            const double z = depth(random);
            const Vec3d point = pointAt(projection, pixel, z);
            const auto list = lightsAt(clusters, pixel, -point.z);
            ASSERT_LE(static_cast<int>(list.size()), clusters.longest);
            held += list.size();
            for (int k = 0; k < static_cast<int>(lights.size()); ++k) {
                if (!reaches(lights[static_cast<size_t>(k)], point)) continue;
                ++reaching;
                ASSERT_TRUE(std::any_of(
                    list.begin(), list.end(),
                    [&](int listed) { return clusters.places[static_cast<size_t>(listed)] == k; }))
                    << "light " << k;
            }
        }
        // The lists are useful: not much longer than they must be.
        EXPECT_LT(double(held), 1.6 * double(reaching));
    }
}

TEST(LightClusters, LeaveOutWhatIsNotSeenAndNothingElse)
{
    const auto lightAt = [](float x, float y, float z, float radius) {
        return lightVectors(pointLight({x, y, z}, radius), glm::dmat4(1.0));
    };
    // Behind the eye, beside the picture; then reaching in from there, and one without a radius.
    const std::vector<LightVectors> lights{
        lightAt(0.0f, 0.0f, 5.0f, 4.9f),   lightAt(-30.0f, 0.0f, -5.0f, 2.0f),
        lightAt(0.0f, 30.0f, -5.0f, 2.0f), lightAt(0.0f, 0.0f, 1.0f, 1.5f),
        lightAt(-6.0f, 0.0f, -5.0f, 5.0f), lightAt(90.0f, 0.0f, 9.0f, 0.0f)};
    const LightClusters clusters = lightClusters(lights, perspective());
    EXPECT_EQ(clusters.places, (std::vector<int32_t>{5, 3, 4}));
    EXPECT_EQ(clusters.everywhere, 1);
    EXPECT_EQ(lightClusters({lights[0], lights[1]}, perspective()).longest, 0);
}

TEST(LightClusters, OfManyLightsAreThoseOfOneThread)
{
    std::mt19937 random(17);
    const auto many = randomLights(3000, random);
    const LightClusters threads = lightClusters(many, perspective());
    // Lists of a part of the lights are made on one thread; what they hold is in all of them too.
    const std::vector<LightVectors> few(many.begin(), many.begin() + 300);
    const LightClusters one = lightClusters(few, perspective(), threads.grid);
    std::uniform_real_distribution<double> unit(0.0, 1.0), depth(0.1, 14.0);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 at(unit(random), unit(random));
        const Vec3d point = pointAt(perspective(), at, depth(random));
        const auto placesOf = [&](const LightClusters& clusters) {
            std::vector<int> places;
            for (const int k : lightsAt(clusters, at, -point.z)) {
                const LightVectors& light = clusters.lights[static_cast<size_t>(k)];
                if (!reaches(light, point)) continue;
                const int place = clusters.places[static_cast<size_t>(k)];
                if (place < 300) places.push_back(place);
            }
            return places;
        };
        ASSERT_EQ(placesOf(threads), placesOf(one));
    }
}

TEST(ClusterBuilder, MakesWhatOneCallMakesWhateverCameBefore)
{
    std::mt19937 random(23);
    ClusterBuilder builder;
    for (const int count : {300, 20, 0, 4000, 7}) {
        const auto lights = randomLights(count, random);
        for (const int most : {0, 5}) {
            EXPECT_TRUE(builder.update(lights, perspective(), {}, most));
            const LightClusters once = lightClusters(lights, perspective(), {}, most);
            const LightClusters& again = builder.clusters();
            EXPECT_TRUE(again.grid == once.grid);
            EXPECT_EQ(again.places, once.places);
            EXPECT_EQ(again.lists, once.lists);
            EXPECT_EQ(again.indices, once.indices);
            EXPECT_EQ(again.everywhere, once.everywhere);
            EXPECT_EQ(again.longest, once.longest);
            EXPECT_EQ(again.dropped, once.dropped);
        }
    }
}

TEST(ClusterBuilder, SeesThatNothingHasMoved)
{
    std::mt19937 random(29);
    auto lights = randomLights(50, random);
    ClusterBuilder builder;
    EXPECT_TRUE(builder.update(lights, perspective()));
    EXPECT_FALSE(builder.update(lights, perspective()));
    EXPECT_TRUE(builder.update(lights, parallel()));
    EXPECT_TRUE(builder.update(lights, parallel(), {4, 4, 4}));
    EXPECT_TRUE(builder.update(lights, parallel(), {4, 4, 4}, 3));
    lights[7][1].x *= 2.0f;
    EXPECT_TRUE(builder.update(lights, parallel(), {4, 4, 4}, 3));
    EXPECT_FALSE(builder.update(lights, parallel(), {4, 4, 4}, 3));
    EXPECT_EQ(builder.clusters().lights.size(), builder.clusters().places.size());
}

TEST(ClusterBuilder, RefusesWhatNoNumberCanCountAndGoesOn)
{
    const LightVectors everywhere = lightVectors(pointLight({}, 0.0f), glm::dmat4(1.0));
    ClusterBuilder builder;
    const auto refused = [&](size_t lights, const ClusterGrid& grid) {
        try {
            builder.update(std::vector<LightVectors>(lights, everywhere), perspective(), grid, 1);
            return std::string();
        } catch (const Error& error) {
            return std::string(error.what());
        }
    };
    EXPECT_NE(refused(70000, {32767, 1, 1}).find("2293690000 entries"), std::string::npos);
    EXPECT_NE(refused(1, {32768, 1, 1}).find("32768 on a side"), std::string::npos);
    EXPECT_NE(refused(1, {1, -1, 1}).find("-1 on a side"), std::string::npos);
    EXPECT_EQ(refused(3, {2, 2, 2}), "");
    EXPECT_EQ(builder.clusters().indices.size(), 24u);
}

TEST(LightClusters, StayFew)
{
    std::mt19937 random(19);
    std::uniform_real_distribution<float> place(-40.0f, 40.0f);
    std::vector<LightVectors> lights;
    for (int i = 0; i < 3000; ++i)
        lights.push_back(
            lightVectors(pointLight({place(random), place(random), -50.0f + place(random)}, 0.3f),
                         glm::dmat4(1.0)));
    EXPECT_LE(lightClusters(lights, perspective()).grid.count(), 32768);
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

TEST(LightClusters, KeepTheStrongestUnderACap)
{
    std::mt19937 random(13);
    auto lights = randomLights(300, random);
    for (size_t i = 0; i < lights.size(); i += 7) lights[i][1] *= glm::vec4(1e3f, 1e3f, 1e3f, 1.0f);
    const LightClusters all = lightClusters(lights, perspective()),
                        capped = lightClusters(lights, perspective(), {}, 6);
    EXPECT_EQ(capped.everywhere, 0);
    EXPECT_EQ(capped.longest, 6);
    EXPECT_GT(capped.dropped, 0);
    EXPECT_GE(all.longest, capped.longest + capped.dropped);
    std::uniform_real_distribution<double> unit(0.0, 1.0), depth(1.0, 12.0);
    double whole = 0.0, kept = 0.0, first = 0.0;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec2 at(unit(random), unit(random));
        const Vec3d point = pointAt(perspective(), at, depth(random));
        const auto brought = [&](const LightClusters& c, size_t most) {
            double sum = 0.0;
            const auto list = lightsAt(c, at, -point.z);
            EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
            for (size_t k = 0; k < std::min(most, list.size()); ++k) {
                const LightVectors& light = c.lights[static_cast<size_t>(list[k])];
                const Vec3d d = Vec3d(light[0]) - point;
                const double inverse2 = double(light[0].w);
                sum += double(light[1].x) *
                       falloff(glm::dot(d, d), inverse2 > 0.0 ? 1.0 / std::sqrt(inverse2) : 0.0);
            }
            return sum;
        };
        whole += brought(all, lights.size());
        kept += brought(capped, lights.size());
        first += brought(all, 6);
    }
    EXPECT_GT(kept, 0.8 * whole);
    EXPECT_LT(first, 0.5 * whole);
}

TEST(PixelBounds, OfASpotEncloseItsCone)
{
    constexpr int kSide = 100;
    std::mt19937 random(8);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> angle(0.1f, 1.2f);
    const auto anywhere = [&] { return Vec3f(normal(random), normal(random), normal(random)); };
    size_t spotPixels = 0, ballPixels = 0;
    for (int i = 0; i < 200; ++i) {
        const Light spot = spotLight(anywhere() + Vec3f(0.0f, 0.0f, -9.0f), anywhere(),
                                     angle(random), 1.5f),
                    ball = pointLight(spot.position, spot.radius);
        const auto area = [&](const Light& light) {
            const PixelRect rect =
                pixelBounds(lightVectors(light, glm::dmat4(1.0)), perspective(), kSide, kSide);
            return std::pair{rect, static_cast<size_t>(rect.width * rect.height)};
        };
        const auto [rect, pixels] = area(spot);
        spotPixels += pixels;
        ballPixels += area(ball).second;
        for (int k = 0; k < 50; ++k) {
            const Vec3d direction = glm::normalize(Vec3d(anywhere()));
            if (coneFactor(spot, -direction) == 0.0) continue;
            const Vec3d point = Vec3d(spot.position) + 1.5 * direction;
            const glm::dvec4 clip = perspective() * glm::dvec4(point, 1.0);
            const glm::dvec2 at = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * double(kSide);
            if (at.x < 0.0 || at.y < 0.0 || at.x >= kSide || at.y >= kSide) continue;
            ASSERT_TRUE(at.x >= rect.x && at.x < rect.x + rect.width && at.y >= rect.y &&
                        at.y < rect.y + rect.height);
        }
    }
    EXPECT_LT(spotPixels, ballPixels * 3 / 4);
}

TEST(PixelBounds, AreOrderedByPlace)
{
    std::vector<PixelRect> rects;
    for (int i = 0; i < 64; ++i) rects.push_back({(i * 37) % 64 * 8, (i * 29) % 64 * 8, 8, 8});
    const auto order = neighboursTogether(rects);
    EXPECT_TRUE(std::is_permutation(order.begin(), order.end(),
                                    [] {
                                        std::vector<int> all(64);
                                        std::iota(all.begin(), all.end(), 0);
                                        return all;
                                    }()
                                        .begin()));
    const auto area = [&](const auto& indexOf) {
        int total = 0;
        for (int first = 0; first < 64; first += 8) {
            PixelRect rect;
            for (int i = first; i < first + 8; ++i)
                rect = enclosing(rect, rects[static_cast<size_t>(indexOf(i))]);
            total += rect.width * rect.height;
        }
        return total;
    };
    EXPECT_LT(2 * area([&](int i) { return order[static_cast<size_t>(i)]; }),
              area([](int i) { return i; }));
}

TEST(PixelBounds, ContainEveryPointOfTheLight)
{
    constexpr int kWidth = 130, kHeight = 100;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const glm::dmat4& projection : {perspective(), parallel()})
        for (const LightVectors& light : randomLights(200, random)) {
            const PixelRect rect = pixelBounds(light, projection, kWidth, kHeight);
            if (light[0].w == 0.0f) {
                EXPECT_EQ(rect.width * rect.height, kWidth * kHeight);
                continue;
            }
            for (int i = 0; i < 50; ++i) {
                const Vec3d direction(normal(random), normal(random), normal(random));
                const Vec3d point =
                    Vec3d(light[0]) + glm::normalize(direction) / std::sqrt(double(light[0].w));
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
