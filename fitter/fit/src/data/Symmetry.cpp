#include "data/Symmetry.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kPairs = 512;
constexpr size_t kPlace = 17;  // of the first in the sequence

}  // namespace

bool isIsotropicSource(const Source& source)
{
    if (source.isotropic) return true;
    if (!source.evaluate) return false;
    constexpr double kSame = 1e-3;  // relative; below what any material of ours resolves
    double largest = 0.0, difference = 0.0;
    for (const auto& pair : uniformPairs(kPairs, kPlace)) {
        HalfDifference turned = halfDifferenceFromPair(pair);
        turned.phi_h += 1.0;
        const auto other = pairFromHalfDifference(turned);
        const Vec3d a = source.evaluate(pair.wo, pair.wi), b = source.evaluate(other.wo, other.wi);
        largest = std::max(largest, a.x + a.y + a.z);
        difference = std::max(difference, glm::length(a - b) / (a.x + a.y + a.z + 1e-6));
    }
    return difference < kSame || largest == 0.0;
}

bool isReciprocalSource(const Source& source)
{
    if (!source.evaluate) return false;
    constexpr double kSame = 1e-2;  // relative
    std::vector<double> differences;
    for (const auto& pair : uniformPairs(kPairs, kPlace)) {
        const Vec3d a = source.evaluate(pair.wo, pair.wi), b = source.evaluate(pair.wi, pair.wo);
        const double sum = a.x + a.y + a.z, other = b.x + b.y + b.z;
        if (sum > 0.0 && other > 0.0) differences.push_back(std::abs(std::log(sum / other)));
    }
    if (differences.empty()) return true;
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return *middle < kSame;
}

}  // namespace fbrdf
