// Network.h - the network of Sztrajman, Rainer, Ritschel, Weyrich 2021, "Neural BRDF Representation
// and Importance Sampling": f = exp(relu(relu(x W1 + b1) W2 + b2) W3 + b3) - 1, x = (h, d) in the
// frame with phi_h = 0. Weights in the order of the published files: W1[6][21] b1[21] W2[21][21]
// b2[21] W3[21][3] b3[3].
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

constexpr int kNetworkWeights = 675;

/// Random weights of the size that trained ones have; their values do not change the cost of the
/// network. Deterministic.
std::vector<float> networkWeights();

/// peerView and peerBrdf, every loop unrolled, for use after half_difference.glsl. Weights come
/// from peerParameters, each read once per fragment, because llvmpipe reads a uniform in a loop
/// anew for each use.
std::string networkShader();

/// The same with the weights as constants: faster, but every material needs its own program.
std::string bakedNetworkShader(const std::vector<float>& weights);

/// f of the network, 0 where it is negative, in double.
Vec3d evaluateNetwork(const std::vector<float>& weights, const Vec3d& wo, const Vec3d& wi);

}  // namespace fbrdf::bench
