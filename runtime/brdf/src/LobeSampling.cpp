#include <fbrdf/brdf/AxesAbout.h>
#include <fbrdf/brdf/LobeSampling.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// The cosine gets at least this share, so that f over the density stays bounded where lobes are
// narrower than the material's own tail.
constexpr double kLeastCosine = 0.05;

/// One stretched cosine of the mixture.
template <class T>
struct Component {
    Vec3<T> axis{T(0)};
    T width = T(1), share = T(0);
};

/// A lobe between two levels is two of them.
template <class T>
struct Mixture {
    std::array<Component<T>, 2 * kMostLobes + 1> components{};
    size_t count = 0;
};

template <class T>
T meanOf(const Vec3<T>& colour)
{
    return (colour.x + colour.y + colour.z) / T(3);
}

template <class T>
Mixture<T> mixtureAt(const LobeTable& table, const Vec3<T>& wo)
{
    const LobeSum<T> sum = lobesAt(table, wo);
    T total = meanOf(sum.cosine);
    for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) total += meanOf(sum.weight[k]);
    Mixture<T> mixture;
    const auto add = [&](const Vec3<T>& axis, T width, T share) {
        if (share > T(0)) mixture.components[mixture.count++] = {axis, width, share};
    };
    // Black: any density will do.
    const T scale = total > T(0) ? T(1.0 - kLeastCosine) / total : T(0);
    const T cosine = total > T(0) ? T(kLeastCosine) + scale * meanOf(sum.cosine) : T(1);
    add(Vec3<T>(T(0), T(0), T(1)), T(1), cosine);
    for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) {
        const T level = std::clamp(sum.level[k], T(0), T(kCosineLevel));
        const T lower = std::min(std::floor(level), T(kCosineLevel - 1));
        const T share = scale * meanOf(sum.weight[k]), fraction = level - lower;
        const T width = std::exp2(lower - T(kCosineLevel));
        add(sum.axis[k], width, share * (T(1) - fraction));
        add(sum.axis[k], T(2) * width, share * fraction);
    }
    return mixture;
}

template <class T>
T density(const Component<T>& component, const Vec3<T>& wi)
{
    const T cosine = glm::dot(component.axis, wi);
    if (!(cosine > T(0))) return T(0);
    // 1 - cos^2 has no digits left near the axis of a narrow lobe.
    const Vec3<T> across = glm::cross(component.axis, wi);
    const T s2 = component.width * component.width;
    const T norm = s2 * cosine * cosine + glm::dot(across, across);
    return s2 * cosine / (T(kPi) * norm * norm);
}

template <class T>
T density(const Mixture<T>& mixture, const Vec3<T>& wi)
{
    T sum(0);
    for (size_t i = 0; i < mixture.count; ++i)
        sum += mixture.components[i].share * density(mixture.components[i], wi);
    return sum;
}

}  // namespace

template <class T>
SampledDirection<T> sampleLobes(const LobeTable& table, const Vec3<T>& wo, const Vec2<T>& u)
{
    const Mixture<T> mixture = mixtureAt(table, wo);
    // The first number chooses a component; what is left of it is again even in [0, 1).
    T left = u.x;
    size_t chosen = 0;
    while (chosen + 1 < mixture.count && left >= mixture.components[chosen].share)
        left -= mixture.components[chosen++].share;
    const Component<T>& component = mixture.components[chosen];
    const T radius2 = std::clamp(left / component.share, T(0), T(1));
    // A cosine-distributed direction, stretched (Heitz et al. 2016, section 3.1).
    const T radius = component.width * std::sqrt(radius2), azimuth = T(2.0 * kPi) * u.y;
    const Vec3<T> local =
        glm::normalize(Vec3<T>(radius * std::cos(azimuth), radius * std::sin(azimuth),
                               std::sqrt(std::max(T(0), T(1) - radius2))));
    SampledDirection<T> sample;
    const auto axes = axesAbout(component.axis);
    sample.wi = local.x * axes[0] + local.y * axes[1] + local.z * component.axis;
    sample.pdf = density(mixture, sample.wi);
    return sample;
}

template <class T>
T lobePdf(const LobeTable& table, const Vec3<T>& wo, const Vec3<T>& wi)
{
    return density(mixtureAt(table, wo), wi);
}

template SampledDirection<float> sampleLobes(const LobeTable&, const Vec3<float>&,
                                             const Vec2<float>&);
template SampledDirection<double> sampleLobes(const LobeTable&, const Vec3<double>&,
                                              const Vec2<double>&);
template float lobePdf(const LobeTable&, const Vec3<float>&, const Vec3<float>&);
template double lobePdf(const LobeTable&, const Vec3<double>&, const Vec3<double>&);

}  // namespace fbrdf
