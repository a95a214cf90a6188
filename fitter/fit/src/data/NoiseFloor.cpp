#include <fbrdf/fit/NoiseFloor.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr float kHalfNormalMedian = 0.6745f;  // of |noise|, in sigma

// Value of a rank, rank 0 the smallest; the last where there are fewer. Reorders.
float ranked(std::vector<float>& values, size_t rank)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

float median(std::vector<float>& values)
{
    return ranked(values, values.size() / 2);
}

// ln of the likelihood of all negative values as halves of normals with one sigma for f, or for
// f cos theta_i, up to what both have in common.
bool negativesFollowCosine(const std::vector<Sample>& samples)
{
    constexpr float kGrazing = 1e-3f;  // pairs at the horizon must not decide
    double count = 0.0, plain = 0.0, scaled = 0.0, logs = 0.0;
    for (const Sample& s : samples)
        for (int c = 0; c < 3; ++c) {
            if (!(s.f[c] < 0.0f) || s.wi.z < kGrazing) continue;
            const auto f = static_cast<double>(s.f[c]), cosine = static_cast<double>(s.wi.z);
            ++count;
            plain += f * f;
            scaled += cosine * cosine * f * f;
            logs += std::log(cosine);
        }
    constexpr double kFew = 100.0;  // negative values that are enough to decide
    return count >= kFew && -0.5 * std::log(scaled) + logs / count > -0.5 * std::log(plain);
}

float floorOfChannel(const std::vector<Sample>& samples, int channel, bool overCosine)
{
    std::vector<float> positive, negative;
    size_t zero = 0;
    for (const Sample& s : samples) {
        const float f = overCosine ? s.f[channel] * s.wi.z : s.f[channel];
        if (f > 0.0f) {
            positive.push_back(f);
        } else if (f < 0.0f) {
            negative.push_back(-f);
        } else {
            ++zero;
        }
    }
    if (positive.empty() || negative.size() + zero == 0) return 0.0f;
    // The median, and not the rms: a few samples must not decide for all. Zeros beside negative
    // values are samples that were lost, and none that were clipped.
    const float floor =
        (negative.empty() ? ranked(positive, zero / 2) : median(negative)) / kHalfNormalMedian;
    // A floor above the median would call most of the data noise; zeros are then holes, not clipped
    // noise.
    return std::min(floor, median(positive));
}

}  // namespace

NoiseModel estimateNoise(const std::vector<Sample>& samples)
{
    NoiseModel noise;
    noise.unclipped = std::any_of(samples.begin(), samples.end(), [](const Sample& s) {
        return s.f.x < 0.0f || s.f.y < 0.0f || s.f.z < 0.0f;
    });
    noise.overCosine = noise.unclipped && negativesFollowCosine(samples);
    for (int c = 0; c < 3; ++c) noise.sigma[c] = floorOfChannel(samples, c, noise.overCosine);
    return noise;
}

Vec3f estimateNoiseFloor(const std::vector<Sample>& samples)
{
    return estimateNoise(samples).sigma;
}

}  // namespace fbrdf
