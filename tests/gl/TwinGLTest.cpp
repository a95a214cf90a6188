// Twins of directions, angles, frames, tables and transfers.
#include "TwinTest.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/plan/Transfer.h>

namespace fbrdf::test {
namespace {

// Azimuths about h are good to three digits at theta_h = 1e-4, as h.xy is.
constexpr float kAcrossThePole = 2e-3f;

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
