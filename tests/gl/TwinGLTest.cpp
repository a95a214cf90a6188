// GLSL functions against their C++ twins in float, on grids of inputs: the inputs go in as a
// texture, the outputs come back as pixels.
#include "EmbeddedShaders.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/brdf/LobeContour.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/plan/AreaContour.h>
#include <fbrdf/plan/LightVectors.h>
#include <fbrdf/plan/Transfer.h>

#include "ClusterGeometry.h"

#include <gtest/gtest.h>

#include "support/gl/GlTest.h"

#include <array>
#include <cmath>
#include <functional>

namespace fbrdf::test {
namespace {

constexpr float kRounding = 2e-6f;  // a dozen operations in float, values of order 1
constexpr float kTexels = 1e-4f;    // positions are up to 32 texels, and sqrt near 0 doubles errors

// Azimuths about h are good to three digits at theta_h = 1e-4, as h.xy is.
constexpr float kAcrossThePole = 2e-3f;

using Vec4 = glm::vec4;

/// The input of one evaluation.
struct Inputs {
    Vec4 a{0.0f}, b{0.0f};
};

class Twin : public GlTest {
protected:
    /// Runs `statements` (which read vec4 a, b and set vec4 result) for all inputs.
    std::vector<Vec4> run(const std::string& statements, const std::vector<Inputs>& inputs);

    void compare(const std::string& statements, const std::vector<Inputs>& inputs,
                 const std::function<Vec4(const Inputs&)>& twin, float tolerance)
    {
        const auto found = run(statements, inputs);
        for (size_t i = 0; i < inputs.size(); ++i) {
            const Vec4 expected = twin(inputs[i]);
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(found[i][c], expected[c],
                            tolerance * std::max(1.0f, std::abs(expected[c])))
                    << statements << "\na = " << inputs[i].a.x << " " << inputs[i].a.y << " "
                    << inputs[i].a.z << " " << inputs[i].a.w << "\nb = " << inputs[i].b.x << " "
                    << inputs[i].b.y << " " << inputs[i].b.z << " " << inputs[i].b.w
                    << "\ncomponent " << c;
        }
    }
};

std::string twinFragment(const std::string& statements)
{
    std::string text = "#version 140\n";
    for (const char* file :
         {"version.glsl", "frame.glsl", "angles.glsl", "projection.glsl", "lights.glsl",
          "cluster_geometry.glsl", "lobe_frame.glsl", "area.glsl", "transfer.glsl"})
        text += embeddedShader(file);
    // The output of these programs has another name.
    text += "#undef FBRDF_COLOUR_OUTPUT\n#define FBRDF_COLOUR_OUTPUT\n" +
            std::string(embeddedShader("prefilter.glsl"));
    return text +
           "uniform sampler2D inputs;\nout vec4 result;\nvoid main()\n{\n"
           "    vec4 a = texelFetch(inputs, ivec2(int(gl_FragCoord.x), 0), 0);\n"
           "    vec4 b = texelFetch(inputs, ivec2(int(gl_FragCoord.x), 1), 0);\n" +
           statements + "\n}\n";
}

std::vector<Vec4> Twin::run(const std::string& statements, const std::vector<Inputs>& inputs)
{
    const auto& g = gl();
    const auto count = static_cast<GLsizei>(inputs.size());
    std::vector<Vec4> rows;
    for (const Inputs& i : inputs) rows.push_back(i.a);
    for (const Inputs& i : inputs) rows.push_back(i.b);
    GLuint texture = 0, array = 0;
    g.GenTextures(1, &texture);
    g.BindTexture(GL_TEXTURE_2D, texture);
    g.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    g.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, 2, 0, GL_RGBA, GL_FLOAT, rows.data());
    g.GenVertexArrays(1, &array);
    g.BindVertexArray(array);
    Offscreen offscreen(context().loader(), {count, 1, OffscreenFormat::rgba32f, false});
    g.BindFramebuffer(GL_FRAMEBUFFER, offscreen.framebuffer());
    g.Viewport(0, 0, count, 1);
    const GLuint program =
        linkProgram(g,
                    "#version 140\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
                    "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n",
                    twinFragment(statements));
    g.UseProgram(program);
    g.DrawArrays(GL_TRIANGLES, 0, 3);
    const auto pixels = offscreen.readPixels();
    g.UseProgram(0);
    g.DeleteProgram(program);
    g.DeleteTextures(1, &texture);
    g.BindVertexArray(0);
    g.DeleteVertexArrays(1, &array);
    g.BindFramebuffer(GL_FRAMEBUFFER, 0);
    std::vector<Vec4> results;
    for (size_t i = 0; i < inputs.size(); ++i)
        results.emplace_back(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2],
                             pixels[4 * i + 3]);
    return results;
}

