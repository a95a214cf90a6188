// LightEditTest.cpp - lights that are added, removed, moved and found under the mouse.
#include "SampleDocument.h"

#include <fbrdf/scene/LightEdit.h>
#include <fbrdf/scene/Shading.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

const Bounds kObjects{Vec3f(0.5f, 1.0f, -2.0f), 1.5f};
const Camera kCamera{{3.0, 2.0, 6.0}, {0.5, 1.0, -2.0}};
constexpr int kWidth = 640, kHeight = 400;

/// One of every kind.
LightSet allKinds()
{
    LightSet set;
    for (int kind = 0; kind < kLightKinds; ++kind)
        addLight(set, static_cast<LightKind>(kind), kCamera, kObjects);
    return set;
}

gl::View seen()
{
    return viewFromCamera(kCamera, double(kWidth) / kHeight, kObjects);
}

double distance(const Vec3d& a, const Vec3d& b)
{
    return glm::length(a - b);
}

TEST(LightEdit, AddedLightsAreValidOfTheirKindAndAsStrongAsOneAnother)
{
    LightSet set;
    for (int kind = 0; kind < kLightKinds; ++kind) {
        const int index = addLight(set, static_cast<LightKind>(kind), kCamera, kObjects);
        EXPECT_EQ(kindOf(set, index), static_cast<LightKind>(kind));
        EXPECT_EQ(set.size(), static_cast<size_t>(kind) + 1);
    }
    for (const Light& light : set.lights) {
        EXPECT_TRUE(isValid(light));
        const Incident incident = incidentFrom(light, Vec3d(kObjects.centre));
        EXPECT_NEAR(incident.irradiance.x, 3.0, 1e-4);
        EXPECT_GT(glm::dot(incident.direction, kCamera.eye - kCamera.centre), 0.0)
            << "from the side of the camera";
    }
    for (const AreaLight& light : set.areaLights) {
        EXPECT_EQ(whyInvalid(light), "");
        if (light.shape == AreaLight::Shape::sphere || light.shape == AreaLight::Shape::tube)
            continue;
        EXPECT_GT(glm::dot(normalOf(light), Vec3d(kObjects.centre) - centreOf(light)), 0.0)
            << shapeName(light.shape) << " shines to the objects";
    }
}

TEST(LightEdit, NamesAreThoseOfFiles)
{
    for (int kind = 0; kind < kLightKinds; ++kind) {
        LightSet set;
        addLight(set, static_cast<LightKind>(kind), kCamera, kObjects);
        EXPECT_NE(lightsToJson(set).find(std::string("\"type\": \"") +
                                         lightKindName(static_cast<LightKind>(kind)) + '"'),
                  std::string::npos);
    }
}

TEST(LightEdit, AMovedLightIsWhereItWasMovedTo)
{
    LightSet set = allKinds();
    const Vec3d place(4.0, -1.0, 2.0);
    for (int light = 0; light < kLightKinds; ++light) {
        const LightKind kind = kindOf(set, light);
        const double extent =
            light < 3 ? 0.0 : extentOf(set.areaLights[static_cast<size_t>(light) - 3]);
        moveLight(set, light, place, kObjects);
        EXPECT_EQ(kindOf(set, light), kind);
        if (kind == LightKind::directional) {
            // Its direction is that of the place; how far it is away means nothing.
            const Vec3d towards = glm::normalize(place - Vec3d(kObjects.centre));
            EXPECT_LT(distance(Vec3d(set.lights[2].position), towards), 1e-6);
        } else {
            EXPECT_LT(distance(placeOf(set, light, kObjects), place), 1e-5);
        }
        if (light >= 3) {
            EXPECT_NEAR(extentOf(set.areaLights[static_cast<size_t>(light) - 3]), extent, 1e-5)
                << "a shape is moved as a whole";
        }
    }
}

TEST(LightEdit, ADirectionalLightCannotBeMovedIntoTheMiddle)
{
    LightSet set = allKinds();
    const Vec3f before = set.lights[2].position;
    moveLight(set, 2, Vec3d(kObjects.centre), kObjects);
    EXPECT_EQ(set.lights[2].position, before);
}

TEST(LightEdit, RemovesTheOneThatIsNamed)
{
    for (int removed = 0; removed < kLightKinds; ++removed) {
        LightSet set = allKinds();
        removeLight(set, removed);
        ASSERT_EQ(set.size(), size_t{kLightKinds} - 1);
        for (int light = 0; light < kLightKinds - 1; ++light)
            EXPECT_EQ(static_cast<int>(kindOf(set, light)), light < removed ? light : light + 1);
    }
}

