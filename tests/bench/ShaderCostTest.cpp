// The counter of operations agrees with counts by hand, and with what is known of forms and peers.
#include "bench/ShaderCost.h"

#include "bench/ShaderPeers.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <gtest/gtest.h>

namespace fbrdf::bench {
namespace {

ShaderCost ofBody(const std::string& body, const std::string& before = "",
                  const std::map<std::string, double>& values = {})
{
    return costOf(
        "#version 330\nuniform vec3 u, v;\nuniform vec4 lights[9];\nuniform mat3 m;\n"
        "uniform float s;\nuniform sampler2D map, other;\n" +
            before + "void main()\n{\n" + body + "\n}\n",
        values);
}

void expectCost(const ShaderCost& cost, double multiplications, double additions, double specials)
{
    EXPECT_EQ(cost.multiplications, multiplications);
    EXPECT_EQ(cost.additions, additions);
    EXPECT_EQ(cost.specials, specials);
}

TEST(ShaderCost, OfExpressionsIsCountedByHand)
{
    expectCost(ofBody("vec3 a = u * v + u;"), 3, 3, 0);
    expectCost(ofBody("float a = dot(u, v);"), 3, 2, 0);
    expectCost(ofBody("vec3 a = s * u;  // u * u"), 3, 0, 0);
    expectCost(ofBody("vec3 a = m * u;"), 9, 6, 0);
    expectCost(ofBody("vec3 a = cross(u, v);"), 6, 3, 0);
    expectCost(ofBody("vec3 a = normalize(u);"), 6, 2, 1);
    expectCost(ofBody("float a = u.x * v.y - lights[2].w;"), 1, 1, 0);
    expectCost(ofBody("vec2 a = u.xy / s;"), 2, 0, 1);
    expectCost(ofBody("vec2 a = u.xy / 4.0;"), 2, 0, 0);
    expectCost(ofBody("vec3 a = exp2(u); a += v; a *= 0.5;"), 3, 3, 3);
    expectCost(ofBody("float a = pow(s, 2.2);"), 1, 0, 2);
    expectCost(ofBody("vec3 a = mix(u, v, s);"), 3, 6, 0);
    expectCost(ofBody("float a = max(-s, 0.0); bool b = a > s; int i = 3 * 4 + 1;"), 0, 0, 0);
    expectCost(ofBody("float a = 2.0 * 3.0 * s;"), 1, 0, 0);
    EXPECT_EQ(ofBody("float a = s * s + s * s * s;").multiplyAdds(), 3);
    EXPECT_EQ(ofBody("float a = s + s + s;").multiplyAdds(), 2);
}

TEST(ShaderCost, OfBranchesIsThatOfTheDearerUnlessConstantsDecide)
{
    expectCost(ofBody("if (s > 0.0) { s * s * s; } else s + s;"), 2, 0, 0);
    expectCost(ofBody("float a = s > 0.0 ? s : s * s * s;"), 2, 0, 0);
    const std::string choose =
        "float choose(bool cheap, float e, float x)\n{\n    if (cheap) return x;\n"
        "    if (e == 0.5) return sqrt(x);\n    return pow(x, e);\n}\n";
    expectCost(ofBody("choose(true, 2.0, s);", choose), 0, 0, 0);
    expectCost(ofBody("choose(false, 0.5, s);", choose), 0, 0, 1);
    expectCost(ofBody("choose(false, 3.0, s);", choose), 1, 0, 2);
    expectCost(ofBody("choose(true, 2.0, s * s);", choose), 1, 0, 0);
}

TEST(ShaderCost, OfLoopsIsThatOfTheirSteps)
{
    expectCost(ofBody("for (int i = 0; i < 4; ++i) s * s;"), 4, 0, 0);
    expectCost(ofBody("for (int i = 1; i < n; ++i) { lights[3 * i + 1].rgb * s; }", "", {{"n", 6}}),
               15, 0, 0);
    expectCost(
        ofBody("for (int i = 0; i < n; ++i) for (int k = 0; k < 2; ++k) s + s;", "", {{"n", 0}}), 0,
        0, 0);
    EXPECT_THROW(ofBody("for (int i = 0; i < unknown; ++i) s * s;"), Error);
}

TEST(ShaderCost, CountsFetchesBySampler)
{
    const ShaderCost cost = ofBody(
        "for (int i = 0; i < 3; ++i) { vec3 a = textureLod(map, u.xy, 0.0).rgb * s; }\n"
        "    twice(other);",
        "vec4 twice(sampler2D given)\n{\n    return FBRDF_TEXTURE2(given, u.xy) + "
        "FBRDF_TEXTURE2(given, v.xy);\n}\n");
    EXPECT_EQ(cost.fetches.at("map"), 3.0);
    EXPECT_EQ(cost.fetches.at("other"), 2.0);
    EXPECT_EQ(cost.fetches.size(), 2u);
    expectCost(cost, 9, 4, 0);
}

TEST(ShaderCost, ReadsStructsOverloadsAndOutParameters)
{
    expectCost(ofBody("Pair p = both(u); s * p.a; v * p.b; one(s); one(u);",
                      "struct Pair {\n    float a;\n    vec3 b;\n};\n"
                      "Pair both(vec3 x)\n{\n    return Pair(x.x * x.y, x);\n}\n"
                      "float one(float x) { return x * x; }\nfloat one(vec3 x) { return dot(x, x); "
                      "}\n"),
               1 + 1 + 3 + 1 + 3, 2, 0);
}

TEST(ShaderCost, RefusesWhatItDoesNotKnow)
{
    EXPECT_THROW(ofBody("mystery(s);"), Error);
    EXPECT_THROW(ofBody("s * (s"), Error);
    EXPECT_THROW(costOf("uniform float s;\n", {}), Error);
    EXPECT_THROW(costOf("void main() {", {}), Error);
}

ShaderCost perLight(const std::string& text)
{
    const auto cost = [&](double lights) { return costOf(text, {{"fbrdfLightCount", lights}}); };
    ShaderCost more = cost(3), result;
    result += more;
    result += cost(2) * -1.0;
    return result;
}

// h.h three products, its root, and so on: the loop of ggx.glsl by hand, peerBrdf and what every
// peer's light costs.
TEST(ShaderCost, OfGgxIsCountedByHand)
{
    const ShaderCost cost = perLight(peerFragmentSource(ggxPeer(), 8));
    // fbrdfToLight 3 + 3 + 1 + 3, dot(n, wi) 3, window 2 (ratio, ratio^2) + 1, its product 1, cone
    // 3 + 1, the products of both, NoL and intensity 2 + 3, weight brdf 3; peerBrdf: dot(h, h) 3,
    // 1 / 1, LoH 1, slope 3 + 3 + 2, d 2 + 1 + 1, lightLength 3 + 3 + (2 + 2 + 1), reflection
    // 1 + 1 + 1 + 1 + 1, c2 c2 c 3, fresnel 3, x reflection 3.
    EXPECT_EQ(cost.multiplications,
              10 + 3 + 3 + 1 + 4 + 5 + 3 + 3 + 1 + 1 + 8 + 4 + 11 + 5 + 3 + 3 + 3);
    // inversesqrt of the light; 1 / dot, inversesqrt, sqrt, and the division.
    EXPECT_EQ(cost.specials, 1 + 4);
    EXPECT_TRUE(cost.fetches.empty());
}

// The loop of `single` over hdio: roots and exponentials are what a GPU does fewest of.
TEST(ShaderCost, OfTwoAnglesIsCountedByHand)
{
    const Form form = formHdio({12, 6, 6});
    PlanRequest request;
    request.lights = 8;
    const Plan plan = planPasses(form, request, Capabilities{});
    ASSERT_EQ(plan.passes.size(), 1u);
    const ShaderCost cost = perLight(
        fragmentSource(form, {{true, true}, {true, true}}, programSpec(plan.passes[0], 8), 330));
    // inversesqrt of the light and of |wi + wo|; of theta_h two roots, of theta_d and theta_i one;
    // exp2.
    EXPECT_EQ(cost.specials, 1 + 1 + 2 + 2 + 3);
    EXPECT_LT(cost.multiplyAdds(), 90.0);
}

TEST(ShaderCost, OfTheNetworkIsThatOfItsWeights)
{
    // 6 inputs, of which one is 0, and three layers; beside angles and light.
    const double weights = 5 * 21 + 21 * 21 + 21 * 3;
    const ShaderCost network = perLight(peerFragmentSource(nbrdfPeer(), 8)),
                     baked = perLight(peerFragmentSource(bakedNbrdfPeer(), 8));
    EXPECT_GT(network.multiplyAdds(), weights);
    EXPECT_LT(network.multiplyAdds(), weights + 100.0);
    EXPECT_EQ(network.multiplications, baked.multiplications);
}

TEST(ShaderCost, OfEveryPeerIsKnown)
{
    for (const ShaderPeer& peer : shaderPeers()) {
        const ShaderCost cost = perLight(peerFragmentSource(peer, 8));
        EXPECT_GT(cost.multiplyAdds(), 30.0) << peer.name;
        double fetches = 0.0;
        for (const auto& [sampler, count] : cost.fetches) fetches += count;
        EXPECT_EQ(fetches, peer.name == "merl" ? 1.0 : peer.passPerLight ? 3.0 : 0.0) << peer.name;
    }
}

}  // namespace
}  // namespace fbrdf::bench