/// Pairs on a grid of half and difference angles, both above the horizon: a = wo, b = wi.
std::vector<Inputs> pairs()
{
    std::vector<Inputs> result;
    for (const double theta_h : {0.0, 1e-4, 0.05, 0.4, 0.9, 1.4})
        for (const double theta_d : {0.0, 1e-3, 0.2, 0.8, 1.3})
            for (int i = 0; i < 8; ++i) {
                const auto pair = pairFromHalfDifference({theta_h, 0.7, theta_d, 0.8 * i});
                if (pair.wo.z <= 0.0 || pair.wi.z <= 0.0) continue;
                result.push_back({Vec4(pair.wo, 0.0), Vec4(pair.wi, 0.0)});
            }
    return result;
}

PairGeometry<float> geometryOf(const Inputs& i)
{
    return PairGeometry<float>({Vec3f(i.a), Vec3f(i.b)});
}

Vec4 angles(const PairGeometry<float>& g, Angle first, Angle second)
{
    const auto i = static_cast<size_t>(first), j = static_cast<size_t>(second);
    return {g.cosine[i], g.complement[i], g.cosine[j], g.complement[j]};
}

TEST_P(Twin, HalfVector)
{
    compare(
        "result = vec4(fbrdfHalfVector(a.xyz, b.xyz), 1.0);", pairs(),
        [](const Inputs& i) { return Vec4(geometryOf(i).h, 1.0f); }, kRounding);
}

TEST_P(Twin, ZenithAngles)
{
    compare(
        "result = vec4(fbrdfZenith(b.xyz), fbrdfZenith(a.xyz));", pairs(),
        [](const Inputs& i) { return angles(geometryOf(i), Angle::theta_i, Angle::theta_o); },
        kRounding);
}

TEST_P(Twin, HalfAndDifferenceAngles)
{
    compare(
        "vec2 size = fbrdfSizeOf(a.xyz + b.xyz);"
        "result = vec4(fbrdfHalfZenith(a.z + b.z, vec3(a.xy + b.xy, 0.0), size), "
        "fbrdfDifferenceAngle(a.xyz, b.xyz, size.x));",
        pairs(),
        [](const Inputs& i) { return angles(geometryOf(i), Angle::theta_h, Angle::theta_d); },
        kRounding);
}

// The same angles without a tangent frame: the pair and the normal turned together.
TEST_P(Twin, AnglesAboutANormal)
{
    const Vec3f normal = glm::normalize(Vec3f(0.3f, -0.5f, 0.8f));
    const auto frame = shadingFrame(normal, Vec3f(1.0f, 0.2f, 0.0f));
    const auto turned = [&frame](const Vec4& v) {
        return Vec4(frame.t * v.x + frame.s * v.y + frame.n * v.z, 0.0f);
    };
    std::vector<Inputs> inputs = pairs();
    for (Inputs& i : inputs) i = {turned(i.a), turned(i.b)};
    compare(
        "vec3 n = normalize(vec3(0.3, -0.5, 0.8)), both = a.xyz + b.xyz; result = vec4("
        "fbrdfHalfZenith(dot(n, both), cross(n, both), fbrdfSizeOf(both)), "
        "fbrdfZenithAbout(n, b.xyz));",
        inputs,
        [&frame](const Inputs& i) {
            const Inputs local{Vec4(frame.local(Vec3f(i.a)), 0.0f),
                               Vec4(frame.local(Vec3f(i.b)), 0.0f)};
            return angles(geometryOf(local), Angle::theta_h, Angle::theta_i);
        },
        kRounding);
}

TEST_P(Twin, DifferenceVectorsAndCombinations)
{
    compare(
        "result = vec4(fbrdfDifferenceVector(fbrdfHalfVector(a.xyz, b.xyz), b.xyz), 0.0);", pairs(),
        [](const Inputs& i) {
            const auto g = geometryOf(i);
            return Vec4(differenceVector(g.h, g.wi), 0.0f);
        },
        kAcrossThePole);
    const Vec3f weights(1.0f, 0.5f, -0.25f);
    compare(
        "result = vec4(fbrdfCombination(vec3(1.0, 0.5, -0.25), a.xyz, b.xyz), 0.0);", pairs(),
        [&weights](const Inputs& i) {
            return Vec4(combination(weights, Vec3f(i.a), Vec3f(i.b)), 0.0f);
        },
        kRounding);
}

