// Fourier.cpp - isotropic BSDFs in splines of cosines and Fourier series of the azimuth: .bsdf of
// layerlab and the layer designer of Mitsuba, which pbrt-v3 reads as its "fourier" material (Jakob,
// d'Eon, Jakob, Marschner, "A Comprehensive Framework for Rendering Layered Materials", 2014).
// Binary, little endian: a head of 64 bytes ("SCATFUN" and 1; uint32 flags, cosines, coefficients,
// longest series, channels, bases, bytes of metadata, parameters, parameter values; float32 index
// of refraction below over above, two roughnesses, two unused); then float32 cosines mu, ascending
// from -1 to 1; a table mu x mu of float32 for sampling; mu x mu pairs of uint32, the first
// coefficient and the length of a series, that of mu_i fastest; float32 coefficients; metadata.
// mu_i is the cosine of the light's PROPAGATION, mu_o that of wo, and the azimuth that between
// both: 0 is the mirror direction, and reflection from above has mu_i below 0 and mu_o above.
// Series are f |mu_i|, interpolated by Catmull-Rom splines. Three channels are luminance, red and
// blue of linear Rec. 709, from which green follows. From the description in pbrt-v3
// (materials/fourier.cpp, core/reflection.cpp) and from the writer of layerlab (storage.cpp); no
// such file was at hand.
#include "Formats.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

namespace fbrdf {
namespace {

constexpr std::string_view kFourierMagic{"SCATFUN\x01", 8};
constexpr size_t kFourierHead = 64;
/// A table of more has more entries than a file of 48 GiB.
constexpr uint64_t kMostCosines = 65536;

struct FourierTable {
    std::vector<float> mu;
    std::vector<std::array<uint32_t, 2>> series;  ///< first coefficient and length, mu_i fastest
    std::vector<float> coefficients;
    size_t channels = 1;
};

/// The numbers of the head behind the magic.
struct FourierHead {
    enum Field : size_t {
        flags,
        cosines,
        coefficients,
        longest,
        channels,
        bases,
        metadataBytes,
        parameters
    };
    std::array<uint32_t, 8> fields{};

