#include "AreaShapes.h"

#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/plan/AreaContour.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

using Shape = AreaLight::Shape;

/// The share of a lobe inside of a light and above the horizon, by tracing rays over a grid that is
/// dense at the axis.
double shareByRays(const AreaLight& light, const Vec3d& point, const Vec3d& n, const Vec3d& axis,
                   double level)
{
    constexpr int kRings = 160, kSteps = 240;
    const auto axes = axesAbout(axis);
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
        const double low = 0.5 * kPi * std::pow(i / double(kRings), 2.0),
                     high = 0.5 * kPi * std::pow((i + 1) / double(kRings), 2.0),
                     theta = 0.5 * (low + high);
        int count = 0;
        for (int j = 0; j < kSteps; ++j) {
            const double phi = 2.0 * kPi * (j + 0.5) / kSteps;
            const Vec3d w = std::cos(theta) * axis +
                            std::sin(theta) * (std::cos(phi) * axes[0] + std::sin(phi) * axes[1]);
            count += glm::dot(n, w) > 0.0 && covers(light, point, w) ? 1 : 0;
        }
        sum += lobeValue(std::cos(theta), level) * (std::cos(low) - std::cos(high)) * count;
    }
    return sum * 2.0 * kPi / kSteps;
}

double share(const AreaLight& light, const Vec3d& point, const Vec3d& n, const Vec3d& axis,
             double level)
{
    std::vector<AreaVectors> vectors;
    appendAreaVectors(light, 0, glm::dmat4(1.0), vectors);
    double sum = 0.0;
    for (const AreaVectors& v : vectors) sum += lobeInArea(areaContour(v, point), n, axis, level);
    return sum;
}

constexpr Shape kShapes[] = {Shape::sphere, Shape::disc, Shape::rectangle, Shape::tube,
                             Shape::polygon};

struct AreaLightOfShape : testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, AreaLightOfShape, testing::ValuesIn(kShapes),
                         [](const auto& shape) { return std::string(shapeName(shape.param)); });

TEST_P(AreaLightOfShape, HasTheShareOfLobesThatRaysFind)
{
    // Of the grid; a round outline of 16 corners is off by less than that.
    constexpr double kGrid = 4e-3;
    const AreaLight light = ofShape(GetParam());
    const Vec3d up(0, 0, 1), low = glm::normalize(Vec3d(0.9, 0.1, 0.25)),
                             tilted = glm::normalize(Vec3d(0.4, 0.1, 0.8));
    double largest = 0.0;
    for (const Vec3d& point : {Vec3d(0.0), Vec3d(0.4, 0.9, 0.6), Vec3d(0.2, 0.2, 1.0)})
        for (const Vec3d& n : {up, glm::normalize(Vec3d(1.0, -1.0, 0.1))})
            for (const Vec3d& axis : {up, low, tilted})
                for (const double level : {2.5, 5.0, 6.0}) {
                    const double found = share(light, point, n, axis, level),
                                 expected = shareByRays(light, point, n, axis, level);
                    EXPECT_NEAR(found, expected, kGrid) << point.x << " " << level;
                    largest = std::max(largest, expected);
                }
    EXPECT_GT(largest, 0.1);  // the light is not missed by all of them
}

TEST_P(AreaLightOfShape, LightsNothingFromBelowTheHorizon)
{
    const AreaLight light = ofShape(GetParam());
    for (const double level : {0.0, 3.0, 6.0})
        EXPECT_EQ(share(light, {0, 0, 3}, {0, 0, 1}, {0, 0, 1}, level), 0.0);
}

TEST_P(AreaLightOfShape, IsAsGoodInFloat)
{
    constexpr double kFloat = 3e-5;
    std::vector<AreaVectors> vectors;
    appendAreaVectors(ofShape(GetParam()), 0, glm::dmat4(1.0), vectors);
    const Vec3d n = glm::normalize(Vec3d(0.1, 0.2, 1.0));
    for (int i = 0; i < 200; ++i) {
        const Vec3d point(std::sin(i * 1.3), std::sin(i * 0.7), 0.5 * std::sin(i * 2.1)),
            axis = glm::normalize(Vec3d(std::sin(i * 0.31), std::sin(i * 0.17), 0.6));
        for (const AreaVectors& v : vectors)
            EXPECT_NEAR(double(lobeInArea(areaContour(v, Vec3f(point)), Vec3f(n), Vec3f(axis),
                                          float(i % 7))),
                        lobeInArea(areaContour(v, Vec3d(Vec3f(point))), n, axis, double(i % 7)),
                        kFloat)
                << i;
    }
}