// The sides of the triangle that phi_d is an angle of, times |wi + wo|; up to a common factor they
// are s.y times the cosine and the sine.
const std::string kSides =
    "vec2 size = fbrdfSizeOf(a.xyz + b.xyz);"
    "float side = a.x * b.y - a.y * b.x, lean = 0.5 * size.x * (a.z - b.z);"
    "vec2 s = fbrdfHalfZenith(a.z + b.z, vec3(a.xy + b.xy, 0.0), size) * "
    "fbrdfDifferenceAngle(a.xyz, b.xyz, size.x);";

TEST_P(Twin, DifferenceAzimuth)
{
    // Up to a common factor these are the sides of the triangle that phi_d is an angle of.
    compare(
        kSides +
            "result = vec4(sqrt(s.y) * "
            "fbrdfDifferenceAzimuth(side, lean), 0.0, 0.0);",
        pairs(),
        [](const Inputs& i) {
            const auto g = geometryOf(i);
            const auto at = [](Angle angle) { return static_cast<size_t>(angle); };
            const float sines =
                std::sqrt(g.complement[at(Angle::theta_h)] * g.complement[at(Angle::theta_d)]);
            return Vec4(sines * g.cosine[at(Angle::phi_d)], sines * g.complement[at(Angle::phi_d)],
                        0.0f, 0.0f);
        },
        kRounding);
}

TEST_P(Twin, HalfDifferenceAzimuth)
{
    // phi_d means nothing where one of these sines is 0.
    compare(
        kSides +
            "result = vec4(sqrt(s.y) * "
            "fbrdfHalfDifferenceAzimuth(side, lean), 0.0, 0.0);",
        pairs(),
        [](const Inputs& i) {
            const auto g = geometryOf(i);
            const auto at = [](Angle angle) { return static_cast<size_t>(angle); };
            const float sines =
                std::sqrt(g.complement[at(Angle::theta_h)] * g.complement[at(Angle::theta_d)]);
            return Vec4(sines * g.cosine[at(Angle::half_phi_d)],
                        sines * g.complement[at(Angle::half_phi_d)], 0.0f, 0.0f);
        },
        kRounding);
}

TEST_P(Twin, SideDifferenceAzimuth)
{
    // phi_d means nothing where one of these sines is 0, and in the plane of incidence, where the
    // sides meet, either will do.
    compare(
        kSides +
            "result = vec4(abs(side * size.y) * "
            "sqrt(s.y) "
            "* fbrdfSideDifferenceAzimuth(side, lean), 0.0, 0.0);",
        pairs(),
        [](const Inputs& i) {
            const auto g = geometryOf(i);
            const auto at = [](Angle angle) { return static_cast<size_t>(angle); };
            const float sines =
                std::sqrt(g.complement[at(Angle::theta_h)] * g.complement[at(Angle::theta_d)]) *
                std::abs(g.h.x * g.wi.y - g.h.y * g.wi.x);
            return Vec4(sines * g.cosine[at(Angle::side_phi_d)],
                        sines * g.complement[at(Angle::side_phi_d)], 0.0f, 0.0f);
        },
        kRounding);
}

TEST_P(Twin, LobeFrame)
{
    std::vector<Inputs> inputs = pairs();
    for (size_t i = 0; i < inputs.size(); i += 2) inputs[i].a = -inputs[i].a;
    for (const int column : {0, 1})
        compare(
            "result = vec4(fbrdfLobeFrame(a.xyz)[" + std::to_string(column) + "], 0.0);", inputs,
            [column](const Inputs& i) {
                const LobeFrame frame = lobeFrame(Vec3d(Vec3f(i.a)));
                return Vec4(column ? Vec3f(frame.y) : Vec3f(frame.x), 0.0f);
            },
            kRounding);
}

TEST_P(Twin, ComplementKeepsItsDigitsNearThePole)
{
    // 1 - cos of 1e-3 is 5e-7: the difference to 1 would have one digit left.
    const Inputs pair{Vec4(std::sin(1e-3f), 0.0f, std::cos(1e-3f), 0.0f), Vec4(0.0f)};
    const auto found = run("result = vec4(fbrdfZenith(a.xyz), 0.0, 0.0);", {pair});
    EXPECT_NEAR(found[0].y / 5e-7f, 1.0f, 1e-5f);
}

