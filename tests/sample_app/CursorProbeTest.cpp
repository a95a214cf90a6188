// CursorProbeTest.cpp - points, angles, curves, samples and texels of places whose answers are
// known.
#include "viewer/CursorProbe.h"

#include <fbrdf/fit/Fit.h>
#include <fbrdf/scene/Camera.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf::viewer {
namespace {

// A facet of the sphere is 1.4 degrees wide; interpolated normals are off by a hundredth of that.
constexpr double kFacet = 2e-4;

class OnSphere : public testing::Test {
protected:
    std::optional<CursorHit> at(double x, double y) const
    {
        const scene::Camera camera;  // at (0, 0, 4)
        return hitAt({{&sphere_}}, viewFromCamera(camera, 1.0, scene::boundsOf(sphere_)), {x, y});
    }
    static scene::LightSet directional(const std::vector<Vec3f>& towards)
    {
        scene::LightSet set;
        for (size_t i = 0; i < towards.size(); ++i) {
            Light light;
            light.type = Light::Type::directional;
            light.position = towards[i];
            light.intensity = Vec3f(static_cast<float>(i + 1));
            set.lights.push_back(light);
        }
        return set;
    }

    scene::Mesh sphere_ = scene::makeSphere();
};

TEST_F(OnSphere, TheMiddleIsSeenAlongItsNormal)
{
    const auto hit = at(0.5, 0.5);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(glm::distance(hit->position, Vec3d(0.0, 0.0, 1.0)), 0.0, kFacet);
    EXPECT_NEAR(hit->wo.z, 1.0, kFacet);
    const ProbeLight light = strongestLight(*hit, directional({{0.0f, 0.0f, 1.0f}}));
    EXPECT_TRUE(light.isLit);
    const ProbeAngles angles = anglesOf({hit->wo, light.wi});
    EXPECT_NEAR(angles.theta_i, 0.0, 0.1);
    EXPECT_NEAR(angles.theta_o, 0.0, 0.1);
    EXPECT_NEAR(angles.theta_h, 0.0, 0.1);
    EXPECT_NEAR(angles.theta_d, 0.0, 0.1);
}

TEST_F(OnSphere, OtherPlacesAreWhereTheCameraSeesThem)
{
    EXPECT_FALSE(at(0.01, 0.01));
    EXPECT_FALSE(at(0.5, 0.001));
    // The ray through a place, cut with the unit sphere.
    const double reach = std::tan(17.5 * kDegree);
    for (const auto& [x, y] : {std::pair(0.3, 0.4), {0.62, 0.5}, {0.5, 0.25}, {0.71, 0.66}}) {
        const auto hit = at(x, y);
        ASSERT_TRUE(hit);
        const Vec3d eye(0.0, 0.0, 4.0);
        const Vec3d ray =
            glm::normalize(Vec3d(reach * (2.0 * x - 1.0), reach * (1.0 - 2.0 * y), -1.0));
        const double b = glm::dot(eye, ray);
        const Vec3d expected = eye + ray * (-b - std::sqrt(b * b - 15.0));
        EXPECT_NEAR(glm::distance(hit->position, expected), 0.0, 1e-3) << x << " " << y;
        EXPECT_NEAR(hit->wo.z, glm::dot(expected, -ray), 1e-3);
        EXPECT_NEAR(glm::dot(hit->frame.n, expected), 1.0, 1e-4);
        EXPECT_NEAR(glm::length(hit->wo), 1.0, 1e-12);
    }
}

TEST_F(OnSphere, TheStrongestLightIsThatOfTheLargestIrradianceTimesCosine)
{
    const auto hit = at(0.5, 0.5);
    ASSERT_TRUE(hit);
    // Twice as bright, but at 80 degrees; and one from behind.
    const auto set =
        directional({{0.0f, 0.0f, 1.0f}, {0.9848f, 0.0f, 0.1736f}, {0.0f, 0.0f, -1.0f}});
    EXPECT_EQ(strongestLight(*hit, set).name, "light 1");
    EXPECT_EQ(strongestLight(*hit, directional({{0.0f, 0.0f, 1.0f}, {0.6f, 0.0f, 0.8f}})).name,
              "light 2");
    const ProbeLight none = strongestLight(*hit, directional({{0.0f, 0.0f, -1.0f}}));
    EXPECT_FALSE(none.isLit);
    EXPECT_NEAR(glm::distance(none.wi, Vec3d(-hit->wo.x, -hit->wo.y, hit->wo.z)), 0.0, 1e-12);
    scene::LightSet area;
    area.areaLights.push_back({});
    area.areaLights.back().position = Vec3f(0.0f, 0.0f, 5.0f);
    EXPECT_NEAR(strongestLight(*hit, area).wi.z, 1.0, 1e-6);
}

TEST(ProbeAngles, OfAMirrorPair)
{
    const Vec3d wi(-std::sin(0.5), 0.0, std::cos(0.5)), wo(std::sin(0.5), 0.0, std::cos(0.5));
    const ProbeAngles angles = anglesOf({wo, wi});
    EXPECT_NEAR(angles.theta_i, 0.5 / kDegree, 1e-9);
    EXPECT_NEAR(angles.theta_o, 0.5 / kDegree, 1e-9);
    EXPECT_NEAR(angles.phi, 180.0, 1e-9);
    EXPECT_NEAR(angles.theta_h, 0.0, 1e-6);
    EXPECT_NEAR(angles.theta_d, 0.5 / kDegree, 1e-9);
}

TEST(Polar, CurvesAreInThePlaneOfTheLightWhichIsToTheLeft)
{
    const Vec3d wi(0.6, 0.0, 0.8);
    EXPECT_NEAR(glm::distance(inPlane(wi, -std::asin(0.6) / kDegree), wi), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(inPlane({0.0, -0.6, 0.8}, 90.0), Vec3d(0.0, 1.0, 0.0)), 0.0, 1e-12);
    // A function that is its view's x: the curve is the sine.
    const PolarCurve curve =
        polarCurve([](const Vec3d& wo, const Vec3d&) { return Vec3d(1.0 + wo.x); }, wi);
    ASSERT_EQ(curve.size(), 179u);
    for (const PolarPoint& point : curve)
        EXPECT_NEAR(point.f, 1.0 - std::sin(point.theta * kDegree), 1e-12);
    EXPECT_NEAR(mostOf({curve, {}}), 2.0, 1e-3);
    EXPECT_TRUE(polarCurve([](const Vec3d&, const Vec3d&) { return Vec3d(1.0); }, {0.0, 0.0, -1.0})
                    .empty());
}

TEST(Polar, PlotsAreTheCubeRootAlongTheView)
{
    const auto up = plotted({0.0, 8.0}, 8.0), right = plotted({90.0, 1.0}, 8.0);
    EXPECT_NEAR(up.x, 0.0, 1e-12);
    EXPECT_NEAR(up.y, 1.0, 1e-12);
    EXPECT_NEAR(right.x, 0.5, 1e-12);
    EXPECT_NEAR(right.y, 0.0, 1e-12);
    EXPECT_LE(glm::length(plotted({-30.0, 99.0}, 8.0)), 1.0 + 1e-12);
}

/// A sample in the plane of incidence whose azimuth is `phi`, degrees; theta_o as in PolarPoint.
Sample sampleAt(double theta_i, double theta_o, double phi, float f)
{
    const auto turn = [phi](double along, double z) {
        return Vec3f(Vec3d(along * std::cos(phi * kDegree), along * std::sin(phi * kDegree), z));
    };
    Sample sample;
    sample.wi = turn(std::sin(theta_i * kDegree), std::cos(theta_i * kDegree));
    sample.wo = turn(-std::sin(theta_o * kDegree), std::cos(theta_o * kDegree));
    sample.f = Vec3f(f);
    return sample;
}

TEST(PlaneSamples, AreThoseWithThatLightInThatPlane)
{
    Source source;
    source.samples = {sampleAt(30.0, 40.0, 0.0, 1.0f), sampleAt(31.0, -20.0, 0.0, 2.0f),
                      sampleAt(50.0, 40.0, 0.0, 3.0f), sampleAt(30.0, 10.0, 75.0, 4.0f)};
    source.samples.push_back(source.samples[0]);
    source.samples.back().wo = Vec3f(0.0f, 0.6f, 0.8f);  // out of the plane
    const Vec3d wi(sampleAt(30.0, 0.0, 0.0, 0.0f).wi);
    const PlaneSamples fixed(source);
    EXPECT_EQ(fixed.size(), 5u);
    PolarCurve found = fixed.near(wi, kPlaneTolerance);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].theta, 40.0, 1e-3);
    EXPECT_EQ(found[0].f, 1.0);
    EXPECT_NEAR(found[1].theta, -20.0, 1e-3);
    source.isotropic = true;
    found = PlaneSamples(source).near(wi, kPlaneTolerance);
    ASSERT_EQ(found.size(), 3u) << "that of another azimuth is turned";
    EXPECT_TRUE(PlaneSamples(source).near({0.0, 0.0, 1.0}, kPlaneTolerance).empty());
}

