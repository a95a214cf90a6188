// Twins of what lights do: how they fall off, where they reach, and what a lobe has of an area
// light.
#include "ClusterGeometry.h"
#include "TwinTest.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/LobeContour.h>
#include <fbrdf/plan/AreaContour.h>
#include <fbrdf/plan/LightVectors.h>

#include <array>

namespace fbrdf::test {
namespace {

class TwinLights : public Twin {};

TEST_P(TwinLights, Falloff)
{
    std::vector<Inputs> inputs;
    for (const float radius : {0.0f, 0.5f, 3.0f})
        for (float d2 = 0.01f; d2 < 20.0f; d2 *= 1.3f)
            inputs.push_back({Vec4(d2, radius, 0.0f, 0.0f), {}});
    inputs.push_back({Vec4(0.0f, 0.0f, 0.0f, 0.0f), {}});
    compare(
        "result = vec4(fbrdfFalloff(vec2(a.x, 1.0 / max(a.x, 1e-30)), a.y > 0.0 ? 1.0 / (a.y * "
        "a.y) "
        ": 0.0));",
        inputs, [](const Inputs& i) { return Vec4(falloff(i.a.x, i.a.y)); }, kRounding);
}

TEST_P(TwinLights, Windows)
{
    std::vector<Inputs> inputs;
    for (float d2 = 0.0f; d2 < 2.0f; d2 += 0.05f)
        inputs.push_back({Vec4(d2, 0.8f, 0.0f, 0.0f), {}});
    compare(
        "result = vec4(fbrdfInfluenceWindow(a.x, a.y));", inputs,
        [](const Inputs& i) { return Vec4(influenceWindow(i.a.x, i.a.y)); }, kRounding);
}

TEST_P(TwinLights, IrradianceOfAPointLight)
{
    std::vector<Inputs> inputs;
    for (float z = 0.5f; z < 4.0f; z += 0.25f)
        inputs.push_back({Vec4(1.0f, -2.0f, z, 0.04f), Vec4(0.5f, 1.0f, 2.0f, 1.0f)});
    compare(
        "vec3 wi; result = vec4(fbrdfIrradiance(a, b, vec4(0.0, 0.0, 0.0, 1.0), vec3(0.1, 0.2, "
        "0.0), wi), wi.y);",
        inputs,
        [](const Inputs& i) {
            const Vec3f d = Vec3f(i.a) - Vec3f(0.1f, 0.2f, 0.0f);
            const float squared = glm::dot(d, d);
            return Vec4(Vec3f(i.b) * falloff(squared, 5.0f), d.y / std::sqrt(squared));
        },
        kRounding);
}

TEST_P(TwinLights, IrradianceOfADirectionalLight)
{
    const Inputs light{Vec4(0.6f, 0.0f, 0.8f, 0.0f), Vec4(0.5f, 1.0f, 2.0f, 0.0f)};
    const auto found =
        run("vec3 wi; result = vec4(fbrdfIrradiance(a, b, vec4(0.0, 0.0, 0.0, 1.0), vec3(7.0, 2.0, "
            "0.0), wi), wi.x);",
            {light});
    EXPECT_NEAR(found[0].z, 2.0f, kRounding);
    EXPECT_NEAR(found[0].w, 0.6f, kRounding);
}

TEST_P(TwinLights, Cones)
{
    Light light;
    light.type = Light::Type::spot;
    light.axis = {0.5f, -1.0f, -2.0f};
    light.innerAngle = 0.2f;
    light.outerAngle = 1.2f;
    const Vec4 cone = lightVectors(light, glm::dmat4(1.0))[2];
    std::vector<Inputs> inputs;
    for (const Inputs& pair : pairs()) inputs.push_back({pair.a, cone});
    compare(
        "result = vec4(fbrdfConeFactor(b, a.xyz));", inputs,
        [&light](const Inputs& i) {
            return Vec4(static_cast<float>(coneFactor(light, Vec3d(Vec3f(i.a)))));
        },
        kRounding);
}

std::vector<Inputs> boxesAndTiles()
{
    std::vector<Inputs> result;
    for (int i = 0; i < 400; ++i) {
        const auto at = [i](int k) { return std::sin(1.7f * static_cast<float>(7 * i + k)); };
        result.push_back({{at(0), at(1), at(2), at(3)}, {at(4), at(5), at(6), at(7)}});
    }
    return result;
}

TEST_P(TwinLights, IntervalDistanceAndTileExtent)
{
    compare(
        "result = vec4(fbrdfTileExtent(a, floor(9.0 * b.x), 0.01),\n"
        "    fbrdfIntervalDistance(vec2(a.x, a.x + 0.5 + 0.5 * b.x), b.y), 1.0);",
        boxesAndTiles(),
        [](const Inputs& i) {
            const auto extent = tileExtent(i.a, std::floor(9.0f * i.b.x), 0.01f);
            const DistanceRange<float> interval{i.a.x, i.a.x + 0.5f + 0.5f * i.b.x};
            return Vec4(extent.low, extent.high, intervalDistance(interval, i.b.y), 1.0f);
        },
        kRounding);
}

// Where a plane is nearly even its bound is far away, and what rounding changes is relative to it.
TEST_P(TwinLights, ConeBounds)
{
    compare(
        "float angle = 1.6 + 1.5 * a.w;\n"
        "vec2 bounds = fbrdfConeBounds(2.0 * a.xyz, 1.5, normalize(b.xyz), cos(angle), "
        "sin(angle),\n"
        "    vec2(b.w, b.w + 0.3), vec2(1.0 + a.x, 2.5 + a.x), 0.01);\n"
        "result = vec4(bounds / (1.0 + abs(bounds)), 0.0, 0.0);",
        boxesAndTiles(),
        [](const Inputs& i) {
            const float angle = 1.6f + 1.5f * i.a.w;
            const auto bounds =
                coneBounds(2.0f * Vec3f(i.a), 1.5f, glm::normalize(Vec3f(i.b)), std::cos(angle),
                           std::sin(angle), DistanceRange<float>{i.b.w, i.b.w + 0.3f},
                           DistanceRange<float>{1.0f + i.a.x, 2.5f + i.a.x}, 0.01f);
            return Vec4(bounds.low / (1.0f + std::abs(bounds.low)),
                        bounds.high / (1.0f + std::abs(bounds.high)), 0.0f, 0.0f);
        },
        kRounding);
}

// What area lights are made of: the share of a lobe in an edge, and in a cap.
TEST_P(TwinLights, LobesInOutlines)
{
    std::vector<Inputs> cosines, levels, edges, caps;
    for (float c = -0.999f; c <= 1.0f; c += 0.037f) cosines.push_back({Vec4(c), {}});
    compare(
        "result = vec4(fbrdfAngleOverSine(a.xy), 0.0, 0.0);", cosines,
        [](const Inputs& i) {
            return Vec4(angleOverSine(i.a.x), angleOverSine(i.a.y), 0.0f, 0.0f);
        },
        kRounding);
    for (float level = -0.5f; level < 7.0f; level += 0.21f) levels.push_back({Vec4(level), {}});
    compare(
        "FbrdfLevelMixture m = fbrdfLevelMixture(a.x); result = vec4(m.squaredWidth, m.share);",
        levels,
        [](const Inputs& i) {
            const auto m = levelMixture(i.a.x);
            return Vec4(m.squaredWidth, m.share);
        },
        kRounding);
    for (int i = 0; i < 60; ++i) {
        const float t = static_cast<float>(i);
        edges.push_back({Vec4(std::sin(t), std::cos(2.0f * t), 0.1f + 0.01f * t, 1.0f / 4096.0f),
                         Vec4(std::sin(t + 0.3f), std::cos(2.0f * t + 0.2f), 0.7f, 0.25f)});
        caps.push_back(
            {Vec4(0.6f + 0.006f * t, 0.3f * std::exp(-0.2f * t), 1.0f / 1024.0f, 1.0f), {}});
    }
    compare(
        "result = vec4(fbrdfLobeEdge(vec3(0.0, 0.6, 0.8), vec2(a.w, b.w), a.xyz, b.xyz), 0.0, "
        "0.0);",
        edges,
        [](const Inputs& i) {
            return Vec4(lobeEdge(Vec3f(0.0f, 0.6f, 0.8f), Vec2<float>(i.a.w, i.b.w), Vec3f(i.a),
                                 Vec3f(i.b)),
                        0.0f, 0.0f);
        },
        kTexels);
    compare(
        "result = vec4(fbrdfLobeInCap(a.zw, a.x, a.y), 0.0, 0.0);", caps,
        [](const Inputs& i) {
            return Vec4(lobeInCap(Vec2<float>(i.a.z, i.a.w), i.a.x, i.a.y), 0.0f, 0.0f);
        },
        kTexels);
}

TEST_P(TwinLights, AreaLights)
{
    std::vector<Inputs> inputs;
    for (int i = 0; i < 120; ++i) {
        const float t = static_cast<float>(i);
        const Vec3f axis = glm::normalize(Vec3f(std::sin(0.31f * t), std::sin(0.17f * t), 0.6f));
        inputs.push_back({Vec4(std::sin(1.3f * t), std::sin(0.7f * t), 0.5f * std::sin(2.1f * t),
                               static_cast<float>(i % 4)),
                          Vec4(axis, 0.05f * t)});
    }
    const std::array<Vec4, 4> ofSphere{Vec4(0.3f, 0.2f, 1.1f, 1.0f), Vec4(0.4f, 0.0f, 0.0f, 1.0f),
                                       Vec4(0.0f), Vec4(0.0f, 0.0f, 0.0f, 8.0f + 4.0f)},
        ofTube{Vec4(-0.6f, 0.2f, 1.1f, 1.0f), Vec4(0.8f, -0.1f, 0.9f, 1.0f), Vec4(0.2f),
               Vec4(5.0f)},
        ofDisc{Vec4(0.1f, 0.2f, 1.2f, 1.0f), Vec4(0.0f, 0.5f, 0.1f, 1.0f),
               Vec4(0.5f, 0.0f, 0.0f, 1.0f), Vec4(0.0f, 0.0f, 0.0f, 3.0f)},
        ofFacet{Vec4(-0.5f, -0.5f, 1.0f, 1.0f), Vec4(-0.4f, 0.6f, 1.0f, 1.0f),
                Vec4(0.7f, 0.6f, 1.2f, 1.0f), Vec4(0.6f, -0.5f, 1.2f, 8.0f)};
    for (const auto& v : {ofSphere, ofTube, ofDisc, ofFacet}) {
        std::string vectors;
        for (const Vec4& k : v)
            vectors += "vec4(" + fixedText(double(k.x)) + ", " + fixedText(double(k.y)) + ", " +
                       fixedText(double(k.z)) + ", " + fixedText(double(k.w)) + "), ";
        const AreaVectors light{Vec4(0.0f), v[0], v[1], v[2], v[3]};
        const std::string contour =
            "FbrdfAreaContour contour = fbrdfAreaContour(" + vectors + "a.xyz); ";
        compare(
            contour + "result = vec4(fbrdfLobeInArea(contour, vec3(0.0, 0.28, 0.96), b.xyz, b.w));",
            inputs,
            [&light](const Inputs& i) {
                return Vec4(lobeInArea(areaContour(light, Vec3f(i.a)), Vec3f(0.0f, 0.28f, 0.96f),
                                       Vec3f(i.b), i.b.w));
            },
            kTexels);
        compare(
            contour +
                "result = contour.points > 0.0 ? vec4(fbrdfContourPoint(contour, a.w), 1.0) : "
                "vec4(0.0);",
            inputs,
            [&light](const Inputs& i) {
                const auto seen = areaContour(light, Vec3f(i.a));
                return seen.points > 0 ? Vec4(contourPoint(seen, static_cast<int>(i.a.w)), 1.0f)
                                       : Vec4(0.0f);
            },
            kTexels);
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, TwinLights, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
