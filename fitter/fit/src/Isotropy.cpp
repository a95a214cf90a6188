#include "Isotropy.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/fit/SampleSets.h>

namespace fbrdf {

bool isIsotropicSource(const Source& source)
{
    if (source.isotropic) return true;
    if (!source.evaluate) return false;
    constexpr double kSame = 1e-3;  // relative; below what any material of ours resolves
    double largest = 0.0, difference = 0.0;
    for (const auto& pair : uniformPairs(512, 17)) {
        HalfDifference turned = halfDifferenceFromPair(pair);
        turned.phi_h += 1.0;
        const auto other = pairFromHalfDifference(turned);
        const Vec3d a = source.evaluate(pair.wo, pair.wi), b = source.evaluate(other.wo, other.wi);
        largest = std::max(largest, a.x + a.y + a.z);
        difference = std::max(difference, glm::length(a - b) / (a.x + a.y + a.z + 1e-6));
    }
    return difference < kSame || largest == 0.0;
}

}  // namespace fbrdf
