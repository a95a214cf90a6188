// ClusterReachTest.cpp - lists of spots and of area lights are shorter than those of the spheres
// that they reach, and nothing that a light reaches is lost.
#include "AreaShapes.h"
#include "ClusterScenes.h"

#include <fbrdf/plan/AreaVectors.h>

#include "ClusterGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fbrdf {
namespace {

class Somewhere {
public:
    explicit Somewhere(unsigned seed) : random_(seed) {}
    double in(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Vec3f place() { return {in(-6.0, 6.0), in(-6.0, 6.0), in(-12.0, 0.0)}; }
    Vec3f direction()
    {
        std::normal_distribution<float> normal;
        return glm::normalize(Vec3f(normal(random_), normal(random_), normal(random_)));
    }

private:
    std::mt19937 random_;
};

struct ListCounts {
    size_t reaching = 0, listed = 0, lost = 0;
};

/// Looks at random points of the view. reaches(i, point): the light at place i lights the point.
template <class Reaches>
ListCounts countAt(const LightClusters& clusters, size_t lights, Somewhere& somewhere,
                   Reaches reaches, const glm::dmat4& projection = perspective())
{
    ListCounts counts;
    for (int k = 0; k < 3000; ++k) {
        const glm::dvec2 unit(somewhere.in(0.0, 1.0), somewhere.in(0.0, 1.0));
        const Vec3d point = pointAt(projection, unit, somewhere.in(0.1, 14.0));
        std::vector<char> isListed(lights, 0);
        for (const int slot : lightsAt(clusters, unit, -point.z)) {
            isListed[static_cast<size_t>(clusters.places[static_cast<size_t>(slot)])] = 1;
            ++counts.listed;
        }
        for (size_t i = 0; i < lights; ++i) {
            if (!reaches(i, point)) continue;
            ++counts.reaching;
            counts.lost += isListed[i] ? 0 : 1;
        }
    }
    return counts;
}

/// The edge of a spot in the shader's words, in float.
bool isInCone(const LightVectors& light, const Vec3d& point)
{
    const Vec3f toLight = glm::normalize(Vec3f(Vec3d(light[0]) - point));
    return light[2].w - glm::dot(Vec3f(light[2]), toLight) > 0.0f;
}

void expectShorterLists(float narrowest, float widest, double share)
{
    Somewhere somewhere(51);
    std::vector<LightVectors> spots, balls;
    for (int i = 0; i < 300; ++i) {
        Light light = pointLight(somewhere.place(), static_cast<float>(somewhere.in(0.5, 4.0)));
        balls.push_back(lightVectors(light, glm::dmat4(1.0)));
        light.type = Light::Type::spot;
        light.axis = somewhere.direction();
        light.outerAngle = static_cast<float>(somewhere.in(narrowest, widest));
        light.innerAngle = i % 3 == 0 ? light.outerAngle : 0.5f * light.outerAngle;
        spots.push_back(lightVectors(light, glm::dmat4(1.0)));
    }
    const auto reachesSpot = [&](size_t i, const Vec3d& point) {
        return reaches(spots[i], point) && isInCone(spots[i], point);
    };
    const ListCounts ofSpots = countAt(lightClusters(spots, perspective()), spots.size(), somewhere,
                                       reachesSpot),
                     ofBalls = countAt(lightClusters(balls, perspective()), balls.size(), somewhere,
                                       reachesSpot);
    EXPECT_EQ(ofSpots.lost, 0u);
    for (const glm::dmat4& projection : {parallel(), mirrored(true), mirrored(false), offCentre()})
        EXPECT_EQ(countAt(lightClusters(spots, projection), spots.size(), somewhere, reachesSpot,
                          projection)
                      .lost,
                  0u);
    EXPECT_GT(ofSpots.reaching, 1000u);
    EXPECT_LT(double(ofSpots.listed), share * double(ofBalls.listed));
}

// A cone of the half angle a fills the share (1 - cos a) / 2 of its sphere: 0.02 to 0.15 here.
TEST(ClusterReach, OfNarrowSpotsIsTheirCone)
{
    expectShorterLists(0.3f, 0.8f, 0.25);
}

TEST(ClusterReach, OfWideSpotsIsTheirCone)
{
    expectShorterLists(1.2f, 2.6f, 0.95);
}

TEST(ClusterReach, OfFlatAreaLightsIsInFrontOfThem)
{
    using Shape = AreaLight::Shape;
    Somewhere somewhere(53);
    std::vector<AreaVectors> areas;
    for (int i = 0; i < 240; ++i) {
        AreaLight light = ofShape(
            std::array{Shape::disc, Shape::rectangle, Shape::polygon}[static_cast<size_t>(i % 3)]);
        light.position = somewhere.place();
        for (Vec3f* const v : {&light.normal, &light.axisU, &light.axisV})
            *v = 0.3f * somewhere.direction();
        const Vec3f shift = somewhere.place(), bent = 3e-4f * somewhere.direction();
        for (Vec3f& corner : light.vertices) corner += shift;
        light.vertices[2] += bent;  // corners need not be exactly in a plane
        light.radius = static_cast<float>(somewhere.in(0.5, 3.0));
        ASSERT_EQ(whyInvalid(light), "");
        appendAreaVectors(light, i, glm::dmat4(1.0), areas);
    }
    std::vector<LightVectors> bounds, balls;
    for (const AreaVectors& area : areas) {
        bounds.push_back(reachOf(area));
        balls.push_back({area[0], bounds.back()[1], glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)});
    }
    // What fbrdfAreaContour asks before it looks at an outline.
    const auto reachesArea = [&](size_t i, const Vec3d& p) {
        const AreaVectors& area = areas[i];
        const Vec3d a(area[1]), b(area[2]), c(area[3]), d(area[4]), centre(area[0]);
        const bool isDisc = static_cast<int>(area[4].w) % kAreaKinds == int(AreaKind::disc);
        const Vec3d normal = isDisc ? glm::cross(b, c) : glm::cross(c - a, d - b);
        return glm::dot(normal, p - a) > 0.0 &&
               glm::dot(p - centre, p - centre) * double(area[0].w) < 1.0;
    };
    const ListCounts front = countAt(lightClusters(bounds, perspective()), areas.size(), somewhere,
                                     reachesArea),
                     around = countAt(lightClusters(balls, perspective()), areas.size(), somewhere,
                                      reachesArea);
    EXPECT_EQ(front.lost, 0u);
    EXPECT_GT(front.reaching, 1000u);
    EXPECT_LT(double(front.listed), 0.9 * double(around.listed));
}

TEST(ClusterReach, OfTwoSidedAndRoundLightsIsASphere)
{
    using Shape = AreaLight::Shape;
    for (const Shape shape : {Shape::sphere, Shape::tube, Shape::disc}) {
        AreaLight light = ofShape(shape);
        light.twoSided = true;
        light.radius = 2.0f;
        std::vector<AreaVectors> areas;
        appendAreaVectors(light, 3, glm::dmat4(1.0), areas);
        EXPECT_EQ(reachOf(areas.front())[0], areas.front()[0]);
        EXPECT_EQ(reachOf(areas.front())[2], glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    }
}

// Planes of a row, against points that are in it and in the cone.
TEST(ConeBounds, HoldEveryPointOfTheCone)
{
    Somewhere somewhere(57);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3d apex(somewhere.place()), axis = glm::normalize(Vec3d(somewhere.direction()));
        const double angle = somewhere.in(0.02, 3.0), radius = somewhere.in(0.1, 4.0),
                     cosine = std::cos(angle), top = apex.y + somewhere.in(-3.0, 3.0),
                     nearest = -apex.z + somewhere.in(-3.0, 3.0);
        const DistanceRange<double> y{top, top + somewhere.in(0.0, 1.0)},
            distance{nearest, nearest + somewhere.in(0.0, 1.0)};
        const auto bounds =
            coneBounds(apex, radius, axis, cosine, std::sin(angle), y, distance, 1e-9);
        for (int k = 0; k < 20; ++k) {
            const Vec3d p = Vec3d(apex.x + somewhere.in(-3.0, 3.0), somewhere.in(y.low, y.high),
                                  -somewhere.in(distance.low, distance.high)) -
                            apex;
            if (glm::length(p) > radius || glm::dot(p, axis) < cosine * glm::length(p)) continue;
            ++inside;
            ASSERT_LE(bounds.low, p.x + apex.x) << i;
            ASSERT_GE(bounds.high, p.x + apex.x) << i;
        }
    }
    EXPECT_GT(inside, 1000);
}

// In the plane of its apex and axis a cone of the half angle a has the slopes tan a.
TEST(ConeBounds, AreExactInThePlaneOfTheAxis)
{
    const Vec3d apex(1.0, 2.0, -3.0), down(0.0, 0.0, -1.0);
    const auto at = [&](double angle, double distance) {
        return coneBounds(apex, 5.0, down, std::cos(angle), std::sin(angle), {2.0, 2.0},
                          {distance, distance}, 0.0);
    };
    EXPECT_NEAR(at(0.4, 5.0).low, 1.0 - 2.0 * std::tan(0.4), 1e-12);
    EXPECT_NEAR(at(0.4, 5.0).high, 1.0 + 2.0 * std::tan(0.4), 1e-12);
    EXPECT_GT(at(0.4, 2.9).low, at(0.4, 2.9).high);  // behind the apex
}

TEST(ConeBounds, AreExactForAHalfSpace)
{
    const auto highAt = [](double cosine) {
        return coneBounds(Vec3d(1.0, 0.0, -3.0), 5.0, Vec3d(-1.0, 0.0, 0.0), cosine, 1.0,
                          {0.0, 1.0}, {2.0, 4.0}, 0.0)
            .high;
    };
    EXPECT_NEAR(highAt(0.0), 1.0, 1e-12);
    EXPECT_NEAR(highAt(-1e-6), 1.0 + 5e-6, 1e-9);
}

}  // namespace
}  // namespace fbrdf