// A point of the outline in the plane of the horizon, or of the lobe's equator, is on one side or
// the other as it is rounded; the share must not depend on that.
TEST_P(AreaLightOfShape, IsSteadyWhereAPointOfTheOutlineIsInThePlaneOfTheHorizon)
{
    constexpr double kSteady = 1e-4;
    std::vector<AreaVectors> vectors;
    appendAreaVectors(ofShape(GetParam()), 0, glm::dmat4(1.0), vectors);
    int met = 0;
    for (int k = 0; k < 400; ++k) {
        const Vec3d point(std::sin(k * 1.3), std::sin(k * 0.7), 0.4 * std::sin(k * 2.1) - 0.5);
        for (const AreaVectors& v : vectors) {
            const AreaContour<double> contour = areaContour(v, point);
            if (contour.points == 0) continue;
            const Vec3d corner = glm::normalize(contourPoint(contour, k % (2 * contour.points)));
            const auto axes = axesAbout(corner);
            const Vec3d n = std::cos(0.9 * k) * axes[0] + std::sin(0.9 * k) * axes[1],
                        axis = glm::normalize(n + 0.8 * corner + 0.3 * std::sin(k * 2.3) * axes[0]);
            for (const bool equator : {false, true}) {
                const Vec3d up = equator ? axis : n, lobe = equator ? n : axis;
                const double exact = lobeInArea(areaContour(v, Vec3d(Vec3f(point))),
                                                up + 1e-5 * corner, lobe + 1e-5 * corner, 4.5);
                for (const float tilt : {0.0f, 1e-7f, -1e-7f})
                    EXPECT_NEAR(double(lobeInArea(areaContour(v, Vec3f(point)),
                                                  Vec3f(up) + tilt * Vec3f(corner),
                                                  Vec3f(lobe) + tilt * Vec3f(corner), 4.5f)),
                                exact, kSteady)
                        << k << " " << tilt;
                met += exact > 1e-3 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(met, 50);
}

TEST(AreaLight, TurnsWithTheEye)
{
    const AreaLight light = ofShape(Shape::disc);
    const glm::dmat4 toEye(glm::dvec4(0, 1, 0, 0), glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 0, 1, 0),
                           glm::dvec4(3, -2, 1, 1));
    std::vector<AreaVectors> world, eye;
    appendAreaVectors(light, 5, glm::dmat4(1.0), world);
    appendAreaVectors(light, 5, toEye, eye);
    const Vec3d point(0.1, 0.2, 0.3), n(0, 0, 1), axis = glm::normalize(Vec3d(0.3, 0.1, 1.0));
    const double here = lobeInArea(areaContour(world[0], point), n, axis, 4.0);
    const double there =
        lobeInArea(areaContour(eye[0], Vec3d(toEye * glm::dvec4(point, 1.0))),
                   Vec3d(toEye * glm::dvec4(n, 0.0)), Vec3d(toEye * glm::dvec4(axis, 0.0)), 4.0);
    EXPECT_NEAR(here, there, 1e-6);  // vectors are stored in float
    EXPECT_EQ(int(eye[0][4].w) / kAreaKinds, 5);
}

TEST(AreaLight, FromInsideIsEverywhere)
{
    AreaLight light = ofShape(Shape::sphere);
    EXPECT_EQ(share(light, Vec3d(light.position), {0, 0, 1}, {0, 0, 1}, 2.0), 1.0);
    light.shape = Shape::tube;
    EXPECT_EQ(share(light, Vec3d(light.end), {0, 0, 1}, {0, 1, 0}, 2.0), 1.0);
}

TEST(AreaLight, ShinesFromBothSidesWhereAsked)
{
    for (const Shape shape : {Shape::disc, Shape::rectangle, Shape::polygon}) {
        AreaLight light = ofShape(shape);
        const Vec3d behind(0.2, 0.2, 2.5), down(0, 0, -1);
        EXPECT_EQ(share(light, behind, down, down, 6.0), 0.0) << shapeName(shape);
        light.twoSided = true;
        EXPECT_GT(share(light, behind, down, down, 6.0), 0.01) << shapeName(shape);
        EXPECT_NEAR(share(light, behind, down, down, 6.0),
                    shareByRays(light, behind, down, down, 6.0), 4e-3)
            << shapeName(shape);
    }
}

TEST(AreaLight, OfManyCornersIsTheSumOfItsFacets)
{
    // A regular polygon of many corners is a disc.
    AreaLight disc = ofShape(Shape::disc), polygon = disc;
    disc.normal = {0, 0, -1};
    polygon.shape = Shape::polygon;
    polygon.vertices.clear();
    for (int i = 0; i < 100; ++i)
        polygon.vertices.push_back(disc.position +
                                   disc.size * Vec3f(float(std::cos(-2.0 * kPi * i / 100)),
                                                     float(std::sin(-2.0 * kPi * i / 100)), 0.0f));
    constexpr double kCorners = 2e-3;  // 16 corners against 100
    for (const double level : {2.0, 6.0})
        EXPECT_NEAR(
            share(disc, Vec3d(0.0), {0, 0, 1}, glm::normalize(Vec3d(0.3, 0.1, 1)), level),
            share(polygon, Vec3d(0.0), {0, 0, 1}, glm::normalize(Vec3d(0.3, 0.1, 1)), level),
            kCorners);
}

TEST(AreaLight, SaysWhatIsWrong)
{
    const auto why = [](Shape shape, auto change) {
        AreaLight light = ofShape(shape);
        EXPECT_EQ(whyInvalid(light), "");
        change(light);
        return whyInvalid(light);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(why(Shape::sphere, [](AreaLight& l) { l.size = 0.0f; }),
              "size: found 0, expected a finite number > 0");
    EXPECT_NE(why(Shape::tube, [](AreaLight& l) { l.size = -1.0f; }), "");
    EXPECT_NE(why(Shape::disc, [&](AreaLight& l) { l.size = nan; }), "");
    EXPECT_NE(why(Shape::disc, [](AreaLight& l) { l.normal = Vec3f(0.0f); }), "");
    EXPECT_NE(why(Shape::rectangle, [](AreaLight& l) { l.axisV = 2.0f * l.axisU; }), "");
    EXPECT_NE(why(Shape::rectangle, [](AreaLight& l) { l.axisV = Vec3f(0.0f); }), "");
    EXPECT_NE(why(Shape::polygon, [](AreaLight& l) { l.vertices.resize(2); }), "");
    EXPECT_NE(why(Shape::polygon, [](AreaLight& l) { l.vertices.resize(300, Vec3f(0.0f)); }), "");
    EXPECT_NE(why(Shape::polygon, [](AreaLight& l) { l.vertices[0].z += 0.5f; }), "");
    EXPECT_NE(why(Shape::polygon, [&](AreaLight& l) { l.vertices[0].z = nan; }), "");
    EXPECT_NE(why(Shape::polygon, [](AreaLight& l) { l.vertices.assign(5, Vec3f(1.0f)); }), "");
    EXPECT_NE(why(Shape::sphere, [](AreaLight& l) { l.radiance.y = -1.0f; }), "");
    EXPECT_NE(why(Shape::sphere, [&](AreaLight& l) { l.radiance.y = nan; }), "");
    EXPECT_NE(why(Shape::sphere, [](AreaLight& l) { l.radius = -1.0f; }), "");
    EXPECT_NE(why(Shape::sphere, [&](AreaLight& l) { l.position.x = nan; }), "");
}

TEST(AreaLight, OfLobesOfAMaterialIsWeighed)
{
    // A white diffuse surface under a sphere of radiance 1: the irradiance of a sphere over pi.
    LobeSum<double> lobes;
    lobes.cosine = Vec3d(1.0);
    AreaLight light;
    light.position = {0, 0, 2};
    light.radiance = {1, 2, 4};
    std::vector<AreaVectors> vectors;
    appendAreaVectors(light, 0, glm::dmat4(1.0), vectors);
    const ShadingFrame<double> frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3d lit = areaReflected(lobes, frame, vectors[0], Vec3d(0.0));
    EXPECT_NEAR(lit.x, 0.0625, 1e-12);
    EXPECT_NEAR(lit.z, 0.25, 1e-12);
    // Windowed as a point light at its centre.
    light.radius = 4.0f;
    vectors.clear();
    appendAreaVectors(light, 0, glm::dmat4(1.0), vectors);
    const double ratio = 4.0 / 16.0, window = (1 - ratio * ratio) * (1 - ratio * ratio);
    EXPECT_NEAR(areaReflected(lobes, frame, vectors[0], Vec3d(0.0)).x, 0.0625 * window, 1e-9);
}

}  // namespace
}  // namespace fbrdf
