// Nbrdf.cpp - neural BRDFs (Sztrajman, Rainer, Ritschel, Weyrich 2021) as raw float32 weights.
// Little endian, one row of 675 weights a material: W1[6][21] b1[21] W2[21][21] b2[21] W3[21][3]
// b3[3], and f = exp(relu(relu(x W1 + b1) W2 + b2) W3 + b3) - 1 with x = (h, d), the half and
// difference vectors in Rusinkiewicz' frame with phi_h = 0 and d the light's. Values are in the
// units of what a net was trained on: those of BRDFRead.cpp for MERL materials, 1/sr for others;
// without the cosine. They may be slightly below 0, and are then 0 here; beyond 80 degrees from the
// normal nothing was trained. Layout from the README of the data set, network from the paper's
// code. FILE.f32#name or #row; the samples are the network on the MERL grid, taken
// all the way round phi_d: nothing makes a network reciprocal.
#include "Collection.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include "MerlGrid.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kLayerInputs = 6, kHidden = 21, kLayerOutputs = 3;
constexpr size_t kWeights = kLayerInputs * kHidden + kHidden + kHidden * kHidden + kHidden +
                            kHidden * kLayerOutputs + kLayerOutputs;
constexpr size_t kNetworkBytes = kWeights * sizeof(float);
static_assert(kWeights == 675, "the published size");

using Weights = std::array<double, kWeights>;

/// out = in W + b; returns what follows b.
template <size_t In, size_t Out>
const double* layer(const double* weights, const std::array<double, In>& in,
                    std::array<double, Out>& out)
{
    const double* bias = weights + In * Out;
    std::copy(bias, bias + Out, out.begin());
    for (size_t i = 0; i < In; ++i)
        for (size_t j = 0; j < Out; ++j) out[j] += in[i] * weights[i * Out + j];
    return bias + Out;
}

template <size_t N>
void rectify(std::array<double, N>& values)
{
    for (double& value : values) value = std::max(value, 0.0);
}

std::array<double, kLayerInputs> inputsOf(const DirectionPair<double>& pair)
{
    const auto [h, d] = halfDifferenceVectors(pair);
    return {h.x, h.y, h.z, d.x, d.y, d.z};
}

Vec3d runNetwork(const Weights& weights, const DirectionPair<double>& pair)
{
    constexpr double kLargestExponent = 80.0;  // exp of it still fits a float
    std::array<double, kHidden> first{}, second{};
    std::array<double, kLayerOutputs> last{};
    const double* next = layer(weights.data(), inputsOf(pair), first);
    rectify(first);
    next = layer(next, first, second);
    rectify(second);
    layer(next, second, last);
    Vec3d f;
    for (int c = 0; c < 3; ++c)
        f[c] = std::max(std::expm1(std::min(last[size_t(c)], kLargestExponent)), 0.0);
    return f;
}

Weights readWeights(const InputFile& file, size_t row)
{
    std::array<float, kWeights> stored{};
    std::memcpy(stored.data(), file.bytes().data() + row * kNetworkBytes, kNetworkBytes);
    Weights weights{};
    for (size_t i = 0; i < kWeights; ++i) {
        constexpr float kLargest = 1e6f;  // trained weights are below 1e2
        if (!(std::abs(stored[i]) < kLargest))
            throw inputError(
                file, row * kNetworkBytes + i * sizeof(float),
                Found(numberText(double(stored[i]))).expected("a weight of a network"));
        weights[i] = double(stored[i]);
    }
    return weights;
}

}  // namespace

bool isNbrdf(const InputFile& file)
{
    return file.extension() == "f32" && file.size() % kNetworkBytes == 0;
}

size_t nbrdfRows(const InputFile& file)
{
    return file.size() / kNetworkBytes;
}

Source readNbrdf(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (file.size() % kNetworkBytes != 0)
        throw inputError(
            file,
            Found(std::to_string(file.size()) + " bytes").expected("rows of 675 float32 weights"));
    const Chosen chosen = chosenMaterial(request, nbrdfRows(file));
    const auto weights = std::make_shared<const Weights>(readWeights(file, chosen.row));
    Source source;
    source.name = chosen.name;
    source.isotropic = true;
    source.description = "neural BRDF (Sztrajman et al. 2021), linear RGB, units of its data";
    source.evaluate = [weights](const Vec3d& wo, const Vec3d& wi) {
        if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
        return runNetwork(*weights, {wo, wi});
    };
    source.exact = true;
    source.stream = streamOnGrid(MerlGrid({90, 90, 180}, 2.0 * kPi), source.evaluate);
    return source;
}

}  // namespace fbrdf
