#include "data/Symmetry.h"

#include <fbrdf/base/Parallel.h>
#include <fbrdf/base/SplitMix.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kPairs = 512;
constexpr size_t kPlace = 17;  // of the first in the sequence

/// The uniform test set has as many: isotropic is what is so wherever errors are measured.
constexpr size_t kAllPairs = 65536, kPairsAtOnce = 4096;

// The difference between f of a pair and f of the pair turned about the normal, relative to f.
double changeByTurning(const Source& source, const DirectionPair<double>& pair)
{
    constexpr double kTiny = 1e-6;  // 1/sr: what is darker is not compared
    HalfDifference turned = halfDifferenceFromPair(pair);
    turned.phi_h += 1.0;
    const auto other = pairFromHalfDifference(turned);
    const Vec3d a = source.evaluate(pair.wo, pair.wi), b = source.evaluate(other.wo, other.wi);
    return glm::length(a - b) / (a.x + a.y + a.z + kTiny);
}

}  // namespace

bool isIsotropicSource(const Source& source)
{
    if (source.isotropic) return true;
    if (!source.evaluate) return false;
    constexpr double kSame = 1e-3;  // relative; below what any material of ours resolves
    const auto pairs = uniformPairs(kAllPairs, kPlace);
    std::vector<double> changes(kPairsAtOnce);
    for (size_t first = 0; first < pairs.size(); first += changes.size()) {
        parallelFor(changes.size(), 0,
                    [&](size_t i) { changes[i] = changeByTurning(source, pairs[first + i]); });
        if (*std::max_element(changes.begin(), changes.end()) >= kSame) return false;
    }
    return true;
}

bool isReciprocalSource(const Source& source, double within)
{
    return source.evaluate && medianReciprocityError(source.evaluate, 1, kPairs) < within;
}

bool isMirrorSymmetricSource(const Source& source)
{
    constexpr double kSame = 5e-2;
    return !source.evaluate || medianMirrorError(source.evaluate, 1, kPairs) < kSame;
}

std::vector<Sample> turned(std::vector<Sample> samples)
{
    constexpr double kAll = 18446744073709551616.0;  // 2^64
    for (size_t i = 0; i < samples.size(); ++i) {
        const auto angle =
            static_cast<float>(2.0 * kPi * (static_cast<double>(splitMix64(i)) / kAll));
        const float c = std::cos(angle), s = std::sin(angle);
        for (Vec3f* v : {&samples[i].wo, &samples[i].wi})
            *v = {c * v->x - s * v->y, s * v->x + c * v->y, v->z};
    }
    return samples;
}

}  // namespace fbrdf
