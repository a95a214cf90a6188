// ClusterEditTest.cpp - lists that are changed where lights have moved are those that would be made
// anew, whatever came before.
#include "ClusterScenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fbrdf {
namespace {

/// The places of the lights of every list, in their order.
std::vector<std::vector<int>> placesOfLists(const LightClusters& clusters)
{
    std::vector<std::vector<int>> lists;
    for (size_t k = 0; k < clusters.lists.size(); k += 2) {
        std::vector<int> list;
        for (int i = 0; i < clusters.lists[k + 1]; ++i) {
            const int slot = clusters.indices[static_cast<size_t>(clusters.lists[k] + i)];
            list.push_back(clusters.places[static_cast<size_t>(slot)]);
        }
        lists.push_back(std::move(list));
    }
    return lists;
}

void expectAsIfMadeAnew(const ClusterBuilder& builder, const std::vector<LightVectors>& lights,
                        const glm::dmat4& projection)
{
    const LightClusters &edited = builder.clusters(), anew = lightClusters(lights, projection);
    ASSERT_TRUE(edited.grid == anew.grid);
    EXPECT_EQ(edited.sliceScale, anew.sliceScale);
    EXPECT_EQ(edited.sliceBias, anew.sliceBias);
    EXPECT_EQ(edited.everywhere, anew.everywhere);
    EXPECT_EQ(edited.longest, anew.longest);
    EXPECT_EQ(placesOfLists(edited), placesOfLists(anew));
    ASSERT_EQ(edited.lights.size(), edited.places.size());
    auto places = edited.places, expected = anew.places;
    std::sort(places.begin(), places.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(places, expected);
    for (size_t slot = 0; slot < edited.lights.size(); ++slot)
        ASSERT_EQ(edited.lights[slot], lights[static_cast<size_t>(edited.places[slot])]);
}

class Crowd {
public:
    explicit Crowd(int count) : random_(31), lights(randomLights(count, random_))
    {
        for (size_t i = 0; i < lights.size(); i += 5) aim(i);
    }

    void move(float by)
    {
        std::normal_distribution<float> step(0.0f, by);
        LightVectors& light = lights[any()];
        if (light[0].w > 0.0f)
            light[0] += glm::vec4(step(random_), step(random_), step(random_), 0.0f);
    }
    void jump() { lights[any()] = randomLights(1, random_).front(); }
    void grow()
    {
        std::uniform_real_distribution<float> factor(0.8f, 1.2f);
        lights[any()][0].w *= factor(random_);
    }
    void recolour() { lights[any()][1].x += 0.1f; }
    void turn() { aim(any()); }

private:
    size_t any() { return random_() % lights.size(); }
    void aim(size_t i)
    {
        std::normal_distribution<float> normal;
        const Vec3f axis = glm::normalize(Vec3f(normal(random_), normal(random_), normal(random_)));
        lights[i][2] = glm::vec4(4.0f * axis, -3.0f);
    }
    std::mt19937 random_;

public:
    std::vector<LightVectors> lights;
};

TEST(ClusterEdits, GiveWhatListsMadeAnewHave)
{
    for (const glm::dmat4& projection : {perspective(), parallel(), mirrored(true)}) {
        Crowd crowd(700);
        ClusterBuilder builder;
        builder.update(crowd.lights, projection);
        int edited = 0;
        for (int step = 0; step < 60; ++step) {
            for (int k = 0; k < 1 + step % 5; ++k) {
                crowd.move(k == 0 ? 3.0f : 0.05f);
                if (step % 3 == 0) crowd.grow();
                if (step % 4 == 0) crowd.recolour();
                if (step % 5 == 0) crowd.turn();
            }
            if (step % 20 == 19) crowd.jump();  // may change who has a radius
            builder.update(crowd.lights, projection);
            edited += builder.wereEdited() ? 1 : 0;
            ASSERT_NO_FATAL_FAILURE(expectAsIfMadeAnew(builder, crowd.lights, projection)) << step;
        }
        EXPECT_GT(edited, 30);
    }
}

TEST(ClusterEdits, SurviveManySteps)
{
    // Lists that grow leave unused places behind, until all are made anew.
    Crowd crowd(300);
    ClusterBuilder builder;
    builder.update(crowd.lights, perspective());
    size_t entries = 0;
    for (int step = 0; step < 3000; ++step) {
        crowd.move(0.5f);
        builder.update(crowd.lights, perspective());
        entries = std::max(entries, builder.clusters().indices.size());
    }
    expectAsIfMadeAnew(builder, crowd.lights, perspective());
    const size_t dense = lightClusters(crowd.lights, perspective()).indices.size();
    EXPECT_LT(entries, 4 * dense + (size_t(1) << 16));
}

TEST(ClusterEdits, AreMadeForFewLightsOnly)
{
    Crowd crowd(600);
    ClusterBuilder builder;
    builder.update(crowd.lights, perspective());
    EXPECT_FALSE(builder.wereEdited());
    crowd.lights[static_cast<size_t>(builder.clusters().places.back())][0].x += 0.01f;
    EXPECT_TRUE(builder.update(crowd.lights, perspective()));
    EXPECT_TRUE(builder.wereEdited());
    for (LightVectors& light : crowd.lights) light[0].x += 0.3f;
    EXPECT_TRUE(builder.update(crowd.lights, perspective()));
    EXPECT_FALSE(builder.wereEdited());
    expectAsIfMadeAnew(builder, crowd.lights, perspective());
    // A limit keeps other lights where one has moved.
    EXPECT_TRUE(builder.update(crowd.lights, perspective(), {}, 5));
    crowd.lights[static_cast<size_t>(builder.clusters().places.back())][0].x += 0.01f;
    EXPECT_TRUE(builder.update(crowd.lights, perspective(), {}, 5));
    EXPECT_FALSE(builder.wereEdited());
}

TEST(ClusterEdits, DoNotCareForLightsThatAreNotSeen)
{
    Crowd crowd(200);
    const LightVectors behind = lightVectors(pointLight({0.0f, 0.0f, 9.0f}, 1.0f), glm::dmat4(1.0));
    crowd.lights[17] = behind;
    ClusterBuilder builder;
    builder.update(crowd.lights, perspective());
    crowd.lights[17][0].x = 1.0f;
    EXPECT_FALSE(builder.update(crowd.lights, perspective()));
    crowd.lights[17][0].z = -5.0f;
    EXPECT_TRUE(builder.update(crowd.lights, perspective()));
    expectAsIfMadeAnew(builder, crowd.lights, perspective());
    crowd.lights[17] = behind;
    EXPECT_TRUE(builder.update(crowd.lights, perspective()));
    expectAsIfMadeAnew(builder, crowd.lights, perspective());
}

}  // namespace
}  // namespace fbrdf
