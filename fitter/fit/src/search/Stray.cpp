#include "search/Stray.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr size_t kProbes = 4096;
constexpr size_t kNearest = 8;
// Natural logarithms: a fifth is no other hue, and between samples a highlight may be three
// times as bright.
constexpr float kHueTolerance = 0.2f, kBrightTolerance = 1.1f;
constexpr float kMostStray = 2.0f;  // black in a channel, or bright: more is not worse
constexpr float kDarkest = std::numeric_limits<float>::min();
constexpr float kRestraintWeight = 0.1f;  // beside samples, which count 1

float brightest(const Vec3f& f)
{
    return std::max({f.x, f.y, f.z});
}

// The direction turned about the normal so that `reference` has the azimuth 0.
Vec3f turned(const Vec3f& direction, const Vec3f& reference)
{
    const float length = std::hypot(reference.x, reference.y);
    if (length == 0.0f) return direction;
    const float c = reference.x / length, s = reference.y / length;
    return {c * direction.x + s * direction.y, std::abs(c * direction.y - s * direction.x),
            direction.z};
}

using Pair = std::array<Vec3f, 2>;

// A pair in the frame in which two that are the same but for a rotation, or for its mirror image,
// are equal.
Pair pairOf(const Sample& sample, bool isotropic)
{
    if (!isotropic) return {sample.wi, sample.wo};
    return {turned(sample.wi, sample.wi), turned(sample.wo, sample.wi)};
}

float squaredDistance(const Pair& a, const Pair& b)
{
    const Vec3f i = a[0] - b[0], o = a[1] - b[1];
    return glm::dot(i, i) + glm::dot(o, o);
}

/// The places of the nearest samples to one pair, nearest first.
class Nearest {
public:
    explicit Nearest(const Pair& pair) : pair_(pair) { distance_.fill(kFar); }

    void offer(const Pair& other, size_t place)
    {
        const float distance = squaredDistance(pair_, other);
        if (distance >= distance_.back()) return;
        size_t at = kNearest - 1;
        for (; at > 0 && distance_[at - 1] > distance; --at) {
            distance_[at] = distance_[at - 1];
            place_[at] = place_[at - 1];
        }
        distance_[at] = distance;
        place_[at] = place;
    }

    template <class Visit>
    void forEach(const Visit& visit) const
    {
        for (size_t k = 0; k < kNearest && distance_[k] < kFar; ++k) visit(place_[k]);
    }

private:
    static constexpr float kFar = std::numeric_limits<float>::max();
    Pair pair_;
    std::array<float, kNearest> distance_{};
    std::array<size_t, kNearest> place_{};
};

}  // namespace

Stray::Stray(const std::vector<Sample>& samples, const Vec3f& floor, bool isotropic, int threads)
{
    constexpr float kAnything = -std::numeric_limits<float>::max();
    std::vector<Pair> pairs;
    std::vector<const Sample*> lit;
    for (const Sample& s : samples) {
        if (!(s.f.x > floor.x || s.f.y > floor.y || s.f.z > floor.z)) continue;
        pairs.push_back(pairOf(s, isotropic));
        lit.push_back(&s);
    }
    if (lit.empty()) return;
    for (const auto& pair : uniformPairs(kProbes, 0))
        probes_.push_back({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(0.0f), kRestraintWeight});
    // A few scans of an anisotropic surface miss its highlights, which are lines: their neighbours
    // say nothing of how bright they are.
    const float darkest = isotropic ? kAnything : std::numeric_limits<float>::max();
    const Range none{Vec3f(0.0f), Vec3f(-kMostStray - kHueTolerance), darkest};
    ranges_.assign(probes_.size(), none);
    parallelFor(probes_.size(), threads, [&](size_t p) {
        Nearest nearest(pairOf(probes_[p], isotropic));
        for (size_t i = 0; i < pairs.size(); ++i) nearest.offer(pairs[i], i);
        nearest.forEach([&](size_t place) {
            Range& range = ranges_[p];
            const Vec3f& f = lit[place]->f;
            range.brightest = std::max(range.brightest, std::log(brightest(f)));
            for (int c = 0; c < 3; ++c) {
                const float hue = std::log(std::max(f[c], floor[c]) / brightest(f));
                range.upper[c] = std::max(range.upper[c], hue);
                range.lower[c] = std::min(range.lower[c], f[c] > floor[c] ? hue : kAnything);
            }
        });
    });
}

Stray::Way Stray::wayOut(const Range& range, const Vec3f& value)
{
    const float most = brightest(value);
    float stray = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const float hue = std::log(std::max(value[c] / most, std::exp(-kMostStray * 2)));
        stray = std::max(
            {stray, hue - range.upper[c] - kHueTolerance, range.lower[c] - hue - kHueTolerance});
    }
    const float above = std::log(most) - range.brightest - kBrightTolerance;
    return {std::min(stray, kMostStray), std::clamp(above, 0.0f, kMostStray)};
}

// The logarithm of the brightest channel is free up to its bound. The sum of the ways that the
// channels go is least where one of them stays, at a bound of its hue.
Vec3f Stray::nearestWithin(const Range& range, const Vec3f& value)
{
    const Vec3f own(std::log(std::max(value.x, kDarkest)), std::log(std::max(value.y, kDarkest)),
                    std::log(std::max(value.z, kDarkest)));
    Vec3f nearest = own;
    float least = std::numeric_limits<float>::max();
    const auto offer = [&](float most) {
        most = std::min(most, range.brightest + kBrightTolerance);
        Vec3f to;
        float way = 0.0f;
        for (int c = 0; c < 3; ++c) {
            to[c] = std::clamp(own[c], most + range.lower[c], most + range.upper[c]);
            way += std::abs(to[c] - own[c]);
        }
        if (way < least) {
            least = way;
            nearest = to;
        }
    };
    for (int c = 0; c < 3; ++c) {
        offer(own[c]);
        offer(own[c] - range.upper[c]);
        if (range.lower[c] > std::log(kDarkest)) offer(own[c] - range.lower[c]);
    }
    return {std::exp(nearest.x), std::exp(nearest.y), std::exp(nearest.z)};
}

Stray::Mean Stray::of(const Material& material, int threads) const
{
    const std::vector<Vec3f> values = evaluateAt(material, probes_, threads);
    Mean mean;
    double weights = 0.0;
    for (size_t p = 0; p < values.size(); ++p) {
        const float most = brightest(values[p]);
        if (!(most > 0.0f) || !std::isfinite(most)) continue;
        const auto weight = static_cast<double>(std::cbrt(most * probes_[p].wi.z));
        const Way way = wayOut(ranges_[p], values[p]);
        mean.hue += weight * static_cast<double>(way.hue);
        mean.brightness += weight * static_cast<double>(way.brightness);
        weights += weight;
    }
    if (weights == 0.0) return {};
    return {mean.hue / weights, mean.brightness / weights};
}

std::vector<Sample> Stray::restraints(const Material& material, int threads) const
{
    const std::vector<Vec3f> values = evaluateAt(material, probes_, threads);
    std::vector<Sample> restraints;
    for (size_t p = 0; p < values.size(); ++p) {
        const float most = brightest(values[p]);
        if (!(most > 0.0f) || !std::isfinite(most)) continue;
        const Way way = wayOut(ranges_[p], values[p]);
        if (way.hue == 0.0f && way.brightness == 0.0f) continue;
        restraints.push_back(probes_[p]);
        restraints.back().f = nearestWithin(ranges_[p], values[p]);
    }
    return restraints;
}

}  // namespace fbrdf
