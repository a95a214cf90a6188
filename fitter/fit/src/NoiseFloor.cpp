#include <fbrdf/fit/NoiseFloor.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr float kHalfNormalMedian = 0.6745f;  // of |noise|, in sigma

float floorOfChannel(const std::vector<Sample>& samples, int channel)
{
    std::vector<float> positive;
    double negativeSquares = 0.0;
    size_t negative = 0, zero = 0;
    for (const Sample& s : samples) {
        const float f = s.f[channel];
        if (f > 0.0f) {
            positive.push_back(f);
        } else if (f < 0.0f) {
            ++negative;
            negativeSquares += static_cast<double>(f) * static_cast<double>(f);
        } else {
            ++zero;
        }
    }
    if (positive.empty() || negative + zero == 0) return 0.0f;
    float floor = 0.0f;
    if (negative > 0)
        floor = static_cast<float>(std::sqrt(negativeSquares / static_cast<double>(negative)));
    if (zero > 0) {
        const size_t rank = std::min(zero / 2, positive.size() - 1);
        std::nth_element(positive.begin(), positive.begin() + static_cast<std::ptrdiff_t>(rank),
                         positive.end());
        floor = std::max(floor, positive[rank] / kHalfNormalMedian);
    }
    // A floor above the median would call most of the data noise; zeros are then holes, not clipped
    // noise.
    const size_t middle = positive.size() / 2;
    std::nth_element(positive.begin(), positive.begin() + static_cast<std::ptrdiff_t>(middle),
                     positive.end());
    return std::min(floor, positive[middle]);
}

}  // namespace

Vec3f estimateNoiseFloor(const std::vector<Sample>& samples)
{
    return {floorOfChannel(samples, 0), floorOfChannel(samples, 1), floorOfChannel(samples, 2)};
}

}  // namespace fbrdf
