#include "bench/ShaderPeers.h"

#include <fbrdf/base/Number.h>

#include "bench/Materials.h"
#include "bench/Network.h"

#include <fbrdf/brdf/Half.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

#include <cmath>

namespace fbrdf {

std::string_view peerShader(std::string_view name);

namespace bench {
namespace {

std::string text(double value)
{
    return fixedText(value);
}

std::string colour(const Vec3d& c)
{
    return text(c.x) + "/" + text(c.y) + "/" + text(c.z);
}

std::string shaderOf(std::initializer_list<const char*> files)
{
    std::string all;
    for (const char* file : files) all += peerShader(file);
    return all;
}

// The parameters of Poulin and Fournier's model for a cloth-like surface.
constexpr double kHeight = 0.5, kSpacing = 1.25, kExponent = 40.0, kSpecular = 0.3;

constexpr int kThetaH = 90, kThetaD = 90, kPhiD = 180;

TextureImage merlImage()
{
    const Source ggx = openSource("ggx:alpha=" + text(kAlpha) + ",f0=" + colour(kF0));
    TextureImage image;
    image.size = {kPhiD, kThetaD, kThetaH};
    image.type = TexelType::half;
    for (int h = 0; h < kThetaH; ++h)
        for (int d = 0; d < kThetaD; ++d)
            for (int p = 0; p < kPhiD; ++p) {
                const double root = (h + 0.5) / kThetaH;
                auto pair = pairFromHalfDifference({root * root * kPi / 2, 0.0,
                                                    (d + 0.5) / kThetaD * kPi / 2,
                                                    (p + 0.5) / kPhiD * kPi});
                // Filtering also reads cells below the horizon: they repeat the value just above
                // it.
                pair.wi.z = std::max(pair.wi.z, 1e-3);
                pair.wo.z = std::max(pair.wo.z, 1e-3);
                const Vec3d f = ggx.evaluate(glm::normalize(pair.wo), glm::normalize(pair.wi));
                for (int c = 0; c < 3; ++c)
                    image.words.push_back(halfFromFloat(static_cast<float>(f[c])));
            }
    return image;
}

/// The table between its cell centres, interpolated as a texture unit does it.
Vec3d merlFiltered(const TextureImage& image, const Vec3d& wo, const Vec3d& wi)
{
    const HalfDifference a = halfDifferenceFromPair({wo, wi});
    const double at[3] = {(a.phi_d / kPi) * kPhiD - 0.5, a.theta_d / (kPi / 2) * kThetaD - 0.5,
                          std::sqrt(a.theta_h / (kPi / 2)) * kThetaH - 0.5};
    Vec3d sum(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        int texel[3] = {};
        for (int i = 0; i < 3; ++i) {
            const int upper = (corner >> i) & 1, size = image.size[static_cast<size_t>(i)];
            const double fraction = at[i] - std::floor(at[i]);
            const int k = static_cast<int>(std::floor(at[i])) + upper;
            weight *= upper ? fraction : 1.0 - fraction;
            texel[i] = i == 0 ? ((k % size) + size) % size : std::clamp(k, 0, size - 1);
        }
        const size_t index =
            3 * (static_cast<size_t>(texel[2] * kThetaD + texel[1]) * kPhiD + size_t(texel[0]));
        for (size_t c = 0; c < 3; ++c)
            sum[static_cast<int>(c)] += weight * double(floatFromHalf(image.words[index + c]));
    }
    return sum;
}

PeerMap factorMap(const Material& material, const std::string& sampler, const std::string& name)
{
    for (const fbrdf::Table& table : material.tables)
        if (table.name == name) return {sampler, textureImage(table, {}), false};
    return {};
}

}  // namespace

ShaderPeer ggxPeer()
{
    const auto vec = [](const Vec3d& v) { return glm::vec4(Vec3f(v), 0.0f); };
    const std::string spec = "ggx:alpha_x=" + text(kAlpha) + ",alpha_y=" + text(kAlphaAcross) +
                             ",f0=" + colour(kF0) + ",kd=" + colour(kDiffuse);
    return {
        "ggx",
        "GGX, anisotropic, analytic",
        shaderOf({"ggx.glsl"}),
        {{kAlpha, kAlphaAcross, 1.0 / kAlpha, 1.0 / kAlphaAcross}, vec(kF0), vec(kDiffuse / kPi)},
        {},
        openSource(spec).evaluate,
        false};
}

ShaderPeer merlPeer()
{
    PeerMap map{"peerTable", merlImage(), true};
    return {"merl",
            "MERL table of 90 x 90 x 180, RGB half, 3D texture, linear filter",
            shaderOf({"half_difference.glsl", "merl.glsl"}),
            {},
            {map},
            [image = map.image](const Vec3d& wo, const Vec3d& wi) {
                return merlFiltered(image, wo, wi);
            },
            false};
}

ShaderPeer nbrdfPeer()
{
    const std::vector<float> weights = networkWeights();
    std::vector<glm::vec4> packed((weights.size() + 3) / 4, glm::vec4(0.0f));
    for (size_t i = 0; i < weights.size(); ++i) packed[i / 4][static_cast<int>(i % 4)] = weights[i];
    return {
        "nbrdf",
        "NBRDF network of 6-21-21-3, unrolled, weights in uniforms",
        shaderOf({"half_difference.glsl"}) + networkShader(),
        packed,
        {},
        [weights](const Vec3d& wo, const Vec3d& wi) { return evaluateNetwork(weights, wo, wi); },
        false};
}

ShaderPeer bakedNbrdfPeer()
{
    ShaderPeer peer = nbrdfPeer();
    peer.name = "nbrdf-baked";
    peer.description = "the same, weights as constants: a program a material";
    peer.shader = shaderOf({"half_difference.glsl"}) + bakedNetworkShader(networkWeights());
    peer.parameters.clear();
    return peer;
}

ShaderPeer poulinFournierPeer()
{
    const std::string spec = "poulin-fournier:height=" + text(kHeight) +
                             ",spacing=" + text(kSpacing) + ",n=" + text(kExponent) +
                             ",kd=" + colour(kDiffuse) + ",ks=" + text(kSpecular);
    const double halfArc = std::acos(1.0 - kHeight), halfWidth = std::sin(halfArc),
                 period = 2.0 * halfWidth * kSpacing, n = kExponent;
    // Blinn-Phong's albedo at normal incidence: (n + 2)(n + 4) / (8 pi (2^(-n/2) + n)).
    const double norm = (n + 2.0) * (n + 4.0) / (8.0 * kPi * (std::exp2(-n / 2.0) + n));
    const Vec3d diffuse = kDiffuse / kPi;
    return {"poulin-fournier",
            "parallel cylinders, 16-point quadrature",
            shaderOf({"poulin_fournier.glsl"}),
            {{halfArc, period, 1.0 - kHeight, period - 2.0 * halfWidth},
             {diffuse.x, diffuse.y, diffuse.z, n},
             glm::vec4(glm::vec3(static_cast<float>(kSpecular * norm)), 0.0f)},
            {},
            openSource(spec).evaluate,
            false};
}

ShaderPeer multipassPeer()
{
    const Material material = benchMaterial("pqp");
    const PeerMap p = factorMap(material, "peerMapP", "p"),
                  q = factorMap(material, "peerMapQ", "q");
    const auto size = static_cast<float>(p.image.size[0]), radius = 0.5f * (size - 1.0f);
    return {"multipass-osgfx",
            "pqp, one additive pass a light with all three look-ups, after a black one",
            shaderOf({"factored.glsl"}),
            {{p.image.lower, size},
             {p.image.extent, radius},
             {q.image.lower, size},
             {q.image.extent, radius},
             {material.scales[0], 0.0f}},
            {p, q},
            [material](const Vec3d& wo, const Vec3d& wi) { return evaluate(material, wo, wi); },
            true};
}

std::vector<ShaderPeer> shaderPeers()
{
    return {ggxPeer(),        merlPeer(),           nbrdfPeer(),
            bakedNbrdfPeer(), poulinFournierPeer(), multipassPeer()};
}

}  // namespace bench
}  // namespace fbrdf