    uint64_t operator[](Field field) const { return fields[field]; }
};

template <class T>
void copyNumbers(const InputFile& file, size_t at, std::vector<T>& numbers)
{
    std::memcpy(numbers.data(), file.bytes().data() + at, numbers.size() * sizeof(T));
}

FourierHead readFourierHead(const InputFile& file)
{
    if (file.size() < kFourierHead)
        throw inputError(file, file.size(),
                         Found("the end of the file").expected("a head of 64 bytes"));
    FourierHead head;
    std::memcpy(head.fields.data(), file.bytes().data() + kFourierMagic.size(), sizeof head.fields);
    const auto require = [&](bool holds, FourierHead::Field field, const char* what,
                             const char* expected) {
        if (!holds)
            throw inputError(file, kFourierMagic.size() + 4 * size_t(field),
                             Found(std::to_string(head[field]) + " " + what).expected(expected));
    };
    require(head[FourierHead::flags] == 1, FourierHead::flags, "as flags",
            "1: a BSDF without harmonic extrapolation");
    require(head[FourierHead::cosines] >= 4 && head[FourierHead::cosines] <= kMostCosines,
            FourierHead::cosines, "cosines", "4 to 65536");
    require(head[FourierHead::channels] == 1 || head[FourierHead::channels] == 3,
            FourierHead::channels, "channels", "1 or 3");
    require(head[FourierHead::bases] == 1, FourierHead::bases, "bases",
            "1: no parameters from textures");
    require(head[FourierHead::parameters] == 0, FourierHead::parameters, "parameters",
            "0: none from textures");
    return head;
}

void requireFourierSize(const InputFile& file, const FourierHead& head)
{
    const uint64_t n = head[FourierHead::cosines];
    const uint64_t expected = kFourierHead + 4 * (n + 3 * n * n + head[FourierHead::coefficients]) +
                              head[FourierHead::metadataBytes];
    if (file.size() != expected)
        throw inputError(file, Found(std::to_string(file.size()) + " bytes")
                                   .expected(std::to_string(expected) + " by the head"));
}

void requireCosines(const InputFile& file, const std::vector<float>& mu)
{
    for (size_t i = 0; i < mu.size(); ++i)
        if (!(std::abs(mu[i]) <= 1.0f) || (i > 0 && mu[i] < mu[i - 1]))
            throw inputError(
                file, kFourierHead + 4 * i,
                Found("another order or range of cosines").expected("ascending ones from -1 to 1"));
}

void requireSeries(const InputFile& file, const FourierHead& head, const FourierTable& table)
{
    const size_t n = table.mu.size();
    const size_t at = kFourierHead + 4 * (n + n * n);
    for (size_t i = 0; i < table.series.size(); ++i) {
        const auto [first, length] = table.series[i];
        if (length > head[FourierHead::longest] ||
            first + uint64_t(length) * table.channels > table.coefficients.size())
            throw inputError(file, at + 8 * i,
                             Found("a series of " + std::to_string(length) + " from coefficient " +
                                   std::to_string(first))
                                 .expected("one within the file"));
    }
    const bool finite = std::all_of(table.coefficients.begin(), table.coefficients.end(),
                                    [](float a) { return std::isfinite(a); });
    if (!finite)
        throw inputError(file, Found("a coefficient that is not finite").expected("numbers"));
}

FourierTable readFourierTable(const InputFile& file)
{
    const FourierHead head = readFourierHead(file);
    requireFourierSize(file, head);
    FourierTable table;
    const size_t n = head[FourierHead::cosines];
    table.channels = head[FourierHead::channels];
    table.mu.resize(n);
    table.series.resize(n * n);
    table.coefficients.resize(head[FourierHead::coefficients]);
    copyNumbers(file, kFourierHead, table.mu);
    copyNumbers(file, kFourierHead + 4 * (n + n * n), table.series);
    copyNumbers(file, kFourierHead + 4 * (n + 3 * n * n), table.coefficients);
    requireCosines(file, table.mu);
    requireSeries(file, head, table);
    return table;
}

/// Weights of the four nodes from `first` on; those without a node are 0.
struct SplineWeights {
    std::ptrdiff_t first = 0;
    std::array<double, 4> weight{};
};

/// Cubic between the nodes around x whose slopes are those of the chords over their neighbours, or
/// of the interval itself at the ends.
SplineWeights catmullRom(const std::vector<float>& nodes, double x)
{
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, static_cast<float>(x));
    const size_t i = size_t(above - nodes.begin()) - 1;
    const double x0 = double(nodes[i]), width = double(nodes[i + 1]) - x0;
    SplineWeights result{std::ptrdiff_t(i) - 1, {0.0, 1.0, 0.0, 0.0}};
    if (!(width > 0.0)) return result;
    auto& w = result.weight;
    const double t = std::clamp((x - x0) / width, 0.0, 1.0), t2 = t * t, t3 = t2 * t;
    w[1] = 2.0 * t3 - 3.0 * t2 + 1.0;
    w[2] = 3.0 * t2 - 2.0 * t3;
    const bool before = i > 0, after = i + 2 < nodes.size();
    const double slope0 = (t3 - 2.0 * t2 + t) * width /
                          (before ? double(nodes[i + 1]) - double(nodes[i - 1]) : width);
    const double slope1 = (t3 - t2) * width / (after ? double(nodes[i + 2]) - x0 : width);
    w[before ? 0 : 1] -= slope0;
    w[2] += slope0;
    w[1] -= slope1;
    w[after ? 3 : 2] += slope1;
    return result;
}

/// Sum of a_k cos(k phi), by the recurrence of Chebyshev.
double cosineSeries(const float* a, size_t length, double cosPhi)
{
    double previous = cosPhi, current = 1.0, sum = 0.0;
    for (size_t k = 0; k < length; ++k) {
        sum += double(a[k]) * current;
        const double next = 2.0 * cosPhi * current - previous;
        previous = current;
        current = next;
    }
    return sum;
}

/// Adds one node's series of each channel.
void addSeries(const FourierTable& table, size_t node, double weight, double cosPhi, Vec3d& sum)
{
    const auto [first, length] = table.series[node];
    for (size_t c = 0; c < table.channels; ++c)
        sum[int(c)] +=
            weight * cosineSeries(table.coefficients.data() + first + c * length, length, cosPhi);
}

/// Cosine of the azimuth between the light's propagation and wo; 1 where one has none.
double cosAzimuthBetween(const Vec3d& wo, const Vec3d& wi)
{
    const double radii = std::hypot(wo.x, wo.y) * std::hypot(wi.x, wi.y);
    return radii > 0.0 ? std::clamp(-(wo.x * wi.x + wo.y * wi.y) / radii, -1.0, 1.0) : 1.0;
}

Vec3d evaluateFourier(const FourierTable& table, const Vec3d& wo, const Vec3d& wi)
{
    if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
    const SplineWeights in = catmullRom(table.mu, -wi.z), out = catmullRom(table.mu, wo.z);
    const double cosPhi = cosAzimuthBetween(wo, wi);
    Vec3d sum(0.0);
    for (size_t o = 0; o < 4; ++o)
        for (size_t i = 0; i < 4; ++i) {
            const double weight = in.weight[i] * out.weight[o];
            if (weight == 0.0) continue;
            const size_t row = size_t(out.first + std::ptrdiff_t(o));
            const size_t column = size_t(in.first + std::ptrdiff_t(i));
            addSeries(table, row * table.mu.size() + column, weight, cosPhi, sum);
        }
    Vec3d rgb(sum.x);
    // Green of the luminance 0.212671 R + 0.715160 G + 0.072169 B.
    if (table.channels == 3)
        rgb = {sum.y, (sum.x - 0.212671 * sum.y - 0.072169 * sum.z) / 0.715160, sum.z};
    return glm::max(rgb / wi.z, Vec3d(0.0));
}

}  // namespace

bool isFourier(const InputFile& file)
{
    return file.bytes().substr(0, kFourierMagic.size()) == kFourierMagic;
}

Source readFourier(const FileRequest& request)
{
    if (!isFourier(*request.file))
        throw inputError(*request.file, 0,
                         Found("another beginning").expected("'SCATFUN' and version 1"));
    const auto table = std::make_shared<const FourierTable>(readFourierTable(*request.file));
    const bool grey = table->channels == 1;
    Source source;
    source.isotropic = true;
    source.description = "Fourier BSDF, " + std::to_string(table->mu.size()) + " cosines, " +
                         (grey ? "one channel" : "linear RGB") + ", 1/sr";
    source.assumptions.emplace_back("the reflection of the upper side; transmission is not read");
    if (grey) source.assumptions.emplace_back("one channel as grey");
    source.evaluate = [table](const Vec3d& wo, const Vec3d& wi) {
        return evaluateFourier(*table, wo, wi);
    };
    return source;
}

}  // namespace fbrdf
