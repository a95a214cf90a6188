#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/brdf/LobeSampling.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// All numbers here have been chosen so that the variance on the networks of docs/benchmarks.md is
// least, above all where it is nearest to that of the best GGX (fbrdf bench-fit --sampling).
//
// The cosine gets a tenth more than its weight, within these bounds of the whole, so that f over
// the density stays bounded where lobes are narrower than the material's own tail.
constexpr double kMoreCosine = 0.1, kLeastCosine = 0.005, kMostCosine = 0.05;
// A highlight is cos theta_d times as wide across the plane of incidence as along it, since wi
// turns by that much less when h does; the lobe that is fitted to it has a width in between. These
// are exponents of the cosine for the narrowest lobes, and less for wider ones. At level 0 a lobe
// stands for highlights that are narrower than any.
constexpr double kAlong = 0.7, kAcross = 0.5, kWider = 0.005;
constexpr double kNarrowestAlong = 0.45, kNarrowestAcross = 0.5, kNarrowest = 0.8;
constexpr double kLeastHalfCosine = 0.01;

template <class T>
T meanOf(const Vec3<T>& colour)
{
    return (colour.x + colour.y + colour.z) / T(3);
}

/// Widths along and across the plane of incidence. level: whole; halfCosine: of the angle between
/// wo and the half vector of wo and the axis.
template <class T>
Vec2<T> sampledWidths(T level, T halfCosine)
{
    const bool narrowest = level < T(0.5);
    const T fade = T(1) - level / T(kCosineLevel);
    const T along = narrowest ? T(kNarrowestAlong) : T(kAlong) * fade,
            across = narrowest ? T(kNarrowestAcross) : T(kAcross) * fade;
    const T width =
        std::exp2(level - T(kCosineLevel)) * (narrowest ? T(kNarrowest) : T(1) - T(kWider) * level);
    return {width * std::pow(halfCosine, -along), width * std::pow(halfCosine, across)};
}

/// The frame of a lobe; any across where wo is its axis.
template <class T>
std::array<Vec3<T>, 3> partAxes(const Vec3<T>& wo, const Vec3<T>& axis)
{
    const Vec3<T> across = glm::cross(wo, axis);
    const T square = glm::dot(across, across);
    // An angle of 1e-4, whose direction floats still know.
    const Vec3<T> y = square > T(1e-8) ? across / std::sqrt(square) : axesAbout(axis)[1];
    return {glm::cross(y, axis), y, axis};
}

/// 1/sr of a cosine about z stretched by diag(x, y, 1) (Heitz et al. 2016, Eq. 1); w: unit.
template <class T>
T stretchedDensity(const Vec2<T>& widths, const Vec3<T>& w)
{
    if (!(w.z > T(0))) return T(0);
    const T x = w.x / widths.x, y = w.y / widths.y, norm = x * x + y * y + w.z * w.z;
    return w.z / (T(kPi) * widths.x * widths.y * norm * norm);
}

}  // namespace

template <class T>
LobeMixture<T> lobeMixture(const LobeTable& table, const Vec3<T>& wo)
{
    const LobeSum<T> sum = lobesAt(table, wo);
    LobeMixture<T> mixture;
    mixture.count = sum.lobes;
    T total = meanOf(sum.cosine);
    for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) total += meanOf(sum.weight[k]);
    // Black: any density will do.
    const T scale = total > T(0) ? T(1) / total : T(0);
    const T cosine = total > T(0) ? scale * meanOf(sum.cosine) : T(1);
    const T more = std::clamp(T(kMoreCosine) * cosine, T(kLeastCosine), T(kMostCosine));
    mixture.cosine = more + (T(1) - more) * cosine;
    for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) {
        auto& part = mixture.parts[k];
        const T level = std::clamp(sum.level[k], T(0), T(kCosineLevel));
        const T lower = std::min(std::floor(level), T(kCosineLevel - 1));
        const T halfCosine =
            std::max(T(kLeastHalfCosine),
                     std::sqrt(std::max(T(0), T(0.5) + T(0.5) * glm::dot(wo, sum.axis[k]))));
        part.axes = partAxes(wo, sum.axis[k]);
        part.widths = {sampledWidths(lower, halfCosine), sampledWidths(lower + T(1), halfCosine)};
        const T share = (T(1) - more) * scale * meanOf(sum.weight[k]);
        part.shares = {share * (T(1) - (level - lower)), share * (level - lower)};
    }
    return mixture;
}

template <class T>
SampledDirection<T> sampleMixture(const LobeMixture<T>& mixture, const Vec2<T>& u)
{
    // The first number chooses a cosine; what is left of it is again even in [0, 1).
    T left = u.x, share = mixture.cosine;
    std::array<Vec3<T>, 3> axes{Vec3<T>(T(1), T(0), T(0)), Vec3<T>(T(0), T(1), T(0)),
                                Vec3<T>(T(0), T(0), T(1))};
    Vec2<T> widths(T(1));
    for (size_t k = 0; k < static_cast<size_t>(mixture.count); ++k)
        for (size_t i = 0; i < 2; ++i)
            if (left >= share && mixture.parts[k].shares[i] > T(0)) {
                left -= share;
                share = mixture.parts[k].shares[i];
                axes = mixture.parts[k].axes;
                widths = mixture.parts[k].widths[i];
            }
    const T radius2 = std::clamp(left / share, T(0), T(1));
    // A cosine-distributed direction, stretched (Heitz et al. 2016, section 3.1).
    const T radius = std::sqrt(radius2), azimuth = T(2.0 * kPi) * u.y;
    const Vec3<T> local = glm::normalize(Vec3<T>(widths.x * radius * std::cos(azimuth),
                                                 widths.y * radius * std::sin(azimuth),
                                                 std::sqrt(std::max(T(0), T(1) - radius2))));
    SampledDirection<T> sample;
    sample.wi = local.x * axes[0] + local.y * axes[1] + local.z * axes[2];
    sample.pdf = mixturePdf(mixture, sample.wi);
    return sample;
}

template <class T>
T mixturePdf(const LobeMixture<T>& mixture, const Vec3<T>& wi)
{
    T sum = mixture.cosine * std::max(T(0), wi.z) / T(kPi);
    for (size_t k = 0; k < static_cast<size_t>(mixture.count); ++k) {
        const auto& part = mixture.parts[k];
        const Vec3<T> local(glm::dot(part.axes[0], wi), glm::dot(part.axes[1], wi),
                            glm::dot(part.axes[2], wi));
        for (size_t i = 0; i < 2; ++i)
            sum += part.shares[i] * stretchedDensity(part.widths[i], local);
    }
    return sum;
}

template LobeMixture<float> lobeMixture(const LobeTable&, const Vec3<float>&);
template LobeMixture<double> lobeMixture(const LobeTable&, const Vec3<double>&);
template SampledDirection<float> sampleMixture(const LobeMixture<float>&, const Vec2<float>&);
template SampledDirection<double> sampleMixture(const LobeMixture<double>&, const Vec2<double>&);
template float mixturePdf(const LobeMixture<float>&, const Vec3<float>&);
template double mixturePdf(const LobeMixture<double>&, const Vec3<double>&);

}  // namespace fbrdf
