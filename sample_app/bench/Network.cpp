#include "bench/Network.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace fbrdf::bench {
namespace {

constexpr int kInputs = 6, kHidden = 21, kOutputs = 3;

struct LayerShape {
    int in, out, first;  ///< first: index of its weights
};
constexpr LayerShape kLayers[3] = {
    {kInputs, kHidden, 0},
    {kHidden, kHidden, (kInputs + 1) * kHidden},
    {kHidden, kOutputs, (kInputs + 1 + kHidden + 1) * kHidden},
};

std::vector<std::string> numbered(const std::string& name, int count)
{
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) names.push_back(name + std::to_string(i));
    return names;
}

/// One line for each output: to<j> = b[j] + from0 W[0][j] + ... `weights` writes a weight. Inputs
/// called "0" are left out.
std::string layerLines(const LayerShape& layer, const std::vector<std::string>& from,
                       const std::string& to, const std::vector<std::string>& weights)
{
    const auto weight = [&](int i, int j) {
        return weights[static_cast<size_t>(layer.first + i * layer.out + j)];
    };
    std::string text;
    for (int j = 0; j < layer.out; ++j) {
        std::string sum = weight(layer.in, j);
        for (int i = 0; i < layer.in; ++i)
            if (from[static_cast<size_t>(i)] != "0")
                sum += " + " + from[static_cast<size_t>(i)] + " * " + weight(i, j);
        const bool rectified = layer.out == kHidden;
        text += "    float " + to + std::to_string(j) + " = " +
                (rectified ? "max(" + sum + ", 0.0)" : sum) + ";\n";
    }
    return text;
}

std::string brdfText(const std::vector<std::string>& weights)
{
    return "vec3 peerBrdf(vec3 wi, float NoL)\n{\n"
           "    PeerAngles angles = peerAngles(wi, NoL);\n" +
           layerLines(kLayers[0],
                      {"angles.sinTheta_h", "0", "angles.cosTheta_h", "angles.d.x", "angles.d.y",
                       "angles.d.z"},
                      "a", weights) +
           layerLines(kLayers[1], numbered("a", kHidden), "b", weights) +
           layerLines(kLayers[2], numbered("b", kHidden), "c", weights) +
           "    return max(exp(min(vec3(c0, c1, c2), 80.0)) - 1.0, 0.0);\n}\n";
}

std::string viewText(const std::string& more)
{
    return "void peerView(FbrdfShadingFrame frame, vec3 wo, float NoV)\n{\n"
           "    peerRemember(frame.n, wo, NoV);\n" +
           more + "}\n\n";
}

template <size_t Out>
std::array<double, Out> layerOf(const std::vector<float>& weights, const LayerShape& shape,
                                const double* in, bool rectified)
{
    std::array<double, Out> out{};
    const float* w = weights.data() + shape.first;
    const auto ins = static_cast<size_t>(shape.in);
    for (size_t j = 0; j < Out; ++j) {
        out[j] = static_cast<double>(w[ins * Out + j]);
        for (size_t i = 0; i < ins; ++i) out[j] += in[i] * static_cast<double>(w[i * Out + j]);
        if (rectified) out[j] = std::max(out[j], 0.0);
    }
    return out;
}

}  // namespace

std::vector<float> networkWeights()
{
    std::mt19937 random(3);
    std::vector<float> weights;
    // Weights are uniform in +-sqrt(3 / inputs), so that values keep their size from layer to
    // layer.
    for (const LayerShape& layer : kLayers) {
        const float bound = std::sqrt(3.0f / static_cast<float>(layer.in));
        for (int i = 0; i < (layer.in + 1) * layer.out; ++i)
            weights.push_back(bound * (2.0f * static_cast<float>(random()) / 4294967296.0f - 1.0f));
    }
    return weights;
}

std::string networkShader()
{
    const std::vector<std::string> names = numbered("w", kNetworkWeights);
    std::string declared, read;
    for (size_t i = 0; i < names.size(); ++i) {
        declared += "float " + names[i] + ";\n";
        read += "    " + names[i] + " = peerParameters[" + std::to_string(i / 4) + "]." +
                "xyzw"[i % 4] + ";\n";
    }
    return "uniform vec4 peerParameters[" + std::to_string((kNetworkWeights + 3) / 4) + "];\n" +
           declared + viewText(read) + brdfText(names);
}

std::string bakedNetworkShader(const std::vector<float>& weights)
{
    std::vector<std::string> numbers;
    for (const float weight : weights) numbers.push_back(fmt::format("({:.9e})", weight));
    return viewText("") + brdfText(numbers);
}

Vec3d evaluateNetwork(const std::vector<float>& weights, const Vec3d& wo, const Vec3d& wi)
{
    const HalfDifference a = halfDifferenceFromPair({wo, wi});
    const Vec3d d = directionFromAngles(a.theta_d, a.phi_d);
    const double in[kInputs] = {std::sin(a.theta_h), 0.0, std::cos(a.theta_h), d.x, d.y, d.z};
    const auto first = layerOf<kHidden>(weights, kLayers[0], in, true);
    const auto second = layerOf<kHidden>(weights, kLayers[1], first.data(), true);
    const auto last = layerOf<kOutputs>(weights, kLayers[2], second.data(), false);
    return glm::max(Vec3d(std::expm1(last[0]), std::expm1(last[1]), std::expm1(last[2])),
                    Vec3d(0.0));
}

}  // namespace fbrdf::bench