TEST(TexelsRead, AreThoseThatTheFormLooksUp)
{
    FitOptions options;
    options.form = "hdio";
    options.heldOut = false;
    options.smoothness = 1e-3;
    const Material material =
        fitMaterial(makeModelSource("ggx:alpha=0.3,kd=0.2"), options).material;
    const Vec3d wo(0.6, 0.0, 0.8), wi(0.0, 0.6, 0.8);
    const auto reads = texelsRead(material, {wo, wi});
    ASSERT_EQ(reads.size(), 2u);
    EXPECT_EQ(reads[0].name, "T1(theta_h, theta_d)");
    Vec3d product(material.scales[0]);
    for (const TexelRead& read : reads) {
        double weights = 0.0;
        for (int i = 0; i < read.texels.count; ++i) weights += read.texels.weight[size_t(i)];
        EXPECT_NEAR(weights, 1.0, 1e-12);
        const auto size = domainSize(material.tables[size_t(read.table)].domain);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(read.position[axis], 0.0);
            EXPECT_LE(read.position[axis], size[size_t(axis)] - 1);
        }
        product *= read.value;
    }
    const Vec3d f = evaluate<double>(material, wo, wi);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(product[c] / f[c], 1.0, 1e-9);
    EXPECT_TRUE(texelsRead(material, {wo, {0.0, 0.0, -1.0}}).empty());
    const scene::Image map = mapPicture(material.tables[0], 0);
    EXPECT_EQ(map.width, domainSize(material.tables[0].domain)[0]);
    EXPECT_EQ(*std::max_element(map.rgba.begin(), map.rgba.end()), 1.0f);
}

}  // namespace
}  // namespace fbrdf::viewer
