#include <fbrdf/fit/NoiseFloor.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

float valueOf(const Sample& sample, int channel, bool overCosine)
{
    return overCosine ? sample.f[channel] * sample.wi.z : sample.f[channel];
}

float squaredDistance(const Sample& a, const Sample& b)
{
    const Vec3f i = a.wi - b.wi, o = a.wo - b.wo;
    return glm::dot(i, i) + glm::dot(o, o);
}

// Of those as near as each other the next one: repeated measurements are neighbours in turn.
size_t nearestTo(const std::vector<Sample>& samples, size_t to)
{
    size_t nearest = to;
    float least = std::numeric_limits<float>::max();
    for (size_t step = 1; step < samples.size(); ++step) {
        const size_t i = (to + step) % samples.size();
        const float distance = squaredDistance(samples[i], samples[to]);
        if (distance >= least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

/// Some of the values below 0, each beside the value of the sample that is nearest in directions.
struct Neighbours {
    std::vector<float> difference;  ///< magnitudes
    size_t negative = 0;            ///< neighbours that are below 0 as well
};

Neighbours neighboursOfNegatives(const std::vector<Sample>& samples, int channel, bool overCosine)
{
    constexpr size_t kLooked = 256, kFewLooked = 16;
    constexpr size_t kCompared = size_t{1} << 24;  // pairs: a fraction of a second
    std::vector<size_t> below;
    for (size_t i = 0; i < samples.size(); ++i)
        if (samples[i].f[channel] < 0.0f) below.push_back(i);
    Neighbours result;
    const size_t looked =
        std::min(below.size(), std::clamp(kCompared / samples.size(), kFewLooked, kLooked));
    for (size_t k = 0; k < looked; ++k) {
        const size_t at = below[k * below.size() / looked];
        const float other = valueOf(samples[nearestTo(samples, at)], channel, overCosine);
        result.difference.push_back(std::abs(valueOf(samples[at], channel, overCosine) - other));
        result.negative += other < 0.0f ? 1 : 0;
    }
    return result;
}

// Noise leaves at most half of the neighbours of a negative value below 0, as f is not. A colour
// that the primaries cannot show is below 0 wherever it is seen, and its noise is what neighbours
// differ by. It is kept above what anyone sees beside the brightest channel, so that no fit has to
// follow logarithms to where the channel passes through 0.
float noiseOfNegatives(const std::vector<Sample>& samples, int channel, bool overCosine,
                       std::vector<float>& magnitudes)
{
    constexpr size_t kFew = 16;
    constexpr double kColour = 0.7;    // of the neighbours
    constexpr float kUnseen = 0.004f;  // of the median of the brightest channel
    const float noise = median(magnitudes) / kHalfNormalMedian;
    if (magnitudes.size() < kFew) return noise;
    Neighbours neighbours = neighboursOfNegatives(samples, channel, overCosine);
    const auto looked = static_cast<double>(neighbours.difference.size());
    if (static_cast<double>(neighbours.negative) < kColour * looked) return noise;
    std::vector<float> brightest;
    for (const Sample& s : samples)
        brightest.push_back(std::max(
            {valueOf(s, 0, overCosine), valueOf(s, 1, overCosine), valueOf(s, 2, overCosine)}));
    const float apart = median(neighbours.difference) / (kHalfNormalMedian * std::sqrt(2.0f));
    return std::min(noise, std::max(apart, kUnseen * median(brightest)));
}

float floorOfChannel(const std::vector<Sample>& samples, int channel, bool overCosine)
{
    std::vector<float> positive, negative;
    size_t zero = 0;
    for (const Sample& s : samples) {
        const float f = valueOf(s, channel, overCosine);
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
    const float floor = negative.empty() ? ranked(positive, zero / 2) / kHalfNormalMedian
                                         : noiseOfNegatives(samples, channel, overCosine, negative);
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