TEST(LightEdit, OrbitsAreUndoneByTheOppositeAngleAndKeepDistances)
{
    const LightSet set = allKinds();
    const Vec3d centre(kObjects.centre);
    const LightSet turned = orbited(set, centre, 0.7);
    const LightSet back = orbited(turned, centre, -0.7);
    for (int light = 0; light < kLightKinds; ++light) {
        const Vec3d was = placeOf(set, light, kObjects), is = placeOf(turned, light, kObjects);
        EXPECT_NEAR(distance(is, centre), distance(was, centre), 1e-5);
        EXPECT_NEAR(is.y, was.y, 1e-5);
        EXPECT_GT(distance(is, was), 0.5);
        EXPECT_LT(distance(placeOf(back, light, kObjects), was), 1e-5);
    }
    for (const AreaLight& light : turned.areaLights) EXPECT_EQ(whyInvalid(light), "");
    // Counter-clockwise seen from above: from +z to +x.
    LightSet one;
    one.lights.resize(1);
    one.lights[0].position = {0.0f, 0.0f, 1.0f};
    EXPECT_NEAR(orbited(one, Vec3d(0.0), kPi / 2).lights[0].position.x, 1.0f, 1e-6f);
}

TEST(LightEdit, PixelsAreThoseOfTheCamera)
{
    const auto middle = pixelOf(kCamera.centre, seen(), kWidth, kHeight);
    ASSERT_TRUE(middle);
    EXPECT_LT(glm::length(*middle - glm::dvec2(0.5 * kWidth, 0.5 * kHeight)), 1e-3);
    const auto above = pixelOf(kCamera.centre + Vec3d(0.0, 1.0, 0.0), seen(), kWidth, kHeight);
    ASSERT_TRUE(above);
    EXPECT_LT(above->y, middle->y) << "rows are counted from the top";
    EXPECT_FALSE(pixelOf(2.0 * kCamera.eye - kCamera.centre, seen(), kWidth, kHeight))
        << "behind the eye";
}

TEST(LightEdit, ADragEndsInThePixelAndKeepsTheDepth)
{
    const Vec3d forward = glm::normalize(kCamera.centre - kCamera.eye);
    for (const Vec3d& place : {Vec3d(0.0), Vec3d(2.0, 3.0, -1.0), Vec3d(-1.0, 0.2, 2.0)})
        for (const glm::dvec2& pixel : {glm::dvec2(10.0, 20.0), glm::dvec2(500.0, 390.0)}) {
            const Vec3d moved = draggedTo(place, pixel, seen(), kWidth, kHeight);
            const auto at = pixelOf(moved, seen(), kWidth, kHeight);
            ASSERT_TRUE(at);
            EXPECT_LT(glm::length(*at - pixel), 1e-3);
            EXPECT_NEAR(glm::dot(moved - kCamera.eye, forward),
                        glm::dot(place - kCamera.eye, forward), 1e-4);
        }
}

TEST(LightEdit, TheNearestHandleWithinTheRadiusIsTaken)
{
    const std::vector<LightHandle> handles{{3, {10.0, 10.0}}, {5, {18.0, 10.0}}};
    EXPECT_EQ(lightAt(handles, {12.0, 10.0}, 12.0), 3);
    EXPECT_EQ(lightAt(handles, {15.0, 10.0}, 12.0), 5);
    EXPECT_EQ(lightAt(handles, {10.0, 30.0}, 12.0), -1);
    EXPECT_EQ(lightAt({}, {10.0, 30.0}, 12.0), -1);
}

TEST(LightEdit, HandlesHaveTheLightsColourWithoutItsStrength)
{
    LightSet set = allKinds();
    colourOf(set, 4) = {200.0f, 100.0f, 0.0f};
    const auto handles = handlesOf(set, kObjects, seen(), kWidth, kHeight);
    ASSERT_EQ(handles.size(), size_t{kLightKinds});
    EXPECT_EQ(handles[4].light, 4);
    EXPECT_EQ(handles[4].kind, LightKind::disc);
    EXPECT_EQ(handles[4].colour, Vec3f(1.0f, 0.5f, 0.0f));
}

}  // namespace
}  // namespace fbrdf::scene
