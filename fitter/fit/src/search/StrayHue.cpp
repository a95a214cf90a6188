#include "search/StrayHue.h"

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
constexpr float kTolerance = 0.2f;  // natural logarithm: a fifth is no other hue
constexpr float kMostStray = 2.0f;  // black in a channel, or bright: more is not worse

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

StrayHue::StrayHue(const std::vector<Sample>& samples, const Vec3f& floor, bool isotropic,
                   int threads)
{
    constexpr float kAnything = -std::numeric_limits<float>::max();
    std::vector<Pair> pairs;
    std::vector<const Sample*> lit;
    for (const Sample& s : samples) {
        if (!(s.f.x > floor.x || s.f.y > floor.y || s.f.z > floor.z)) continue;
        pairs.push_back(pairOf(s, isotropic));
        lit.push_back(&s);
    }
    for (const auto& pair : uniformPairs(kProbes, 0))
        probes_.push_back({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(0.0f)});
    ranges_.assign(probes_.size(), {Vec3f(0.0f), Vec3f(-kMostStray - kTolerance)});
    parallelFor(probes_.size(), threads, [&](size_t p) {
        Nearest nearest(pairOf(probes_[p], isotropic));
        for (size_t i = 0; i < pairs.size(); ++i) nearest.offer(pairs[i], i);
        nearest.forEach([&](size_t place) {
            const Vec3f& f = lit[place]->f;
            for (int c = 0; c < 3; ++c) {
                const float hue = std::log(std::max(f[c], floor[c]) / brightest(f));
                ranges_[p].upper[c] = std::max(ranges_[p].upper[c], hue);
                ranges_[p].lower[c] =
                    std::min(ranges_[p].lower[c], f[c] > floor[c] ? hue : kAnything);
            }
        });
    });
}

double StrayHue::of(const Material& material, int threads) const
{
    const std::vector<Vec3f> values = evaluateAt(material, probes_, threads);
    double sum = 0.0, weights = 0.0;
    for (size_t p = 0; p < values.size(); ++p) {
        const float most = brightest(values[p]);
        if (!(most > 0.0f) || !std::isfinite(most)) continue;
        float stray = 0.0f;
        for (int c = 0; c < 3; ++c) {
            const float hue = std::log(std::max(values[p][c] / most, std::exp(-kMostStray * 2)));
            stray = std::max({stray, hue - ranges_[p].upper[c] - kTolerance,
                              ranges_[p].lower[c] - hue - kTolerance});
        }
        const auto weight = static_cast<double>(std::cbrt(most * probes_[p].wi.z));
        sum += weight * static_cast<double>(std::min(stray, kMostStray));
        weights += weight;
    }
    return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace fbrdf
