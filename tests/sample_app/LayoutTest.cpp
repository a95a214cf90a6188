// LayoutTest.cpp - several objects side by side, lights around them, and the stats; no GL.
#include <fbrdf/scene/Layout.h>
#include <fbrdf/scene/Lights.h>
#include <fbrdf/scene/Stats.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace fbrdf::scene {
namespace {

TEST(Arranged, OneMaterialStaysWhereTheMeshIs)
{
    const Mesh mesh = makeSphere(8, 4);
    const auto instances = arranged(mesh, 1, 1.5);
    ASSERT_EQ(instances.size(), 1u);
    EXPECT_EQ(instances[0].model, glm::mat4(1.0f));
    EXPECT_EQ(instances[0].mesh, &mesh);
}

TEST(Arranged, SeveralNeitherOverlapNorLeanToOneSide)
{
    const Mesh mesh = makeSphere(8, 4);
    for (const int count : {2, 3, 4, 5, 12})
        for (const double aspect : {0.4, 1.0, 2.5}) {
            const auto instances = arranged(mesh, count, aspect);
            ASSERT_EQ(instances.size(), static_cast<size_t>(count));
            std::set<int> materials;
            Vec3f sum(0.0f);
            for (const Instance& a : instances) {
                materials.insert(a.material);
                sum += Vec3f(a.model[3]);
                for (const Instance& b : instances)
                    if (&a != &b) {
                        EXPECT_GE(glm::distance(Vec3f(a.model[3]), Vec3f(b.model[3])), 2.0f);
                    }
            }
            EXPECT_EQ(materials.size(), static_cast<size_t>(count));
            EXPECT_NEAR(sum.x, 0.0f, 1e-4f) << count << " at " << aspect;
        }
    const auto wide = arranged(mesh, 3, 3.0);
    EXPECT_EQ(wide[0].model[3].y, wide[2].model[3].y) << "one row in a wide picture";
    EXPECT_LT(wide[0].model[3].x, wide[2].model[3].x);
}

TEST(Arranged, BoundsEncloseEveryInstance)
{
    const Mesh mesh = makeSphere(8, 4);
    const Bounds bounds = boundsOf(arranged(mesh, 4, 1.0));
    EXPECT_NEAR(glm::length(bounds.centre), 0.0f, 1e-6f);
    EXPECT_NEAR(bounds.radius, 1.0f + 1.075f * std::sqrt(2.0f), 1e-5f);
}

TEST(Facing, SeesEveryBallAndTouchesTheEdgeWithOne)
{
    const Mesh mesh = makeSphere(64, 32);
    for (const int count : {1, 2, 4, 7})
        for (const double aspect : {0.5, 1.0, 2.0}) {
            const auto instances = arranged(mesh, count, aspect);
            const Camera camera = facing(instances, aspect);
            const gl::View view = viewFromCamera(camera, aspect, boundsOf(instances));
            double farthest = 0.0;
            for (const Instance& instance : instances)
                for (const Vec3f& p : mesh.positions) {
                    const glm::vec4 clip =
                        view.projection * (view.view * (instance.model * glm::vec4(p, 1.0f)));
                    farthest = std::max({farthest, std::abs(double(clip.x / clip.w)),
                                         std::abs(double(clip.y / clip.w))});
                }
            EXPECT_LE(farthest, 1.0 + 1e-5) << count << " at " << aspect;
            EXPECT_GT(farthest, 0.99) << count << " at " << aspect;
        }
}

TEST(SpreadAround, LeavesScenesThatFitAndKeepsIrradianceElsewhere)
{
    const auto lights = makeLights(5);
    EXPECT_EQ(lightsToJson({spreadAround(lights, {Vec3f(0.0f), 1.19f}), {}}),
              lightsToJson({lights, {}}));
    const Bounds far{Vec3f(100.0f, 0.0f, 0.0f), 12.0f};
    const auto moved = spreadAround(lights, far);
    for (size_t i = 0; i < lights.size(); ++i) {
        const Vec3f offset = moved[i].position - far.centre;
        EXPECT_NEAR(glm::distance(offset, 10.0f * lights[i].position), 0.0f, 1e-3f);
        const double before =
            falloff<double>(glm::dot(Vec3d(lights[i].position), Vec3d(lights[i].position)), 0.0);
        const double after = falloff<double>(glm::dot(Vec3d(offset), Vec3d(offset)), 0.0);
        EXPECT_NEAR(double(moved[i].intensity.g) * after / (double(lights[i].intensity.g) * before),
                    1.0, 1e-4);
    }
}

TEST(Spread, OfOddAndEvenLists)
{
    EXPECT_EQ(spreadOf({3.0, 1.0, 2.0}).median, 2.0);
    EXPECT_EQ(spreadOf({4.0, 1.0, 2.0, 3.0}).median, 2.5);
    EXPECT_EQ(spreadOf({4.0, 1.0, 2.0, 3.0}).min, 1.0);
    EXPECT_EQ(spreadOf({4.0, 1.0, 2.0, 3.0}).max, 4.0);
    EXPECT_EQ(spreadOf({}).median, 0.0);
}

TEST(Stats, HoldEveryFieldThatIsPromised)
{
    Stats stats;
    stats.backend = "egl";
    stats.glRenderer = "llvmpipe";
    stats.materials = {"a \"quoted\" name", "\xff not UTF-8"};
    stats.lightsGiven = 5;
    stats.lightsDropped = 2;
    stats.maxLookups = 2;
    stats.milliseconds = {2.0, 1.0, 4.0};
    const auto json = nlohmann::json::parse(statsToJson(stats));
    EXPECT_EQ(json["backend"], "egl");
    EXPECT_EQ(json["gl_renderer"], "llvmpipe");
    EXPECT_TRUE(json["gl_version"].is_null());
    EXPECT_EQ(json["materials"][0], "a \"quoted\" name");
    EXPECT_EQ(json["lights"]["given"], 5);
    EXPECT_EQ(json["lights"]["dropped"], 2);
    EXPECT_EQ(json["milliseconds"]["median"], 2.0);
    EXPECT_EQ(json["milliseconds"]["min"], 1.0);
    EXPECT_EQ(json["milliseconds"]["max"], 4.0);
    EXPECT_EQ(json["frames"], 3);
    for (const char* field : {"technique", "mesh", "evaluated", "size", "covered_pixels", "passes",
                              "draw_calls", "max_lookups", "accumulation", "clock"})
        EXPECT_TRUE(json.contains(field)) << field;
}

TEST(Turned, TurnsAboutTheVerticalThroughTheMiddle)
{
    Mesh mesh = makePlane(1);
    for (Vec3f& position : mesh.positions) position += Vec3f(3.0f, 0.0f, 2.0f);
    const Instance quarter = turned({&mesh}, 0.5 * kPi);
    const auto at = [&](const Vec3f& p) { return Vec3f(quarter.model * glm::vec4(p, 1.0f)); };
    EXPECT_LT(glm::distance(at({3.0f, 0.5f, 2.0f}), Vec3f(3.0f, 0.5f, 2.0f)), 1e-5f);
    EXPECT_LT(glm::distance(at({4.0f, 0.0f, 2.0f}), Vec3f(3.0f, 0.0f, 1.0f)), 1e-5f)
        << "+x to -z, counter-clockwise seen from above";
}

}  // namespace
}  // namespace fbrdf::scene
