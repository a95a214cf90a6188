#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/SampleLattice.h>

#include <numeric>

namespace fbrdf {

int latticeStep(int count)
{
    FBRDF_ASSERT(count, >=, 1);
    constexpr double kGoldenRatio = 1.618033988749895;
    int step = static_cast<int>(std::lround(count / kGoldenRatio));
    while (std::gcd(step, count) != 1) ++step;
    return step;
}

}  // namespace fbrdf