TEST_P(Twin, Axes)
{
    std::vector<Inputs> inputs;
    for (int i = 0; i <= 200; ++i) {
        const float angle = static_cast<float>(kPi / 2.0) * static_cast<float>(i) / 200.0f;
        const float half = std::sin(0.5f * angle);
        inputs.push_back({Vec4(std::cos(angle), 2.0f * half * half, 0.0f, 0.0f), {}});
    }
    for (const double exponent : {1.0, 0.5, 0.25, 0.7})
        for (const bool cosine : {false, true}) {
            const AxisMap map{cosine ? AxisMap::From::cosine : AxisMap::From::oneMinusCosine,
                              exponent};
            // A cosine below 0 by rounding would give NaN in either language.
            const std::string call = std::string("fbrdfAxisCoordinate(") +
                                     (cosine ? "true" : "false") + ", " + fixedText(exponent) +
                                     ", max(a.x, 0.0), a.y)";
            compare(
                "result = vec4(" + call + ");", inputs,
                [&map](const Inputs& i) {
                    return Vec4(axisCoordinate(map, std::max(i.a.x, 0.0f), i.a.y));
                },
                kTexels);
        }
}

TEST_P(Twin, Discs)
{
    std::vector<Inputs> inputs = pairs();
    inputs.push_back({Vec4(0.0f, 0.0f, 1.0f, 0.0f), {}});
    inputs.push_back({Vec4(1.0f, 0.0f, 0.0f, 0.0f), {}});
    inputs.push_back({Vec4(0.0f, 0.6f, -0.8f, 0.0f), {}});  // below the horizon: still finite
    for (const DiscDomain& disc :
         {DiscDomain{32, 1.0, 14.0}, DiscDomain{32, 0.5, 15.5}, DiscDomain{9, 0.8, 4.0}})
        compare(
            "result = vec4(fbrdfDiscPosition(" + std::to_string(disc.size) + ".0, " +
                fixedText(disc.gamma) + ", " + fixedText(disc.radius) + ", a.xyz), 0.0, 0.0);",
            inputs,
            [&disc](const Inputs& i) { return Vec4(discPosition(disc, Vec3f(i.a)), 0.0f, 0.0f); },
            kTexels);
}

TEST_P(Twin, Falloff)
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

TEST_P(Twin, Windows)
{
    std::vector<Inputs> inputs;
    for (float d2 = 0.0f; d2 < 2.0f; d2 += 0.05f)
        inputs.push_back({Vec4(d2, 0.8f, 0.0f, 0.0f), {}});
    compare(
        "result = vec4(fbrdfInfluenceWindow(a.x, a.y));", inputs,
        [](const Inputs& i) { return Vec4(influenceWindow(i.a.x, i.a.y)); }, kRounding);
}

// What area lights are made of: the share of a lobe in an edge, and in a cap.
TEST_P(Twin, LobesInOutlines)
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

TEST_P(Twin, AreaLights)
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

TEST_P(Twin, Frames)
{
    std::vector<Inputs> inputs;
    for (const Vec3f normal : {Vec3f(0.0f, 0.0f, 1.0f), Vec3f(0.9f, 0.1f, -0.2f),
                               Vec3f(-2.0f, 1.0f, 0.5f), Vec3f(1.0f, 0.0f, 0.0f)})
        for (const Vec3f tangent : {Vec3f(1.0f, 0.0f, 0.0f), Vec3f(0.3f, 0.4f, -2.0f), Vec3f(0.0f),
                                    Vec3f(1.8f, 0.2f, -0.4f)})
            inputs.push_back({Vec4(normal, 0.0f), Vec4(tangent, 0.0f)});
    // A tangent parallel to its normal, up to rounding, may go either way; keep to exact ones.
    for (int row = 0; row < 3; ++row)
        compare(
            "FbrdfShadingFrame f = fbrdfShadingFrame(a.xyz, b.xyz); result = vec4(" +
                std::string(row == 0   ? "f.t"
                            : row == 1 ? "f.s"
                                       : "f.n") +
                ", 0.0);",
            inputs,
            [row](const Inputs& i) {
                const auto f = shadingFrame(Vec3f(i.a), Vec3f(i.b));
                return Vec4(row == 0 ? f.t : row == 1 ? f.s : f.n, 0.0f);
            },
            kRounding);
}

// A normal map does this, in a frame of either handedness; 0 leaves the frame unchanged.
TEST_P(Twin, PerturbedFrames)
{
    std::vector<Inputs> inputs;
    for (const Vec3f normal : {Vec3f(0.0f), Vec3f(0.0f, 0.0f, 1.0f), Vec3f(0.3f, -0.2f, 0.9f)})
        for (const float handedness : {-1.0f, 1.0f})
            inputs.push_back({Vec4(normal, 0.0f), Vec4(1.0f, 0.2f, 0.0f, handedness)});
    for (const char axis : {'t', 's', 'n'})
        compare(
            std::string("FbrdfShadingFrame f = fbrdfPerturbed(fbrdfShadingFrame(vec3(0.3, -0.5, "
                        "0.8), b), a.xyz); result = vec4(f.") +
                axis + ", 0.0);",
            inputs,
            [axis](const Inputs& i) {
                const auto frame = shadingFrame(Vec3f(0.3f, -0.5f, 0.8f), Vec3f(i.b), i.b.w);
                const auto f = perturbed(frame, Vec3f(i.a));
                return Vec4(axis == 't' ? f.t : axis == 's' ? f.s : f.n, 0.0f);
            },
            kRounding);
}

TEST_P(Twin, LocalDirections)
{
    const auto frame = shadingFrame(Vec3f(0.3f, -0.5f, 0.8f), Vec3f(1.0f, 0.2f, 0.0f));
    compare(
        "FbrdfShadingFrame f = fbrdfShadingFrame(vec3(0.3, -0.5, 0.8), vec3(1.0, 0.2, 0.0)); "
        "result = "
        "vec4(fbrdfLocal(f, a.xyz), 0.0);",
        pairs(), [&frame](const Inputs& i) { return Vec4(frame.local(Vec3f(i.a)), 0.0f); },
        kRounding);
}

TEST_P(Twin, IrradianceOfAPointLight)
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

TEST_P(Twin, IrradianceOfADirectionalLight)
{
    const Inputs light{Vec4(0.6f, 0.0f, 0.8f, 0.0f), Vec4(0.5f, 1.0f, 2.0f, 0.0f)};
    const auto found =
        run("vec3 wi; result = vec4(fbrdfIrradiance(a, b, vec4(0.0, 0.0, 0.0, 1.0), vec3(7.0, 2.0, "
            "0.0), wi), wi.x);",
            {light});
    EXPECT_NEAR(found[0].z, 2.0f, kRounding);
    EXPECT_NEAR(found[0].w, 0.6f, kRounding);
}

TEST_P(Twin, Transfers)
{
    constexpr float kPow = 1e-4f;  // accuracy of a driver's pow
    std::vector<Inputs> inputs{{Vec4(0.0f), {}}, {Vec4(1.0f), {}}, {Vec4(0.0031308f), {}}};
    for (float x = 1e-4f; x < 1.0f; x *= 1.1f) inputs.push_back({Vec4(x), {}});
    compare(
        "result = vec4(fbrdfSrgbFromLinear(a.rgb), 0.0);", inputs,
        [](const Inputs& i) { return Vec4(Vec3f(srgbFromLinear(i.a.x)), 0.0f); }, kPow);
    for (Inputs& i : inputs) i.a *= 8.0f;
    compare(
        "result = vec4(fbrdfToneMapped(a.rgb), 0.0);", inputs,
        [](const Inputs& i) { return Vec4(Vec3f(toneMapped(i.a.x)), 0.0f); }, kRounding);
}

TEST_P(Twin, Cones)
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

TEST_P(Twin, IntervalDistanceAndTileExtent)
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
TEST_P(Twin, ConeBounds)
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

INSTANTIATE_TEST_SUITE_P(Backends, Twin, ::testing::ValuesIn(modernVariants()), variantName);

// The tester: a twin with a wrong exponent is noticed.
class WrongTwin : public Twin {};

TEST_P(WrongTwin, IsNoticed)
{
    const auto found = run("result = vec4(fbrdfAxisCoordinate(false, 0.5, a.x, a.y));",
                           {{Vec4(0.5f, 0.5f, 0.0f, 0.0f), {}}});
    EXPECT_GT(std::abs(found[0].x -
                       axisCoordinate(AxisMap{AxisMap::From::oneMinusCosine, 0.25}, 0.5f, 0.5f)),
              100.0f * kTexels);
}

INSTANTIATE_TEST_SUITE_P(Backends, WrongTwin, ::testing::ValuesIn(modernVariants()), variantName);

}  // namespace
}  // namespace fbrdf::test
